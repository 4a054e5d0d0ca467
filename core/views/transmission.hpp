// How much light passes through what absorbs along paths of different lengths.
#pragma once

#include "beams/polygon.hpp"

namespace icespar {

/// The mean of exp(-depth) over a convex polygon with an area, in closed form.
[[nodiscard]] double mean_transmission(PolygonView polygon, const Affine& depth);

}  // namespace icespar
