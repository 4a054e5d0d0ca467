// What a coloured stone leaves of each colour along a beam's path.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "beams/polygon.hpp"
#include "scene/crystal.hpp"

namespace icespar {

/// Depths are sums over the lengths that a beam has gone (BeamTracer), so that paths carry a number
/// or three and no spectrum.
class PathColour {
public:
    /// Follows colours of equal weight: each is the mean of the next `per_colour` wavelengths.
    void set(const Crystal& crystal, std::span<const double> wavelengths_nm,
             std::size_t per_colour = 1);
    /// Only those from number `first` to `last` - 1.
    void narrow(std::size_t first, std::size_t last);

    /// The mean over the colours of what is left after these lengths.
    double transmit(std::span<const Affine> lengths);

    /// After `transmit`: by colour, what is left over the mean. Of those that are followed.
    [[nodiscard]] std::span<const double> tint() const { return tint_; }
    /// From u in the unit interval such a number as makes colours as frequent as they are strong.
    [[nodiscard]] double draw(double u) const;
    /// What is left at a wavelength over what is left of the colour that number `drawn` is one of.
    [[nodiscard]] double correction(double drawn, double wavelength_nm) const;

private:
    const Crystal* crystal_ = nullptr;
    std::size_t first_ = 0, last_ = 0;
    std::array<std::vector<double>, 3> per_length_;
    std::array<double, 3> lengths_{};
    std::vector<double> tint_;
    double mean_ = 1;
};

}  // namespace icespar
