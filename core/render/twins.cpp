// Both modes of an active stone at one facet, as fields.
#include "render/twins.hpp"

namespace icespar {
namespace {

constexpr double apart = 1e-4;

bool all_reflected(const Interface& face) {
    return face.propagating(false, 0) && face.propagating(false, 1);
}

/// What `to` must be multiplied by to be `from`, which differs from it by a phase; 0 when by more.
Complex phase(const CVec3& to, const CVec3& from) {
    const Complex overlap = dot(conj(to), from);
    const double size = std::abs(overlap);
    return size > 0.99 ? overlap / size : Complex(0);
}

}  // namespace

std::optional<TwinFace> meet_facet(const Medium& medium, const Vec3& normal, const Wave& fast,
                                   const Wave& slow) {
    const Medium air = Medium::isotropic(1);
    const Interface face(medium, air, normal, fast);
    if (!all_reflected(face)) return std::nullopt;
    // The slow wave that shares the tangential part of the fast one's wave vector, so that together
    // they scatter without loss: what comes back when a reflected wave meets the facet's back.
    const Interface behind(medium, air, -normal, face.reflected(0));
    if (!all_reflected(behind)) return std::nullopt;
    const Wave beside = behind.reflected(1);
    const Complex turn = phase(beside.E, slow.E);
    if (turn == 0.0 || length(real(beside.k) - real(slow.k)) > apart) return std::nullopt;
    const Interface other(medium, air, normal, beside);
    TwinFace out;
    out.leaves = face.propagating(true, 0);
    if (!all_reflected(other) || other.propagating(true, 0) != out.leaves) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
        out.reflected[i] = face.reflected(i);
        const Complex same = phase(out.reflected[i].E, other.reflected(i).E);
        if (same == 0.0) return std::nullopt;
        out.reflect[0][i] = face.flux_amplitude(0, false, i);
        out.reflect[1][i] = turn * same * other.flux_amplitude(1, false, i);
    }
    if (!out.leaves) return out;
    out.k = face.wave_vector(true, 0);
    const Vec3 &s = face.s_direction(), &t = other.s_direction();
    out.basis = {s, cross(normalised(out.k), s)};
    // At normal incidence the two faces may have chosen different directions s.
    const double along = dot(s, t), across = dot(out.basis[1], t);
    const Complex os = other.flux_amplitude(1, true, 0), op = other.flux_amplitude(1, true, 1);
    out.transmit[0] = {face.flux_amplitude(0, true, 0), face.flux_amplitude(0, true, 1)};
    out.transmit[1] = {turn * (along * os - across * op), turn * (across * os + along * op)};
    return out;
}

}  // namespace icespar
