// The choice of kernels in words.
#include <algorithm>

#include "beams/ray_lanes.hpp"
#include "render/needs.hpp"

namespace icespar {
namespace {

/// "the stone at ring.spar:12", "the stones at ring.spar:12 and ring.spar:15", "4 of 9 stones".
template <class Property>
std::string stones_with(const Scene& scene, const Needs& needs, Property property) {
    std::vector<std::string> names;
    std::size_t count = 0;
    for (std::size_t i = 0; i < needs.stones.size(); ++i) {
        if (!property(i)) continue;
        ++count;
        const std::string& name = scene.gems[i].name;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    const std::string all = std::to_string(needs.stones.size());
    if (count == needs.stones.size()) return count == 1 ? "the stone" : "all " + all + " stones";
    if (count == 1) return "the stone at " + names[0];
    return std::to_string(count) + " of " + all + " stones (the first at " + names[0] + ")";
}

std::string counted(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

constexpr const char* asked = "asked for, to compare: no stone needs it";

PlanLine wavelengths(const Scene& scene, const Needs& n) {
    const auto own = [&](std::size_t i) { return scene.gems[i].crystal.dispersive(); };
    const bool any =
        scene.gems.end() != std::find_if(scene.gems.begin(), scene.gems.end(),
                                         [](const Gem& g) { return g.crystal.dispersive(); });
    const bool parted = n.engine != Engine::beams ||
                        std::any_of(n.stones.begin(), n.stones.end(), [](const StoneNeeds& s) {
                            return s.wavelengths && (s.parts_wavelengths || !s.beams);
                        });
    if (any && !parted) {
        return {"wavelengths", "all on one path",
                stones_with(scene, n, own) +
                    " sends them the same way: a path knows what is left of each"};
    }
    if (any) {
        return {"wavelengths", "one at a time",
                "index or colour of " + stones_with(scene, n, own) + " depends on them"};
    }
    if (n.wavelengths) return {"wavelengths", "one at a time", asked};
    return {"wavelengths", "all on one path",
            n.stones.empty() ? "there is no stone" : "stones treat them alike; colours are exact"};
}

PlanLine crystals(const Scene& scene, const Needs& n) {
    const auto solver = [&](std::size_t i) { return n.stones[i].general; };
    const auto split = [&](std::size_t i) { return n.stones[i].birefringent; };
    if (n.stones.empty()) return {"crystals", "none", "there is no stone"};
    if (n.general) {
        const auto own = [&](std::size_t i) {
            return n.stones[i].active || scene.gems[i].crystal.indices.size() == 3;
        };
        bool any = false;
        for (std::size_t i = 0; i < n.stones.size(); ++i) any |= own(i);
        return {"crystals", "any, by the general solver",
                any ? stones_with(scene, n, own) + (" biaxial or optically active")
                    : std::string("asked for, to compare: closed forms would do for ") +
                          stones_with(scene, n, solver)};
    }
    if (n.birefringent) {
        return {"crystals", "uniaxial, by closed forms",
                "o and e part in " + stones_with(scene, n, split)};
    }
    return {"crystals", "isotropic", "no stone splits light"};
}

PlanLine absorption(const Scene& scene, const Needs& n) {
    if (!n.absorption) return {"absorption", "none", "stones are clear"};
    const auto own = [&](std::size_t i) { return scene.gems[i].crystal.absorbs(); };
    bool any = false;
    for (std::size_t i = 0; i < n.stones.size(); ++i) any |= own(i);
    return {"absorption", "along every path in a stone",
            any ? "light is taken by " + stones_with(scene, n, own) : std::string(asked)};
}

PlanLine objects(const Scene& scene, const Needs& n) {
    const std::size_t bounded = bounded_objects(scene);
    const std::string count = counted(bounded, "bounded object") +
                              (bounded > 0 && n.tree && n.forced.tree ? ", asked for" : "");
    if (n.tree) return {"objects", "found by Embree", count};
    return {"objects", bounded < 2 ? "no search" : "asked in turn", count};
}

PlanLine surroundings(const Scene& scene, const Needs& n) {
    const Environment& sky = scene.environment;
    const std::string by_rays = "light that leaves stones goes on as rays";
    if (scene.gems.empty()) return {"surroundings", "by rays", "there is no stone"};
    if (n.engine == Engine::exact) {
        return {"surroundings", "sky", "its light is looked up once for each beam"};
    }
    if (!n.surroundings) {
        return {"surroundings",
                sky.discs.empty() ? "sky" : "sky and " + counted(sky.discs.size(), "lamp"),
                "one stone below a smooth sky: light that leaves it is integrated exactly"};
    }
    if (!scene.things.empty())
        return {"surroundings", "objects and sky",
                counted(scene.things.size(), "object") + ": " + by_rays};
    if (scene.gems.size() > 1)
        return {"surroundings", "stones and sky",
                counted(scene.gems.size(), "stone") + ": " + by_rays};
    if (sky.pattern || !sky.formulas.empty())
        return {"surroundings", "a sky with a pattern", by_rays};
    if (sky.state != Stokes{1, 0, 0, 0}) return {"surroundings", "a polarised sky", by_rays};
    return {"surroundings", "sky", "asked for, to compare: " + by_rays};
}

PlanLine pixels(const Needs& n) {
    if (n.engine == Engine::exact) return {"pixels", "all together", "beams are drawn over them"};
    if (n.engine == Engine::rays) return {"pixels", "one by one", "each has its own rays"};
    if (n.blocks) return {"pixels", "up to 16 together", "what a beam brings is shared out"};
    return {"pixels", "one by one",
            n.surroundings ? "beams go on as rays of one pixel" : std::string(asked)};
}

PlanLine survivors(const Needs& n) {
    if (n.engine != Engine::beams) return {"survivors", "none", "no beam ends by chance"};
    const auto any = [&](bool StoneNeeds::*property) {
        return std::any_of(n.stones.begin(), n.stones.end(),
                           [&](const StoneNeeds& s) { return s.beams && s.*property; });
    };
    if (any(&StoneNeeds::faint_rays)) {
        return {"survivors", "rays",
                "faint beams of clear crystals go on as rays, " + std::to_string(RayLanes::size) +
                    " side by side"};
    }
    const char* why = !any(&StoneNeeds::birefringent)
                          ? "what survives by chance in one mode is little"
                      : n.forced.survivors ? asked
                                           : "a coloured crystal's light fades along them";
    return {"survivors", "beams", why};
}

PlanLine lights(const Scene& scene) {
    if (scene.lights.empty()) {
        const Environment& sky = scene.environment;
        const bool bright =
            scatters(scene) && (!sky.discs.empty() || sky.pattern || !sky.formulas.empty());
        return {"lights", "none",
                bright ? "diffuse surfaces look for lamps and bright parts of the sky"
                       : "the environment and what glows"};
    }
    const std::string count = counted(scene.lights.size(), "light source");
    if (!scatters(scene)) return {"lights", "unused", count + ", but no diffuse surface"};
    return {"lights", count, "asked at every point of a diffuse surface"};
}

/// Why a parallel view of a stone is not drawn by exact beams.
std::string not_exact(const Scene& scene, const Needs& n) {
    const bool parallel = scene.camera.kind == Camera::Kind::orthographic && !scene.gems.empty();
    return parallel && !n.exact_obstacle.empty() ? "; not exact beams: " + n.exact_obstacle
                                                 : std::string();
}

PlanLine engine(const Scene& scene, const Needs& n) {
    if (n.engine == Engine::exact) {
        return {
            "engine", "exact beams",
            "one stone in a parallel view: whole facets are followed, the faint rest is sampled"};
    }
    if (n.engine == Engine::beams) {
        std::size_t by_rays = 0;
        for (const StoneNeeds& s : n.stones) by_rays += s.beams ? 0 : 1;
        return {"engine", "beams",
                "pixels of stones are cut along the facets' edges" +
                    (by_rays > 0 ? "; " + std::to_string(by_rays) + " of " +
                                       counted(n.stones.size(), "stone") + " by rays"
                                 : std::string()) +
                    not_exact(scene, n)};
    }
    return {"engine", "rays", n.obstacle.empty() ? "asked for" : n.obstacle + not_exact(scene, n)};
}

}  // namespace

std::vector<PlanLine> plan(const Scene& scene, const Needs& n) {
    return {
        wavelengths(scene, n),
        {"polarisation", n.stokes ? "Stokes vectors" : "intensity",
         n.stokes ? "asked for"
                  : "Stokes vectors were not asked for; what turns s into p counts all the same"},
        crystals(scene, n),
        absorption(scene, n),
        objects(scene, n),
        surroundings(scene, n),
        lights(scene),
        pixels(n),
        survivors(n),
        engine(scene, n)};
}

std::vector<std::string> plan_warnings(const Scene& scene) {
    std::vector<std::string> out;
    if (scene.gems.empty() || !scatters(scene)) return out;
    if (!scene.lights.empty()) {
        out.push_back(
            "stones cast plain shadows from light sources onto diffuse surfaces: the light that "
            "they "
            "gather there (caustics) is left out; lamps of the environment bring it");
    }
    if (!scene.environment.discs.empty()) {
        out.push_back(
            "light of the environment's lamps reaches diffuse surfaces through stones by chance: "
            "such caustics converge slowly");
    }
    return out;
}

std::string plan_text(const Scene& scene, const Needs& needs) {
    std::string text;
    const std::vector<PlanLine> lines = plan(scene, needs);
    std::size_t subject = 0, choice = 0;
    for (const PlanLine& l : lines) {
        subject = std::max(subject, l.subject.size());
        choice = std::max(choice, l.choice.size());
    }
    for (const PlanLine& l : lines) {
        text += l.subject + std::string(subject + 2 - l.subject.size(), ' ') + l.choice +
                std::string(choice + 2 - l.choice.size(), ' ') + l.reason + '\n';
    }
    for (const std::string& warning : plan_warnings(scene)) text += "warning: " + warning + '\n';
    return text;
}

std::string plan_summary(const Needs& n) {
    std::string text = n.engine == Engine::exact   ? "exact beams"
                       : n.engine == Engine::beams ? "beams"
                                                   : "rays";
    text += n.wavelengths ? ", spectral" : ", one path for all wavelengths";
    text += n.stokes ? ", Stokes" : ", intensity";
    if (!n.stones.empty())
        text += n.general ? ", any crystal" : n.birefringent ? ", uniaxial" : ", isotropic";
    if (n.absorption) text += ", absorbing";
    if (n.tree) text += ", Embree";
    if (!n.stones.empty() && !n.surroundings) text += ", sky alone";
    return text;
}

}  // namespace icespar
