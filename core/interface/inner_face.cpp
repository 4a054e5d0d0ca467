// Beyond the face only a wave goes away, so that there H_x = -q E_y and eps E_x = q H_y: two
// conditions on the incident and both reflected waves, free of quotients that vanish.
#include "interface/inner_face.hpp"

#include <cmath>

namespace icespar {
namespace {

/// Of what is of order 1 (a square, mostly), smaller numbers have lost digits.
constexpr double delicate = 1e-4;

/// Tangential fields of a wave times the tangential wave number, in the face's frame.
template <class T>
struct Tangential {
    T q, ex, ey, hy;
};

/// `t`: tangential wave vector; `y` = normal x t.
Tangential<double> tangential(const Vec3& E, double q, const Vec3& t, const Vec3& y,
                              const Vec3& normal) {
    const double ex = dot(E, t);
    return {q, ex, dot(E, y), q * ex - dot(t, t) * dot(E, normal)};
}

/// The field k x axis of an ordinary wave of normal component -i sqrt(-q2).
Tangential<Complex> fading_o(double q2, const Vec3& axis, const Vec3& t, const Vec3& y,
                             const Vec3& normal) {
    const Complex q(0, -std::sqrt(-q2));
    const Vec3 flat = cross(t, axis), deep = cross(normal, axis);
    const Complex ex = q * dot(deep, t);
    return {q, ex, dot(flat, y) + q * dot(deep, y), q * ex - dot(t, t) * dot(flat, normal)};
}

/// The field axis - (k . axis) k / eps_o of an extraordinary wave.
Tangential<Complex> fading_e(const Complex& q, double eps_o, const Vec3& axis, const Vec3& t,
                             const Vec3& y, const Vec3& normal) {
    const double kt2 = dot(t, t);
    const Complex along = (dot(t, axis) + q * dot(normal, axis)) / eps_o;
    const Complex ex = dot(t, axis) - along * kt2;
    return {q, ex, dot(axis, y), q * ex - kt2 * (dot(normal, axis) - along * q)};
}

double size(double v) { return std::abs(v); }
double size(const Complex& v) { return std::abs(v.real()) + std::abs(v.imag()); }

/// Amplitudes of both reflected waves for the E of each; false where they are all but parallel.
template <class T, class O, class E>
bool match(const T& q_beyond, double eps_beyond, const Tangential<double>& in, const O& o,
           const E& e, std::array<T, 2>& r) {
    const auto first = [&](const auto& w) { return (q_beyond - w.q) * w.ey; };
    const auto second = [&](const auto& w) { return eps_beyond * w.ex - q_beyond * w.hy; };
    const T a = first(o), b = first(e), c = second(o), d = second(e);
    const T x = first(in), y = second(in), ad = a * d, bc = b * c, det = ad - bc;
    if (!(size(det) > delicate * (size(ad) + size(bc)))) return false;
    const T inverse = -1.0 / det;
    r = {(x * d - b * y) * inverse, (a * y - x * c) * inverse};
    return true;
}

}  // namespace

CrystalWaves::CrystalWaves(const Interface& face, bool transmitted) {
    for (std::size_t i = 0; i < 2; ++i) {
        propagates[i] = face.propagating(transmitted, i);
        if (!propagates[i]) continue;
        k[i] = face.wave_vector(transmitted, i);
        E[i] = face.field_direction(transmitted, i);
    }
}

bool InnerFace::find(const Medium& crystal, const Medium& beyond, const Vec3& normal, const Vec3& k,
                     const Vec3& field, bool extraordinary) {
    const double eps_o = crystal.n_o * crystal.n_o, eps_e = crystal.n_e * crystal.n_e,
                 eps_beyond = beyond.n_o * beyond.n_o, excess = eps_e - eps_o;
    const double kn = dot(normal, k);
    const Vec3 t = k - kn * normal, y = cross(normal, t);
    const double kt2 = dot(t, t), tc = dot(t, crystal.axis), nc = dot(normal, crystal.axis);
    const double q_beyond2 = eps_beyond - kt2;
    if (kt2 < delicate || std::abs(q_beyond2) < delicate) return false;
    passes = q_beyond2 > 0;

    // k . k = eps_o and k . eps k = eps_o eps_e. A mode knows its own other root.
    const double o2 = eps_o - kt2;
    const double a = eps_o + excess * nc * nc, b = excess * tc * nc;
    const double e2 = b * b - a * (eps_o * kt2 + excess * tc * tc - eps_o * eps_e);
    if (std::abs(o2) < delicate || std::abs(e2) < delicate) return false;
    const double q_o = extraordinary ? -std::sqrt(std::max(0.0, o2)) : -kn;
    const double q_e = extraordinary ? -2 * b / a - kn : -(b + std::sqrt(std::max(0.0, e2))) / a;

    // Normal flux: k N - (E . N) (E . k) for unit E.
    const double flux_in = kn - dot(field, normal) * dot(field, k);
    if (flux_in < delicate) return false;
    const Tangential<double> in = tangential(field, kn, t, y, normal);
    Tangential<double> o{}, e{};
    double norm_o = 0, norm_e = 0;
    reflected.propagates = {o2 > 0, e2 > 0};
    if (o2 > 0) {
        const double along = tc + q_o * nc, across2 = eps_o - along * along;
        if (across2 < delicate) return false;
        const Vec3& wave = reflected.k[0] = t + q_o * normal;
        reflected.E[0] = (1 / std::sqrt(across2)) * cross(wave, crystal.axis);
        o = tangential(reflected.E[0], q_o, t, y, normal);
        norm_o = std::sqrt(-q_o / flux_in);
    }
    if (e2 > 0) {
        const Vec3& wave = reflected.k[1] = t + q_e * normal;
        const Vec3 E = crystal.axis - ((tc + q_e * nc) / eps_o) * wave;
        const double E2 = dot(E, E);
        if (E2 < delicate) return false;
        const Vec3& unit = reflected.E[1] = (1 / std::sqrt(E2)) * E;
        const double flux = dot(unit, normal) * dot(unit, wave) - q_e;
        if (flux < delicate) return false;
        e = tangential(unit, q_e, t, y, normal);
        norm_e = std::sqrt(flux / flux_in);
    }
    if (!passes) {
        const Complex beyond_q(0, std::sqrt(-q_beyond2));
        std::array<Complex, 2> r;
        // One of the reflected waves may fade away from the face, too.
        const auto with = [&](const auto& wave_o, const auto& wave_e) {
            return match(beyond_q, eps_beyond, in, wave_o, wave_e, r);
        };
        const bool found = o2 < 0   ? with(fading_o(o2, crystal.axis, t, y, normal), e)
                           : e2 < 0 ? with(o, fading_e(Complex(-b, -std::sqrt(-e2)) / a, eps_o,
                                                       crystal.axis, t, y, normal))
                                    : with(o, e);
        amplitude = {norm_o * r[0], norm_e * r[1]};
        return found;
    }
    if (o2 < 0 || e2 < 0) return false;
    const double q_beyond = std::sqrt(q_beyond2);
    std::array<double, 2> r;
    if (!match(q_beyond, eps_beyond, in, o, e, r)) return false;
    amplitude = {norm_o * r[0], norm_e * r[1]};
    const double norm = std::sqrt(q_beyond / (flux_in * kt2));
    s = y;
    k_out = t + q_beyond * normal;
    out_s = norm * (in.ey + r[0] * o.ey + r[1] * e.ey);
    out_p = -norm / beyond.n_o * (in.hy + r[0] * o.hy + r[1] * e.hy);
    return true;
}

InnerFace::InnerFace(const Medium& crystal, const Medium& beyond, const Vec3& normal, const Vec3& k,
                     const Vec3& E, bool extraordinary) {
    if (find(crystal, beyond, normal, k, E, extraordinary)) return;
    Wave incident;
    incident.mode = extraordinary ? Mode::extraordinary : Mode::ordinary;
    incident.k = complexified(k);
    incident.E = complexified(E);
    const Interface face(crystal, beyond, normal, incident);
    const std::size_t m = extraordinary ? 1 : 0;
    reflected = CrystalWaves(face, false);
    amplitude = {face.flux_amplitude(m, false, 0), face.flux_amplitude(m, false, 1)};
    passes = face.propagating(true, 0);
    if (!passes) return;
    s = face.s_direction();
    k_out = face.wave_vector(true, 0);
    out_s = face.flux_amplitude(m, true, 0);
    out_p = face.flux_amplitude(m, true, 1);
}

}  // namespace icespar
