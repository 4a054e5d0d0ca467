// Plane waves in a medium: Re[E exp(i(k . r - w t))], k in units of w/c.
#pragma once

#include <array>

#include "crystal/medium.hpp"
#include "math/vec3.hpp"

namespace icespar {

/// s and p: isotropic media, with respect to a face. Ordinary and extraordinary: uniaxial media
/// without activity. Fast and slow: biaxial and active media; fast is the wave of smaller index for
/// its wave normal.
enum class Mode { s, p, ordinary, extraordinary, fast, slow };

/// The names of a medium's two waves.
[[nodiscard]] inline std::array<Mode, 2> modes_of(const MediumCore& m) {
    if (m.symmetry == Symmetry::biaxial || m.active()) return {Mode::fast, Mode::slow};
    if (m.symmetry == Symmetry::uniaxial) return {Mode::ordinary, Mode::extraordinary};
    return {Mode::s, Mode::p};
}

/// Place of a mode in its pair.
[[nodiscard]] inline std::size_t mode_index(Mode m) {
    return m == Mode::p || m == Mode::extraordinary || m == Mode::slow ? 1 : 0;
}

struct Wave {
    Mode mode = Mode::s;
    bool propagating = true;  ///< false: evanescent, decays away from the face, carries no power;
                              ///< true for every wave of, or lit from, an absorbing medium
    CVec3 k;                  ///< wave vector; real when propagating
    CVec3 E;                  ///< unit Hermitian norm
    CVec3 H;                  ///< k x E (+ i alpha E in an active medium)
    Vec3 ray;                 ///< unit direction of the mean energy flow, Re(E x H*)
    double n_phase = 1;       ///< |Re k|
    double n_ray = 1;         ///< Re k . ray = n_phase cos(walk-off)

    /// Mean energy flow along n, in units in which E of norm 1 in vacuum along n has 1.
    [[nodiscard]] double flux(const Vec3& n) const { return dot(real(cross(E, conj(H))), n); }
};

/// Unit direction of the energy of a propagating extraordinary wave, along eps k.
[[nodiscard]] inline Vec3 extraordinary_ray(const MediumCore& medium, const Vec3& k) {
    const double eps_o = medium.n_o * medium.n_o, eps_e = medium.n_e * medium.n_e;
    return normalised(eps_o * k + ((eps_e - eps_o) * dot(k, medium.axis)) * medium.axis);
}

enum class By { wave_normal, ray };

/// The propagating wave of the given mode along a unit direction. s and p (isotropic) refer to the
/// face with unit normal `normal`: s = normal x k, p = k x s; at normal incidence s is a fixed
/// vector in the face. In a uniaxial medium o has E along k x axis, e along axis - k (k . axis) /
/// n_o^2; for k along the axis both are fixed perpendicular vectors across it. In an absorbing
/// medium the wave is homogeneous: k = (n + i kappa) wave normal. Throws Error for a mode that the
/// medium, or this ray, does not have.
[[nodiscard]] Wave plane_wave(const Medium& medium, Mode mode, const Vec3& direction, By by,
                              const Vec3& normal);

/// Both waves of a direction. By ray, a biaxial crystal can answer with two slow waves: rays inside
/// the cone of internal conical refraction. Along a biradial every E across the ray is a solution,
/// each with its own wave normal (external conical refraction); two of them are returned. Throws
/// Error where a strongly absorbing medium has no two waves with such a ray.
[[nodiscard]] std::array<Wave, 2> waves_along(const Medium& medium, const Vec3& direction, By by,
                                              const Vec3& normal);

/// Waves whose mean energy flow is along a ray, all that were found: two, or beside the optic axes
/// of absorbing and active crystals up to eight, whose rays agree with the one asked for within
/// 1e-12. The first two continue those of the transparent crystal without activity.
struct WavesOfRay {
    std::array<Wave, 8> waves;
    std::size_t count = 0;

    void add(const Wave& wave);  ///< unless it is there already
};
[[nodiscard]] WavesOfRay waves_of_ray(const Medium& medium, const Vec3& ray);

/// The real direction of a linearly polarised field, whatever its phase.
[[nodiscard]] inline Vec3 without_phase(const CVec3& E) {
    const Complex largest = std::norm(E.x) >= std::norm(E.y)
                                ? (std::norm(E.x) >= std::norm(E.z) ? E.x : E.z)
                                : (std::norm(E.y) >= std::norm(E.z) ? E.y : E.z);
    const double size = std::abs(largest);
    return size > 0 && largest.imag() != 0 ? real(std::conj(largest) / size * E) : real(E);
}

}  // namespace icespar
