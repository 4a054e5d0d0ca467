// A homogeneous medium at one wavelength: isotropic, uniaxial or biaxial, absorbing or not, and
// uniaxial with optical activity.
#pragma once

#include <array>

#include "math/symmetric.hpp"
#include "math/vec3.hpp"

namespace icespar {

enum class Symmetry { isotropic, uniaxial, biaxial };

/// What the waves of a face need to know of their medium once they are found.
struct MediumCore {
    double n_o = 1, n_e = 1;
    Vec3 axis{0, 0, 1};         ///< unit optic axis of a uniaxial medium
    bool birefringent = false;  ///< uniaxial or biaxial
    Symmetry symmetry = Symmetry::isotropic;
    bool absorbing = false;
    double kappa_o = 0, kappa_e = 0;
    double gyration = 0, gyration_along = 0;

    [[nodiscard]] bool active() const { return gyration != 0 || gyration_along != 0; }
    /// Transparent, not active, and isotropic or uniaxial: the closed forms apply.
    [[nodiscard]] bool plain() const {
        return !absorbing && symmetry != Symmetry::biaxial && !active();
    }
    [[nodiscard]] Complex eps_o() const { return Complex(n_o, kappa_o) * Complex(n_o, kappa_o); }
    [[nodiscard]] Complex eps_e() const { return Complex(n_e, kappa_e) * Complex(n_e, kappa_e); }
    /// H of a wave with the given k and E.
    [[nodiscard]] CVec3 magnetic_field(const CVec3& k, const CVec3& E) const;
};

/// Constitutive relations D = eps E + i alpha H, B = H - i alpha E, with eps complex symmetric
/// (Im eps >= 0 absorbs) and alpha real symmetric, 0 without optical activity. They are reciprocal,
/// and conserve energy when eps is real.
///
/// eps is n_o^2 I + (n_e^2 - n_o^2) axis axis^T with complex indices n + i kappa, unless the medium
/// is biaxial: then it is mean I + deviation, which need not have principal axes when it absorbs.
///
/// alpha = gyration (I - axis axis^T) + gyration_along axis axis^T. Along the axis only `gyration`
/// acts (E and H lie across it): the circular waves have n_L = n_o + gyration, n_R = n_o -
/// gyration, so that light is turned by rho = 180 deg (n_L - n_R) / wavelength = 360 deg gyration /
/// wavelength, clockwise for the receiver when gyration > 0 (dextrorotatory). In terms of the
/// gyration tensor G of crystal optics (Nye 1985, ch. XIV), G33 ~ 2 gyration and G11 ~ gyration +
/// gyration_along.
struct Medium : MediumCore {
    using MediumCore::active;

    Complex mean = 1;                     ///< biaxial media only
    ComplexTensor deviation{};            ///< biaxial media only, precise where it is small
    std::array<double, 3> n_principal{};  ///< biaxial: rising; of Re eps when it absorbs
    std::array<Vec3, 3> principal{};      ///< biaxial: unit axes of n_principal

    /// Throws Error unless n is finite and positive.
    static Medium isotropic(double n);
    /// n + i kappa; throws Error unless n > 0, kappa >= 0 and both are finite.
    static Medium isotropic(Complex n);
    /// Throws Error unless both indices are finite and positive and the axis is finite and not
    /// zero. n_e = n_o is allowed and stays uniaxial: its modes are o and e.
    static Medium uniaxial(double n_o, double n_e, const Vec3& axis);
    static Medium uniaxial(Complex n_o, Complex n_e, const Vec3& axis);
    /// Principal indices in any order along `first`, `second` and their vector product. Throws
    /// Error for axes that are not perpendicular within 1e-6; equal indices are allowed and the
    /// medium stays biaxial: its modes are fast and slow.
    static Medium biaxial(const std::array<Complex, 3>& n, const Vec3& first, const Vec3& second);
    /// A uniaxial crystal that turns the polarisation of light along its axis by
    /// `rotation_deg_per_mm` at `wavelength_nm`, positive: clockwise for the receiver.
    /// `g_ratio` = G11 / G33 (quartz: about -0.5); 0: no rotation across the axis.
    static Medium active(double n_o, double n_e, const Vec3& axis, double rotation_deg_per_mm,
                         double wavelength_nm, double g_ratio = 0);
    /// The same by its dimensionless constants, as stated above: below the indices in magnitude.
    static Medium gyrotropic(double n_o, double n_e, const Vec3& axis, double gyration,
                             double gyration_along);
    /// Isotropic, uniaxial or biaxial as the tensor (rows) is, within roundings of its elements.
    /// Throws Error when it is not finite, not symmetric, gives energy to light (a negative
    /// eigenvalue of Im eps) or, where it does not absorb, is not positive definite.
    static Medium from_tensor(const std::array<std::array<Complex, 3>, 3>& eps);

    [[nodiscard]] ComplexTensor permittivity() const;

    /// The same symmetry, hence names of modes, and the same numbers; an axis and its opposite are
    /// the same axis.
    friend bool operator==(const Medium& a, const Medium& b);
};

/// Principal indices of a biaxial medium along its `principal` axes. Where Re eps and Im eps have
/// no common axes they are those of Re eps, without absorption; the permittivity says all.
[[nodiscard]] std::array<Complex, 3> principal_indices(const Medium& medium);

/// The directions of equal indices for both waves (binormals).
struct OpticAxes {
    Vec3 first, second;
    double two_v_gamma;  ///< angle between the two that the axis of n_gamma halves, 0 .. pi
};

/// Uniaxial media have twice the same axis. Of an absorbing biaxial medium, the axes of Re eps.
/// Throws Error for isotropic media.
[[nodiscard]] OpticAxes optic_axes(const Medium& medium);

}  // namespace icespar
