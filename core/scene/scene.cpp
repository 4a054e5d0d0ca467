// The light of formulas, and where the camera stands.
#include "scene/scene.hpp"

#include <cmath>

#include "scene/nearby.hpp"

namespace icespar {

Stokes formula_light(const Environment& environment, const Vec3& direction) {
    const auto& f = environment.formulas;
    const Vec3 d = normalised(environment.to_own.vector(direction));
    const double radiance = f[0](d);
    if (!(radiance > 0 && std::isfinite(radiance))) return {};
    if (f.size() < 4) return {radiance, 0, 0, 0};
    Stokes light{radiance, f[1](d), f[2](d), f[3](d)};
    const double polarised = std::hypot(light.s1, light.s2, light.s3);
    if (!std::isfinite(polarised)) return {};
    if (polarised > radiance) {
        const double less = radiance / polarised;
        light = {radiance, less * light.s1, less * light.s2, less * light.s3};
    }
    return light;
}

const Gem* gem_around(const Scene& scene, const Vec3& point) {
    for (const Gem& gem : scene.gems) {
        if (inside(gem.stone, point)) return &gem;
    }
    return nullptr;
}

std::vector<std::string> camera_faults(const Scene& scene) {
    std::vector<std::string> out;
    const Camera& c = scene.camera;
    if (!is_finite(c.location) || !is_finite(c.direction) || !is_finite(c.right) ||
        !is_finite(c.up) || !(std::abs(dot(c.direction, cross(c.right, c.up))) > 0)) {
        out.push_back("camera: direction, right and up must be finite and not in one plane");
    }
    const Gem* gem = gem_around(scene, c.location);
    if (c.kind != Camera::Kind::orthographic && gem != nullptr) {
        out.push_back("the camera is inside the stone at " + gem->name + "; move it out");
    }
    return out;
}

}  // namespace icespar
