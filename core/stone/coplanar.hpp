// Triangles of a convex surface gathered into the flat faces they were cut from.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/vec3.hpp"

namespace icespar {

using Triangle = std::array<std::uint32_t, 3>;

/// Triangle numbers of each face, in ascending order. Neighbours are joined, flattest pair first,
/// as long as every corner of the joined face stays within `tolerance` of one plane. The triangles
/// form a closed surface, all turned the same way.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> coplanar_faces(
    std::span<const Vec3> points, std::span<const Triangle> triangles, double tolerance);

/// Half the vector product of two edges: the triangle's normal times its area.
[[nodiscard]] Vec3 vector_area(std::span<const Vec3> points, const Triangle& t);

}  // namespace icespar
