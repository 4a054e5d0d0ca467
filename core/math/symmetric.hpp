// Symmetric 3 x 3 tensors, real or complex, and the principal axes of real ones.
#pragma once

#include <array>

#include "math/vec3.hpp"

namespace icespar {

template <class T>
struct SymmetricTensor {
    T xx{}, yy{}, zz{}, yz{}, xz{}, xy{};

    static SymmetricTensor diagonal(const T& x, const T& y, const T& z) {
        return {x, y, z, {}, {}, {}};
    }

    friend constexpr bool operator==(const SymmetricTensor&, const SymmetricTensor&) = default;
    friend SymmetricTensor operator+(const SymmetricTensor& a, const SymmetricTensor& b) {
        return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.yz + b.yz, a.xz + b.xz, a.xy + b.xy};
    }
    friend SymmetricTensor operator*(const T& f, const SymmetricTensor& a) {
        return {f * a.xx, f * a.yy, f * a.zz, f * a.yz, f * a.xz, f * a.xy};
    }
    template <class S>
    friend auto operator*(const SymmetricTensor& a, const Vector3<S>& v)
        -> Vector3<decltype(T{} * S{})> {
        return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
                a.xz * v.x + a.yz * v.y + a.zz * v.z};
    }

    [[nodiscard]] T determinant() const {
        return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    }
    /// The tensor must not be singular.
    [[nodiscard]] SymmetricTensor inverse() const {
        const T d = determinant();
        return {(yy * zz - yz * yz) / d, (xx * zz - xz * xz) / d, (xx * yy - xy * xy) / d,
                (xy * xz - xx * yz) / d, (xy * yz - yy * xz) / d, (xz * yz - xy * zz) / d};
    }
    /// Components in the orthonormal frame x, y, z.
    template <class R>
    [[nodiscard]] SymmetricTensor in_frame(const Vector3<R>& x, const Vector3<R>& y,
                                           const Vector3<R>& z) const {
        const auto ax = *this * x, ay = *this * y, az = *this * z;
        return {dot(x, ax), dot(y, ay), dot(z, az), dot(y, az), dot(x, az), dot(x, ay)};
    }
};

using RealTensor = SymmetricTensor<double>;
using ComplexTensor = SymmetricTensor<Complex>;

template <class R>
SymmetricTensor<R> real(const SymmetricTensor<std::complex<R>>& t) {
    return {t.xx.real(), t.yy.real(), t.zz.real(), t.yz.real(), t.xz.real(), t.xy.real()};
}
template <class R>
SymmetricTensor<R> imag(const SymmetricTensor<std::complex<R>>& t) {
    return {t.xx.imag(), t.yy.imag(), t.zz.imag(), t.yz.imag(), t.xz.imag(), t.xy.imag()};
}
template <class R>
SymmetricTensor<std::complex<R>> complexified(const SymmetricTensor<R>& t) {
    return {t.xx, t.yy, t.zz, t.yz, t.xz, t.xy};
}

/// The same tensor in numbers of another type.
template <class To, class T>
SymmetricTensor<To> converted(const SymmetricTensor<T>& t) {
    return {static_cast<To>(t.xx), static_cast<To>(t.yy), static_cast<To>(t.zz),
            static_cast<To>(t.yz), static_cast<To>(t.xz), static_cast<To>(t.xy)};
}

/// The inverse times the determinant.
template <class T>
SymmetricTensor<T> cofactors(const SymmetricTensor<T>& t) {
    return {t.yy * t.zz - t.yz * t.yz, t.xx * t.zz - t.xz * t.xz, t.xx * t.yy - t.xy * t.xy,
            t.xy * t.xz - t.xx * t.yz, t.xy * t.yz - t.yy * t.xz, t.xz * t.yz - t.xy * t.zz};
}

/// v v^T.
template <class T>
SymmetricTensor<T> dyad(const Vector3<T>& v) {
    return {v.x * v.x, v.y * v.y, v.z * v.z, v.y * v.z, v.x * v.z, v.x * v.y};
}

/// The sum over all elements of their products.
template <class T>
T product(const SymmetricTensor<T>& a, const SymmetricTensor<T>& b) {
    return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2 * (a.yz * b.yz + a.xz * b.xz + a.xy * b.xy);
}

/// Rising eigenvalues with a right-handed orthonormal set of eigenvectors.
struct PrincipalAxes {
    std::array<double, 3> values;
    std::array<Vec3, 3> axes;
};

/// By Jacobi rotations; accurate to a few roundings of the largest element.
[[nodiscard]] PrincipalAxes principal_axes(const RealTensor& tensor);

}  // namespace icespar
