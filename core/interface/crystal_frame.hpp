// The frame in which a uniaxial crystal's modes never become 0/0: two fixed directions across the
// optic axis, and the axis itself.
#pragma once

#include "crystal/medium.hpp"

namespace icespar {

/// Hermitian norm of a pair.
inline double norm2(double a, double b) { return std::sqrt(a * a + b * b); }
inline double norm2(const Complex& a, const Complex& b) {
    return std::sqrt(std::norm(a) + std::norm(b));
}

/// a^2 + b^2; for complex pairs as a product, which stays precise where it vanishes.
inline double square(double a, double b) { return a * a + b * b; }
inline Complex square(const Complex& a, const Complex& b) {
    const Complex turned{-b.imag(), b.real()};
    return (a + turned) * (a - turned);
}

struct CrystalFrame {
    Vec3 a, b, c;

    /// The frame of Duff et al. (2017), with components that are small as precise as the axis's
    /// own.
    explicit CrystalFrame(const Vec3& axis) : c(axis) {
        const double sign = std::copysign(1.0, c.z), f = 1 / (1 + std::abs(c.z));
        a = {f * (c.y * c.y + std::abs(c.z) * (1 + std::abs(c.z))), -f * c.x * c.y, -sign * c.x};
        b = {-sign * f * c.x * c.y, f * (c.x * c.x + std::abs(c.z) * (1 + std::abs(c.z))) * sign,
             -c.y};
    }

    /// Unit E along k x axis of the ordinary wave whose k has components (ka, kb) across the axis.
    template <class T>
    [[nodiscard]] Vector3<T> ordinary(T ka, T kb) const {
        const double m = norm2(ka, kb);
        if (m == 0) {
            ka = T(1);
            kb = T(0);
        } else {
            ka = ka / m;
            kb = kb / m;
        }
        return kb * a - ka * b;
    }

    /// E along axis - k (k . axis) / n_o^2 of the extraordinary wave with components (ka, kb) and
    /// kc of k. Divided by |k across axis|, it needs no small difference: the dispersion relation
    /// ka^2 + kb^2 = n_e^2 (1 - kc^2 / n_o^2) gives its part along the axis. Not normalised; for
    /// real k its energy density E . eps E is 1.
    template <class T>
    [[nodiscard]] Vector3<T> extraordinary(T ka, T kb, T kc, double eps_o, double eps_e) const {
        const double m = norm2(ka, kb);
        const T along = m == 0 ? T(0) : square(ka, kb) / m;
        if (m == 0) {
            ka = T(1);
            kb = T(0);
        } else {
            ka = ka / m;
            kb = kb / m;
        }
        const T across = -kc / eps_o;
        return (across * ka) * a + (across * kb) * b + (along / eps_e) * c;
    }
};

}  // namespace icespar
