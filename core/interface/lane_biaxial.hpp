// The waves of transparent biaxial crystals in lanes: the formulas of real_waves.hpp and modes.cpp
// with selections in place of branches, and a mask of the faces where nothing is delicate.
#pragma once

#include "interface/lane_face.hpp"
#include "math/symmetric.hpp"

namespace icespar::lanes {

/// eps = mean I + deviation.
template <class V>
struct BiaxialLanes {
    V mean;
    SymmetricTensor<V> deviation;
};

/// plane_wave by a wave normal.
template <class V>
struct BiaxialIncident {
    Vector3<V> k, ray, E;

    BiaxialIncident(const BiaxialLanes<V>& m, const Vector3<V>& direction, bool second) {
        const Vector3<V> x = Frame<V>::across(direction), y = cross(direction, x);
        const SymmetricTensor<V>& dev = m.deviation;
        const SymmetricTensor<V> turn = cofactors(dev) + (-m.mean) * dev;
        const V base = m.mean * (m.mean + (dev.xx + dev.yy + dev.zz));
        const V det = (SymmetricTensor<V>::diagonal(m.mean, m.mean, m.mean) + dev).determinant();
        const Vector3<V> tx = turn * x, ty = turn * y;
        // hermitian_eigen in lanes.
        const V a = dot(x, tx), b = dot(x, ty), d = dot(y, ty);
        const V half = (a - d) / V(2), off = abs(b), radius = sqrt(half * half + off * off);
        const Mask<V> differ = radius > V(0), first_larger = half >= V(0);
        const V safe = select<V>(differ, radius, V(1));
        const V large = sqrt((V(1) + abs(half) / safe) / V(2)), small = b / (V(2) * safe * large);
        const V sign = select<V>(b < V(0), V(-1), V(1));
        // (u, v) for the greater value, (-v, u) times the sign for the lesser.
        const V u = select<V>(differ, select<V>(first_larger, sign * large, small), V(1)),
                v = select<V>(differ, select<V>(first_larger, abs(small), large), V(0));
        const V value = (a + d) / V(2) + (second ? -radius : radius);
        const V cx = second ? -sign * v : u, cy = second ? sign * u : v;
        k = sqrt(det / (base + value)) * direction;
        E = unit(cx * (base * x + tx) + cy * (base * y + ty));
        ray = unit(dot(E, E) * k - dot(k, E) * E);
    }
};

/// The sheets of a biaxial crystal's wave vectors over a tangential one; see real_waves.hpp.
template <class V>
struct Sheets {
    V mean, K, sum, det, least;
    SymmetricTensor<V> dev, adj;

    Sheets(const V& mean_square, const SymmetricTensor<V>& deviation, const V& tangential)
        : mean(mean_square), K(tangential), dev(deviation), adj(cofactors(deviation)) {
        sum = adj.xx + adj.yy + adj.zz + mean * (dev.xx + dev.yy + dev.zz);
        det = dev.xx * adj.xx + dev.xy * adj.xy + dev.xz * adj.xz;
        const V size2 = dev.xx * dev.xx + dev.yy * dev.yy + dev.zz * dev.zz +
                        V(2) * (dev.yz * dev.yz + dev.xz * dev.xz + dev.xy * dev.xy);
        least = number<V>(1e-6) * mean * mean * size2;
    }

    /// Newton's method for q on the outer (sign 1) or inner (-1) sheet, from nearby; where it ends
    /// well.
    Mask<V> settle(double sign, V& q, V& s) const {
        Mask<V> apart(true), settled(false);
        const V half = V(0.5) / mean;
        for (int i = 0; i < 5; ++i) {
            const V B = sum - (K * K * dev.xx + q * (V(2) * K * dev.xz + q * dev.zz)),
                    C = det + K * K * adj.xx + q * (V(2) * K * adj.xz + q * adj.zz),
                    dB = V(-2) * (K * dev.xz + q * dev.zz), dC = V(2) * (K * adj.xz + q * adj.zz);
            const V square = B * B - V(4) * mean * C;
            apart = apart && (settled || square > least);
            const V root = V(sign) * sqrt(square), sheet = half * (B + root);
            const V ds = half * (dB + (B * dB - V(2) * mean * dC) / root);
            const V step = (q * q + K * K - mean - sheet) / (V(2) * q - ds);
            // A lane that has settled stays, whatever its neighbours do.
            s = select<V>(settled, s, sheet - ds * step);
            q = select<V>(settled, q, q - step);
            settled = settled || abs(step) < V(1e-8);
            if (all_of(settled || !apart)) break;
        }
        return apart && settled;
    }

    /// E from the cofactors of the singular matrix A + k k^T, A = dev - s I.
    [[nodiscard]] Vector3<V> field(const V& q, const V& s) const {
        SymmetricTensor<V> A = dev;
        A.xx -= s;
        A.yy -= s;
        A.zz -= s;
        SymmetricTensor<V> c = cofactors(A);
        const V mixed = K * A.yz - q * A.xy;
        c.xx += q * q * A.yy;
        c.xz -= q * K * A.yy;
        c.zz += K * K * A.yy;
        c.xy += q * mixed;
        c.yz -= K * mixed;
        c.yy += q * (q * A.xx - V(2) * K * A.xz) + K * K * A.zz;
        const V x = abs(c.xx), y = abs(c.yy), z = abs(c.zz);
        const Vector3<V> ofx{c.xx, c.xy, c.xz}, ofy{c.xy, c.yy, c.yz}, ofz{c.xz, c.yz, c.zz};
        return unit(select<V>(x >= y && x >= z, ofx, select<V>(y >= z, ofy, ofz)));
    }
};

/// Both pairs of a side, along the normal and against it: fast, slow.
template <class V>
struct BiaxialWaves {
    Pair<V, V> up, down;
    Mask<V> sound;  ///< all four propagate, and none is delicate

    BiaxialWaves(const BiaxialLanes<V>& m, const Frame<V>& face) {
        constexpr double apart = 0.02;
        const V K = face.kt, &mean = m.mean;
        const SymmetricTensor<V> dev = m.deviation.in_frame(face.x, face.y, face.z);
        const V exx = mean + dev.xx, eyy = mean + dev.yy, ezz = mean + dev.zz;
        const V b = eyy - K * K, c = ezz - K * K, scale = V(1) / ezz;
        const V c3 = V(2) * dev.xz * K * scale,
                c2 = -(exx * c + b * ezz - dev.yz * dev.yz - dev.xz * dev.xz) * scale,
                c1 = V(2) * K * (dev.xy * dev.yz - b * dev.xz) * scale,
                c0 = (exx * (b * c - dev.yz * dev.yz) - dev.xy * dev.xy * c +
                      V(2) * dev.xy * dev.yz * dev.xz - b * dev.xz * dev.xz) *
                     scale;
        // q = y - h makes y^4 + p y^2 + r y + s = (y^2 + a y + low)(y^2 - a y + high).
        const V h = c3 / V(4), p = c2 - V(6) * h * h, r = c1 - V(2) * h * (c2 - V(4) * h * h),
                s = c0 - h * (c1 - h * (c2 - V(3) * h * h));
        V u = V(-2) * p, step(1);
        sound = u > V(4 * apart * apart);
        u = select<V>(sound, u, V(1));
        for (int i = 0; i < 8; ++i) {
            const Mask<V> moves = sound && abs(step) > V(1e-9) * u;
            if (none_of(moves)) break;
            const V v = u + p, w = v * v - V(4) * s;
            step = select<V>(moves, (u * w - r * r) / (w + V(2) * u * v), step);
            u = select<V>(moves, u - step, u);
        }
        sound = sound && abs(step) <= V(1e-9) * u;
        const V a = sqrt(u), turn = r / a, middle = V(0.5) * (p + u);
        // A little below 0 by rounding where the indices nearly agree.
        const V gap_up = V(0.25) * u - middle - V(0.5) * turn,
                gap_down = V(0.25) * u - middle + V(0.5) * turn;
        const V ru = sqrt(max(gap_up, V(0))), rd = sqrt(max(gap_down, V(0)));
        sound = sound && gap_up > V(-1e-9) && gap_down > V(-1e-9) && a - ru - rd > V(2 * apart);
        const Sheets<V> sheets(mean, dev, K);
        const auto set = [&](FaceWave<V, V>& wave, double sign, V q) {
            V square(0);
            sound = sound && sheets.settle(sign, q, square);
            wave.set(K, q, sheets.field(q, square));
        };
        set(up[0], -1, V(0.5) * a - ru - h);
        set(up[1], 1, V(0.5) * a + ru - h);
        set(down[0], -1, V(-0.5) * a + rd - h);
        set(down[1], 1, V(-0.5) * a - rd - h);
        part(up);
        part(down);
        const V limit(apart), least(0.01);
        sound = sound && up[0].q > limit && up[1].q > up[0].q && down[0].q < -limit &&
                down[1].q < down[0].q && up[0].flux > least && up[1].flux > least &&
                down[0].flux < -least && down[1].flux < -least;
    }

    /// Makes the second wave independent of the first to rounding.
    static void part(Pair<V, V>& pair) {
        const auto flux = [](const FaceWave<V, V>& w) { return w.E.x * w.hy - w.E.y * w.hx; };
        pair[0].flux = flux(pair[0]);
        const V f = pairing(pair[0], pair[1]) / (V(2) * pair[0].flux);
        pair[1].E -= f * pair[0].E;
        pair[1].hx -= f * pair[0].hx;
        pair[1].hy -= f * pair[0].hy;
        pair[1].flux = flux(pair[1]);
    }
};

}  // namespace icespar::lanes
