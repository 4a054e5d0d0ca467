// The plane-wave boundary problem in sixty digits, straight from Maxwell's equations by Berreman's
// 4 x 4 matrix. It shares no code with the interface core and serves as its truth.
#pragma once

#include <complex>
#include <string>

#include "support/precise.hpp"

namespace reference {

using Double3 = std::array<double, 3>;
using RealVector = std::array<Real, 3>;
using Vector = std::array<Cplx, 3>;
using Tensor = std::array<Row<3>, 3>;

/// A dielectric tensor and the names of its modes: s, p | o, e | fast, slow.
struct Material {
    enum class Modes { s_p, o_e, fast_slow };
    Tensor epsilon{};
    Modes modes = Modes::s_p;
    RealVector axis{};  ///< unit; o_e only
    Cplx epsilon_o = 1;
    std::array<std::array<Real, 3>, 3> alpha{};  ///< D = epsilon E + i alpha H, B = H - i alpha E

    static Material isotropic(double n);
    /// The axis is normalised in sixty digits.
    static Material uniaxial(double n_o, double n_e, const Double3& axis);
    /// Any symmetric complex tensor; positive imaginary parts absorb.
    static Material general(const std::array<std::array<std::complex<double>, 3>, 3>& epsilon);
};

struct PlaneWave {
    Vector k, E, H;   ///< E of unit Hermitian norm, H = k x E + i alpha E
    RealVector flow;  ///< Re(E x H*)
    bool propagating = true;
    Cplx amplitude = 1;
    Real power = 1;  ///< part of the incident normal flux; 0 when evanescent

    RealVector ray() const;
};

struct Solution {
    PlaneWave incident;
    std::array<PlaneWave, 2> reflected, transmitted;
    Vector reflected_field, transmitted_field;  ///< total E at the face for incident E of norm 1
    Real normal_flux;                           ///< of the incident wave
};

/// The wave of mode 0 or 1 along the wave normal `direction`; s and p refer to `face_normal`.
PlaneWave wave_along(const Material&, int mode, const Double3& direction,
                     const Double3& face_normal);

/// `normal` points from `from` to `to`. Vectors are normalised in sixty digits. Where a mode's own
/// polarisation is 0/0 (s at normal incidence, o along the axis) a perpendicular pair is chosen.
Solution solve(const Material& from, const Material& to, const Double3& normal,
               const Double3& direction, int mode);

/// Largest residual of k x E = H, k x H = -epsilon E, |E| = 1 over the five waves, and of
/// continuity of tangential E and H.
Real residual(const Solution&, const Material& from, const Material& to, const Double3& normal);

/// Vector algebra shared with the self-checks.
RealVector unit(const Double3& v);
Real dot(const RealVector& a, const RealVector& b);
Cplx dot(const Vector& a, const Vector& b);  ///< bilinear
Vector cross(const Vector& a, const Vector& b);
Vector complexified(const RealVector& v);
Vector times(const Tensor& t, const Vector& v);
Vector combine(const Cplx& a, const Vector& x, const Cplx& b, const Vector& y);  ///< a x + b y
Real hermitian_norm(const Vector& v);

}  // namespace reference
