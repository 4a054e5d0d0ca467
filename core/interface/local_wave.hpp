// The waves of one side of a face, as the matching sees them.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "interface/face_medium.hpp"

namespace icespar {

inline constexpr Complex i_unit{0, 1};

/// A wave as the matching sees it: tangential fields, in the face's frame.
template <class T>
struct LocalWave {
    T q{};
    Vector3<T> E;
    T hx{}, hy{};
    double flux = 0;  ///< along +N, 0 when evanescent
    bool propagating = true;
};

template <class A, class B>
auto pairing(const LocalWave<A>& a, const LocalWave<B>& b) {
    return a.E.x * b.hy - a.E.y * b.hx + b.E.x * a.hy - b.E.y * a.hx;
}

/// H = k x E with k = (K, 0, q).
template <class T>
void set_fields(LocalWave<T>& wave, double kt, const T& q, const Vector3<T>& E) {
    wave.q = q;
    wave.E = E;
    wave.hx = -q * E.y;
    wave.hy = q * E.x - kt * E.z;
}

template <class T>
T signed_root(double square, double sign) {
    if constexpr (std::is_same_v<T, double>) {
        return sign * std::sqrt(square);
    } else {
        return square > 0 ? T(sign * std::sqrt(square)) : T(0, sign * std::sqrt(-square));
    }
}

/// Normal components of a crystal's pair towards sign * N. `step` = q_e - q_o for given squared
/// |k_o across the axis| a2: exact where the modes meet, by (ee - eo) a2 / D.
template <class T>
struct CrystalPair {
    T q_o, flow, divisor, q_e_direct;
    bool same_kind;

    CrystalPair(const FaceMedium& m, double sign)
        : q_o(signed_root<T>(m.q_o2, sign)),
          flow(signed_root<T>(m.w2, sign)),
          divisor(m.eps_g() * q_o + flow + m.cross_term()),
          q_e_direct((flow - m.cross_term()) / m.eps_g()),
          same_kind((m.q_o2 > 0) == (m.w2 > 0)) {}

    [[nodiscard]] T step(const FaceMedium& m, const T& across_squared) const {
        return std::abs(divisor) > 1e-150 ? T(m.delta() * across_squared / divisor)
                                          : T(q_e_direct - q_o);
    }
};

/// o and e from k_o's components (ka, kb) across the axis.
template <class T>
std::array<LocalWave<T>, 2> crystal_waves(const FaceMedium& m, const CrystalPair<T>& pair,
                                          double sign, const T& ka, const T& kb, const T& step) {
    std::array<LocalWave<T>, 2> out;
    const CrystalFrame& f = m.crystal;
    out[0].propagating = m.q_o2 > 0;
    out[0].flux = out[0].propagating ? sign * std::sqrt(m.q_o2) : 0;
    set_fields(out[0], m.kt, pair.q_o, f.ordinary(ka, kb));
    T q_e = pair.q_e_direct;
    if constexpr (std::is_same_v<T, double>) q_e = pair.q_o + step;
    const Vector3<T> E = f.extraordinary(T(ka + step * f.a.z), T(kb + step * f.b.z),
                                         T(m.kt * f.c.x + q_e * f.c.z), m.eps_o, m.eps_e);
    const double norm = length(E);
    out[1].propagating = m.w2 > 0;
    // For E of energy density 1 the energy flow is eps k / (eo ee).
    out[1].flux =
        out[1].propagating ? sign * std::sqrt(m.w2) / (m.eps_o * m.eps_e * norm * norm) : 0;
    set_fields(out[1], m.kt, q_e, E / norm);
    return out;
}

/// The two waves of a medium that carry energy along sign * N (or decay that way): s, p or o, e.
template <class T>
std::array<LocalWave<T>, 2> waves_towards(const FaceMedium& m, double sign) {
    const double K = m.kt;
    if (m.birefringent) {
        const CrystalPair<T> pair(m, sign);
        const CrystalFrame& f = m.crystal;
        const T ka = K * f.a.x + pair.q_o * f.a.z, kb = K * f.b.x + pair.q_o * f.b.z;
        return crystal_waves<T>(m, pair, sign, ka, kb, pair.step(m, ka * ka + kb * kb));
    }
    std::array<LocalWave<T>, 2> out;
    const T q = signed_root<T>(m.q_o2, sign);
    for (auto& wave : out) {
        wave.propagating = m.q_o2 > 0;
        wave.flux = wave.propagating ? sign * std::sqrt(m.q_o2) : 0;
    }
    set_fields(out[0], K, q, Vector3<T>{T(0), T(1), T(0)});
    const double norm = norm2(q, T(K));
    set_fields(out[1], K, q, Vector3<T>{-q / norm, T(0), T(K / norm)});
    return out;
}

/// The incoming pair that belongs to an incident wave of a crystal. Close to the axis, where a wave
/// vector no longer says which way its field points, the given field E (in the face's frame) does.
template <class T>
std::array<LocalWave<T>, 2> incident_waves(const FaceMedium& m, const Vec3& E, double kn,
                                           bool extraordinary) {
    constexpr double close = 0.1, noise = 2e-15;
    const CrystalPair<T> pair(m, +1);
    const CrystalFrame& f = m.crystal;
    double ka = m.kt * f.a.x + kn * f.a.z, kb = m.kt * f.b.x + kn * f.b.z;
    const double kc = m.kt * f.c.x + kn * f.c.z;
    const double across = norm2(ka, kb);
    if (across < close * std::abs(kc)) {
        // The direction of k across the axis, but for its sign: E turned back for o, E for e.
        const double ea = dot(E, f.a), eb = dot(E, f.b);
        const double ua = extraordinary ? ea : -eb, ub = extraordinary ? eb : ea;
        const double size = norm2(ua, ub);
        if (size > 0) {
            // A vanishing k across the axis keeps its direction.
            const double along = ua * ka + ub * kb;
            const double forward =
                across > noise * std::abs(kc) ? along : (extraordinary ? -kc : 1.0);
            const double least = std::copysign(std::max(across, 1e-100), forward) / size;
            ka = least * ua;
            kb = least * ub;
        }
    }
    const double a2 = ka * ka + kb * kb;
    if (!extraordinary) {
        return crystal_waves<T>(m, pair, +1, T(ka), T(kb), pair.step(m, T(a2)));
    }
    // k_e . k_e = eo + |k_e across axis|^2 (1 - eo / ee) gives the step from the e side.
    const T sum = kn + pair.q_o;
    const T step = pair.same_kind && std::abs(sum) > std::abs(kn)
                       ? T(m.delta() * a2 / (m.eps_e * sum))
                       : T(kn - pair.q_o);
    return crystal_waves<T>(m, pair, +1, T(ka - step * f.a.z), T(kb - step * f.b.z), step);
}

/// Whether o and e, both evanescent, are close to becoming one wave: |k across axis . k across
/// axis| small against the squares of its parts.
inline bool merging(const FaceMedium& m, double sign) {
    constexpr double close = 0.3;
    if (!m.birefringent || !m.all_evanescent()) return false;
    const CrystalFrame& f = m.crystal;
    const Complex q = signed_root<Complex>(m.q_o2, sign);
    const Complex ka = m.kt * f.a.x + q * f.a.z, kb = m.kt * f.b.x + q * f.b.z;
    const double w = std::norm(ka + i_unit * kb), v = std::norm(ka - i_unit * kb);
    return std::min(w, v) < close * close * std::max(w, v);
}

/// Where o and e are both evanescent they can coincide (k across the axis of the form (1, +-i)).
/// This pair spans the same fields and stays independent there. With w = ka + i kb, v = ka - i kb
/// and e+- = a +- i b, the ordinary field is (v e+ - w e-) / 2, and the partner is the combination
/// of o and e in which the larger circular part cancels, divided by the component that vanishes:
///   ordinary = o_factor E_o,   small partner = e_factor E_e + mix ordinary.
struct MergedPair {
    LocalWave<Complex> ordinary, partner;
    Complex small, mix, o_factor;
    double e_factor, kt;

    MergedPair(const FaceMedium& m, double sign) : kt(m.kt) {
        const CrystalFrame& f = m.crystal;
        const CrystalPair<Complex> pair(m, sign);
        const Complex ka = m.kt * f.a.x + pair.q_o * f.a.z, kb = m.kt * f.b.x + pair.q_o * f.b.z;
        small = ka + i_unit * kb;
        Complex large = ka - i_unit * kb;
        Complex turn = i_unit;
        if (std::abs(small) > std::abs(large)) {
            std::swap(small, large);
            turn = -i_unit;
        }
        const Complex n_small = f.a.z + turn * f.b.z, n_large = f.a.z - turn * f.b.z;
        const CVec3 e_small = complexified(f.a) - turn * complexified(f.b);
        const CVec3 e_large = complexified(f.a) + turn * complexified(f.b);
        const Complex step_over_small = m.delta() * large / pair.divisor;
        const Complex omega = 1.0 + step_over_small * n_small;
        const Complex large_e = large + step_over_small * small * n_large;
        const Complex kc = m.kt * f.c.x + pair.q_e_direct * f.c.z;
        mix = kc / m.eps_o * large_e / large;
        const CVec3 o = 0.5 * (large * e_large - small * e_small);
        const CVec3 p = (-0.5 * kc / m.eps_o * (omega + large_e / large)) * e_small +
                        (omega * large_e / m.eps_e) * complexified(f.c);
        set_fields(ordinary, m.kt, pair.q_o, o);
        // H = k_e x partner - mix (q_e - q_o) / small N x ordinary.
        set_fields(partner, m.kt, pair.q_e_direct, p);
        const Complex lag = mix * step_over_small;
        partner.hx += lag * o.y;
        partner.hy -= lag * o.x;
        o_factor = -turn * norm2(ka, kb);
        e_factor = length(small * p - mix * o);
        // Exactly merged: amplitudes as large as rounding lets them be told apart.
        const double least = 1e-16 * std::abs(large);
        if (std::abs(small) < least) small = least;
    }

    /// Amplitudes of the unit waves o and e from those of this pair. They grow without bound as the
    /// two waves merge; their sum does not.
    [[nodiscard]] std::array<Complex, 2> unit_amplitudes(const Complex& of_ordinary,
                                                         const Complex& of_partner) const {
        const Complex e = of_partner / small;
        return {o_factor * (of_ordinary + mix * e), e_factor * e};
    }
};

}  // namespace icespar
