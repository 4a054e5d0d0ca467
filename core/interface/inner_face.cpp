// Beyond the face only a wave goes away, so that there H_x = -q E_y and eps E_x = q H_y: two
// conditions on the incident and both reflected waves, free of quotients that vanish.
#include "interface/inner_face.hpp"

#include <cmath>

namespace icespar {
namespace {

/// Of what is of order 1 (a square, mostly), smaller numbers have lost digits.
constexpr double delicate = 1e-4;

/// Tangential fields of a wave times the tangential wave number, in the face's frame.
struct Tangential {
    double q, ex, ey, hy;

    /// `t`: tangential wave vector; `y` = normal x t.
    Tangential(const Vec3& E, double along_normal, const Vec3& t, const Vec3& y, const Vec3& normal)
        : q(along_normal), ex(dot(E, t)), ey(dot(E, y)), hy(q * ex - dot(t, t) * dot(E, normal)) {}
};

double size(double v) { return std::abs(v); }
double size(const Complex& v) { return std::abs(v.real()) + std::abs(v.imag()); }

/// Amplitudes of both reflected waves for |E| = 1 of each; false where they are all but parallel.
template <class T>
bool match(const T& q_beyond, double eps_beyond, const Tangential& in,
           const std::array<Tangential, 2>& out, std::array<T, 2>& r) {
    const auto first = [&](const Tangential& w) { return (q_beyond - w.q) * w.ey; };
    const auto second = [&](const Tangential& w) { return eps_beyond * w.ex - q_beyond * w.hy; };
    const T a = first(out[0]), b = first(out[1]), c = second(out[0]), d = second(out[1]);
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

    // k . k = eps_o and k . eps k = eps_o eps_e. A mode knows its own other root.
    const double o2 = eps_o - kt2;
    const double a = eps_o + excess * nc * nc, b = excess * tc * nc;
    const double e2 = b * b - a * (eps_o * kt2 + excess * tc * tc - eps_o * eps_e);
    if (o2 < delicate || e2 < delicate) return false;
    const double q_o = extraordinary ? -std::sqrt(o2) : -kn;
    const double q_e = extraordinary ? -2 * b / a - kn : -(b + std::sqrt(e2)) / a;
    const double along_o = tc + q_o * nc, along_e = tc + q_e * nc;
    const Vec3 k_o = t + q_o * normal, k_e = t + q_e * normal;
    const double across_o2 = eps_o - along_o * along_o;
    const Vec3 E_e = crystal.axis - (along_e / eps_o) * k_e;
    const double E_e2 = dot(E_e, E_e);
    if (across_o2 < delicate || E_e2 < delicate) return false;
    reflected.propagates = {true, true};
    reflected.k = {k_o, k_e};
    reflected.E = {(1 / std::sqrt(across_o2)) * cross(k_o, crystal.axis),
                   (1 / std::sqrt(E_e2)) * E_e};

    // Normal flux: k N - (E . N) (E . k) for unit E.
    const Vec3& e = reflected.E[1];
    const double flux_in = kn - dot(field, normal) * dot(field, k);
    const double flux_e = dot(e, normal) * dot(e, k_e) - q_e;
    if (flux_in < delicate || flux_e < delicate) return false;
    const Tangential in(field, kn, t, y, normal);
    const std::array<Tangential, 2> out{Tangential(reflected.E[0], q_o, t, y, normal),
                                        Tangential(e, q_e, t, y, normal)};
    const double norm_o = std::sqrt(-q_o / flux_in), norm_e = std::sqrt(flux_e / flux_in);
    passes = q_beyond2 > 0;
    if (!passes) {
        std::array<Complex, 2> r;
        if (!match(Complex(0, std::sqrt(-q_beyond2)), eps_beyond, in, out, r)) return false;
        amplitude = {norm_o * r[0], norm_e * r[1]};
        return true;
    }
    const double q_beyond = std::sqrt(q_beyond2);
    std::array<double, 2> r;
    if (!match(q_beyond, eps_beyond, in, out, r)) return false;
    amplitude = {norm_o * r[0], norm_e * r[1]};
    const double norm = std::sqrt(q_beyond / (flux_in * kt2));
    s = y;
    k_out = t + q_beyond * normal;
    out_s = norm * (in.ey + r[0] * out[0].ey + r[1] * out[1].ey);
    out_p = -norm / beyond.n_o * (in.hy + r[0] * out[0].hy + r[1] * out[1].hy);
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
