// What a stone is made of, over the spectrum.
#pragma once

#include <optional>
#include <vector>

#include "crystal/index.hpp"
#include "math/vec3.hpp"
#include "spectrum/spectrum.hpp"

namespace icespar {

/// POV-Ray's attenuation in an interior, for each stretch of a path between two facets. With c the
/// colour and x = length / distance, what is left is exp(-(1 - c) x) for a power of 1000 or more
/// (Beer and Lambert's law), otherwise c + (1 - c) / (1 + x^power).
struct Fade {
    double distance = 1;  ///< mm, not 0
    double power = 1000;
    Spectrum colour{0.0};
    /// Beer and Lambert's law, which never adds light.
    [[nodiscard]] bool exponential() const;
    [[nodiscard]] double transmittance(double length, double wavelength_nm) const;
};

/// One index: isotropic. Two: uniaxial, n_o then n_e. Three: biaxial.
struct Crystal {
    std::vector<IndexFunction> indices{IndexFunction(1.5)};
    /// Unit, in world coordinates. Uniaxial: the optic axis. Biaxial: the principal axis of the
    /// first index.
    Vec3 axis{0, 0, 1};
    /// Biaxial: the principal axis of the third index, unit and perpendicular to `axis`.
    Vec3 third_axis{1, 0, 0};
    /// Of intensity, per mm, one for each index: for light polarised along that principal axis
    /// (uniaxial: across the axis, then along it). Empty: clear.
    std::vector<Spectrum> absorption{};
    std::optional<Fade> fade{};
    /// Uniaxial: degrees per mm by which light along the axis is turned, > 0 dextrorotatory.
    Spectrum rotation{0.0};

    [[nodiscard]] bool birefringent() const { return indices.size() > 1; }
    [[nodiscard]] bool absorbs() const { return fade || !absorption.empty(); }
    [[nodiscard]] bool active() const { return rotation.least() != 0 || rotation.greatest() != 0; }
    /// Whether it treats wavelengths differently.
    [[nodiscard]] bool dispersive() const;
    /// Whether it sends them different ways.
    [[nodiscard]] bool parts_wavelengths() const;
};

}  // namespace icespar
