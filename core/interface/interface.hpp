// The plane-wave boundary problem at a plane face between two media, solved exactly.
#pragma once

#include <array>

#include "interface/wave.hpp"

namespace icespar {

/// The four waves that leave a face for a given tangential wave vector. Index 0 and 1 are s and p
/// (isotropic) or o and e (uniaxial).
struct OutgoingWaves {
    std::array<Wave, 2> reflected, transmitted;
};

/// What one incident wave of E = 1 sends into them.
struct Coefficients {
    std::array<Complex, 2> reflected, transmitted;  ///< amplitudes of the waves' E
    std::array<double, 2> reflected_power, transmitted_power;  ///< parts of the incident normal flux
};

/// A face with everything that does not depend on which incident wave it is.
class Interface {
public:
    /// `normal` (unit) points from medium `from` to medium `to`; `k` is the incident wave vector, of
    /// which only the tangential part is used.
    Interface(const Medium& from, const Medium& to, const Vec3& normal, const Vec3& k);

    [[nodiscard]] const OutgoingWaves& waves() const { return waves_; }

    /// `incident` is a propagating wave of `from` with this face's tangential wave vector, carrying
    /// energy towards the face.
    [[nodiscard]] Coefficients solve(const Wave& incident) const;

private:
    Vec3 normal_;
    OutgoingWaves waves_;
    // (solver's private state)
};

}  // namespace icespar
