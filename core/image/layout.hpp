// Whether the planes of an image have the sizes it states.
#pragma once

#include "image/image.hpp"

namespace icespar {

/// Throws Error when a plane is too short or too long, or the wavelengths do not rise.
void check_layout(const Image& image);

}  // namespace icespar
