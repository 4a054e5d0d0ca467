// A stone at one wavelength: its medium, and what it takes from light on the way.
#pragma once

#include "crystal/medium.hpp"
#include "scene/crystal.hpp"
#include "views/view.hpp"

namespace icespar {

/// Absorption is weak on the scale of a wavelength, as in everything that light gets through: waves
/// and facets are those of the transparent crystal, and each wave decays along its ray.
class StoneOptics {
public:
    StoneOptics() = default;
    /// `general`: a uniaxial crystal, too, is left to the general solver, with modes fast and slow.
    StoneOptics(const Crystal& crystal, double wavelength_nm, bool general = false);

    [[nodiscard]] const Medium& medium() const { return medium_; }
    [[nodiscard]] double wavelength_nm() const { return wavelength_nm_; }

    /// What it takes, where that is exponential in the length: not for fade_power below 1000.
    [[nodiscard]] Absorption absorption() const;

    /// What is left of the power of a wave after a length along its unit `ray`. Its unit E is re +
    /// i im; an isotropic stone does not ask for it.
    [[nodiscard]] double transmittance(const Vec3& k, const Vec3& ray, const Vec3& re,
                                       const Vec3& im, double length) const;

private:
    Medium medium_;
    double wavelength_nm_ = 0;
    /// k0 Im eps: index times absorption along each principal axis, per mm.
    RealTensor loss_{};
    const Fade* fade_ = nullptr;
};

}  // namespace icespar
