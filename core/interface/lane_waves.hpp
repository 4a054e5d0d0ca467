// The waves of one side of many faces: the formulas of face_frame, crystal_frame, face_medium and
// local_wave, with selections in place of branches.
#pragma once

#include <array>

#include "interface/lanes.hpp"

namespace icespar::lanes {

/// x along the tangential wave vector, y = normal x k direction.
template <class V>
struct Frame {
    Vector3<V> x, y, z;
    V kt, kn;

    Frame(const Vector3<V>& normal, const Vector3<V>& k) : z(normal), kn(dot(normal, k)) {
        const Vector3<V> once = k - kn * normal, t = once - dot(normal, once) * normal;
        const V kt2 = norm_of(t);
        const Mask<V> inclined =
            kt2 > number<V>(0.25) * norm_of(once) && kt2 > V(tiny<V> * tiny<V>);
        kt = select<V>(inclined, sqrt(kt2), V(0));
        const Vector3<V> along = (V(1) / select<V>(inclined, kt, V(1))) * t;
        const Vector3<V> straight = along - dot(normal, along) * normal;
        // A length this near to 1 is put right by the first term of its series.
        constexpr double near = single<V> ? 1e-4 : 1e-8;
        const V size2 = norm_of(straight);
        V f = number<V>(1.5) - number<V>(0.5) * size2;
        if (any_of(abs(size2 - V(1)) > number<V>(near))) f = V(1) / sqrt(size2);
        x = f * straight;
        if (!all_of(inclined)) x = select<V>(inclined, x, across(normal));
        y = cross(z, x);
    }

    /// any_perpendicular in lanes.
    static Vector3<V> across(const Vector3<V>& n) {
        const V sign = copysign(V(1), n.z), a = V(-1) / (sign + n.z);
        return {V(1) + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
    }
    [[nodiscard]] Vector3<V> to_face(const Vector3<V>& v) const {
        return {dot(x, v), dot(y, v), dot(z, v)};
    }
    template <class T>
    [[nodiscard]] Vector3<T> from_face(const Vector3<T>& v) const {
        return {v.x * x.x + v.y * y.x + v.z * z.x, v.x * x.y + v.y * y.y + v.z * z.y,
                v.x * x.z + v.y * y.z + v.z * z.z};
    }
};

template <class V>
struct Crystal {
    Vector3<V> a, b, c;

    explicit Crystal(const Vector3<V>& axis) : c(axis) {
        const V sign = copysign(V(1), c.z), up = abs(c.z), f = V(1) / (V(1) + up);
        const V diagonal = up * (V(1) + up);
        a = {f * (c.y * c.y + diagonal), -f * c.x * c.y, -sign * c.x};
        b = {-sign * f * c.x * c.y, sign * f * (c.x * c.x + diagonal), -c.y};
    }

    template <class T>
    [[nodiscard]] Vector3<T> combine(const T& u, const T& v, const T& w) const {
        return {u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y,
                u * a.z + v * b.z + w * c.z};
    }
    template <class T>
    [[nodiscard]] Vector3<T> ordinary(const T& ka, const T& kb) const {
        const V m2 = norm(ka) + norm(kb);
        const Mask<V> none = m2 == V(0);
        const V f = V(1) / sqrt(select<V>(none, V(1), m2));
        const T u = select(none, as<T>(V(1)), f * ka), v = f * kb;
        return {v * a.x - u * b.x, v * a.y - u * b.y, v * a.z - u * b.z};
    }
    /// Of energy density 1 for real k.
    template <class T>
    [[nodiscard]] Vector3<T> extraordinary(const T& ka, const T& kb, const T& kc,
                                           const V& inverse_o, const V& inverse_e) const {
        const V m2 = norm(ka) + norm(kb);
        const Mask<V> none = m2 == V(0);
        const V f = V(1) / sqrt(select<V>(none, V(1), m2));
        const T along = f * square(ka, kb), across = -inverse_o * kc;
        const T u = select(none, as<T>(V(1)), f * ka), v = f * kb;
        return combine<T>(across * u, across * v, inverse_e * along);
    }
};

template <class V>
struct MediumLanes {
    V n_o, n_e;
    Vector3<V> axis;
    V eps_o, eps_e, inverse_o, inverse_e;  ///< permittivities and their reciprocals

    MediumLanes(const V& ordinary, const V& extraordinary, const Vector3<V>& optic_axis)
        : n_o(ordinary),
          n_e(extraordinary),
          axis(optic_axis),
          eps_o(n_o * n_o),
          eps_e(n_e * n_e),
          inverse_o(V(1) / eps_o),
          inverse_e(V(1) / eps_e) {}
};

/// A medium seen from the face.
template <class V, bool uniaxial>
struct Seen {
    const MediumLanes<V>& medium;
    V kt, delta;
    Crystal<V> crystal;
    V q_o2, w2 = V(1), eps_g, cross_term;
    V root_o, root_e, inverse_g;  ///< of the sizes of q_o2 and w2
    Mask<V> real_o, real_e;       ///< positive q_o2 and w2

    Seen(const MediumLanes<V>& m, const Frame<V>& face)
        : medium(m),
          kt(face.kt),
          delta(m.eps_e - m.eps_o),
          crystal(uniaxial ? face.to_face(m.axis) : Vector3<V>{V(0), V(0), V(1)}),
          eps_g(m.eps_o + delta * crystal.c.z * crystal.c.z),
          cross_term(delta * crystal.c.z * kt * crystal.c.x) {}

    [[nodiscard]] V flow_squared(const V& q_o) const {
        const V w = eps_g * q_o + cross_term;
        const V ka = kt * crystal.a.x + q_o * crystal.a.z,
                kb = kt * crystal.b.x + q_o * crystal.b.z;
        return w * w + eps_g * delta * (ka * ka + kb * kb);
    }
    /// The medium of the incident wave, from the normal component of that.
    void adopt(const V& kn, bool extraordinary) {
        q_o2 = kn * kn;
        if (!uniaxial) {
        } else if (!extraordinary) {
            w2 = flow_squared(kn);
        } else {
            const V w = eps_g * kn + cross_term;
            w2 = w * w;
            const V ka = kt * crystal.a.x + kn * crystal.a.z,
                    kb = kt * crystal.b.x + kn * crystal.b.z;
            q_o2 -= (ka * ka + kb * kb) * delta * medium.inverse_e;
        }
        take_roots();
    }
    /// The other medium, from the squared normal component of its ordinary wave.
    void complete(const V& ordinary_q2) {
        q_o2 = ordinary_q2;
        if constexpr (uniaxial) {
            w2 = flow_squared(sqrt(abs(q_o2)));
            const Mask<V> evanescent = !(q_o2 > V(0));
            if (any_of(evanescent)) w2 = select<V>(evanescent, flow_squared_without(), w2);
        }
        take_roots();
    }
    /// Where the ordinary wave is evanescent.
    [[nodiscard]] V flow_squared_without() const {
        const Vector3<V>& c = crystal.c;
        const V tilt = c.y * c.y + c.z * c.z;
        return medium.eps_o * (q_o2 * (medium.eps_o + delta * (c.x * c.x + c.z * c.z)) +
                               delta * (medium.eps_o * tilt + delta * c.z * c.z));
    }
    void take_roots() {
        real_o = q_o2 > V(0);
        root_o = sqrt(abs(q_o2));
        if constexpr (uniaxial) {
            real_e = w2 > V(0);
            root_e = sqrt(abs(w2));
            inverse_g = V(1) / eps_g;
        } else {
            real_e = real_o;
        }
    }
    [[nodiscard]] Mask<V> all_real() const { return real_o && real_e; }
};

/// A wave as the matching sees it.
template <class T, class V>
struct FaceWave {
    T q;
    Vector3<T> E;
    T hx, hy;
    V flux;  ///< along the normal, 0 when evanescent

    void set(const V& kt, const T& normal_component, const Vector3<T>& field) {
        q = normal_component;
        E = field;
        hx = -(q * E.y);
        hy = q * E.x - kt * E.z;
    }
};
template <class T, class V>
using Pair = std::array<FaceWave<T, V>, 2>;

template <class S, class T, class V>
auto pairing(const FaceWave<S, V>& a, const FaceWave<T, V>& b) {
    return a.E.x * b.hy - a.E.y * b.hx + b.E.x * a.hy - b.E.y * a.hx;
}

/// Normal components of a crystal's pair; step = q_e - q_o.
template <class T, class V>
struct Roots {
    T q_o, flow, divisor, q_e;

    Roots(const Seen<V, true>& m, const V& sign)
        : q_o(signed_root(m.real_o, m.root_o, sign, static_cast<const T*>(nullptr))),
          flow(signed_root(m.real_e, m.root_e, sign, static_cast<const T*>(nullptr))),
          divisor(m.eps_g * q_o + flow + m.cross_term),
          q_e(m.inverse_g * (flow - m.cross_term)) {}

    [[nodiscard]] T step(const Seen<V, true>& m, const T& across_squared) const {
        const Mask<V> apart = size(divisor) > V(tiny<V>);
        const T safe = select(apart, divisor, as<T>(V(1)));
        return select(apart, m.delta * across_squared * reciprocal(safe), q_e - q_o);
    }
};

template <class T, class V>
Pair<T, V> crystal_waves(const Seen<V, true>& m, const Roots<T, V>& roots, const V& sign,
                         const T& ka, const T& kb, const T& step) {
    Pair<T, V> out;
    const Crystal<V>& f = m.crystal;
    out[0].flux = sign * select<V>(m.real_o, m.root_o, V(0));
    out[0].set(m.kt, roots.q_o, f.ordinary(ka, kb));
    T q_e = roots.q_e;
    if constexpr (std::is_same_v<T, V>) q_e = roots.q_o + step;
    const Vector3<T> E =
        f.extraordinary(ka + step * f.a.z, kb + step * f.b.z, q_e * f.c.z + m.kt * f.c.x,
                        m.medium.inverse_o, m.medium.inverse_e);
    const V inverse = V(1) / norm_of(E);
    out[1].flux = sign * select<V>(m.real_e, m.root_e, V(0)) * inverse *
                  (m.medium.inverse_o * m.medium.inverse_e);
    out[1].set(m.kt, q_e, sqrt(inverse) * E);
    return out;
}

/// The two waves that carry energy along sign * normal, or decay that way: s, p or o, e.
template <class T, class V, bool uniaxial>
Pair<T, V> waves_towards(const Seen<V, uniaxial>& m, const V& sign) {
    if constexpr (uniaxial) {
        const Roots<T, V> roots(m, sign);
        const Crystal<V>& f = m.crystal;
        const T ka = roots.q_o * f.a.z + m.kt * f.a.x, kb = roots.q_o * f.b.z + m.kt * f.b.x;
        return crystal_waves<T, V>(m, roots, sign, ka, kb, roots.step(m, ka * ka + kb * kb));
    } else {
        Pair<T, V> out;
        const T q = signed_root(m.real_o, m.root_o, sign, static_cast<const T*>(nullptr));
        out[0].flux = out[1].flux = sign * select<V>(m.real_o, m.root_o, V(0));
        const T zero = as<T>(V(0));
        out[0].set(m.kt, q, {zero, as<T>(V(1)), zero});
        const V f = V(1) / sqrt(norm(q) + m.kt * m.kt);
        out[1].set(m.kt, q, {-(f * q), zero, as<T>(f * m.kt)});
        return out;
    }
}

/// The incoming pair of a crystal to which the incident wave with unit field E belongs.
template <class T, class V>
Pair<T, V> incident_waves(const Seen<V, true>& m, const Vector3<V>& E, const V& kn,
                          bool extraordinary) {
    const V close = number<V>(0.1), noise(8 * epsilon<V>);
    const Roots<T, V> roots(m, V(1));
    const Crystal<V>& f = m.crystal;
    V ka = m.kt * f.a.x + kn * f.a.z, kb = m.kt * f.b.x + kn * f.b.z;
    const V kc = m.kt * f.c.x + kn * f.c.z, across = sqrt(ka * ka + kb * kb);
    const Mask<V> near = across < close * abs(kc);
    if (any_of(near)) {
        // The direction of k across the axis, but for its sign: E turned back for o, E for e.
        const V ea = dot(E, f.a), eb = dot(E, f.b);
        const V ua = extraordinary ? ea : -eb, ub = extraordinary ? eb : ea;
        const V length = sqrt(ua * ua + ub * ub);
        const Mask<V> given = near && length > V(0);
        const V forward =
            select<V>(across > noise * abs(kc), ua * ka + ub * kb, extraordinary ? -kc : V(1));
        const V least = copysign(max(across, V(tiny<V>)), forward) / select<V>(given, length, V(1));
        ka = select<V>(given, least * ua, ka);
        kb = select<V>(given, least * ub, kb);
    }
    const V a2 = ka * ka + kb * kb;
    const T ta = as<T>(ka), tb = as<T>(kb);
    if (!extraordinary) {
        return crystal_waves<T, V>(m, roots, V(1), ta, tb, roots.step(m, as<T>(a2)));
    }
    // k_e . k_e = eo + |k_e across axis|^2 (1 - eo / ee) gives the step from the e side.
    const T sum = roots.q_o + kn;
    const Mask<V> same = m.real_o == m.real_e && norm(sum) > kn * kn;
    const T safe = select(same, sum, as<T>(V(1)));
    const T step =
        select(same, (m.delta * a2 * m.medium.inverse_e) * reciprocal(safe), as<T>(kn) - roots.q_o);
    return crystal_waves<T, V>(m, roots, V(1), ta - step * f.a.z, tb - step * f.b.z, step);
}

}  // namespace icespar::lanes
