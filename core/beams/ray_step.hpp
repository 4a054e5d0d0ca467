// One step of rays in lanes: a search of the planes, then InnerFace's closed form.
#pragma once

#include "beams/ray_lanes.hpp"
#include "interface/lanes.hpp"

namespace icespar::lanes {

template <class V>
[[gnu::always_inline]] inline V row(const double* from) {
    return V(from, std::experimental::element_aligned);
}
template <class V>
[[gnu::always_inline]] inline Vector3<V> rows(const RayLanes::Row* from, int lane) {
    return {row<V>(from[0] + lane), row<V>(from[1] + lane), row<V>(from[2] + lane)};
}
template <class V>
[[gnu::always_inline]] inline void put(const V& v, double* to) {
    v.copy_to(to, std::experimental::element_aligned);
}
template <class V>
[[gnu::always_inline]] inline void put(const Vector3<V>& v, RayLanes::Row* to, int lane) {
    put(v.x, to[0] + lane);
    put(v.y, to[1] + lane);
    put(v.z, to[2] + lane);
}

/// The facet ahead, -1 if none, and the multiple of `flow` to it.
template <class V>
[[gnu::always_inline]] inline V facet_ahead(const RayStone& stone, const Vector3<V>& from,
                                            const Vector3<V>& flow, V& t) {
    // Distances are quotients gap / ahead, compared without dividing; the first is infinite. The
    // facet just left lies behind, as all do that light goes away from.
    struct Nearest {
        V gap = 1, ahead = 0, place = -1;
    };
    const auto look = [&](int i, const V& number, Nearest& nearest) {
        const V nx = stone.x[i], ny = stone.y[i], nz = stone.z[i];
        const V a = nx * flow.x + ny * flow.y + nz * flow.z;
        const V g = max(((stone.distance[i] - nx * from.x) - ny * from.y) - nz * from.z, V(0));
        const Mask<V> nearer = g * nearest.ahead < nearest.gap * a;
        where(nearer, nearest.gap) = g;
        where(nearer, nearest.ahead) = a;
        where(nearer, nearest.place) = number;
    };
    // Runs side by side, so that no comparison waits for the one before.
    Nearest even, odd;
    V number = 0;
    for (int i = 0; i < stone.planes; i += 2) {
        look(i, number, even);
        look(i + 1, number + V(1), odd);
        number += 2;
    }
    const Mask<V> nearer = odd.gap * even.ahead < even.gap * odd.ahead;
    where(nearer, even.gap) = odd.gap;
    where(nearer, even.ahead) = odd.ahead;
    where(nearer, even.place) = odd.place;
    t = even.gap / even.ahead;
    return even.place;
}

/// Tangential fields of a wave times the tangential wave number, in the face's frame.
template <class V>
struct TangentialField {
    V q, ex, ey, hy;
};
template <class V>
[[gnu::always_inline]] inline TangentialField<V> tangential(const Vector3<V>& E, const V& q,
                                                            const Vector3<V>& t, const V& kt2,
                                                            const Vector3<V>& y,
                                                            const Vector3<V>& normal) {
    const V ex = dot(E, t);
    return {q, ex, dot(E, y), q * ex - kt2 * dot(E, normal)};
}

/// As in beams/carry.hpp.
template <class V>
[[gnu::always_inline]] inline Vector3<V> fanned(const Vector3<V>& fan, const Vector3<V>& normal,
                                                const Vector3<V>& flow, const V& swell) {
    return fan + ((swell - dot(flow, fan)) / dot(flow, normal)) * normal;
}

template <class V, bool spectral>
[[gnu::always_inline]] inline void step(const RayStone& stone, double threshold, RayLanes& rays,
                                        int lane) {
    const V delicate = stone.delicate;
    const V eps_o = stone.eps_o, eps_e = stone.eps_e, excess = stone.eps_e - stone.eps_o, one = 1,
            zero = 0;
    const Vector3<V> axis{stone.axis[0], stone.axis[1], stone.axis[2]};
    const Vector3<V> k = rows<V>(rays.k, lane), field = rows<V>(rays.field, lane);
    const Mask<V> extraordinary = row<V>(rays.extraordinary + lane) > 0;

    const V along = dot(k, axis);
    const Vector3<V> flow = select<V>(extraordinary, eps_o * k + (excess * along) * axis, k);
    V distance;
    const Vector3<V> from = rows<V>(rays.position, lane);
    const V facet = facet_ahead(stone, from, flow, distance);
    put(from + distance * flow, rays.position, lane);
    put(facet, rays.left + lane);
    Vector3<V> normal;
    for (std::size_t i = 0; i < V::size(); ++i) {
        const auto f = static_cast<int>(facet[i]);
        if (f < 0) continue;
        normal.x[i] = stone.x[f];
        normal.y[i] = stone.y[f];
        normal.z[i] = stone.z[f];
    }

    const V kn = dot(normal, k);
    const Vector3<V> t = k - kn * normal, y = cross(normal, t);
    const V kt2 = dot(t, t), tc = dot(t, axis), nc = dot(normal, axis);
    const V beyond2 = one - kt2, o2 = eps_o - kt2;
    const V a = eps_o + excess * nc * nc, b = excess * tc * nc;
    const V e2 = b * b - a * (eps_o * kt2 + excess * tc * tc - eps_o * eps_e);
    const V q_o = select<V>(extraordinary, -sqrt(max(o2, zero)), -kn);
    const V q_e = select<V>(extraordinary, -2 * b / a - kn, -(b + sqrt(max(e2, zero))) / a);
    const V along_o = tc + q_o * nc, along_e = tc + q_e * nc;
    const Vector3<V> k_o = t + q_o * normal, k_e = t + q_e * normal;
    const V across_o2 = eps_o - along_o * along_o;
    const Vector3<V> E_long = axis - (along_e / eps_o) * k_e;
    const V E_long2 = dot(E_long, E_long);
    const Vector3<V> E_o = (one / sqrt(across_o2)) * cross(k_o, axis),
                     E_e = (one / sqrt(E_long2)) * E_long;
    const V flux_in = kn - dot(field, normal) * dot(field, k);
    const V flux_e = dot(E_e, normal) * dot(E_e, k_e) - q_e;
    const auto in = tangential<V>(field, kn, t, kt2, y, normal),
               o = tangential<V>(E_o, q_o, t, kt2, y, normal),
               e = tangential<V>(E_e, q_e, t, kt2, y, normal);

    // Beyond the face H_x = -q E_y and E_x = q H_y, q being imaginary in total reflection.
    const Mask<V> passes = beyond2 > 0;
    const V root = sqrt(abs(beyond2));
    const Cx<V> q{select<V>(passes, root, zero), select<V>(passes, zero, root)};
    const auto first = [&](const TangentialField<V>& w) {
        return Cx<V>{(q.re - w.q) * w.ey, q.im * w.ey};
    };
    const auto second = [&](const TangentialField<V>& w) {
        return Cx<V>{w.ex - q.re * w.hy, -q.im * w.hy};
    };
    const Cx<V> m_a = first(o), m_b = first(e), m_c = second(o), m_d = second(e);
    const Cx<V> x_in = first(in), y_in = second(in), ad = m_a * m_d, bc = m_b * m_c, det = ad - bc;
    // Of some grazing waves the other mode cannot follow: all of it stays what it is.
    const Mask<V> o_good = o2 >= delicate && across_o2 >= delicate,
                  e_good = e2 >= delicate && E_long2 >= delicate, total = beyond2 <= -delicate;
    const Mask<V> o_alone = total && !extraordinary && o_good && e2 <= -delicate,
                  e_alone = total && extraordinary && e_good && o2 <= -delicate;
    const Mask<V> both = abs(beyond2) >= delicate && o_good && e_good && flux_in >= delicate &&
                         flux_e >= delicate && size(det) > delicate * (size(ad) + size(bc));
    const Mask<V> fine = facet >= 0 && kt2 >= delicate && (both || o_alone || e_alone);
    const Cx<V> inverse = -reciprocal(det);
    const Cx<V> r_o = (x_in * m_d - m_b * y_in) * inverse,
                r_e = (m_a * y_in - x_in * m_c) * inverse;
    const V weight = row<V>(rays.weight + lane);
    const V share = weight / flux_in;
    const V w_o = select<V>(both, -q_o * share * norm(r_o), select<V>(o_alone, weight, zero)),
            w_e = select<V>(both, flux_e * share * norm(r_e), select<V>(e_alone, weight, zero));
    const V out_s = in.ey + r_o.re * o.ey + r_e.re * e.ey,
            out_p = in.hy + r_o.re * o.hy + r_e.re * e.hy;
    const V through = root * share / kt2 * (out_s * out_s + out_p * out_p);
    put(select<V>(fine && passes, through, zero), rays.passed + lane);
    const Vector3<V> k_out = t + root * normal;
    put(k_out, rays.out, lane);
    put(out_s, rays.out_s + lane);
    put(-out_p, rays.out_p + lane);

    const V stays = w_o + w_e;
    const V chance = row<V>(rays.chance + lane);
    const V survival = min(stays / V(threshold), row<V>(rays.most + lane));
    const Mask<V> as_e = chance * stays < survival * w_e;
    const Vector3<V> k_on = select<V>(as_e, k_e, k_o);
    if constexpr (spectral) {
        const Vector3<V> fan = rows<V>(rays.fan, lane);
        put(fanned<V>(fan, normal, k_out, zero), rays.out_fan, lane);
        const V along_e2 = along_e * along_e;
        const V swell_e =
            stone.swell_o * (eps_e - dot(k_e, k_e) + along_e2) + stone.swell_e * (eps_o - along_e2);
        const Vector3<V> on = select<V>(as_e, eps_o * k_e + (excess * along_e) * axis, k_o);
        const V swell = select<V>(as_e, swell_e, V(stone.swell_o));
        put(select<V>(fine, fanned<V>(fan, normal, on, swell), fan), rays.fan, lane);
    }
    put(select<V>(chance < survival, one, zero), rays.alive + lane);
    put(select<V>(fine, one, zero), rays.solved + lane);
    put(select<V>(fine, stays / survival, weight), rays.weight + lane);
    put(select<V>(fine, select<V>(as_e, one, zero), select<V>(extraordinary, one, zero)),
        rays.extraordinary + lane);
    put(select<V>(fine, k_on, k), rays.k, lane);
    put(select<V>(fine, select<V>(as_e, E_e, E_o), field), rays.field, lane);
}

template <class V>
void step_all(const RayStone& stone, double threshold, RayLanes& rays) {
    constexpr int width = static_cast<int>(V::size());
    static_assert(RayLanes::size % width == 0);
    for (int lane = 0; lane < RayLanes::size; lane += width) {
        if (stone.spectral) {
            step<V, true>(stone, threshold, rays, lane);
        } else {
            step<V, false>(stone, threshold, rays, lane);
        }
    }
}

}  // namespace icespar::lanes
