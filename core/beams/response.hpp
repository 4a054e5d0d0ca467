// What a sensor sees of light that comes in along a beam: all four Stokes components, or intensity
// alone.
#pragma once

#include <array>

#include "interface/interface.hpp"
#include "math/vec3.hpp"
#include "polarisation/mueller.hpp"
#include "polarisation/stokes.hpp"

namespace icespar {

/// Amplitudes that a face turns s and p into: [outgoing s or p][incident s or p].
using Transfer = std::array<std::array<Complex, 2>, 2>;

/// What a face does to the s and p that come from an isotropic medium.
[[nodiscard]] inline Transfer transfer(const Interface& face, bool transmitted) {
    Transfer out;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t m = 0; m < 2; ++m) out[i][m] = face.flux_amplitude(m, transmitted, i);
    }
    return out;
}

/// For pictures of the polarisation: what unit waves launched from the sensor with polarisations x
/// and y have become, as in a Branch.
struct FullResponse {
    static constexpr bool stokes = true;

    /// Along a ray of an isotropic medium: amplitudes [sensor axis][s or p].
    struct Pair {
        std::array<std::array<Complex, 2>, 2> a{{{1, 0}, {0, 1}}};

        [[nodiscard]] double power() const {
            return 0.5 * (std::norm(a[0][0]) + std::norm(a[0][1]) + std::norm(a[1][0]) +
                          std::norm(a[1][1]));
        }
        /// What it sees of unpolarised light of radiance 1.
        [[nodiscard]] Stokes unpolarised() const {
            const double xx = std::norm(a[0][0]) + std::norm(a[0][1]),
                         yy = std::norm(a[1][0]) + std::norm(a[1][1]);
            const Complex xy = a[0][0] * std::conj(a[1][0]) + a[0][1] * std::conj(a[1][1]);
            return {0.5 * (xx + yy), 0.5 * (xx - yy), xy.real(), xy.imag()};
        }
        /// Of light whose Stokes vector refers to s and -p.
        [[nodiscard]] Stokes seen(const Stokes& light) const {
            const double ss = 0.5 * (light.s0 + light.s1), pp = 0.5 * (light.s0 - light.s1);
            const Complex sp{-0.5 * light.s2, -0.5 * light.s3};
            const auto coherency = [&](std::size_t i, std::size_t j) {
                return ss * a[i][0] * std::conj(a[j][0]) + pp * a[i][1] * std::conj(a[j][1]) +
                       sp * a[i][0] * std::conj(a[j][1]) +
                       std::conj(sp) * a[i][1] * std::conj(a[j][0]);
            };
            const double xx = coherency(0, 0).real(), yy = coherency(1, 1).real();
            const Complex xy = coherency(0, 1);
            return {xx + yy, xx - yy, 2 * xy.real(), 2 * xy.imag()};
        }
        /// From a sensor behind an analyser.
        [[nodiscard]] static Pair behind(const Jones& analyser) { return {analyser.m}; }
        /// On axes turned so that the new s, of any length, has components (c, d) along the old s
        /// and p.
        [[nodiscard]] Pair turned(double c, double d) const {
            const double size = std::sqrt(c * c + d * d);
            c /= size;
            d /= size;
            Pair out;
            for (std::size_t i = 0; i < 2; ++i) {
                out.a[i] = {c * a[i][0] + d * a[i][1], c * a[i][1] - d * a[i][0]};
            }
            return out;
        }
        [[nodiscard]] Pair times(const Complex& s, const Complex& p) const {
            return {{{{s * a[0][0], p * a[0][1]}, {s * a[1][0], p * a[1][1]}}}};
        }
        [[nodiscard]] Pair through(const Transfer& j) const {
            Pair out;
            for (std::size_t i = 0; i < 2; ++i) {
                out.a[i] = {j[0][0] * a[i][0] + j[0][1] * a[i][1],
                            j[1][0] * a[i][0] + j[1][1] * a[i][1]};
            }
            return out;
        }
        void scale(double power_factor) {
            const double f = std::sqrt(power_factor);
            for (auto& row : a) row = {f * row[0], f * row[1]};
        }
    };

    /// Along a mode of a crystal.
    struct Single {
        std::array<Complex, 2> a;

        [[nodiscard]] double power() const { return 0.5 * (std::norm(a[0]) + std::norm(a[1])); }
        [[nodiscard]] Single times(const Complex& f) const { return {{f * a[0], f * a[1]}}; }
        [[nodiscard]] Pair leaving(const Complex& s, const Complex& p) const {
            return {{{{s * a[0], p * a[0]}, {s * a[1], p * a[1]}}}};
        }
        void scale(double power_factor) {
            const double f = std::sqrt(power_factor);
            a = {f * a[0], f * a[1]};
        }
    };
    [[nodiscard]] static Single entering(const Pair& r, const Complex& s, const Complex& p) {
        return {{s * r.a[0][0] + p * r.a[0][1], s * r.a[1][0] + p * r.a[1][1]}};
    }
};

/// For pictures of the intensity: one row of the Mueller product, as the Hermitian form sum over
/// both sensor axes of a_i conj(a_j).
struct IntensityResponse {
    static constexpr bool stokes = false;

    struct Pair {
        double ss = 1, pp = 1;
        Complex sp = 0;

        [[nodiscard]] double power() const { return 0.5 * (ss + pp); }
        [[nodiscard]] Stokes unpolarised() const { return {power(), 0, 0, 0}; }
        [[nodiscard]] Stokes seen(const Stokes& light) const {
            const double mixed = light.s2 * sp.real() - light.s3 * sp.imag();
            return {0.5 * (light.s0 * (ss + pp) + light.s1 * (ss - pp)) - mixed, 0, 0, 0};
        }
        [[nodiscard]] static Pair behind(const Jones& analyser) {
            const auto& [x, y] = analyser.m;
            return {std::norm(x[0]) + std::norm(y[0]), std::norm(x[1]) + std::norm(y[1]),
                    x[0] * std::conj(x[1]) + y[0] * std::conj(y[1])};
        }
        [[nodiscard]] Pair turned(double c, double d) const {
            const double share = 1 / (c * c + d * d), re = sp.real();
            const double cc = share * c * c, dd = share * d * d, cd = share * c * d;
            const double mixed = 2 * cd * re;
            return {cc * ss + dd * pp + mixed,
                    dd * ss + cc * pp - mixed,
                    {cd * (pp - ss) + (cc - dd) * re, sp.imag()}};
        }
        [[nodiscard]] Pair times(const Complex& s, const Complex& p) const {
            return {std::norm(s) * ss, std::norm(p) * pp, s * std::conj(p) * sp};
        }
        [[nodiscard]] Pair through(const Transfer& j) const {
            const auto form = [&](const std::array<Complex, 2>& u,
                                  const std::array<Complex, 2>& v) {
                return ss * u[0] * std::conj(v[0]) + pp * u[1] * std::conj(v[1]) +
                       sp * u[0] * std::conj(v[1]) + std::conj(sp) * u[1] * std::conj(v[0]);
            };
            return {form(j[0], j[0]).real(), form(j[1], j[1]).real(), form(j[0], j[1])};
        }
        void scale(double power_factor) {
            ss *= power_factor;
            pp *= power_factor;
            sp *= power_factor;
        }
    };

    struct Single {
        double whole = 0;  ///< sum over both sensor axes

        [[nodiscard]] double power() const { return 0.5 * whole; }
        [[nodiscard]] Single times(const Complex& f) const { return {std::norm(f) * whole}; }
        [[nodiscard]] Pair leaving(const Complex& s, const Complex& p) const {
            return {std::norm(s) * whole, std::norm(p) * whole, whole * s * std::conj(p)};
        }
        void scale(double power_factor) { whole *= power_factor; }
    };
    [[nodiscard]] static Single entering(const Pair& r, const Complex& s, const Complex& p) {
        return {std::norm(s) * r.ss + std::norm(p) * r.pp + 2 * (s * std::conj(p) * r.sp).real()};
    }
};

/// Light without polarisation: s and p averaged anew at every face, as programs do that know
/// intensities alone. For comparison with them, in isotropic stones.
struct AveragedResponse {
    static constexpr bool stokes = false;

    struct Pair {
        double whole = 1;

        [[nodiscard]] double power() const { return whole; }
        [[nodiscard]] Stokes unpolarised() const { return {whole, 0, 0, 0}; }
        [[nodiscard]] Pair turned(double, double) const { return *this; }
        [[nodiscard]] Pair times(const Complex& s, const Complex& p) const {
            return {0.5 * (std::norm(s) + std::norm(p)) * whole};
        }
        void scale(double power_factor) { whole *= power_factor; }
    };
};

}  // namespace icespar
