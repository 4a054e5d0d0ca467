// What an absorbing medium takes from a wave on its way.
#pragma once

#include "math/symmetric.hpp"
#include "math/vec3.hpp"

namespace icespar {

/// The power that a wave of unit field E and wave vector k loses per multiple of `along`, which
/// lies along its ray: by Poynting's theorem, to first order, E . loss E / (k . ray) per unit of
/// length. `loss` is k0 Im eps, per unit of length: index times absorption along each principal
/// axis.
[[nodiscard]] inline double loss_along(const RealTensor& loss, const Vec3& E, const Vec3& k,
                                       const Vec3& along) {
    return dot(E, loss * E) * dot(along, along) / dot(k, along);
}

}  // namespace icespar
