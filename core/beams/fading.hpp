// Lengths along a beam's way by which a coloured stone's light fades.
#pragma once

#include <algorithm>
#include <array>

#include "beams/expansion.hpp"
#include "crystal/loss.hpp"
#include "crystal/medium.hpp"

namespace icespar {

/// After which a wave has lost as much as a wave of the isotropic stone; in a crystal one polarised
/// across the axis, one polarised along it, and any wave (the length itself).
template <bool birefringent>
using LengthsOf = std::array<Affine, birefringent ? 3 : 1>;

template <bool birefringent>
class FadingLengths {
public:
    using Lengths = LengthsOf<birefringent>;

    void set_medium(const Medium& medium) {
        n_ = medium.n_o;
        if constexpr (birefringent) {
            const RealTensor along = dyad(medium.axis);
            across_ = medium.n_o * (RealTensor::diagonal(1, 1, 1) + -1.0 * along);
            along_ = medium.n_e * along;
        }
    }

    /// From `position` on along the flow of a wave with k and E to a plane that is `t` away. What
    /// grazes a facet may be expanded to lengths below 0, along which light would grow.
    [[nodiscard]] Lengths onward(Lengths lengths, const Expansion& position, const Vec3& k,
                                 const Vec3& E, const Expansion& flow, const Vec3& normal,
                                 double t) const {
        const double speed = -1 / dot(normal, flow.value);
        const double dx = speed * dot(normal, position.dx + t * flow.dx),
                     dy = speed * dot(normal, position.dy + t * flow.dy);
        const auto add = [&](std::size_t i, double rate) {
            Affine& length = lengths[i];
            length = {length.value + rate * std::max(0.0, t), length.dx + rate * dx,
                      length.dy + rate * dy};
        };
        if constexpr (birefringent) {
            add(0, loss_along(across_, E, k, flow.value));
            add(1, loss_along(along_, E, k, flow.value));
            add(2, length(flow.value));
        } else {
            add(0, n_);
        }
        return lengths;
    }

private:
    double n_ = 1;
    RealTensor across_{}, along_{};  ///< losses of unit absorption, across the axis and along it
};

}  // namespace icespar
