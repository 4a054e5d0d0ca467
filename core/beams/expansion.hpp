// Vectors that vary linearly over a fragment of the picture.
#pragma once

#include "beams/polygon.hpp"
#include "math/vec3.hpp"

namespace icespar {

/// A vector to first order about a fragment's centroid.
struct Expansion {
    Vec3 value, dx, dy;  ///< at the centroid; per unit of picture x and y

    [[nodiscard]] Vec3 at(const Point2& p) const { return value + p.x * dx + p.y * dy; }
    /// The same about another point.
    [[nodiscard]] Expansion about(const Point2& p) const { return {at(p), dx, dy}; }
    [[nodiscard]] Affine along(const Vec3& n) const {
        return {dot(n, value), dot(n, dx), dot(n, dy)};
    }
};

/// Where the lines of a camera start and go: over one pixel both are linear in picture coordinates,
/// and one of the two is constant (perspective: the origin; parallel: the direction).
struct RayField {
    Expansion origin, direction;  ///< the direction not normalised
};

}  // namespace icespar
