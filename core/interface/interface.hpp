// The plane-wave boundary problem at a plane face between two media, solved exactly.
#pragma once

#include <array>

#include "interface/wave.hpp"

namespace icespar {

/// The four waves that leave a face for a given tangential wave vector. Index 0 and 1 are s and p
/// (isotropic), o and e (uniaxial), or fast and slow (biaxial, active): inner and outer sheet of
/// the surface of wave vectors, also where a line along the normal meets the outer sheet four
/// times, beside an optic axis at grazing emergence; the wave that lies further in is then called
/// fast.
struct OutgoingWaves {
    std::array<Wave, 2> reflected, transmitted;
};

/// What one incident wave of E = 1 sends into them.
struct Coefficients {
    std::array<Complex, 2> reflected, transmitted;  ///< amplitudes of the waves' E
    std::array<double, 2> reflected_power,
        transmitted_power;  ///< parts of the incident normal flux
    /// Normal flux of both waves together at the face over the incident one. In a transparent
    /// medium it is the sum of their powers; where a medium absorbs, the two also interfere. With a
    /// transparent first medium both totals add to 1.
    double reflected_total = 0, transmitted_total = 0;
    /// Of an absorbing first medium, whose incident and reflected waves carry energy together too:
    /// with it the totals add to 1. Otherwise 0.
    double interference = 0;
};

/// Summed tangential and normal fields of the waves of each side, just at the face, for incident
/// |E| = 1: well defined also where two waves merge.
struct SummedFields {
    CVec3 reflected_E, reflected_H, transmitted_E, transmitted_H;
};

/// A face with everything that the waves of one incident wave vector share.
class Interface {
public:
    /// `normal` (unit) points from medium `from` to medium `to`. `incident` is a propagating wave
    /// of `from` that carries energy towards the face (at grazing incidence its own k is more
    /// precise than anything recovered from the tangential wave vector). Throws Error for a wave of
    /// an absorbing medium that fades across its plane of incidence.
    Interface(const Medium& from, const Medium& to, const Vec3& normal, const Wave& incident);

    /// Coefficients of the incident wave given, or of another wave with the same wave vector: in an
    /// isotropic medium s and p share one face.
    [[nodiscard]] Coefficients solve(const Wave& incident) const;

    [[nodiscard]] SummedFields summed_fields(const Wave& incident) const;

    /// The four outgoing waves in full, and one of them.
    [[nodiscard]] OutgoingWaves waves() const;
    [[nodiscard]] Wave reflected(std::size_t i) const;
    [[nodiscard]] Wave transmitted(std::size_t i) const;

    /// The ray of an outgoing wave, without building the wave.
    [[nodiscard]] Vec3 ray(bool transmitted, std::size_t i) const;

    /// For ray tracers, without building a wave: the direction s of the face, whether a wave
    /// propagates, and the amplitude from incident wave m (0: s, o; 1: p, e) into it, normalised so
    /// that its squared magnitude is the power.
    [[nodiscard]] const Vec3& s_direction() const { return y_; }
    [[nodiscard]] bool propagating(bool transmitted, std::size_t i) const {
        return (transmitted ? transmitted_ : reflected_).propagating[i];
    }
    [[nodiscard]] Complex flux_amplitude(std::size_t m, bool transmitted, std::size_t i) const;
    /// Of a propagating wave: its wave vector, and its unit E, which is real but for a phase (left
    /// out here) in media without activity.
    [[nodiscard]] Vec3 wave_vector(bool transmitted, std::size_t i) const {
        return kt_.real() * x_ + (transmitted ? transmitted_ : reflected_).q[i].real() * normal_;
    }
    [[nodiscard]] Vec3 field_direction(bool transmitted, std::size_t i) const {
        const CVec3& E = (transmitted ? transmitted_ : reflected_).E[i];
        const Vec3 F = general_ ? without_phase(E) : real(E);
        return F.x * x_ + F.y * y_ + F.z * normal_;
    }

private:
    friend struct FaceSolver;
    friend struct GeneralSolver;
    /// Outgoing waves of one side in the face's frame: x along the tangential wave vector, z =
    /// normal.
    struct Side {
        std::array<Complex, 2> q;  ///< normal component of k
        std::array<CVec3, 2> E;
        std::array<double, 2> flux;
        std::array<bool, 2> propagating;
    };

    [[nodiscard]] Wave built(const Side& side, const MediumCore& medium, std::size_t i) const;
    /// Of a propagating wave, where all is real.
    [[nodiscard]] Vec3 real_ray(const Side& side, const MediumCore& medium, std::size_t i,
                                const Vec3& k) const;
    /// Of an evanescent wave of a transparent medium, along the face.
    [[nodiscard]] Vec3 evanescent_ray(const Side& side, const MediumCore& medium,
                                      std::size_t i) const;

    MediumCore from_, to_;
    Vec3 x_, y_, normal_;
    Complex kt_ = 0;  ///< tangential wave number
    bool general_ = false, merged_ = false;
    Side reflected_, transmitted_;
    std::array<double, 2> flux_in_{};  ///< normal flux of the incident waves of |E| = 1
    std::array<std::array<Complex, 2>, 2> reflect_, transmit_;  ///< [incident mode][outgoing mode]
    /// General media, and what is transmitted where evanescent waves merge; else without value. By
    /// [incident mode]: real and imaginary parts of the
    /// summed reflected E, H and transmitted E, H in the face's frame; their normal flux over the
    /// incident one.
    std::array<std::array<double, 24>, 2> summed_;
    std::array<double, 2> reflected_flux_, transmitted_flux_, interference_;
};

}  // namespace icespar
