// Conservative: whatever cannot be shown to lie behind a stone may hide it.
#include "render/visibility.hpp"

#include <algorithm>
#include <array>

namespace icespar {
namespace {

std::array<Vec3, 8> corners(const Bounds& b) {
    std::array<Vec3, 8> out;
    for (std::size_t i = 0; i < 8; ++i) {
        out[i] = {(i & 1) != 0 ? b.high.x : b.low.x, (i & 2) != 0 ? b.high.y : b.low.y,
                  (i & 4) != 0 ? b.high.z : b.low.z};
    }
    return out;
}

/// Where the camera's lines start: its location, or the corners of a parallel view.
std::vector<Vec3> starts(const Camera& c) {
    if (c.kind == Camera::Kind::perspective) return {c.location};
    std::vector<Vec3> out;
    for (const double u : {-0.5, 0.5}) {
        for (const double v : {-0.5, 0.5}) out.push_back(c.location + u * c.right + v * c.up);
    }
    return out;
}

}  // namespace

Visibility::Visibility(const World& world, int gem, int width, int height) {
    const Scene& scene = world.scene();
    const Stone& stone = scene.gems[static_cast<std::size_t>(gem)].stone;
    const std::vector<Vec3> eyes = starts(scene.camera);

    for (const int index : world.unbounded()) {
        const Transform back = scene.things[static_cast<std::size_t>(index)].to_world.inverse();
        const auto above = [&](const Vec3& p) { return back.point(p).y > 0; };
        const auto below = [&](const Vec3& p) { return back.point(p).y < 0; };
        const auto apart = [&](const auto& side) {
            return std::all_of(eyes.begin(), eyes.end(), side) &&
                   std::all_of(stone.vertices.begin(), stone.vertices.end(), side);
        };
        if (!apart(above) && !apart(below)) before_.push_back({0, 0, width, height});
    }

    // A line to a facet stays outside its plane until it is there.
    const auto behind_all_seen = [&](std::span<const Vec3> box) {
        for (const Facet& f : stone.facets) {
            const auto outside = [&](const Vec3& p) { return dot(f.normal, p) > f.distance; };
            const bool turned_away = scene.camera.kind == Camera::Kind::orthographic
                                         ? !(dot(f.normal, scene.camera.direction) < 0)
                                         : !outside(scene.camera.location);
            if (!turned_away && std::any_of(box.begin(), box.end(), outside)) return false;
        }
        return true;
    };
    const Projection projection(scene.camera, width, height);
    for (std::size_t i = 0; i < world.bounds().size(); ++i) {
        if (static_cast<int>(i) == gem) continue;
        const auto box = corners(world.bounds()[i]);
        if (!behind_all_seen(box)) before_.push_back(projection.frame(box));
    }
}

}  // namespace icespar
