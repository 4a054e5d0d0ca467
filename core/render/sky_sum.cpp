// A gradient is exact at the centroid; the edge of a lamp cuts polygons.
#include "render/sky_sum.hpp"

#include "render/lamp_edge.hpp"

namespace icespar {

void SkySum::add(const Expansion& k, PolygonView polygon, double area, const Stokes& response) {
    const double height = 0.5 * (1 + dot(k.value, sky_.up));
    below_ += (area * (1 - height)) * response;
    above_ += (area * height) * response;
    if (discs_.empty()) return;
    const double across = spread(k, polygon);
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        const Disc& disc = sky_.discs[i];
        const double inside = dot(k.value, disc.direction) - disc.cos_radius;
        if (inside <= -across) continue;
        discs_[i] += (inside >= across ? area : lit_area(disc, k, polygon, area)) * response;
    }
}

void SkySum::flush(const Palette& palette, Sampler& sampler) {
    sampler.see(palette.below, below_, false);
    sampler.see(palette.above, above_, false);
    below_ = above_ = {};
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        sampler.see(palette.discs[i], discs_[i], false);
        discs_[i] = {};
    }
}

}  // namespace icespar
