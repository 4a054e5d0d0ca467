// A gradient is exact at the centroid; the edge of a lamp cuts polygons.
#include "render/sky_sum.hpp"

#include <algorithm>

#include "render/lamp_edge.hpp"

namespace icespar {

SkySum::SkySum(const Environment& sky, const Palette& palette, std::size_t pixels)
    : sky_(sky), lights_(2 + sky.discs.size()), sums_(pixels * lights_) {
    const auto add = [&](const Emitter& e) { luminances_.push_back(xyz_from_rgb(e.rgb)[1]); };
    add(palette.below);
    add(palette.above);
    for (const Emitter& e : palette.discs) add(e);
}

double SkySum::add(std::size_t pixel, const Expansion& k, PolygonView polygon, double area,
                   const Stokes& response) {
    Stokes* sums = &sums_[pixel * lights_];
    const double height = 0.5 * (1 + dot(k.value, sky_.up));
    sums[0] += (area * (1 - height)) * response;
    sums[1] += (area * height) * response;
    double luminance = area * ((1 - height) * luminances_[0] + height * luminances_[1]);
    if (sky_.discs.empty()) return luminance * response.s0;
    const double across = spread(k, polygon);
    for (std::size_t i = 0; i < sky_.discs.size(); ++i) {
        const Disc& disc = sky_.discs[i];
        const double inside = dot(k.value, disc.direction) - disc.cos_radius;
        if (inside <= -across) continue;
        const double lit = inside >= across ? area : lit_area(disc, k, polygon, area);
        sums[2 + i] += lit * response;
        luminance += lit * luminances_[2 + i];
    }
    return luminance * response.s0;
}

void SkySum::flush(std::size_t pixel, const Palette& palette, Sampler& sampler) {
    Stokes* sums = &sums_[pixel * lights_];
    sampler.see(palette.below, sums[0], false);
    sampler.see(palette.above, sums[1], false);
    for (std::size_t i = 2; i < lights_; ++i) {
        // Few pixels see more than one lamp.
        if (sums[i].s0 != 0) sampler.see(palette.discs[i - 2], sums[i], false);
    }
    std::fill_n(sums, lights_, Stokes{});
}

}  // namespace icespar
