// A gradient is exact at the centroid; the edge of a lamp cuts the polygon along a straight line.
#include "render/sky_sum.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {

void SkySum::add(const Expansion& k, PolygonView polygon, double area, const Stokes& response) {
    const double height = 0.5 * (1 + dot(k.value, sky_.up));
    below_ += (area * (1 - height)) * response;
    above_ += (area * height) * response;
    if (discs_.empty()) return;
    double x = 0, y = 0;
    for (const Point2& p : polygon) {
        x = std::max(x, std::abs(p.x));
        y = std::max(y, std::abs(p.y));
    }
    const double spread = x * length(k.dx) + y * length(k.dy);
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        const Disc& disc = sky_.discs[i];
        const double inside = dot(k.value, disc.direction) - disc.cos_radius;
        if (inside <= -spread) continue;
        double part = area;
        if (inside < spread) {
            part = part_within({inside, dot(k.dx, disc.direction), dot(k.dy, disc.direction)},
                               polygon, area);
        }
        discs_[i] += part * response;
    }
}

double SkySum::part_within(const Affine& inside, PolygonView polygon, double area) {
    int corners = 0;
    for (const Point2& p : polygon) corners += inside(p) >= 0 ? 1 : 0;
    if (corners == 0) return 0;
    if (corners == static_cast<int>(polygon.size())) return area;
    clip(polygon, inside, within_);
    return extent(within_).area;
}

void SkySum::flush(const Palette& palette, double share, bool one_wavelength, Sampler& sampler) {
    sampler.see(palette.below, share * below_, one_wavelength);
    sampler.see(palette.above, share * above_, one_wavelength);
    below_ = above_ = {};
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        sampler.see(palette.discs[i], share * discs_[i], one_wavelength);
        discs_[i] = {};
    }
}

}  // namespace icespar
