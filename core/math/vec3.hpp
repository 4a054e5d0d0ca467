// Three-vectors of real or complex numbers, and the handful of operations light needs.
#pragma once

#include <cmath>
#include <complex>

namespace icespar {

using Complex = std::complex<double>;

template <class T>
struct Vector3 {
    T x{}, y{}, z{};

    friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
    constexpr Vector3& operator+=(const Vector3& b) { return *this = *this + b; }
    constexpr Vector3& operator-=(const Vector3& b) { return *this = *this - b; }
};

using Vec3 = Vector3<double>;
using CVec3 = Vector3<Complex>;

template <class S, class T>
constexpr auto operator*(const S& s, const Vector3<T>& v) -> Vector3<decltype(s * v.x)> {
    return {s * v.x, s * v.y, s * v.z};
}
template <class S, class T>
constexpr auto operator*(const Vector3<T>& v, const S& s) -> Vector3<decltype(v.x * s)> {
    return {v.x * s, v.y * s, v.z * s};
}
template <class S, class T>
constexpr auto operator/(const Vector3<T>& v, const S& s) -> Vector3<decltype(v.x / s)> {
    return {v.x / s, v.y / s, v.z / s};
}

/// Bilinear product: no complex conjugation.
template <class S, class T>
constexpr auto dot(const Vector3<S>& a, const Vector3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Bilinear vector product: no complex conjugation.
template <class S, class T>
constexpr auto cross(const Vector3<S>& a, const Vector3<T>& b) {
    using R = decltype(a.x * b.x);
    return Vector3<R>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class R = double>
R length(const Vector3<R>& v) {
    return std::sqrt(dot(v, v));
}

/// Hermitian norm.
template <class R = double>
R length(const Vector3<std::complex<R>>& v) {
    return std::sqrt(std::norm(v.x) + std::norm(v.y) + std::norm(v.z));
}

/// The unit vector along v; v must not be zero.
template <class R = double>
Vector3<R> normalised(const Vector3<R>& v) {
    return v / length(v);
}

template <class R>
Vector3<std::complex<R>> conj(const Vector3<std::complex<R>>& v) {
    return {std::conj(v.x), std::conj(v.y), std::conj(v.z)};
}
template <class R>
Vector3<R> real(const Vector3<std::complex<R>>& v) {
    return {v.x.real(), v.y.real(), v.z.real()};
}
template <class R>
Vector3<R> imag(const Vector3<std::complex<R>>& v) {
    return {v.x.imag(), v.y.imag(), v.z.imag()};
}
template <class R>
Vector3<std::complex<R>> complexified(const Vector3<R>& v) {
    return {v.x, v.y, v.z};
}

/// The same vector in numbers of another type.
template <class To, class T>
Vector3<To> converted(const Vector3<T>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A unit vector perpendicular to the unit vector n (Duff et al. 2017, branch-free frame).
template <class R = double>
Vector3<R> any_perpendicular(const Vector3<R>& n) {
    const R sign = std::copysign(R(1), n.z);
    const R a = R(-1) / (sign + n.z);
    return {R(1) + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

}  // namespace icespar
