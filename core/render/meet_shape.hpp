// Where a ray meets the shapes of things, each in its own space.
#pragma once

#include "scene/shape.hpp"

namespace icespar {

/// A point origin + distance direction, and the surface's normal there (of any length and side).
struct Meeting {
    double distance = 0;
    Vec3 normal;
};

/// The nearest point beyond `start`; false when there is none. The direction need not be a unit
/// vector. Meshes are met triangle by triangle.
[[nodiscard]] bool meet_shape(const Shape& shape, const Vec3& origin, const Vec3& direction,
                              double start, Meeting& out);

/// The same for a triangle. Edges that triangles share by number are met by one of them at least:
/// no ray slips through between.
[[nodiscard]] bool meet_triangle(const std::vector<Vec3>& vertices,
                                 const std::array<std::uint32_t, 3>& triangle, const Vec3& origin,
                                 const Vec3& direction, double start, Meeting& out);

/// Half the edges of a box about the shape, in its own space, and the box's centre.
struct Reach {
    Vec3 centre, half;
};
[[nodiscard]] Reach reach_of(const Shape& shape);

}  // namespace icespar
