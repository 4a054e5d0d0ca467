// Patterns on opaque surfaces, and over the sky.
#pragma once

#include "math/vec3.hpp"
#include "scene/pigment.hpp"

namespace icespar {

/// Which of the pigment's colours a point shows, and in what shares. `normal` is the surface's (a
/// grid leaves out the family of lines that would cover a face whole); for a sky the point is a
/// unit direction.
[[nodiscard]] Mix mix_at(const Pigment& pigment, const Vec3& point, const Vec3& normal);

}  // namespace icespar
