// Berreman's matrix: q psi = D psi for psi = (Ex, Ey, Hx, Hy) of the waves with k = (K, 0, q)
// (Berreman 1972), with the z components eliminated.
#pragma once

#include <array>

#include "interface/quartic.hpp"
#include "math/symmetric.hpp"

namespace icespar {

template <class T>
using Vector4 = std::array<T, 4>;
template <class T>
using Matrix4 = std::array<std::array<T, 4>, 4>;

/// A medium in the face's frame: D = eps E + i alpha H, B = H - i alpha E.
template <class T>
struct LocalMedium {
    SymmetricTensor<T> eps;
    SymmetricTensor<Real<T>> alpha{};
    bool active = false;
};

template <class T>
struct Berreman {
    Matrix4<T> d{};
    Vector4<T> ez{};  ///< Ez = ez . psi

    Berreman(const LocalMedium<T>& m, const T& K) {
        const auto& e = m.eps;
        if constexpr (is_complex<T>) {
            if (m.active) {
                with_activity(m, K);
                return;
            }
        }
        ez = {-e.xz / e.zz, -e.yz / e.zz, T(0), -K / e.zz};
        for (std::size_t j = 0; j < 4; ++j) {
            d[0][j] = K * ez[j];
            d[2][j] = -e.yz * ez[j];
            d[3][j] = e.xz * ez[j];
        }
        d[0][3] += T(1);
        d[1][2] = T(-1);
        d[2][0] -= e.xy;
        d[2][1] += K * K - e.yy;
        d[3][0] += e.xx;
        d[3][1] += e.xy;
    }

    /// Characteristic polynomial, by the traces of powers (Newton's identities).
    [[nodiscard]] Quartic<T> characteristic(const Matrix4<T>& square) const {
        using R = Real<T>;
        T t1{}, t2{}, t3{}, t4{};
        for (std::size_t i = 0; i < 4; ++i) {
            t1 += d[i][i];
            t2 += square[i][i];
            for (std::size_t j = 0; j < 4; ++j) {
                t3 += square[i][j] * d[j][i];
                t4 += square[i][j] * square[j][i];
            }
        }
        return {-t1, (t1 * t1 - t2) / R(2), -(t1 * t1 * t1 - R(3) * t1 * t2 + R(2) * t3) / R(6),
                (t1 * t1 * t1 * t1 - R(6) * t1 * t1 * t2 + R(3) * t2 * t2 + R(8) * t1 * t3 -
                 R(6) * t4) /
                    R(24)};
    }

private:
    void with_activity(const LocalMedium<T>& m, const T& K) {
        const auto& e = m.eps;
        const auto& a = m.alpha;
        const T i(0, 1);
        // B = H - i alpha E and D = eps E + i alpha H; Bz = K Ey and Dz = -K Hy give Ez and Hz.
        const Vector4<T> b_known{i * a.xz, K + i * a.yz, T(0), T(0)};
        const Vector4<T> d_known{-e.xz, -e.yz, -i * a.xz, -K - i * a.yz};
        Vector4<T> hz;
        for (std::size_t j = 0; j < 4; ++j) {
            ez[j] = (d_known[j] - i * a.zz * b_known[j]) / (e.zz - a.zz * a.zz);
            hz[j] = b_known[j] + i * a.zz * ez[j];
        }
        const Vector4<T> bx{-i * a.xx, -i * a.xy, T(1), T(0)}, by{-i * a.xy, -i * a.yy, T(0), T(1)};
        const Vector4<T> dx{e.xx, e.xy, i * a.xx, i * a.xy}, dy{e.xy, e.yy, i * a.xy, i * a.yy};
        for (std::size_t j = 0; j < 4; ++j) {
            d[0][j] = K * ez[j] + by[j] - i * a.yz * ez[j];
            d[1][j] = -(bx[j] - i * a.xz * ez[j]);
            d[2][j] = K * hz[j] - (dy[j] + e.yz * ez[j] + i * a.yz * hz[j]);
            d[3][j] = dx[j] + e.xz * ez[j] + i * a.xz * hz[j];
        }
    }
};

template <class T>
Matrix4<T> product(const Matrix4<T>& a, const Matrix4<T>& b) {
    Matrix4<T> out{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t j = 0; j < 4; ++j) out[i][j] += a[i][k] * b[k][j];
        }
    }
    return out;
}

/// D^2 + b D + c: its columns span the waves that are not roots of q^2 + b q + c, its rows
/// annihilate those that are.
template <class T>
Matrix4<T> evaluate(const Quadratic<T>& f, const Matrix4<T>& d, const Matrix4<T>& square) {
    Matrix4<T> out = square;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) out[i][j] += f.b * d[i][j];
        out[i][i] += f.c;
    }
    return out;
}

}  // namespace icespar
