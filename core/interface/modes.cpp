// Plane waves of a medium from a direction.
#include "interface/crystal_frame.hpp"
#include "interface/face_frame.hpp"
#include "interface/half_space.hpp"
#include "interface/plane.hpp"
#include "interface/real_waves.hpp"
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
    if (std::is_same_v<R, double> && h.separation < R(0.05)) {
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

/// A wave of a transparent medium, by its wave vector, unit E and ray.
Wave real_wave(Mode mode, const Vec3& k, const Vec3& E, const Vec3& ray) {
    Wave w;
    w.mode = mode;
    w.k = complexified(k);
    w.E = complexified(E);
    w.H = complexified(cross(k, E));
    w.ray = ray;
    w.n_phase = length(k);
    w.n_ray = dot(k, ray);
    return w;
}

bool transparent_biaxial(const Medium& m) {
    return m.symmetry == Symmetry::biaxial && !m.absorbing && !m.active();
}

/// The waves of a transparent biaxial crystal: D across the wave normal, along the principal axes
/// there of the inverse tensor, whose values are 1 / n^2 (Born & Wolf, 15.2.2).
struct NormalEllipse {
    const Medium& medium;
    Vec3 direction, ex, ey;
    double base = 0, det = 1;
    Eigen2<double> sections;

    NormalEllipse(const Medium& m, const Vec3& normal) : medium(m), direction(normal) {
        const Vec3 x = any_perpendicular(direction), y = cross(direction, x);
        // Of eps = mean I + dev the inverse times det is base I + turn, turn as small as dev.
        const RealTensor dev = real(medium.deviation);
        const double mean = medium.mean.real();
        const RealTensor turn = cofactors(dev) + (-mean) * dev;
        const double trace = dev.xx + dev.yy + dev.zz;
        base = mean * (mean + trace);
        det = real(medium.permittivity()).determinant();
        const Vec3 tx = turn * x, ty = turn * y;
        ex = base * x + tx;
        ey = base * y + ty;
        sections = hermitian_eigen<double>(dot(x, tx), dot(x, ty), dot(y, ty));
    }

    /// 0: fast, 1: slow.
    [[nodiscard]] Wave wave(std::size_t i) const {
        const auto& v = sections.vector[i];
        const Vec3 k = std::sqrt(det / (base + sections.value[i])) * direction,
                   E = normalised(v[0] * ex + v[1] * ey);
        return real_wave(i == 0 ? Mode::fast : Mode::slow, k, E, normalised(cross(E, cross(k, E))));
    }
};

std::array<Wave, 2> waves_of_normal(const Medium& medium, const Vec3& direction) {
    if (transparent_biaxial(medium)) {
        const NormalEllipse ellipse(medium, direction);
        return {ellipse.wave(0), ellipse.wave(1)};
    }
    return waves_of_normal_in<double>(medium, direction);
}

}  // namespace

std::array<Wave, 2> waves_along(const Medium& medium, const Vec3& direction, By by,
                                const Vec3& normal) {
    const auto names = modes_of(medium);
    if (medium.plain() || (medium.symmetry == Symmetry::isotropic && !medium.active())) {
        return {plane_wave(medium, names[0], direction, by, normal),
                plane_wave(medium, names[1], direction, by, normal)};
    }
    if (by == By::wave_normal) return waves_of_normal(medium, direction);
    const WavesOfRay found = waves_of_ray(medium, direction);
    if (found.count < 2) {
        throw Error(
            "this medium has no two waves whose energy flows along the ray asked for; give "
            "the wave normal instead");
    }
    const std::size_t first = mode_index(found.waves[0].mode) <= mode_index(found.waves[1].mode);
    return {found.waves[1 - first], found.waves[first]};
}

Wave plane_wave(const Medium& medium, Mode mode, const Vec3& direction, By by, const Vec3& normal) {
    require_mode(medium, mode);
    if (medium.symmetry == Symmetry::isotropic && !medium.active() && medium.absorbing) {
        const Complex n(medium.n_o, medium.kappa_o);
        const FaceFrame face(normal, direction);
        const Vec3 E = mode == Mode::s ? face.y : cross(direction, face.y);
        return finished(medium, mode, n * direction, complexified(E));
    }
    if (by == By::wave_normal && transparent_biaxial(medium)) {
        return NormalEllipse(medium, direction).wave(mode_index(mode));
    }
    if (!medium.plain()) {
        const auto both = waves_along(medium, direction, by, normal);
        const std::size_t wanted = mode_index(mode);
        if (both[wanted].mode == mode) return both[wanted];
        if (both[1 - wanted].mode == mode) return both[1 - wanted];
        throw Error("both waves of this ray are slow: it lies inside the cone of an optic axis");
    }
    const double eps_o = medium.n_o * medium.n_o, eps_e = medium.n_e * medium.n_e;
    const CrystalFrame crystal(medium.axis);
    Vec3 k, E, ray = direction;
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
        if (by == By::wave_normal) ray = extraordinary_ray(medium, k);
    } else {
        k = medium.n_o * direction;
        if (mode == Mode::ordinary) {
            E = crystal.ordinary(dot(direction, crystal.a), dot(direction, crystal.b));
        } else {
            const FaceFrame face(normal, k);
            E = mode == Mode::s ? face.y : cross(direction, face.y);
        }
    }
    return real_wave(mode, k, E, ray);
}

}  // namespace icespar
