// Two-dimensional spaces of tangential fields, and eigenvectors within them; T is double or
// Complex.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "interface/berreman.hpp"

namespace icespar {

inline constexpr std::size_t two = 2;

template <class T>
double size2(const T& x) {
    if constexpr (std::is_same_v<T, double>) {
        return x * x;
    } else {
        return std::norm(x);
    }
}

template <class T>
T conjugate(const T& x) {
    if constexpr (std::is_same_v<T, double>) {
        return x;
    } else {
        return std::conj(x);
    }
}

template <class T>
double real_part(const T& x) {
    return std::real(x);
}

/// Two columns that span a space, made the identity on the two rows where they are most
/// independent.
template <class T>
struct Plane {
    std::array<Vector4<T>, 2> columns;
    std::array<std::size_t, 2> pivot{};

    Plane() = default;

    explicit Plane(const std::array<Vector4<T>, 2>& given) : columns(given) {
        double best = -1;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double s =
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
    double best = -1;
    std::size_t second = column;
    for (std::size_t j = 0; j < 4; ++j) {
        if (j == column) continue;
        const T factor = m[row][j] / m[row][column];
        double left = 0;
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
Eigen2<T> hermitian_eigen(double a, const T& b, double d) {
    const double half = 0.5 * (a - d), mean = 0.5 * (a + d), off = std::sqrt(size2(b));
    const double radius = std::sqrt(half * half + off * off);
    const T turn = off > 0 ? T(b / off) : T(1);
    // (cos, sin) of half the angle whose tangent is off / half, without cancellation.
    double c = 1, s = 0;
    if (radius > 0) {
        const double large = std::sqrt(0.5 * (1 + std::abs(half) / radius));
        const double small = 0.5 * off / (radius * large);
        c = half >= 0 ? large : small;
        s = half >= 0 ? small : large;
    }
    Eigen2<T> out;
    out.value = {T(mean + radius), T(mean - radius)};
    out.vector = {{{turn * c, T(s)}, {T(-s) * turn, T(c)}}};
    return out;
}

/// Any 2 x 2 matrix [a b; c d].
inline Eigen2<Complex> general_eigen(const Complex& a, const Complex& b, const Complex& c,
                                     const Complex& d) {
    const Complex half = 0.5 * (a - d), mean = 0.5 * (a + d);
    const Complex root = std::sqrt(half * half + b * c);
    Eigen2<Complex> out;
    for (std::size_t i = 0; i < 2; ++i) {
        const Complex r = i == 0 ? root : -root;
        // Columns of the adjoint: (b, r - half) and (r + half, c).
        const Complex up = r + half, down = r - half;
        out.value[i] = mean + r;
        out.vector[i] = std::norm(up) >= std::norm(down) ? std::array{up, c} : std::array{b, down};
        if (std::norm(out.vector[i][0]) + std::norm(out.vector[i][1]) == 0) {
            out.vector[i] = {Complex(i == 0 ? 1 : 0), Complex(i == 0 ? 0 : 1)};
        }
    }
    return out;
}

template <class T>
SymmetricTensor<T> cast(const ComplexTensor& t) {
    if constexpr (std::is_same_v<T, double>) {
        return real(t);
    } else {
        return t;
    }
}

template <class T>
T cast(const Complex& z) {
    if constexpr (std::is_same_v<T, double>) {
        return z.real();
    } else {
        return z;
    }
}

}  // namespace icespar
