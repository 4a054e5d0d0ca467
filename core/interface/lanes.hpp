// Numbers in lanes: one variable holds a quantity of several faces. Everything here is a template
// over the lane type, so that code for wider processors never replaces the baseline's.
#pragma once

#include <experimental/simd>
#include <limits>

#include "math/vec3.hpp"

namespace icespar::lanes {

template <class V>
using Mask = typename V::mask_type;
template <class V>
inline constexpr
    typename V::value_type epsilon = std::numeric_limits<typename V::value_type>::epsilon();
template <class V>
inline constexpr bool single = sizeof(typename V::value_type) == 4;
/// Its square is still a normal number.
template <class V>
inline constexpr typename V::value_type tiny = single<V> ? 1e-18F : 1e-150;

/// The same number in every lane.
template <class V>
V number(double x) {
    return V(static_cast<typename V::value_type>(x));
}

/// Always inline: a call would pass lanes through memory.
template <class V>
[[gnu::always_inline]] inline V select(const Mask<V>& condition, const V& yes, const V& no) {
    V out = no;
    where(condition, out) = yes;
    return out;
}

/// A complex number in lanes.
template <class V>
struct Cx {
    V re{}, im{};

    friend Cx operator+(const Cx& a, const Cx& b) { return {a.re + b.re, a.im + b.im}; }
    friend Cx operator-(const Cx& a, const Cx& b) { return {a.re - b.re, a.im - b.im}; }
    friend Cx operator-(const Cx& a) { return {-a.re, -a.im}; }
    friend Cx operator*(const Cx& a, const Cx& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend Cx operator*(const V& a, const Cx& b) { return {a * b.re, a * b.im}; }
    friend Cx operator*(const Cx& a, const V& b) { return {a.re * b, a.im * b}; }
    friend Cx operator+(const V& a, const Cx& b) { return {a + b.re, b.im}; }
    friend Cx operator+(const Cx& a, const V& b) { return {a.re + b, a.im}; }
    friend Cx operator-(const Cx& a, const V& b) { return {a.re - b, a.im}; }
};

template <class V>
V lift(const V& a, const V*) {
    return a;
}
template <class V>
Cx<V> lift(const V& a, const Cx<V>*) {
    return {a, V(0)};
}
/// A real number as T.
template <class T, class V>
T as(const V& a) {
    return lift(a, static_cast<const T*>(nullptr));
}

template <class V>
V real_part(const V& a) {
    return a;
}
template <class V>
V real_part(const Cx<V>& a) {
    return a.re;
}
template <class V>
V imag_part(const V&) {
    return V(0);
}
template <class V>
V imag_part(const Cx<V>& a) {
    return a.im;
}

template <class V>
V norm(const V& a) {
    return a * a;
}
template <class V>
V norm(const Cx<V>& a) {
    return a.re * a.re + a.im * a.im;
}
template <class V>
V reciprocal(const V& a) {
    return V(1) / a;
}
template <class V>
Cx<V> reciprocal(const Cx<V>& a) {
    const V f = V(1) / norm(a);
    return {a.re * f, -a.im * f};
}
template <class V>
V size(const V& a) {
    return abs(a);
}
template <class V>
V size(const Cx<V>& a) {
    return abs(a.re) + abs(a.im);
}

template <class V>
[[gnu::always_inline]] inline Cx<V> select(const Mask<V>& condition, const Cx<V>& yes, const Cx<V>& no) {
    return {select<V>(condition, yes.re, no.re), select<V>(condition, yes.im, no.im)};
}
template <class V>
[[gnu::always_inline]] inline Vector3<V> select(const Mask<V>& condition, const Vector3<V>& yes, const Vector3<V>& no) {
    return {select<V>(condition, yes.x, no.x), select<V>(condition, yes.y, no.y),
            select<V>(condition, yes.z, no.z)};
}

/// a^2 + b^2; for complex pairs as a product, which stays precise where it vanishes.
template <class V>
V square(const V& a, const V& b) {
    return a * a + b * b;
}
template <class V>
Cx<V> square(const Cx<V>& a, const Cx<V>& b) {
    return Cx<V>{a.re - b.im, a.im + b.re} * Cx<V>{a.re + b.im, a.im - b.re};
}

template <class V>
V norm_of(const Vector3<V>& v) {
    return norm(v.x) + norm(v.y) + norm(v.z);
}
template <class V>
V norm_of(const Vector3<Cx<V>>& v) {
    return norm(v.x) + norm(v.y) + norm(v.z);
}
template <class V>
Vector3<V> unit(const Vector3<V>& v) {
    return (V(1) / sqrt(norm_of(v))) * v;
}
template <class V>
Vector3<V> real_part(const Vector3<Cx<V>>& v) {
    return {v.x.re, v.y.re, v.z.re};
}
template <class V>
Vector3<V> imag_part(const Vector3<Cx<V>>& v) {
    return {v.x.im, v.y.im, v.z.im};
}
template <class V>
Vector3<V> real_part(const Vector3<V>& v) {
    return v;
}
template <class V>
Vector3<V> imag_part(const Vector3<V>&) {
    return {V(0), V(0), V(0)};
}

/// sign * root where a square is positive, sign * i * root elsewhere (if T is complex), for the
/// root of its size.
template <class V>
V signed_root(const Mask<V>&, const V& root, const V& sign, const V*) {
    return sign * root;
}
template <class V>
Cx<V> signed_root(const Mask<V>& positive, const V& root, const V& sign, const Cx<V>*) {
    const V signed_size = sign * root;
    return {select<V>(positive, signed_size, V(0)), select<V>(positive, V(0), signed_size)};
}

}  // namespace icespar::lanes
