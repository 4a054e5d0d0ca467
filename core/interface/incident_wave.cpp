// Refines an incident wave to more digits than its numbers have.
#include "interface/incident_wave.hpp"

namespace icespar {
namespace {

template <class R>
FaceAxes<R> axes_across(const Vector3<R>& z) {
    const Vector3<R> x = any_perpendicular(z);
    return {x, cross(z, x), z};
}

template <class R>
std::complex<R> overlap(const Vector3<std::complex<R>>& a, const Vector3<std::complex<R>>& b) {
    return dot(conj(a), b);
}

}  // namespace

template <class R>
IncidentWave<R> IncidentWave<R>::refined(const Medium& medium, const FaceFrame& frame,
                                         const Wave& wave) {
    const Vec3 re = real(wave.k), im{wave.k.x.imag(), wave.k.y.imag(), wave.k.z.imag()};
    if (length(cross(re, im)) > 1e-14 * dot(re, re)) return IncidentWave(frame, wave);

    const Vector3<R> d = normalised(converted<R>(re));
    const Vector3<C> given = converted<C>(wave.E);
    std::array<C, 2> n;
    std::array<Vector3<C>, 2> E;
    if (medium.symmetry == Symmetry::isotropic && !medium.active()) {
        const Vector3<C> across = given - dot(given, d) * d;
        n[0] = n[1] = index_o<R>(medium);
        E[0] = across / length(across);
        E[1] = cross(d, conj(E[0]));
    } else {
        const FaceAxes<R> axes = axes_across(d);
        const HalfSpace<R> h(medium, axes, C(0), +1, nullptr);
        n = h.q;
        for (std::size_t i = 0; i < 2; ++i) E[i] = axes.from_face(h.E[i]);
    }
    const C n_given(R(wave.n_phase), dot(converted<R>(im), d));
    const bool together = std::abs(n[0] - n[1]) < R(1e-10) * std::abs(n[0]);
    const bool first = together ? std::abs(overlap(E[0], given)) > std::abs(overlap(E[1], given))
                                : std::abs(n[0] - n_given) < std::abs(n[1] - n_given);
    const std::size_t m = first ? 0 : 1;
    const C own = overlap(E[m], given);
    Vector3<C> field = (std::abs(own) > 0 ? own / std::abs(own) : C(1)) * E[m];
    if (together) {
        // Coefficients of both waves, which need not be orthogonal.
        const C s = overlap(E[0], E[1]), a = overlap(E[0], given), b = overlap(E[1], given);
        const C det = C(1) - s * std::conj(s);
        field = ((a - s * b) / det) * E[0] + ((b - std::conj(s) * a) / det) * E[1];
        field = field / length(field);
    }
    const Vector3<C> k = n[m] * d;
    Vector3<C> H = cross(k, field);
    if (medium.active()) {
        const Vector3<R> axis = normalised(converted<R>(medium.axis));
        const R across(medium.gyration), more = R(medium.gyration_along) - across;
        H += C(0, 1) * (across * field + (more * dot(axis, field)) * axis);
    }

    IncidentWave out;
    FaceAxes<R>& axes = out.axes;
    axes.z = normalised(converted<R>(frame.z));
    // x lies along k, where it is inclined enough to say so: near an optic axis even a rounding of
    // k turns the field, and the energy of a wave that grazes the face with it. Elsewhere k across
    // the frame's x is left out.
    const Vector3<R> along = d - dot(d, axes.z) * axes.z;
    const Vector3<R> x = dot(along, along) > R(0.25) ? along : converted<R>(frame.x);
    axes.x = normalised(x - dot(x, axes.z) * axes.z);
    axes.y = cross(axes.z, axes.x);
    out.set(k, field, H);
    if (frame.kt == 0) out.K = 0;
    return out;
}

template struct IncidentWave<long double>;

}  // namespace icespar
