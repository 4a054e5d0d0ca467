// What a coloured stone leaves of several colours on the same way: it follows from a few lengths.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "beams/polygon.hpp"
#include "crystal/medium.hpp"
#include "math/symmetric.hpp"
#include "math/vec3.hpp"
#include "views/view.hpp"

namespace icespar {

/// Colours of equal weight that a medium sends the same way. Their depths are sums of lengths, each
/// times the colour's rate: along an isotropic stone's path one, in multiples of its wave vector;
/// in a crystal one for each principal axis, and the plain one last.
class Colours {
public:
    /// Throws Error where an absorption has other axes than the medium.
    Colours(const Medium& medium, std::span<const Absorption> colours);

    [[nodiscard]] std::size_t count() const { return rates_.size(); }
    [[nodiscard]] const std::vector<ColourRates>& rates() const { return rates_; }
    /// A tensor with the symmetry of all absorptions.
    [[nodiscard]] RealTensor axes() const { return axes_[0] + 2.0 * axes_[1] + 3.0 * axes_[2]; }
    /// By how much a crystal's length number i grows along `along`, of a wave with E and k.
    [[nodiscard]] double growth(std::size_t i, const Vec3& E, const Vec3& k,
                                const Vec3& along) const;

    /// The mean over colours and polygon of what is left after these lengths.
    double transmit(PolygonView polygon, std::span<const Affine> lengths);
    /// Of each colour, after `transmit`, over that mean.
    [[nodiscard]] std::span<const double> tint() const { return tint_; }
    /// As where nothing is lost yet.
    void begin() { tint_.assign(count(), 1.0); }

private:
    std::array<RealTensor, 3> axes_{};  ///< of a crystal: along each length
    std::vector<ColourRates> rates_;
    std::vector<double> tint_;
};

}  // namespace icespar
