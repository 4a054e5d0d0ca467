// Whether the surface of a thing goes through a stone.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.hpp"

namespace icespar {

/// Points whose bounds hold the thing; none of a plane, which has no bounds.
[[nodiscard]] std::vector<Vec3> outermost_points(const Thing& thing);

/// How many polygons `runs_through` looks at.
[[nodiscard]] std::size_t polygons_of(const Thing& thing);

/// Whether some of the thing's surface lies within the stone, deeper than a thousandth of the
/// stone's size (of a sheet: than rounding). A stone that touches, or is wholly within a hollow
/// thing, is well.
[[nodiscard]] bool runs_through(const Thing& thing, const Stone& stone);

}  // namespace icespar
