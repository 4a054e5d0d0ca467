// How exact the places of facets are.
#pragma once

#include "stone/stone.hpp"

namespace icespar {

/// How far a stone's surface may be off by the rounding of its place and its size.
[[nodiscard]] double rounding_of(const Stone& stone);

}  // namespace icespar
