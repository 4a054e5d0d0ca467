// The outgoing waves of a crystal that is almost isotropic.
#pragma once

#include "interface/plane.hpp"

namespace icespar {

/// The outgoing plane of a crystal that is almost isotropic, eps = mean I + deviation, as a
/// perturbation of the isotropic one, so that its two waves keep their own precision: H = X E and
/// D = q + M on the plane, M of the size of the deviation. X solves a Riccati equation whose linear
/// part is -2 q; false where the deviation is not small beside q.
template <class R>
bool nearly_isotropic(R mean, const SymmetricTensor<R>& dev, R K, int sign, Plane<R>& plane,
                      R (&M)[2][2], R& q);

}  // namespace icespar
