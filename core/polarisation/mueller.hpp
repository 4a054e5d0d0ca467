// Mueller and Jones matrices: what an optical element does to polarised light. Signs and frames:
// docs/conventions.md (x right, y up, z towards the receiver; S3 > 0 clockwise for the receiver).
#pragma once

#include <array>
#include <cmath>
#include <complex>

#include "polarisation/stokes.hpp"

namespace icespar {

/// Acts on the field (Ex, Ey), Re[E exp(-i w t)].
struct Jones {
    std::array<std::array<std::complex<double>, 2>, 2> m{};

    friend Jones operator*(const Jones& a, const Jones& b) {
        Jones out;
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                out.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j];
            }
        }
        return out;
    }
};

/// Acts on Stokes vectors.
struct Mueller {
    std::array<std::array<double, 4>, 4> m{};

    friend Mueller operator*(const Mueller& a, const Mueller& b) {
        Mueller out;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                for (std::size_t j = 0; j < 4; ++j) out.m[i][j] += a.m[i][k] * b.m[k][j];
            }
        }
        return out;
    }
    friend Mueller operator+(const Mueller& a, const Mueller& b) {
        Mueller out;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) out.m[i][j] = a.m[i][j] + b.m[i][j];
        }
        return out;
    }
    friend Mueller operator*(double f, const Mueller& a) {
        Mueller out = a;
        for (auto& row : out.m) {
            for (double& x : row) x *= f;
        }
        return out;
    }
    friend Stokes operator*(const Mueller& a, const Stokes& s) {
        const auto row = [&](std::size_t i) {
            return a.m[i][0] * s.s0 + a.m[i][1] * s.s1 + a.m[i][2] * s.s2 + a.m[i][3] * s.s3;
        };
        return {row(0), row(1), row(2), row(3)};
    }
};

/// Turns the light's polarisation by `angle` from x towards y: an active rotation of the light,
/// such as a laevorotatory crystal makes; a dextrorotatory one turns by a negative angle.
[[nodiscard]] inline Jones jones_rotator(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{{{c, -s}, {s, c}}}};
}

/// Element `j` turned by `angle` from x towards y: R(angle) J R(-angle).
[[nodiscard]] inline Jones turned(const Jones& j, double angle) {
    return jones_rotator(angle) * j * jones_rotator(-angle);
}

/// `retardance` = k0 (n_slow - n_fast) length, the phase by which the slow field lies behind; fast
/// axis at `fast_axis` from x towards y.
[[nodiscard]] inline Jones jones_linear_retarder(double retardance, double fast_axis = 0) {
    const std::complex<double> i(0, 1);
    // In exp(-i w t) a longer optical path advances the phase by +.
    return turned(
        {{{{std::exp(-0.5 * i * retardance), 0.0}, {0.0, std::exp(0.5 * i * retardance)}}}},
        fast_axis);
}

/// Delays left circular light by `retardance` against right circular light; linear light turns
/// clockwise for the receiver by half of it when positive (dextrorotatory).
[[nodiscard]] inline Jones jones_circular_retarder(double retardance) {
    return jones_rotator(-0.5 * retardance);
}

/// Field transmissions along `axis` and across it.
[[nodiscard]] inline Jones jones_diattenuator(double along, double across, double axis = 0) {
    return turned({{{{along, 0.0}, {0.0, across}}}}, axis);
}

[[nodiscard]] inline Jones jones_polariser(double axis = 0) {
    return jones_diattenuator(1, 0, axis);
}

/// M_ij = 1/2 tr(sigma_i J sigma_j J^+) with sigma_0..3 = 1, diag(1, -1), [0 1; 1 0] and
/// [0 i; -i 0], the last for S3 = 2 Im(Ex Ey*) (Chipman, Lam & Young 2019, eq. 6.107, with our
/// sign).
[[nodiscard]] Mueller mueller_from_jones(const Jones& j);

/// The Jones matrix of a Mueller matrix that does not depolarise, with the phase that makes the
/// element of largest column-sum weight real and positive. Of a depolarising one, its largest
/// non-depolarising part (Cloude 1986: the first eigenvector of the coherency matrix).
[[nodiscard]] Jones jones_from_mueller(const Mueller& m);

/// Turns polarisations by `angle` from x towards y.
[[nodiscard]] Mueller rotator(double angle);
/// The element turned by `angle` from x towards y.
[[nodiscard]] inline Mueller turned(const Mueller& m, double angle) {
    return rotator(angle) * m * rotator(-angle);
}
/// As jones_linear_retarder (Collett 1993, eq. 5-27, with our sign of S3).
[[nodiscard]] Mueller linear_retarder(double retardance, double fast_axis = 0);
/// As jones_circular_retarder.
[[nodiscard]] Mueller circular_retarder(double retardance);
/// Power transmissions along `axis` and across it (Chipman, Lam & Young 2019, eq. 6.53).
[[nodiscard]] Mueller linear_diattenuator(double along, double across, double axis = 0);
[[nodiscard]] Mueller linear_polariser(double axis = 0);
/// Passes right circular light, or left circular light.
[[nodiscard]] Mueller circular_polariser(bool right);
/// Leaves S0 and scales S1 .. S3.
[[nodiscard]] Mueller depolariser(double a1, double a2, double a3);

/// The matrix of one fully polarised wave, such as the ordinary or the extraordinary ray: it takes
/// from the incoming light what `analyser` (the field amplitudes of this wave for x and y light)
/// accepts and sends out `out`, a fully polarised Stokes vector, normalised here to S0 = 1. Its
/// rank is 1.
[[nodiscard]] Mueller mueller_of_wave(std::complex<double> analyser_x,
                                      std::complex<double> analyser_y, const Stokes& out);

/// 0: ideal depolariser, 1: does not depolarise (Gil & Bernabeu 1986):
/// sqrt(sum M_ij^2 - M00^2) / (sqrt(3) M00).
[[nodiscard]] double depolarisation_index(const Mueller& m);

/// Ratio of difference to sum of the largest and least transmittance (Lu & Chipman 1996, eq. 11).
[[nodiscard]] double diattenuation(const Mueller& m);

/// Degree of polarisation that unpolarised light leaves with (Lu & Chipman 1996, eq. 13).
[[nodiscard]] double polarisance(const Mueller& m);

/// Polarised part of the light, 0 .. 1; 0 for no light.
[[nodiscard]] inline double degree_of_polarisation(const Stokes& s) {
    return s.s0 > 0 ? std::sqrt(s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3) / s.s0 : 0;
}
[[nodiscard]] inline double degree_of_linear_polarisation(const Stokes& s) {
    return s.s0 > 0 ? std::hypot(s.s1, s.s2) / s.s0 : 0;
}
/// Of the ellipse's long axis, from x towards y, -pi/2 .. pi/2.
[[nodiscard]] inline double angle_of_polarisation(const Stokes& s) {
    return 0.5 * std::atan2(s.s2, s.s1);
}
/// Short over long axis of the polarised part, -1 .. 1, positive when right-handed.
[[nodiscard]] inline double ellipticity(const Stokes& s) {
    return std::tan(0.5 * std::atan2(s.s3, std::hypot(s.s1, s.s2)));
}

/// Phase between two waves, 2 pi (n_slow - n_fast) length / wavelength, from their indices along a
/// common path. For waves that part, take the difference of the optical paths to the place where
/// they meet again.
[[nodiscard]] double retardance(double n_fast, double n_slow, double length_mm,
                                double wavelength_nm);

}  // namespace icespar
