// Whether two scenes agree to the last bit.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace icespar {

/// Where everything stands and what shape it has: all numbers as bits, and the lengths of lists.
inline std::vector<std::uint64_t> numbers_of(const Scene& scene) {
    std::vector<std::uint64_t> out;
    const auto add = [&](double value) { out.push_back(std::bit_cast<std::uint64_t>(value)); };
    const auto vector = [&](const Vec3& v) { add(v.x), add(v.y), add(v.z); };
    const Camera& c = scene.camera;
    for (const Vec3& v : {c.location, c.direction, c.right, c.up}) vector(v);
    out.push_back(scene.gems.size());
    for (const Gem& gem : scene.gems) {
        for (const Vec3& v : gem.stone.vertices) vector(v);
        for (const Facet& f : gem.stone.facets) {
            vector(f.normal), add(f.distance);
            out.insert(out.end(), f.corners.begin(), f.corners.end());
        }
    }
    out.push_back(scene.things.size());
    for (const Thing& thing : scene.things) {
        for (const Vec3& v : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
            vector(thing.to_world.point(v));
    }
    out.push_back(scene.lights.size());
    for (const Light& light : scene.lights)
        vector(light.position), vector(light.edge_u), vector(light.edge_v);
    return out;
}

inline bool same_numbers(const Scene& a, const Scene& b) { return numbers_of(a) == numbers_of(b); }

}  // namespace icespar
