// What reaches a point from a lamp, but for what stands between.
#pragma once

#include "scene/scene.hpp"

namespace icespar {

struct LampRay {
    Vec3 to_lamp;         ///< unit
    double distance = 0;  ///< within which things cast shadows
    double strength = 0;  ///< of the lamp's light: its beam and its fading
};

/// (u, v) of the unit square choose the point of an area light.
[[nodiscard]] LampRay lamp_ray(const Light& light, const Vec3& point, double u, double v);

}  // namespace icespar
