// Fresnel's (1823) equations between two isotropic media, as beams need them.
#pragma once

#include <algorithm>
#include <cmath>

#include "beams/expansion.hpp"

namespace icespar {

/// What a face does to s and p, normalised to energy flow; a phase common to both is left out.
struct Fresnel {
    bool passes = false;  ///< false: total reflection
    double q = 0;         ///< of what passes, the part of k along the normal
    Complex r_s, r_p;
    double t_s = 0, t_p = 0;
};

/// From index n to n_beyond, `q` being the part of k along the normal: n cos i.
[[nodiscard]] inline Fresnel fresnel(double n, double n_beyond, double q) {
    const double eps = n * n, eps_beyond = n_beyond * n_beyond;
    const double q2 = q * q + (n_beyond - n) * (n_beyond + n);
    Fresnel out;
    if (q2 > 0) {
        out.passes = true;
        out.q = std::sqrt(q2);
        const double a = eps_beyond * q, b = eps * out.q;
        const double r_s = (q - out.q) / (q + out.q), r_p = (a - b) / (a + b);
        out.r_s = r_s;
        out.r_p = r_p;
        out.t_s = std::sqrt((1 - r_s) * (1 + r_s));
        out.t_p = std::sqrt((1 - r_p) * (1 + r_p));
    } else {
        const double decay = std::sqrt(-q2);
        const Complex z{eps_beyond * q * q + eps * decay * decay, (eps - eps_beyond) * q * decay};
        out.r_s = z * z / std::norm(z);
        out.r_p = 1;
    }
    return out;
}

/// What passes a face goes with the part of the outer k along the normal, whose square is 0 at the
/// critical angle: whether that changes over a polygon by more than so much of its value.
[[nodiscard]] inline bool near_critical(const Expansion& k, PolygonView polygon, const Vec3& normal,
                                        double n_beyond, double most) {
    const Vec3 along = k.value - dot(normal, k.value) * normal;
    const double square = n_beyond * n_beyond - dot(along, along);
    const double dx = 2 * dot(along, k.dx), dy = 2 * dot(along, k.dy);
    const double least = most * std::abs(square);
    return std::any_of(polygon.begin(), polygon.end(),
                       [&](const Point2& p) { return std::abs(dx * p.x + dy * p.y) > least; });
}

/// A response about another s, of any length. At normal incidence any s will do.
template <class Pair>
[[nodiscard]] Pair on_face(const Pair& response, const Vec3& k, double n, const Vec3& normal,
                           Vec3& s) {
    constexpr double straight = 1e-24;
    const Vec3 across = cross(normal, k);
    if (!(dot(across, across) > straight * n * n)) return response;
    // s may not lie quite across k, where k has turned since.
    const double c = n * dot(across, s), d = dot(across, cross(k, s));
    s = across;
    return response.turned(c, d);
}

}  // namespace icespar
