// What the exact polyhedron code offers to the rest of this folder.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "stone/coplanar.hpp"
#include "stone/stone.hpp"

namespace icespar {

/// normal . p <= distance; or, where three points are given, exactly the half-space through them
/// from whose outside they are seen counter-clockwise.
struct HalfSpace {
    Vec3 normal;
    double distance = 0;
    std::optional<std::array<Vec3, 3>> through{};
};

/// The largest ball within half-spaces, found in exact arithmetic.
struct InnerBall {
    Vec3 centre;
    double radius = 0;                  ///< 0 or negative when there is no common interior
    std::vector<std::size_t> touching;  ///< the planes that stop the ball from growing
};

/// Normals need not be unit vectors, but must be finite and not 0. Half-spaces that admit balls of
/// any size give one no larger than the greatest plane distance (or 1, when all distances are 0).
/// Points that planes go through are not regarded.
[[nodiscard]] InnerBall inner_ball(std::span<const HalfSpace> planes);

/// The common part of half-spaces.
struct Intersection {
    Stone stone;                         ///< without names; empty when it is not closed
    std::vector<std::size_t> unreached;  ///< planes without a facet on the stone, ascending
    std::vector<Vec3> open;              ///< directions that run out of it; empty when it is closed
};

/// `centre` lies within all half-spaces. Throws Error when rounding has put it outside. Facets that
/// are narrower than rounding are left out, as Stone::from_planes says.
[[nodiscard]] Intersection intersection(std::span<const HalfSpace> planes, const Vec3& centre);

/// Triangles of the convex hull, counter-clockwise from outside; none when all points lie in a
/// plane.
[[nodiscard]] std::vector<Triangle> hull_triangles(std::span<const Vec3> points);

}  // namespace icespar
