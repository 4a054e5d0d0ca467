// Affine maps: composition and inversion.
#include "math/transform.hpp"

#include "math/error.hpp"

namespace icespar {
namespace {

using Rows = std::array<Vec3, 3>;

Vec3 apply(const Rows& r, const Vec3& v) { return {dot(r[0], v), dot(r[1], v), dot(r[2], v)}; }

Vec3 apply_transposed(const Rows& r, const Vec3& v) { return v.x * r[0] + v.y * r[1] + v.z * r[2]; }

/// a after b.
Rows product(const Rows& a, const Rows& b) {
    return {apply_transposed(b, a[0]), apply_transposed(b, a[1]), apply_transposed(b, a[2])};
}

Rows inverted(const Rows& r) {
    const double det = dot(r[0], cross(r[1], r[2]));
    if (!(std::abs(det) > 0) || !std::isfinite(1 / det)) {
        throw Error(
            "this transform flattens space (its determinant is 0): use scales and matrices "
            "that keep all three dimensions");
    }
    const Vec3 c0 = cross(r[1], r[2]) / det;
    const Vec3 c1 = cross(r[2], r[0]) / det;
    const Vec3 c2 = cross(r[0], r[1]) / det;
    return {Vec3{c0.x, c1.x, c2.x}, Vec3{c0.y, c1.y, c2.y}, Vec3{c0.z, c1.z, c2.z}};
}

}  // namespace

Transform::Transform(const Rows& rows, const Vec3& offset)
    : rows_(rows), offset_(offset), inverse_rows_(inverted(rows)) {
    inverse_offset_ = -apply(inverse_rows_, offset_);
}

Transform Transform::translation(const Vec3& by) {
    Transform t;
    t.offset_ = by;
    t.inverse_offset_ = -by;
    return t;
}

Transform Transform::scaling(const Vec3& by) {
    return {Rows{Vec3{by.x, 0, 0}, Vec3{0, by.y, 0}, Vec3{0, 0, by.z}}, Vec3{}};
}

Vec3 Transform::point(const Vec3& p) const { return apply(rows_, p) + offset_; }

Vec3 Transform::vector(const Vec3& v) const { return apply(rows_, v); }

Vec3 Transform::normal(const Vec3& n) const { return apply_transposed(inverse_rows_, n); }

Transform Transform::inverse() const {
    Transform t;
    t.rows_ = inverse_rows_;
    t.offset_ = inverse_offset_;
    t.inverse_rows_ = rows_;
    t.inverse_offset_ = offset_;
    return t;
}

double Transform::determinant() const { return dot(rows_[0], cross(rows_[1], rows_[2])); }

Transform Transform::then(const Transform& next) const {
    Transform t;
    t.rows_ = product(next.rows_, rows_);
    t.offset_ = next.point(offset_);
    t.inverse_rows_ = product(inverse_rows_, next.inverse_rows_);
    t.inverse_offset_ = apply(inverse_rows_, next.inverse_offset_) + inverse_offset_;
    return t;
}

}  // namespace icespar
