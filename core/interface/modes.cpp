// Plane waves of a medium from a direction.
#include "interface/crystal_frame.hpp"
#include "interface/face_frame.hpp"
#include "interface/half_space.hpp"
#include "interface/wave.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

void require_mode(const Medium& medium, Mode mode) {
    const auto fitting = modes_of(medium);
    if (mode == fitting[0] || mode == fitting[1]) return;
    switch (fitting[0]) {
        case Mode::s:
            throw Error("an isotropic medium has the modes s and p");
        case Mode::ordinary:
            throw Error("a uniaxial medium has the modes o and e");
        default:
            throw Error("a biaxial or active medium has the modes fast and slow");
    }
}

Wave finished(const Medium& medium, Mode mode, const CVec3& k, const CVec3& E) {
    Wave w;
    w.mode = mode;
    w.k = k;
    w.E = E;
    w.H = medium.magnetic_field(k, E);
    w.ray = normalised(real(cross(w.E, conj(w.H))));
    w.n_phase = length(real(k));
    w.n_ray = dot(real(k), w.ray);
    return w;
}

/// Both waves of a wave normal: those that leave a face across it with no tangential wave vector.
template <class R>
std::array<Wave, 2> waves_of_normal_in(const Medium& medium, const Vec3& direction) {
    const Vector3<R> z = normalised(converted<R>(direction)), x = any_perpendicular(z);
    const FaceAxes<R> face{x, cross(z, x), z};
    const HalfSpace<R> h(medium, face, 0, +1, nullptr);
    if (std::is_same_v<R, double> && h.separation < R(0.02)) {
        return waves_of_normal_in<long double>(medium, direction);
    }
    const auto names = modes_of(medium);
    std::array<Wave, 2> out;
    for (std::size_t i = 0; i < 2; ++i) {
        out[i] = finished(medium, names[i], Complex(h.q[i]) * direction,
                          converted<Complex>(face.from_face(h.E[i])));
    }
    return out;
}

std::array<Wave, 2> waves_of_normal(const Medium& medium, const Vec3& direction) {
    return waves_of_normal_in<double>(medium, direction);
}

/// Both waves of a ray in a transparent medium without activity, by the dual of the wave-normal
/// problem: E across the ray, (eps across the ray) E = n_ray^2 E (Born & Wolf, 15.2.3).
std::array<Wave, 2> waves_of_ray(const Medium& medium, const Vec3& ray) {
    const Vec3 x = any_perpendicular(ray), y = cross(ray, x);
    const RealTensor full = real(medium.permittivity());
    // Without the multiple of the identity, which turns no axis and would drown small differences.
    const double mean = full.zz;
    RealTensor eps = full;
    eps.xx -= mean;
    eps.yy -= mean;
    eps.zz = 0;
    const double half = 0.5 * (dot(x, eps * x) - dot(y, eps * y)), off = dot(x, eps * y);
    const double angle = half == 0 && off == 0 ? 0 : 0.5 * std::atan2(off, half);
    const Vec3 major = std::cos(angle) * x + std::sin(angle) * y;
    const std::array<Vec3, 2> fields{cross(ray, major), major};
    std::array<Wave, 2> out;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 D = full * fields[i];
        const double n_ray = std::sqrt(dot(fields[i], D));
        // k lies in the plane of ray and D, across D, with k . ray = n_ray.
        const Vec3 w = ray - (dot(ray, D) / dot(D, D)) * D;
        const Vec3 k = (n_ray / dot(w, w)) * w;
        out[i] = finished(medium, Mode::slow, complexified(k), complexified(fields[i]));
        out[i].ray = ray;
        out[i].n_ray = n_ray;
        // Fast if the other wave of this wave normal has the larger index.
        const Vec3 u = k / out[i].n_phase, a = normalised(D), b = cross(u, a);
        const RealTensor eta = full.inverse();
        const bool fast = dot(b, eta * b) < dot(a, eta * a);
        out[i].mode = fast ? Mode::fast : Mode::slow;
    }
    return out;
}

}  // namespace

std::array<Wave, 2> waves_along(const Medium& medium, const Vec3& direction, By by,
                                const Vec3& normal) {
    const auto names = modes_of(medium);
    if (names[0] != Mode::fast) {
        return {plane_wave(medium, names[0], direction, by, normal),
                plane_wave(medium, names[1], direction, by, normal)};
    }
    if (by == By::wave_normal) return waves_of_normal(medium, direction);
    if (medium.absorbing || medium.active()) {
        throw Error("waves by ray direction are known for transparent media without activity only");
    }
    return waves_of_ray(medium, direction);
}

Wave plane_wave(const Medium& medium, Mode mode, const Vec3& direction, By by, const Vec3& normal) {
    require_mode(medium, mode);
    if (mode == Mode::fast || mode == Mode::slow) {
        const auto both = waves_along(medium, direction, by, normal);
        const std::size_t wanted = mode_index(mode);
        if (both[wanted].mode == mode) return both[wanted];
        if (both[1 - wanted].mode == mode) return both[1 - wanted];
        throw Error("both waves of this ray are slow: it lies inside the cone of an optic axis");
    }
    if (medium.absorbing) {
        if (by == By::ray) {
            throw Error("waves by ray direction are known for transparent media only");
        }
        if (medium.symmetry == Symmetry::uniaxial) {
            return waves_of_normal(medium, direction)[mode_index(mode)];
        }
        const Complex n(medium.n_o, medium.kappa_o);
        const FaceFrame face(normal, direction);
        const Vec3 E = mode == Mode::s ? face.y : cross(direction, face.y);
        return finished(medium, mode, n * direction, complexified(E));
    }
    const double eps_o = medium.n_o * medium.n_o, eps_e = medium.n_e * medium.n_e;
    const CrystalFrame crystal(medium.axis);
    Wave wave;
    wave.mode = mode;
    Vec3 k, E;
    if (mode == Mode::extraordinary) {
        // Ray direction ~ eps k, so k ~ eps^-1 ray; k . eps k = n_o^2 n_e^2 sets the length.
        const Vec3 d = by == By::wave_normal
                           ? direction
                           : direction / eps_o + (1 / eps_e - 1 / eps_o) *
                                                     dot(direction, medium.axis) * medium.axis;
        const double x = dot(d, crystal.a), y = dot(d, crystal.b), z = dot(d, crystal.c);
        const double scale =
            medium.n_o * medium.n_e / std::sqrt(eps_o * (x * x + y * y) + eps_e * z * z);
        k = scale * d;
        E = normalised(crystal.extraordinary(scale * x, scale * y, scale * z, eps_o, eps_e));
        wave.ray =
            by == By::ray
                ? direction
                : normalised(eps_o * k + ((eps_e - eps_o) * dot(k, medium.axis)) * medium.axis);
    } else {
        k = medium.n_o * direction;
        wave.ray = direction;
        if (mode == Mode::ordinary) {
            E = crystal.ordinary(dot(direction, crystal.a), dot(direction, crystal.b));
        } else {
            const FaceFrame face(normal, k);
            E = mode == Mode::s ? face.y : cross(direction, face.y);
        }
    }
    wave.k = complexified(k);
    wave.E = complexified(E);
    wave.H = complexified(cross(k, E));
    wave.n_phase = length(k);
    wave.n_ray = dot(k, wave.ray);
    return wave;
}

}  // namespace icespar
