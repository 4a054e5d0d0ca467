// Pictures of beams that a coloured stone fades, more where their way is longer.
#pragma once

#include <span>
#include <vector>

#include "views/raster.hpp"

namespace icespar {

/// Adds a polygon with what it has on the whole of several hues, each of which passes it by its own
/// depth; `sum` is that of all. In each strip of it every hue has its exact mean, and their sum is
/// as steep as they are on average.
void shade(PolygonView polygon, std::span<const Affine> depths,
           const std::vector<std::vector<double>>& shares, std::span<const double> sum,
           Raster& raster);

}  // namespace icespar
