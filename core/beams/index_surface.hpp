// Where the wave vectors of an isotropic or uniaxial stone end.
#pragma once

#include <cmath>

#include "crystal/medium.hpp"

namespace icespar {

/// k . k = eps_o for the ordinary wave (the only one of an isotropic stone), k . eps k = eps_o
/// eps_e for the extraordinary one.
struct IndexSurface {
    double eps_o, eps_e;
    Vec3 axis;
    double swell_o, swell_e;  ///< half the derivatives of eps_o and eps_e with colour

    explicit IndexSurface(const MediumCore& medium, double dn_o = 0, double dn_e = 0)
        : eps_o(medium.n_o * medium.n_o),
          eps_e(medium.n_e * medium.n_e),
          axis(medium.axis),
          swell_o(medium.n_o * dn_o),
          swell_e(medium.n_e * dn_e) {}

    /// The direction of energy, not normalised: linear in k.
    [[nodiscard]] Vec3 energy(const Vec3& k, bool extraordinary) const {
        if (!extraordinary) return k;
        return eps_o * k + ((eps_e - eps_o) * dot(k, axis)) * axis;
    }

    /// The wave vector along k.
    [[nodiscard]] Vec3 onto(const Vec3& k, bool extraordinary) const {
        const double value = extraordinary ? eps_e * eps_o : eps_o;
        return std::sqrt(value / dot(energy(k, extraordinary), k)) * k;
    }

    /// Half the change with colour of the surface's equation at k, which is dk . S.
    [[nodiscard]] double swelling(const Vec3& k, bool extraordinary) const {
        if (!extraordinary) return swell_o;
        const double along = dot(k, axis), along2 = along * along;
        return swell_o * (eps_e - dot(k, k) + along2) + swell_e * (eps_o - along2);
    }
};

}  // namespace icespar
