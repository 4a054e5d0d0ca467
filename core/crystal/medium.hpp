// A transparent medium at one wavelength.
#pragma once

#include "math/vec3.hpp"

namespace icespar {

/// Isotropic (n_o = n_e) or uniaxial. Dielectric tensor n_o^2 I + (n_e^2 - n_o^2) axis axis^T.
struct Medium {
    double n_o = 1, n_e = 1;
    Vec3 axis{0, 0, 1};  ///< unit optic axis
    bool birefringent = false;

    /// Throws Error unless n is finite and positive.
    static Medium isotropic(double n);
    /// Throws Error unless both indices are finite and positive and the axis is finite and not
    /// zero. n_e = n_o is allowed and stays uniaxial: its modes are o and e.
    static Medium uniaxial(double n_o, double n_e, const Vec3& axis);
};

}  // namespace icespar
