// The ray of a point of the picture.
#pragma once

#include <optional>

#include "render/branch.hpp"

namespace icespar {

/// u and v from 0 to 1 rightwards and downwards; a and b from 0 to 1 choose the point of the lens.
/// Nothing where a fisheye's picture has no ray.
[[nodiscard]] std::optional<Branch> camera_branch(const Camera& camera, double u, double v,
                                                  double a, double b);

}  // namespace icespar
