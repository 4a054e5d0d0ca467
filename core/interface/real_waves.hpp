// The four waves of a transparent medium at a face, for the quick path, which leaves whatever is
// delicate to the general solver: all propagating, in real numbers, or those of an isotropic medium
// all evanescent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "crystal/medium.hpp"
#include "interface/crystal_frame.hpp"
#include "interface/face_frame.hpp"

namespace icespar {

template <class T>
struct QuickWave {
    T q{};
    Vector3<T> E;
    T hx{}, hy{};

    /// H = k x E with k = (K, 0, q).
    void set(double K, const T& normal_component, const Vector3<T>& field) {
        q = normal_component;
        E = field;
        hx = -q * E.y;
        hy = q * E.x - K * E.z;
    }
    /// Energy flow along the normal of a real wave.
    [[nodiscard]] T flux() const { return E.x * hy - E.y * hx; }
};

/// Lorentz's pairing, which vanishes between different waves of one medium; see interface.cpp.
template <class S, class T>
auto pairing(const QuickWave<S>& a, const QuickWave<T>& b) {
    return a.E.x * b.hy - a.E.y * b.hx + b.E.x * a.hy - b.E.y * a.hx;
}

struct EvanescentWaves {
    std::array<QuickWave<Complex>, 2> up, down;

    /// s and p of an isotropic medium beyond its critical angle; false near or below it.
    bool find(const Medium& m, const FaceFrame& face) {
        const double K = face.kt, q2 = (K - m.n_o) * (K + m.n_o);
        if (m.symmetry != Symmetry::isotropic || !(q2 > 1e-3)) return false;
        const double depth = std::sqrt(q2), size = std::sqrt(q2 + K * K);
        for (const double sign : {1.0, -1.0}) {
            const Complex q(0, sign * depth);
            auto& pair = sign > 0 ? up : down;
            pair[0].set(K, q, {0, 1, 0});
            pair[1].set(K, q, {-q / size, 0, K / size});
        }
        return true;
    }
};

struct RealWaves {
    using RealWave = QuickWave<double>;
    static constexpr double apart =
        0.02;  ///< least q of a wave, or half gap between them, accepted

    std::array<RealWave, 2> up, down;  ///< energy along the normal, and against it

    /// False where some wave is evanescent, grazes the face or nearly meets the other of its pair.
    bool find(const Medium& m, const FaceFrame& face) {
        if (m.symmetry == Symmetry::biaxial) return biaxial(m, face);
        return m.symmetry == Symmetry::uniaxial ? uniaxial(m, face) : isotropic(m.n_o, face.kt);
    }

private:
    bool isotropic(double n, double K) {
        const double q2 = (n - K) * (n + K);
        if (!(q2 > apart * apart)) return false;
        const double q = std::sqrt(q2);
        up[0].set(K, q, {0, 1, 0});
        up[1].set(K, q, {-q / n, 0, K / n});
        down[0].set(K, -q, {0, 1, 0});
        down[1].set(K, -q, {q / n, 0, K / n});
        return true;
    }

    bool uniaxial(const Medium& m, const FaceFrame& face) {
        const double K = face.kt, eo = m.n_o * m.n_o, ee = m.n_e * m.n_e;
        const double delta = (m.n_e - m.n_o) * (m.n_e + m.n_o);
        const CrystalFrame crystal(face.to_face(m.axis));
        const Vec3& c = crystal.c;
        const double eg = eo + delta * c.z * c.z, X = delta * c.z * c.x * K;
        const double q2 = (m.n_o - K) * (m.n_o + K);
        const double w2 = eo * (eg * (ee - K * K) - delta * c.x * c.x * K * K);
        if (!(q2 > apart * apart && w2 > apart * apart)) return false;
        const double q_o = std::sqrt(q2), w = std::sqrt(w2);
        for (const double sign : {1.0, -1.0}) {
            auto& pair = sign > 0 ? up : down;
            const auto across = [&](double q, const Vec3& v) { return K * v.x + q * v.z; };
            const double o = sign * q_o, e = (sign * w - X) / eg;
            pair[0].set(K, o, crystal.ordinary(across(o, crystal.a), across(o, crystal.b)));
            const double ea = across(e, crystal.a), eb = across(e, crystal.b);
            // Along the axis both fields are a matter of a small difference.
            if (ea * ea + eb * eb < 1e-4) return false;
            pair[1].set(K, e, normalised(crystal.extraordinary(ea, eb, across(e, c), eo, ee)));
        }
        return true;
    }

    /// A biaxial medium in the face's frame, eps = mean I + dev. With s = k . k - mean the
    /// determinant of k x (k x E) + eps E is mean s^2 - B s + C, B and C as small as dev and dev^2:
    /// so the two sheets keep their distance to rounding, whatever the birefringence.
    struct Sheets {
        double mean, K, sum, det, least;
        RealTensor dev, adj;

        Sheets(double mean_square, const RealTensor& deviation, double tangential)
            : mean(mean_square), K(tangential), dev(deviation), adj(cofactors(deviation)) {
            const double trace = dev.xx + dev.yy + dev.zz;
            sum = adj.xx + adj.yy + adj.zz + mean * trace;
            det = dev.xx * adj.xx + dev.xy * adj.xy + dev.xz * adj.xz;
            const double size2 = dev.xx * dev.xx + dev.yy * dev.yy + dev.zz * dev.zz +
                                 2 * (dev.yz * dev.yz + dev.xz * dev.xz + dev.xy * dev.xy);
            constexpr double close = 1e-3;  // to an optic axis, against the birefringence
            least = close * close * mean * mean * size2;
        }

        /// Newton's method for q on the outer (or inner) sheet, from nearby.
        bool settle(bool outer, double& q, double& s) const {
            const double sign = outer ? 1 : -1;
            for (int i = 0; i < 5; ++i) {
                const double B = sum - (K * K * dev.xx + q * (2 * K * dev.xz + q * dev.zz)),
                             C = det + K * K * adj.xx + q * (2 * K * adj.xz + q * adj.zz),
                             dB = -2 * (K * dev.xz + q * dev.zz),
                             dC = 2 * (K * adj.xz + q * adj.zz);
                const double square = B * B - 4 * mean * C;
                if (!(square > least)) return false;
                const double root = sign * std::sqrt(square), half = 0.5 / mean;
                s = half * (B + root);
                const double ds = half * (dB + (B * dB - 2 * mean * dC) / root);
                const double step = (q * q + K * K - mean - s) / (2 * q - ds);
                q -= step;
                s -= ds * step;
                if (std::abs(step) < 1e-8) return true;
            }
            return false;
        }

        /// E from the cofactors of the singular matrix A + k k^T, A = dev - s I, which are E E^T
        /// but for a factor.
        [[nodiscard]] Vec3 field(double q, double s) const {
            RealTensor A = dev;
            A.xx -= s;
            A.yy -= s;
            A.zz -= s;
            RealTensor c = cofactors(A);
            const double mixed = K * A.yz - q * A.xy;
            c.xx += q * q * A.yy;
            c.xz -= q * K * A.yy;
            c.zz += K * K * A.yy;
            c.xy += q * mixed;
            c.yz -= K * mixed;
            c.yy += q * (q * A.xx - 2 * K * A.xz) + K * K * A.zz;
            const double x = std::abs(c.xx), y = std::abs(c.yy), z = std::abs(c.zz);
            return normalised(x >= y && x >= z ? Vec3{c.xx, c.xy, c.xz}
                              : y >= z         ? Vec3{c.xy, c.yy, c.yz}
                                               : Vec3{c.xz, c.yz, c.zz});
        }
    };

    /// The determinant is a quartic in q, whose two quadratic factors follow from the largest root
    /// of the resolvent cubic: where to start.
    bool biaxial(const Medium& m, const FaceFrame& face) {
        const double K = face.kt, mean = m.mean.real();
        const RealTensor dev = real(m.deviation).in_frame(face.x, face.y, face.z);
        RealTensor eps = dev;
        eps.xx += mean;
        eps.yy += mean;
        eps.zz += mean;
        const double b = eps.yy - K * K, c = eps.zz - K * K, scale = 1 / eps.zz;
        const double c3 = 2 * eps.xz * K * scale,
                     c2 = -(eps.xx * c + b * eps.zz - eps.yz * eps.yz - eps.xz * eps.xz) * scale,
                     c1 = 2 * K * (eps.xy * eps.yz - b * eps.xz) * scale,
                     c0 = (eps.xx * (b * c - eps.yz * eps.yz) - eps.xy * eps.xy * c +
                           2 * eps.xy * eps.yz * eps.xz - b * eps.xz * eps.xz) *
                          scale;
        // q = y - h makes y^4 + p y^2 + r y + s = (y^2 + a y + low)(y^2 - a y + high).
        const double h = c3 / 4, p = c2 - 6 * h * h, r = c1 - 2 * h * (c2 - 4 * h * h),
                     s = c0 - h * (c1 - h * (c2 - 3 * h * h));
        double u = -2 * p;
        if (!(u > 4 * apart * apart)) return false;
        double step = 1;
        for (int i = 0; i < 8 && std::abs(step) > 1e-9 * u; ++i) {
            const double v = u + p;
            step = (u * (v * v - 4 * s) - r * r) / (v * v - 4 * s + 2 * u * v);
            u -= step;
        }
        if (!(std::abs(step) <= 1e-9 * u)) return false;
        const double a = std::sqrt(u), turn = r / a;
        // A little below 0 by rounding where the indices nearly agree.
        const double gap_up = 0.25 * u - 0.5 * (p + u + turn),
                     gap_down = 0.25 * u - 0.5 * (p + u - turn);
        if (!(gap_up > -1e-9 && gap_down > -1e-9)) return false;
        const double ru = std::sqrt(std::max(gap_up, 0.0)), rd = std::sqrt(std::max(gap_down, 0.0));
        if (!(a - ru - rd > 2 * apart)) return false;
        const Sheets sheets(mean, dev, K);
        const auto set = [&](RealWave& wave, bool outer, double q) {
            double square = 0;
            if (!sheets.settle(outer, q, square)) return false;
            wave.set(K, q, sheets.field(q, square));
            return true;
        };
        if (!set(up[0], false, 0.5 * a - ru - h) || !set(up[1], true, 0.5 * a + ru - h) ||
            !set(down[0], false, -0.5 * a + rd - h) || !set(down[1], true, -0.5 * a - rd - h)) {
            return false;
        }
        part(up);
        part(down);
        return up[0].q > apart && up[1].q > up[0].q && down[0].q < -apart &&
               down[1].q < down[0].q && up[0].flux() > 0.01 && up[1].flux() > 0.01 &&
               down[0].flux() < -0.01 && down[1].flux() < -0.01;
    }

    /// Makes the second wave independent of the first to rounding, so that their sums stay right
    /// where each alone is uncertain.
    static void part(std::array<RealWave, 2>& pair) {
        const double f = pairing(pair[0], pair[1]) / (2 * pair[0].flux());
        pair[1].E -= f * pair[0].E;
        pair[1].hx -= f * pair[0].hx;
        pair[1].hy -= f * pair[0].hy;
    }
};

}  // namespace icespar
