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

    /// Hands the sums to the sampler, times `share`, and starts anew.
    void flush(const Palette& palette, double share, bool one_wavelength, Sampler& sampler);

private:
    [[nodiscard]] double part_within(const Affine& inside, PolygonView polygon, double area);

    const Environment& sky_;
    Stokes below_, above_;
    std::vector<Stokes> discs_;
    Polygon within_;
};

}  // namespace icespar
