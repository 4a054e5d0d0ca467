// A gradient is exact at the centroid; the edge of a lamp cuts small polygons along a straight
// line.
#include "render/sky_sum.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {

void SkySum::add(const Expansion& k, PolygonView polygon, double area, const Stokes& response) {
    const double height = 0.5 * (1 + dot(k.value, sky_.up));
    below_ += (area * (1 - height)) * response;
    above_ += (area * height) * response;
    if (discs_.empty()) return;
    constexpr int halvings = 8;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        const Disc& disc = sky_.discs[i];
        const double part = within(disc, k, polygon, area, halvings);
        if (part != 0) discs_[i] += part * response;
    }
}

double SkySum::within(const Disc& disc, const Expansion& k, PolygonView polygon, double area,
                      int halvings) const {
    double x = 0, y = 0;
    for (const Point2& p : polygon) {
        x = std::max(x, std::abs(p.x));
        y = std::max(y, std::abs(p.y));
    }
    const double wide = x * length(k.dx), high = y * length(k.dy), spread = wide + high;
    const double inside = dot(k.value, disc.direction) - disc.cos_radius;
    if (inside <= -spread) return 0;
    if (inside >= spread) return area;

    constexpr double straight = 0.1;
    Polygon piece;
    const double sine = std::sqrt(std::max(0.0, 1 - disc.cos_radius * disc.cos_radius));
    if (spread > straight * sine && halvings > 0) {
        double sum = 0;
        for (const double side : {-1.0, 1.0}) {
            clip(polygon, wide > high ? Affine{0, side, 0} : Affine{0, 0, side}, piece);
            const Extent e = extent(piece);
            if (!(e.area > 0)) continue;
            for (Point2& p : piece) p = p - e.centroid;
            const Vec3 there = k.at(e.centroid);
            const double size = length(there);
            sum +=
                within(disc, {there / size, k.dx / size, k.dy / size}, piece, e.area, halvings - 1);
        }
        return sum;
    }
    // k has unit length only in the middle: the mean of its second-order part over the polygon.
    const double longer = (wide * wide + high * high) / 6;
    clip(polygon,
         {inside - longer * disc.cos_radius, dot(k.dx, disc.direction), dot(k.dy, disc.direction)},
         piece);
    return extent(piece).area;
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
