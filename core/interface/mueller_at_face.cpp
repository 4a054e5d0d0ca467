// From the amplitudes of a face to Mueller matrices.
#include "interface/mueller_at_face.hpp"

#include "math/error.hpp"

namespace icespar {
namespace {

/// Components of a field along x = s made perpendicular to the ray, and y = ray x x.
std::array<Complex, 2> seen_along(const Vec3& ray, const Vec3& s, const CVec3& E) {
    const Vec3 across = s - dot(ray, s) * ray;
    const Vec3 x = length(across) > 1e-12 ? normalised(across) : any_perpendicular(ray);
    return {dot(E, x), dot(E, cross(ray, x))};
}

}  // namespace

FaceMueller mueller_at_face(const Medium& from, const Medium& to, const Vec3& normal,
                            const Wave& incident) {
    if (from.absorbing) {
        throw Error("Mueller matrices of a face need a first medium that does not absorb");
    }
    const Interface face(from, to, normal, incident);
    const Vec3& s = face.s_direction();
    const OutgoingWaves waves = face.waves();
    // The field (x, y) of incident light excites a wave by analyser . (x, y).
    const auto analyser = [&](bool transmitted, std::size_t i) -> std::array<Complex, 2> {
        if (!from.birefringent) {
            return {face.flux_amplitude(0, transmitted, i), face.flux_amplitude(1, transmitted, i)};
        }
        const auto own = seen_along(incident.ray, s, incident.E);
        const Complex f = face.flux_amplitude(mode_index(incident.mode), transmitted, i);
        return {f * std::conj(own[0]), f * std::conj(own[1])};
    };
    const auto side = [&](bool transmitted, const Medium& medium, const std::array<Wave, 2>& pair,
                          std::array<Mueller, 2>& alone, std::optional<Mueller>& together) {
        Jones sum;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!pair[i].propagating) continue;
            const auto a = analyser(transmitted, i);
            const auto out = seen_along(pair[i].ray, s, pair[i].E);
            alone[i] = mueller_of_wave(a[0], a[1], stokes_from_field(out[0], out[1]));
            for (std::size_t row = 0; row < 2; ++row) {
                for (std::size_t column = 0; column < 2; ++column) {
                    sum.m[row][column] += out[row] * a[column];
                }
            }
        }
        if (!medium.birefringent) together = mueller_from_jones(sum);
    };
    FaceMueller out;
    side(false, from, waves.reflected, out.reflected, out.reflected_light);
    side(true, to, waves.transmitted, out.transmitted, out.transmitted_light);
    return out;
}

}  // namespace icespar
