// Light from air onto an optically active crystal, in sixty digits: the truth for active media.
#pragma once

#include "crystal/medium.hpp"
#include "support/maxwell_reference.hpp"

namespace reference {

/// D = eps E + i alpha H, B = H - i alpha E with alpha = across (1 - c c^T) + along c c^T.
struct ActiveCrystal {
    double n_o, n_e, across, along;
    Double3 axis;
};

struct ActiveSolution {
    std::array<Cplx, 2>
        q;  ///< normal components of the transmitted waves, the smaller Re q^2 first
    std::array<Real, 2> power;  ///< of the transmitted waves
    Real reflected_s, reflected_p;
};

/// s (mode 0) or p (mode 1) from index 1; `direction` and `normal` are unit to rounding.
ActiveSolution into_active(const ActiveCrystal& crystal, const Double3& normal,
                           const Double3& direction, int mode);

}  // namespace reference
