// The scene is looked at once; every kernel is picked from what is found here.
#include "render/needs.hpp"

#include <algorithm>

#include "math/error.hpp"
#include "render/view_picture.hpp"

namespace icespar {
namespace {

/// With no more objects than this, asking all is cheaper than a tree (bench/).
constexpr std::size_t few_objects = 4;

/// Beams add up lengths of paths, which tell what is left where the law is exponential.
bool fades_otherwise(const Crystal& c) { return c.fade && !c.fade->exponential(); }

StoneNeeds needs_of_stone(const Crystal& c, const Forced& forced) {
    StoneNeeds n;
    n.birefringent = c.birefringent();
    n.active = c.active();
    n.general = c.indices.size() == 3 || n.active || (forced.general && n.birefringent);
    n.wavelengths = c.dispersive() || forced.wavelengths;
    n.parts_wavelengths = c.parts_wavelengths() || forced.wavelengths;
    n.absorption = c.absorbs() || forced.absorption;
    n.beams = !n.general && !fades_otherwise(c);
    n.faint_rays = n.beams && n.birefringent && !c.absorbs() && !forced.survivors;
    return n;
}

/// Lines of sight of a parallel view have a start, which beams do not ask for.
bool reaches_behind(const Camera& camera, const Stone& stone) {
    return camera.kind == Camera::Kind::orthographic &&
           std::any_of(stone.vertices.begin(), stone.vertices.end(), [&](const Vec3& v) {
               return dot(v - camera.location, camera.direction) <= 0;
           });
}

std::string obstacle(const Scene& scene, const std::vector<StoneNeeds>& stones,
                     const Forced& forced) {
    if (stones.empty()) return "there is no stone in the scene";
    if (scene.camera.kind == Camera::Kind::fisheye) return "the camera is a fisheye";
    if (scene.camera.lens_radius > 0) return "the camera has a lens";
    if (scene.camera.analyser) return "the camera has an analyser";
    const auto any = [&](auto property) {
        return std::any_of(stones.begin(), stones.end(), property);
    };
    if (any([](const StoneNeeds& s) { return s.beams; })) return {};
    std::string why;
    const auto add = [&](bool is, const char* what) {
        if (is) why += (why.empty() ? "" : " or ") + std::string(what);
    };
    const auto fades = [](const Gem& g) { return fades_otherwise(g.crystal); };
    add(std::any_of(scene.gems.begin(), scene.gems.end(), fades),
        "attenuate light otherwise than exponentially");
    add(any([](const StoneNeeds& s) { return s.active; }), "turn polarisation");
    add(any([](const StoneNeeds& s) { return s.general && !s.active; }),
        forced.general ? "are left to the general solver" : "are biaxial");
    const auto behind = [&](const Gem& g) { return reaches_behind(scene.camera, g.stone); };
    add(std::any_of(scene.gems.begin(), scene.gems.end(), behind), "reach behind the camera");
    return "its stones " + why;
}

}  // namespace

bool& Forced::part(std::string_view name) {
    if (name == "wavelengths") return wavelengths;
    if (name == "stokes") return stokes;
    if (name == "general") return general;
    if (name == "absorption") return absorption;
    if (name == "tree") return tree;
    if (name == "surroundings") return surroundings;
    if (name == "pixels") return pixels;
    if (name == "survivors") return survivors;
    throw Error("full: '" + std::string(name) +
                "' is not one of wavelengths, stokes, general, absorption, tree, surroundings, "
                "pixels and survivors");
}

std::size_t bounded_objects(const Scene& scene) {
    std::size_t count = scene.gems.size();
    for (const Thing& thing : scene.things) {
        const auto* mesh = std::get_if<MeshShape>(&thing.shape);
        if (mesh)
            count += mesh->mesh->triangles.size();
        else if (!std::holds_alternative<PlaneShape>(thing.shape))
            ++count;
    }
    return count;
}

Needs needs_of(const Scene& scene, bool stokes, Engine engine, const Forced& forced) {
    Needs n;
    n.forced = forced;
    n.stokes = stokes || forced.stokes;
    for (const Gem& gem : scene.gems) {
        StoneNeeds& s = n.stones.emplace_back(needs_of_stone(gem.crystal, forced));
        const bool behind = reaches_behind(scene.camera, gem.stone);
        s.beams = s.beams && !behind;
        if (behind) n.exact_obstacle = "the stone reaches behind the camera";
        n.wavelengths |= s.wavelengths;
        n.birefringent |= s.birefringent;
        n.general |= s.general;
        n.absorption |= s.absorption;
    }
    n.tree = bounded_objects(scene) > few_objects || forced.tree;
    const Environment& sky = scene.environment;
    n.surroundings = scene.gems.size() > 1 || !scene.things.empty() ||
                     sky.state != Stokes{1, 0, 0, 0} || sky.pattern || !sky.formulas.empty() ||
                     forced.surroundings;
    n.obstacle = obstacle(scene, n.stones, forced);
    if (n.exact_obstacle.empty()) n.exact_obstacle = view_obstacle(scene);
    const bool exact =
        engine == Engine::exact || (engine == Engine::automatic && forced == Forced{});
    if (exact && n.exact_obstacle.empty()) {
        n.engine = Engine::exact;
    } else {
        n.engine = engine != Engine::rays && n.obstacle.empty() ? Engine::beams : Engine::rays;
    }
    n.blocks = n.engine == Engine::beams && !n.surroundings && !forced.pixels;
    return n;
}

}  // namespace icespar
