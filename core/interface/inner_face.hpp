// A face of a transparent uniaxial crystal seen from inside, as tracers meet it again and again.
#pragma once

#include <array>

#include "crystal/medium.hpp"
#include "interface/interface.hpp"

namespace icespar {

/// The waves o and e that a face sends into a crystal.
struct CrystalWaves {
    std::array<bool, 2> propagates{};
    std::array<Vec3, 2> k, E;  ///< E of unit length; of waves that propagate

    CrystalWaves() = default;
    CrystalWaves(const Interface& face, bool transmitted);
};

/// What becomes of one mode. Amplitudes are normalised so that their squared magnitudes are powers.
struct InnerFace {
    CrystalWaves reflected;
    std::array<Complex, 2> amplitude;  ///< of the reflected waves
    bool passes = false;               ///< false: total reflection
    Vec3 s;                            ///< the face's s, of any length
    Vec3 k_out;                        ///< of what passes
    Complex out_s, out_p;

    /// The mode of wave vector k and unit field E goes from the crystal, a `plain` medium, into an
    /// isotropic one; the normal points out.
    InnerFace(const Medium& crystal, const Medium& beyond, const Vec3& normal, const Vec3& k,
              const Vec3& E, bool extraordinary);

private:
    /// In closed form; false where that would lose digits: near the axis, normal incidence or a
    /// wave that grazes.
    bool find(const Medium& crystal, const Medium& beyond, const Vec3& normal, const Vec3& k,
              const Vec3& field, bool extraordinary);
};

}  // namespace icespar
