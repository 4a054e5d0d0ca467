// What part of a stone's face is bright under the domes by which faceters judge it.
#pragma once

#include <optional>

#include "views/view.hpp"

namespace icespar {

/// Radiance over the height d of a direction above the horizon, as GemRay defines it: 1, d, and 2 d
/// sqrt(1 - d^2); none from below, and none from behind the viewer's head.
enum class Dome { iso, cosine, sc2 };

struct DomeLight {
    Dome dome = Dome::iso;
    Vec3 zenith{0, 0, 1};  ///< unit; where the viewer's head is
    double head = 0;       ///< angle from the middle of the head to its edge, radians; 0: none

    [[nodiscard]] double radiance(const Vec3& direction) const;
    /// The greatest there is.
    [[nodiscard]] double greatest() const { return 1; }
};

/// The mean radiance that is seen. It is never further than `bound` from `value`; where the rest of
/// the light was not sampled it is not below `value`.
struct LightReturn {
    double value = 0, bound = 0;
    double error = 0;  ///< one standard error of the sample; without one, the bound
};

/// Of the whole stone, or of what is seen in one of its facets. A facet that is not seen has the
/// value 0.
[[nodiscard]] LightReturn light_return(const Exits& exits, const DomeLight& light,
                                       std::optional<int> facet = {});

/// The facet whose normal points along z, the dop axis, if there is one.
[[nodiscard]] std::optional<int> table_facet(const Stone& stone);

}  // namespace icespar
