// Affine maps of space with their inverses, composed in POV-Ray's order.
#pragma once

#include <array>

#include "math/vec3.hpp"

namespace icespar {

/// p -> (rows . p) + offset. The inverse is kept beside it, so that undoing never divides.
class Transform {
public:
    Transform() = default;  ///< identity

    /// Rows of the linear part and the translation; throws Error when the linear part
    /// has no inverse (determinant 0 or not finite).
    Transform(const std::array<Vec3, 3>& rows, const Vec3& offset);

    static Transform translation(const Vec3& by);
    static Transform scaling(const Vec3& by);  ///< no component may be 0

    [[nodiscard]] Vec3 point(const Vec3& p) const;
    [[nodiscard]] Vec3 vector(const Vec3& v) const;
    /// A plane's normal, by the inverse transpose; not renormalised.
    [[nodiscard]] Vec3 normal(const Vec3& n) const;
    [[nodiscard]] Transform inverse() const;
    [[nodiscard]] double determinant() const;

    /// First this map, then `next`.
    [[nodiscard]] Transform then(const Transform& next) const;

private:
    std::array<Vec3, 3> rows_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 offset_{};
    std::array<Vec3, 3> inverse_rows_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Vec3 inverse_offset_{};
};

}  // namespace icespar
