// A branch of light through an ideal sheet.
#pragma once

#include "render/branch.hpp"

namespace icespar {

/// Applies the sheet's Jones matrix to the branch, which is outside of stones; its ray goes on
/// unbent. `normal` is the sheet's, of either sign. False when nothing passes.
[[nodiscard]] bool pass_filter(Branch& branch, const Filter& filter, const Vec3& normal,
                               double wavelength_nm);

}  // namespace icespar
