// The shapes of opaque things and of sheets, each in a space of its own.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "math/vec3.hpp"

namespace icespar {

struct PlaneShape {};   ///< y = 0
struct BoxShape {};     ///< the unit cube 0 .. 1
struct SphereShape {};  ///< the unit sphere
/// About y, from radius 1 at y = 0 to `top` at y = 1; closed by discs unless `open`.
struct ConeShape {
    double top = 1;
    bool open = false;
};
/// The unit disc in y = 0, with a hole of this radius.
struct DiscShape {
    double hole = 0;
};
struct SquareShape {};  ///< y = 0, x and z from 0 to 1
struct TriangleMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// Instances share their triangles. Flat, seen from both sides.
struct MeshShape {
    std::shared_ptr<const TriangleMesh> mesh;
};

using Shape =
    std::variant<PlaneShape, BoxShape, SphereShape, ConeShape, DiscShape, SquareShape, MeshShape>;

/// Flat ones cannot be met again by a ray that has just left them.
[[nodiscard]] inline bool is_flat(const Shape& s) {
    return std::holds_alternative<PlaneShape>(s) || std::holds_alternative<DiscShape>(s) ||
           std::holds_alternative<SquareShape>(s);
}

}  // namespace icespar
