// The boundary problem of many faces at once for one incident mode, by the method of interface.cpp.
#pragma once

#include "interface/lane_waves.hpp"

namespace icespar::lanes {

/// plane_wave in lanes.
template <class V, bool uniaxial>
struct Incident {
    Vector3<V> k, ray;
    Vector3<V> local;  ///< along k, in the crystal's frame: o and e by exactly the same direction

    Incident(const MediumLanes<V>& m, const Vector3<V>& direction, bool second, bool by_ray)
        : k(m.n_o * direction), ray(direction) {
        if constexpr (!uniaxial) return;
        const Crystal<V> f(m.axis);
        Vector3<V> d = direction;
        if (!second) {
            local = {dot(d, f.a), dot(d, f.b), dot(d, f.c)};
            return;
        }
        if (by_ray) {
            const V along = dot(direction, m.axis);
            d = m.inverse_o * direction + ((m.inverse_e - m.inverse_o) * along) * m.axis;
        }
        const V x = dot(d, f.a), y = dot(d, f.b), z = dot(d, f.c);
        const V scale = m.n_o * m.n_e / sqrt(m.eps_o * (x * x + y * y) + m.eps_e * z * z);
        local = {scale * x, scale * y, scale * z};
        k = scale * d;
        if (!by_ray) ray = unit(m.eps_o * k + ((m.eps_e - m.eps_o) * dot(k, m.axis)) * m.axis);
    }

    /// Unit E; `frame` is that of the face.
    [[nodiscard]] Vector3<V> field(const MediumLanes<V>& m, const Frame<V>& frame,
                                   bool second) const {
        if constexpr (!uniaxial) {
            return second ? cross(ray, frame.y) : frame.y;
        } else {
            const Crystal<V> f(m.axis);
            if (!second) return f.ordinary(local.x, local.y);
            return unit(f.extraordinary(local.x, local.y, local.z, m.inverse_o, m.inverse_e));
        }
    }
};

/// m x = rhs; a determinant that is all rounding is taken as that rounding.
template <class V, class T>
std::array<T, 2> solved(const std::array<std::array<T, 2>, 2>& m, const T& r0, const T& r1) {
    const T a = m[0][0] * m[1][1], b = m[0][1] * m[1][0];
    T det = a - b;
    const V least = V(epsilon<V> / 2) * (size(a) + size(b));
    const V safe = select<V>(least > V(0), least, V(tiny<V> * tiny<V>));
    det = select(size(det) > least, det, as<T>(safe));
    const T inverse = reciprocal(det);
    return {(r0 * m[1][1] - m[0][1] * r1) * inverse, (m[0][0] * r1 - r0 * m[1][0]) * inverse};
}

/// The outgoing waves of both sides and what the incident wave sends into them.
template <class T, class V>
struct Solution {
    Pair<T, V> reflected, transmitted;
    std::array<T, 2> r, t;
    std::array<V, 2> r_power, t_power;

    template <bool from_uniaxial, bool to_uniaxial>
    Solution(const Seen<V, from_uniaxial>& near, const Seen<V, to_uniaxial>& far,
             const Pair<T, V>& incident, std::size_t mode)
        : reflected(waves_towards<T>(near, V(-1))), transmitted(waves_towards<T>(far, V(1))) {
        const Pair<T, V> probe = waves_towards<T>(far, V(-1));
        std::array<std::array<T, 2>, 2> reflect, transmit;
        for (std::size_t j = 0; j < 2; ++j) {
            for (std::size_t i = 0; i < 2; ++i) {
                reflect[j][i] = pairing(probe[j], reflected[i]);
                transmit[j][i] = pairing(incident[j], transmitted[i]);
            }
        }
        const FaceWave<T, V>& in = incident[mode];
        const T self = pairing(in, in), zero = as<T>(V(0));
        r = solved<V>(reflect, -pairing(probe[0], in), -pairing(probe[1], in));
        t = solved<V>(transmit, mode == 0 ? self : zero, mode == 1 ? self : zero);
        const V per_flux = V(1) / in.flux;
        for (std::size_t i = 0; i < 2; ++i) {
            r_power[i] = norm(r[i]) * -reflected[i].flux * per_flux;
            t_power[i] = norm(t[i]) * transmitted[i].flux * per_flux;
        }
    }
};

/// Where o and e are both evanescent and close to becoming one wave: left to Interface.
template <class V>
Mask<V> merging(const Seen<V, true>& m, const V& sign) {
    const Crystal<V>& f = m.crystal;
    const Cx<V> q = signed_root(m.real_o, m.root_o, sign, static_cast<const Cx<V>*>(nullptr));
    const Cx<V> ka = q * f.a.z + m.kt * f.a.x, kb = q * f.b.z + m.kt * f.b.x;
    const V w = norm(Cx<V>{ka.re - kb.im, ka.im + kb.re}),
            v = norm(Cx<V>{ka.re + kb.im, ka.im - kb.re});
    const V close = number<V>(0.09);
    return !m.real_o && !m.real_e && min(w, v) < close * max(w, v);
}

}  // namespace icespar::lanes
