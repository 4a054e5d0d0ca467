// Turns and mirrors of the picture that leave stone, crystal and view as they are.
#pragma once

#include <vector>

#include "views/view.hpp"

namespace icespar {

struct ViewSymmetry {
    std::vector<PictureImage> images;  ///< the identity first
    /// A part of the picture whose images fill it once: where all of these are positive.
    std::vector<Affine> sector;
};

/// True to 1e-12; only the identity for a view along which there is no more.
[[nodiscard]] ViewSymmetry symmetry_of(const Stone& stone, const Medium& medium,
                                       const RealTensor& loss, const PictureFrame& frame);
/// The identity alone.
[[nodiscard]] ViewSymmetry no_symmetry(const Stone& stone);

}  // namespace icespar
