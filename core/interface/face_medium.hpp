// A transparent isotropic or uniaxial medium seen from a face: its four waves in closed form.
#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "interface/crystal_frame.hpp"
#include "interface/face_frame.hpp"

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

/// H = k x E with k = (K, 0, q).
template <class T>
void set_fields(LocalWave<T>& wave, double kt, const T& q, const Vector3<T>& E) {
    wave.q = q;
    wave.E = E;
    wave.hx = -q * E.y;
    wave.hy = q * E.x - kt * E.z;
}

/// A medium seen from a face, for a fixed tangential wave number.
struct FaceMedium {
    bool birefringent;
    double kt, eps_o, eps_e;
    CrystalFrame crystal;
    double q_o2;  ///< squared normal component of the ordinary (or isotropic) wave
    double w2;    ///< squared normal energy flow W = N . eps k of the extraordinary wave

    FaceMedium(const Medium& m, const FaceFrame& face)
        : birefringent(m.birefringent),
          kt(face.kt),
          eps_o(m.n_o * m.n_o),
          eps_e(m.n_e * m.n_e),
          crystal(m.birefringent ? face.to_face(m.axis) : Vec3{0, 0, 1}),
          q_o2((m.n_o - kt) * (m.n_o + kt)),
          w2(1) {
        if (!birefringent) return;
        if (q_o2 > 0) {
            w2 = flow_squared(std::sqrt(q_o2));
        } else {
            const double ct = kt * crystal.c.x;
            w2 = eps_o * (eps_g() * (eps_e - kt * kt) - delta() * ct * ct);
        }
    }

    [[nodiscard]] double delta() const { return eps_e - eps_o; }
    [[nodiscard]] double eps_g() const { return eps_o + delta() * crystal.c.z * crystal.c.z; }
    [[nodiscard]] double cross_term() const { return delta() * crystal.c.z * kt * crystal.c.x; }
    [[nodiscard]] bool all_real() const { return q_o2 > 0 && w2 > 0; }
    [[nodiscard]] bool all_evanescent() const { return q_o2 <= 0 && w2 <= 0; }

    /// Squared |k across the axis| for a real normal component q.
    [[nodiscard]] double across_squared(double q) const {
        const double ka = kt * crystal.a.x + q * crystal.a.z,
                     kb = kt * crystal.b.x + q * crystal.b.z;
        return ka * ka + kb * kb;
    }

    /// W^2 from the ordinary wave's q. The e-wave's quadratic is eg q^2 + 2 X q + C = 0 with
    /// X = de cn ct, and W = eg q_e + X its root; at q_o it leaves -de |k_o across axis|^2. So the
    /// two waves stay at their true distance where both are grazing and nearly touch.
    [[nodiscard]] double flow_squared(double q_o) const {
        const double w = eps_g() * q_o + cross_term();
        return w * w + eps_g() * delta() * across_squared(q_o);
    }

    /// The incident wave knows its own normal component better than its tangential one does.
    void adopt(double kn, bool extraordinary) {
        if (!extraordinary) {
            q_o2 = kn * kn;
            if (birefringent) w2 = flow_squared(kn);
        } else {
            const double w = eps_g() * kn + cross_term();
            w2 = w * w;
            // k_e . k_e = eo + |k_e across axis|^2 (1 - eo / ee).
            q_o2 = kn * kn - across_squared(kn) * delta() / eps_e;
        }
    }
};

template <class T>
T signed_root(double square, double sign) {
    if constexpr (std::is_same_v<T, double>) {
        return sign * std::sqrt(square);
    } else {
        return square > 0 ? T(sign * std::sqrt(square)) : T(0, sign * std::sqrt(-square));
    }
}

/// The two waves of a medium that carry energy along sign * N (or decay that way): s, p or o, e.
template <class T>
std::array<LocalWave<T>, 2> waves_towards(const FaceMedium& m, double sign) {
    std::array<LocalWave<T>, 2> out;
    const double K = m.kt;
    const T q = signed_root<T>(m.q_o2, sign);
    out[0].propagating = m.q_o2 > 0;
    out[0].flux = out[0].propagating ? sign * std::sqrt(m.q_o2) : 0;
    if (!m.birefringent) {
        out[1].propagating = out[0].propagating;
        out[1].flux = out[0].flux;
        set_fields(out[0], K, q, Vector3<T>{T(0), T(1), T(0)});
        const double norm = norm2(q, T(K));
        set_fields(out[1], K, q, Vector3<T>{-q / norm, T(0), T(K / norm)});
        return out;
    }
    const CrystalFrame& f = m.crystal;
    const T ka = K * f.a.x + q * f.a.z, kb = K * f.b.x + q * f.b.z;
    set_fields(out[0], K, q, f.ordinary(ka, kb));

    const T w = signed_root<T>(m.w2, sign);
    const T q_direct = (w - m.cross_term()) / m.eps_g();
    // q_e - q_o = (ee - eo) |k_o across axis|^2 / D keeps the modes' difference exact where they
    // meet.
    const T D = m.eps_g() * q + w + m.cross_term();
    const bool same_kind = (m.q_o2 > 0) == (m.w2 > 0);
    const T step = same_kind && std::abs(D) > 1e-150 ? T(m.delta() * (ka * ka + kb * kb) / D)
                                                     : T(q_direct - q);
    T q_e = q_direct;
    if constexpr (std::is_same_v<T, double>) {
        q_e = q + step;
    }
    const Vector3<T> E = f.extraordinary(T(ka + step * f.a.z), T(kb + step * f.b.z),
                                         T(K * f.c.x + q_e * f.c.z), m.eps_o, m.eps_e);
    const double norm = length(E);
    out[1].propagating = m.w2 > 0;
    // For E of energy density 1 the energy flow is eps k / (eo ee).
    out[1].flux =
        out[1].propagating ? sign * std::sqrt(m.w2) / (m.eps_o * m.eps_e * norm * norm) : 0;
    set_fields(out[1], K, q_e, E / norm);
    return out;
}

/// Where o and e are both evanescent they can coincide (k across the axis of the form (1, +-i)).
/// The combination of the incoming pair that stays independent there, scaled by the vanishing
/// component: with w = ka + i kb, v = ka - i kb and e+- = a +- i b, the ordinary field is (v e+ - w
/// e-) / 2.
inline LocalWave<Complex> independent_partner(const FaceMedium& m, double sign) {
    const CrystalFrame& f = m.crystal;
    const double K = m.kt;
    const Complex q = signed_root<Complex>(m.q_o2, sign), flow = signed_root<Complex>(m.w2, sign);
    const Complex q_e = (flow - m.cross_term()) / m.eps_g();
    const Complex D = m.eps_g() * q + flow + m.cross_term();
    const Complex ka = K * f.a.x + q * f.a.z, kb = K * f.b.x + q * f.b.z;
    Complex small = ka + i_unit * kb, large = ka - i_unit * kb;
    Complex turn = i_unit;
    if (std::abs(small) > std::abs(large)) {
        std::swap(small, large);
        turn = -i_unit;
    }
    // N and the fields in the basis that belongs to `turn`; the mirrored case is the conjugate
    // basis.
    const Complex n_small = f.a.z + turn * f.b.z, n_large = f.a.z - turn * f.b.z;
    const CVec3 e_small = complexified(f.a) - turn * complexified(f.b);
    const CVec3 e_large = complexified(f.a) + turn * complexified(f.b);
    const Complex step_over_small = m.delta() * large / D;
    const Complex step = step_over_small * small;
    const Complex omega = 1.0 + step_over_small * n_small;
    const Complex large_e = large + step * n_large;
    const Complex kc = K * f.c.x + q_e * f.c.z;
    const Complex g = kc / m.eps_o * large_e / large;
    const CVec3 partner = (-0.5 * kc / m.eps_o * (omega + large_e / large)) * e_small +
                          (omega * large_e / m.eps_e) * complexified(f.c);
    const CVec3 ordinary = 0.5 * (large * e_large - small * e_small);
    // H = k_e x partner - g (step / small) N x ordinary.
    LocalWave<Complex> out;
    set_fields(out, K, q_e, partner);
    const Complex lag = g * step_over_small;
    out.hx += lag * ordinary.y;
    out.hy -= lag * ordinary.x;
    return out;
}

}  // namespace icespar
