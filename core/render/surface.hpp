// Opaque surfaces: which of a pigment's colours is where.
#pragma once

#include "scene/scene.hpp"

namespace icespar {

/// True where the pigment's first colour lies at a world point of a surface with this normal. A
/// grid's lines run along the integer planes of the pattern's space; planes parallel to the surface
/// draw none.
[[nodiscard]] bool shows_first(const Pigment& pigment, const Vec3& point, const Vec3& normal);

}  // namespace icespar
