// Faces that do not mix s and p: both media isotropic, or crystals with their axis along the normal
// (Fresnel 1823). There o is s and e is p.
#pragma once

#include "interface/lane_face.hpp"

namespace icespar::lanes {

/// A medium whose axis, if any, is the normal.
template <class V, bool uniaxial>
struct Upright {
    const MediumLanes<V>& medium;
    std::array<V, 2> sense;  ///< E of s or o, p or e, along the isotropic s or p
    std::array<V, 2> q2;     ///< squared normal components
    V kt2;

    /// From the ordinary wave's squared normal component.
    Upright(const MediumLanes<V>& m, const Vector3<V>& normal, const V& q_o2)
        : medium(m), sense{V(1), V(1)}, q2{q_o2, q_o2}, kt2(m.eps_o - q_o2) {
        if constexpr (uniaxial) {
            const V up = copysign(V(1), dot(normal, m.axis));
            sense = {-up, up};
            q2[1] = m.eps_o * m.inverse_e * ((m.n_e - m.n_o) * (m.n_e + m.n_o) + q_o2);
        }
    }

    /// n^2 |E|^2 of the p or e wave with n H = 1.
    [[nodiscard]] V field2() const {
        const V& o = medium.inverse_o;
        if constexpr (!uniaxial) {
            return o * select<V>(q2[1] > V(0), V(1), V(1) - V(2) * o * q2[1]);
        }
        return abs(q2[1]) * o * o + kt2 * medium.inverse_e * medium.inverse_e;
    }
};

/// What one incident wave sends into the waves of its own kind; the others get nothing.
template <class V>
struct Fresnel {
    Mask<V> propagating;
    V root, r_real, r_imag, t_real, t_imag, r_power, t_power;

    /// q1: normal component of the incident wave. `second`: p or e.
    template <bool from_uniaxial, bool to_uniaxial>
    Fresnel(const Upright<V, from_uniaxial>& near, const Upright<V, to_uniaxial>& far, const V& q1,
            bool second) {
        const V q22 = far.q2[second];
        propagating = q22 > V(0);
        root = sqrt(abs(q22));
        const V a = second ? far.medium.eps_o * q1 : q1,
                b = second ? near.medium.eps_o * root : root;
        const V both = a + b;
        const V inverse = V(1) / select<V>(propagating, both * both, a * a + b * b);
        r_real = (a - b) * both * inverse;
        r_imag = select<V>(propagating, V(0), V(-2) * a * b * inverse);
        const V field2 = second ? far.field2() / near.field2() : V(1);
        const V size = V(2) * a * inverse * near.sense[second] * far.sense[second] *
                       (second ? sqrt(field2) : V(1));
        t_real = size * select<V>(propagating, both, a);
        t_imag = select<V>(propagating, V(0), -size * b);
        r_power = r_real * r_real + r_imag * r_imag;
        t_power = select<V>(propagating, V(4) * a * b * inverse, V(0));
    }
};

}  // namespace icespar::lanes
