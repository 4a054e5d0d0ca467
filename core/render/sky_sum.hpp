// What leaves see of a sky of smooth gradient and round lamps, integrated over their polygons.
#pragma once

#include <vector>

#include "beams/expansion.hpp"
#include "render/palette.hpp"
#include "render/sampler.hpp"

namespace icespar {

/// Sums responses by light, so that colours are worked out once a pixel.
class SkySum {
public:
    explicit SkySum(const Environment& sky) : sky_(sky), discs_(sky.discs.size()) {}

    /// `k`: unit wave vectors over the polygon, whose centroid is the origin.
    void add(const Expansion& k, PolygonView polygon, double area, const Stokes& response);

    /// Luminance of the sums so far, for lights of these luminances: below, above, then the discs.
    [[nodiscard]] double luminance(const std::vector<double>& lights) const {
        double sum = lights[0] * below_.s0 + lights[1] * above_.s0;
        for (std::size_t i = 0; i < discs_.size(); ++i) sum += lights[2 + i] * discs_[i].s0;
        return sum;
    }

    /// Hands the sums to the sampler and starts anew.
    void flush(const Palette& palette, Sampler& sampler);

private:
    const Environment& sky_;
    Stokes below_, above_;
    std::vector<Stokes> discs_;
};

}  // namespace icespar
