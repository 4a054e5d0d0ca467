// What leaves see of a sky of smooth gradient and round lamps, integrated over their polygons,
// pixel by pixel.
#pragma once

#include <vector>

#include "beams/expansion.hpp"
#include "render/palette.hpp"
#include "render/sampler.hpp"

namespace icespar {

/// Sums responses by light, so that colours are worked out once a pixel.
class SkySum {
public:
    SkySum(const Environment& sky, const Palette& palette, std::size_t pixels);

    /// `k`: unit wave vectors over the polygon, whose centroid is the origin.
    /// Returns the luminance.
    double add(std::size_t pixel, const Expansion& k, PolygonView polygon, double area,
               const Stokes& response);

    /// Hands a pixel's sums to the sampler and starts it anew.
    void flush(std::size_t pixel, const Palette& palette, Sampler& sampler);

private:
    const Environment& sky_;
    std::size_t lights_;
    std::vector<double> luminances_;  ///< of lights: below, above, then the discs
    std::vector<Stokes> sums_;        ///< [pixel][light]
};

}  // namespace icespar
