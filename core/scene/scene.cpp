// The light of formulas, and where the camera stands.
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "scene/nearby.hpp"
#include "stone/rounding.hpp"

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

bool scatters(const Scene& scene) {
    return std::any_of(scene.things.begin(), scene.things.end(),
                       [](const Thing& t) { return !t.filter && t.finish.diffuse > 0; });
}

const Gem* gem_around(const Scene& scene, const Vec3& point) {
    for (const Gem& gem : scene.gems) {
        if (inside(gem.stone, point)) return &gem;
    }
    return nullptr;
}

namespace {

/// Whether a part of the rectangle from which a parallel view looks lies within the stone: the
/// rectangle, cut by every facet's plane, is not empty.
bool starts_within(const Camera& c, const Stone& stone) {
    std::vector<Vec3> left, next;
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        left.push_back(c.location + u * c.right + v * c.up);
    }
    const double skin = rounding_of(stone);
    for (const Facet& f : stone.facets) {
        next.clear();
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Vec3 &a = left[i], &b = left[(i + 1) % left.size()];
            const double in_a = f.distance - skin - dot(f.normal, a),
                         in_b = f.distance - skin - dot(f.normal, b);
            if (in_a > 0) next.push_back(a);
            if ((in_a > 0) != (in_b > 0)) next.push_back(a + (in_a / (in_a - in_b)) * (b - a));
        }
        left.swap(next);
        if (left.empty()) return false;
    }
    return true;
}

}  // namespace

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
    if (c.kind == Camera::Kind::orthographic) {
        for (const Gem& cut : scene.gems) {
            if (!starts_within(c, cut.stone)) continue;
            out.push_back("lines of sight of the parallel view start inside the stone at " +
                          cut.name + "; move the camera back");
            break;
        }
    }
    return out;
}

}  // namespace icespar
