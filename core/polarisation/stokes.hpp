// Polarised radiance and its relation to fields. Signs and frames: docs/conventions.md.
#pragma once

#include <complex>

namespace icespar {

/// Polarised radiance seen by a receiver who looks back at the source: x to the right, y up,
/// z along the travel of the light. S1 > 0 lies along x, S2 > 0 along +45 degrees (towards y),
/// S3 > 0 is right circular, that is, clockwise in time for that receiver.
struct Stokes {
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0;

    friend constexpr Stokes operator+(const Stokes& a, const Stokes& b) {
        return {a.s0 + b.s0, a.s1 + b.s1, a.s2 + b.s2, a.s3 + b.s3};
    }
    friend constexpr Stokes operator*(double f, const Stokes& a) {
        return {f * a.s0, f * a.s1, f * a.s2, f * a.s3};
    }
    friend constexpr bool operator==(const Stokes&, const Stokes&) = default;
    constexpr Stokes& operator+=(const Stokes& b) { return *this = *this + b; }
};

/// Stokes vector of the field Re[(ex, ey) exp(-i w t)]; the other sign of i would flip S3.
[[nodiscard]] inline Stokes stokes_from_field(std::complex<double> ex, std::complex<double> ey) {
    const std::complex<double> xy = ex * std::conj(ey);
    return {std::norm(ex) + std::norm(ey), std::norm(ex) - std::norm(ey), 2 * xy.real(),
            2 * xy.imag()};
}

}  // namespace icespar
