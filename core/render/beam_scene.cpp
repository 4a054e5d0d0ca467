// Stones laid out for beams; what stands in front of others is left to rays.
#include "render/beam_scene.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {

BeamScene::BeamScene(const World& world, const Needs& needs, int width, int height)
    : world_(world), needs_(needs), width_(width), height_(height) {
    const Scene& scene = world.scene();
    for (std::size_t i = 0; i < scene.gems.size(); ++i) {
        const Stone& stone = scene.gems[i].stone;
        stones_.facets.emplace_back(stone);
        stones_.footprints.emplace_back(stone, scene.camera, width, height);
        stones_.visibility.emplace_back(world, static_cast<int>(i), width, height);
    }
}

int BeamScene::block_side(int samples) const {
    if (!needs_.blocks) return 1;
    const Camera& camera = world_.scene().camera;
    if (camera.kind == Camera::Kind::orthographic) return most_across;
    // Directions are expanded to first order, so that what falls into a wrong pixel grows with a
    // pixel's angle and the square of the side. It stays well below the noise (docs/method.md).
    constexpr double noise = 3.2, slope = 0.8;
    const double angle = std::max(length(camera.right) / width_, length(camera.up) / height_) /
                         length(camera.direction);
    const double most = noise * std::pow(samples, -slope) / angle;
    int side = most_across;
    while (side > 1 && side * side > most) side /= 2;
    return side;
}

bool BeamScene::tells_error() const { return !needs_.surroundings; }

int BeamScene::stone_at(int x, int y) const {
    int found = -1;
    for (std::size_t i = 0; i < stones_.footprints.size(); ++i) {
        if (!stones_.footprints[i].frame().holds(x, y)) continue;
        if (found >= 0 || !needs_.stones[i].beams || stones_.visibility[i].doubtful(x, y)) {
            return by_rays;
        }
        found = static_cast<int>(i);
    }
    return found >= 0 ? found : needs_.surroundings ? by_rays : sky;
}

}  // namespace icespar
