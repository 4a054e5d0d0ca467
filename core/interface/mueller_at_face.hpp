// Mueller matrices of the waves that leave a face: one of rank 1 for each ray of a crystal.
#pragma once

#include <optional>

#include "interface/interface.hpp"
#include "polarisation/mueller.hpp"

namespace icespar {

/// Light is described as it runs along its ray, by x = s (normal x k of the incident wave) made
/// perpendicular to the ray, and y = ray x x: s and p in isotropic media. S0 is the energy flow
/// through the face, that of the incident light being 1; so M00 is the power for unpolarised light.
struct FaceMueller {
    /// Of each wave alone, 1/2 F (1, p_out) (a0, a1, a2, a3)^T: what its analyser accepts leaves in
    /// its own polarisation. 0 for an evanescent wave.
    std::array<Mueller, 2> reflected, transmitted;
    /// Of s and p together, which share one path and interfere; only on a side that is isotropic.
    std::optional<Mueller> reflected_light, transmitted_light;
};

/// `incident` propagates in the transparent medium `from`, towards the face. In an isotropic medium
/// it stands for light of any polarisation along it; in a crystal light is in one mode, and the
/// matrices accept that mode's polarisation. Throws Error where `from` absorbs.
[[nodiscard]] FaceMueller mueller_at_face(const Medium& from, const Medium& to, const Vec3& normal,
                                          const Wave& incident);

}  // namespace icespar
