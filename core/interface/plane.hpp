// Two-dimensional spaces of tangential fields, and eigenvectors within them; T is real or complex.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "interface/berreman.hpp"

namespace icespar {

inline constexpr std::size_t two = 2;

/// Two columns that span a space, made the identity on the two rows where they are most
/// independent.
template <class T>
struct Plane {
    std::array<Vector4<T>, 2> columns;
    std::array<std::size_t, 2> pivot{};

    Plane() = default;

    explicit Plane(const std::array<Vector4<T>, 2>& given) : columns(given) {
        Real<T> best = -1;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const Real<T> s =
                    size2(columns[0][i] * columns[1][j] - columns[0][j] * columns[1][i]);
                if (s > best) {
                    best = s;
                    pivot = {j, i};
                }
            }
        }
        const auto [j, i] = pivot;
        const T a = columns[0][j], b = columns[1][j], c = columns[0][i], d = columns[1][i];
        const T det = a * d - b * c;
        const T ia = d / det, ib = -b / det, ic = -c / det, id = a / det;
        for (std::size_t r = 0; r < 4; ++r) {
            const T x = columns[0][r], y = columns[1][r];
            columns[0][r] = x * ia + y * ic;
            columns[1][r] = x * ib + y * id;
        }
        columns[0][j] = columns[1][i] = T(1);
        columns[0][i] = columns[1][j] = T(0);
    }
};

/// The two most independent columns of a matrix of rank 2.
template <class T>
std::array<Vector4<T>, 2> spanning_columns(const Matrix4<T>& m) {
    std::size_t row = 0, column = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            if (size2(m[i][j]) > size2(m[row][column])) row = i, column = j;
        }
    }
    Real<T> best = -1;
    std::size_t second = column;
    for (std::size_t j = 0; j < 4; ++j) {
        if (j == column) continue;
        const T factor = m[row][j] / m[row][column];
        Real<T> left = 0;
        for (std::size_t i = 0; i < 4; ++i) left += size2(T(m[i][j] - factor * m[i][column]));
        if (left > best) best = left, second = j;
    }
    std::array<Vector4<T>, 2> out;
    const T factor = m[row][second] / m[row][column];
    for (std::size_t i = 0; i < 4; ++i) {
        out[0][i] = m[i][column];
        out[1][i] = i == row ? T(0) : T(m[i][second] - factor * m[i][column]);
    }
    return out;
}

template <class T>
T dot4(const Vector4<T>& a, const Vector4<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

template <class T>
struct Eigen2 {
    std::array<T, 2> value;
    std::array<std::array<T, 2>, 2> vector;
};

/// Hermitian 2 x 2 matrix [a b; conj(b) d].
template <class T>
Eigen2<T> hermitian_eigen(Real<T> a, const T& b, Real<T> d) {
    using R = Real<T>;
    const R half = (a - d) / 2, mean = (a + d) / 2, off = std::sqrt(size2(b));
    const R radius = std::sqrt(half * half + off * off);
    const T turn = off > 0 ? T(b / off) : T(1);
    // (cos, sin) of half the angle whose tangent is off / half, without cancellation.
    R c = 1, s = 0;
    if (radius > 0) {
        const R large = std::sqrt((1 + std::abs(half) / radius) / 2);
        const R small = off / (2 * radius * large);
        c = half >= 0 ? large : small;
        s = half >= 0 ? small : large;
    }
    Eigen2<T> out;
    out.value = {T(mean + radius), T(mean - radius)};
    out.vector = {{{turn * c, T(s)}, {T(-s) * turn, T(c)}}};
    return out;
}

/// Any 2 x 2 matrix [a b; c d].
template <class R>
Eigen2<std::complex<R>> general_eigen(const std::complex<R>& a, const std::complex<R>& b,
                                      const std::complex<R>& c, const std::complex<R>& d) {
    using C = std::complex<R>;
    const C half = R(0.5) * (a - d), mean = R(0.5) * (a + d);
    const C root = std::sqrt(half * half + b * c);
    Eigen2<C> out;
    for (std::size_t i = 0; i < 2; ++i) {
        const C r = i == 0 ? root : -root;
        // Columns of the adjoint: (b, r - half) and (r + half, c).
        const C up = r + half, down = r - half;
        out.value[i] = mean + r;
        out.vector[i] = std::norm(up) >= std::norm(down) ? std::array{up, c} : std::array{b, down};
        if (std::norm(out.vector[i][0]) + std::norm(out.vector[i][1]) == 0) {
            out.vector[i] = {C(i == 0 ? 1 : 0), C(i == 0 ? 0 : 1)};
        }
    }
    return out;
}

}  // namespace icespar
