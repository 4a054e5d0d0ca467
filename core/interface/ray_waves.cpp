// Plane waves from the direction of their energy.
#include <algorithm>
#include <optional>

#include "interface/wave.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

/// Both waves of a ray in a transparent medium without activity, by the dual of the wave-normal
/// problem: E across the ray, (eps across the ray) E = n_ray^2 E (Born & Wolf, 15.2.3).
std::array<Wave, 2> closed_form(const Medium& medium, const RealTensor& full, const Vec3& ray) {
    const Vec3 x = any_perpendicular(ray), y = cross(ray, x);
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
        Wave& w = out[i];
        const Vec3 D = full * fields[i];
        w.n_ray = std::sqrt(dot(fields[i], D));
        // k lies in the plane of ray and D, across D, with k . ray = n_ray.
        const Vec3 across = ray - (dot(ray, D) / dot(D, D)) * D;
        const Vec3 k = (w.n_ray / dot(across, across)) * across;
        w.k = complexified(k);
        w.E = complexified(fields[i]);
        w.H = medium.magnetic_field(w.k, w.E);
        w.ray = ray;
        w.n_phase = length(k);
        // Fast if the other wave of this wave normal has the larger index.
        const Vec3 u = k / w.n_phase, a = normalised(D), b = cross(u, a);
        const RealTensor eta = full.inverse();
        w.mode = dot(b, eta * b) < dot(a, eta * a) ? Mode::fast : Mode::slow;
    }
    return out;
}

/// The medium with a part of its absorption and activity.
Medium lessened(Medium m, double part) {
    m.kappa_o *= part;
    m.kappa_e *= part;
    m.gyration *= part;
    m.gyration_along *= part;
    const auto less = [&](Complex z) { return Complex(z.real(), part * z.imag()); };
    m.mean = less(m.mean);
    auto& d = m.deviation;
    d = {less(d.xx), less(d.yy), less(d.zz), less(d.yz), less(d.xz), less(d.xy)};
    return m;
}

/// The wave of a direction whose field is most like `model`.
Wave nearest(const Medium& medium, const Vec3& direction, const CVec3& model) {
    const auto both = waves_along(medium, direction, By::wave_normal, direction);
    const auto like = [&](const Wave& w) { return std::norm(dot(conj(w.E), model)); };
    return like(both[0]) >= like(both[1]) ? both[0] : both[1];
}

/// Newton's method for the wave normal whose ray is the one asked for, from a wave near it. Nothing
/// where it does not settle.
std::optional<Wave> with_ray(const Medium& medium, const Vec3& ray, const Wave& start) {
    Wave wave = nearest(medium, normalised(real(start.k)), start.E);
    double error = length(wave.ray - ray);
    for (int i = 0; i < 30 && error > 0; ++i) {
        constexpr double h = 1e-6;
        const Vec3 d = normalised(real(wave.k)), a = any_perpendicular(d), b = cross(d, a);
        const Vec3 along_a = (nearest(medium, normalised(d + h * a), wave.E).ray - wave.ray) / h,
                   along_b = (nearest(medium, normalised(d + h * b), wave.E).ray - wave.ray) / h;
        // Least squares: both derivatives and the error lie across the ray.
        const Vec3 miss = ray - wave.ray;
        const double aa = dot(along_a, along_a), ab = dot(along_a, along_b),
                     bb = dot(along_b, along_b), det = aa * bb - ab * ab;
        const double ma = dot(along_a, miss), mb = dot(along_b, miss);
        double x = (bb * ma - ab * mb) / det, y = (aa * mb - ab * ma) / det;
        const double size = std::sqrt(x * x + y * y);
        if (!std::isfinite(size)) return std::nullopt;
        // Full steps only near the goal; half of them until they help.
        double part = std::min(1.0, 0.3 / size);
        bool better = false;
        for (int halving = 0; halving < 8 && !better; ++halving, part /= 2) {
            const Wave next = nearest(medium, normalised(d + part * x * a + part * y * b), wave.E);
            const double left = length(next.ray - ray);
            better = left < error;
            if (better) wave = next, error = left;
        }
        if (!better) break;
    }
    constexpr double settled = 1e-12;
    if (!(error < settled)) return std::nullopt;
    return wave;
}

bool same(const Wave& a, const Wave& b) {
    return length(a.k - b.k) < 1e-7 && std::norm(dot(conj(a.E), b.E)) > 1 - 1e-6;
}

}  // namespace

void WavesOfRay::add(const Wave& wave) {
    for (std::size_t i = 0; i < count; ++i) {
        if (same(waves[i], wave)) return;
    }
    if (count < waves.size()) waves[count++] = wave;
}

WavesOfRay waves_of_ray(const Medium& medium, const Vec3& ray) {
    WavesOfRay out;
    if (medium.plain()) {
        for (const Mode mode : modes_of(medium))
            out.add(plane_wave(medium, mode, ray, By::ray, ray));
        return out;
    }
    const auto start = closed_form(medium, real(medium.permittivity()), ray);
    if (!medium.absorbing && !medium.active()) {
        out.waves[0] = start[0];
        out.waves[1] = start[1];
        out.count = 2;
        return out;
    }
    // Absorption and activity grow from nothing, and each wave is followed.
    for (std::size_t which = 0; which < 2; ++which) {
        Wave begin = start[which];
        if (!std::isfinite(begin.n_phase)) {
            // Re eps of a metal is not positive.
            begin = waves_along(medium, ray, By::wave_normal, ray)[which];
        }
        for (const int steps : {1, 8, 64}) {
            std::optional<Wave> wave = begin;
            for (int i = 1; i <= steps && wave; ++i) {
                wave =
                    with_ray(i == steps ? medium : lessened(medium, double(i) / steps), ray, *wave);
            }
            if (!wave) continue;
            out.add(*wave);
            break;
        }
    }
    // Beside an optic axis the sheets are bent so much that several wave normals share a ray.
    if (medium.symmetry == Symmetry::isotropic) return out;
    const OpticAxes axes = optic_axes(medium);
    for (const Vec3& axis : {axes.first, -axes.first, axes.second, -axes.second}) {
        if (dot(axis, ray) < 0.7) continue;
        const Vec3 a = any_perpendicular(axis), b = cross(axis, a);
        for (int i = 0; i < 8; ++i) {
            const double turn = 0.7853981633974483 * i;
            const Vec3 d = normalised(axis + 0.01 * (std::cos(turn) * a + std::sin(turn) * b));
            for (const Wave& w : waves_along(medium, d, By::wave_normal, d)) {
                if (const auto found = with_ray(medium, ray, w)) out.add(*found);
            }
        }
    }
    return out;
}

}  // namespace icespar
