// What would make a wrong picture: the last look at a scene before light enters it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "scene/contact.hpp"
#include "scene/nearby.hpp"
#include "scene/scene.hpp"

namespace icespar {
namespace {

constexpr std::size_t enough_faults = 20;
constexpr std::size_t most_work = 2'000'000;  ///< pairs whose bounds meet

void check_crystal(const Crystal& c, const std::function<void(std::string)>& add) {
    if (c.indices.empty() || c.indices.size() > 3) {
        add("a stone needs one index (isotropic), two (uniaxial) or three (biaxial)");
    }
    for (const IndexFunction& n : c.indices) {
        if (!n.valid()) {
            add("a refractive index is below 1 or not finite between 380 and 780 nm");
        }
    }
    if (!(std::abs(length(c.axis) - 1) < 1e-6)) {
        add("the optic axis is not a unit vector");
    }
    if (c.indices.size() == 3 && (!(std::abs(length(c.third_axis) - 1) < 1e-6) ||
                                  !(std::abs(dot(c.axis, c.third_axis)) < 1e-6))) {
        add("the principal axes are not perpendicular unit vectors");
    }
    if (!c.absorption.empty() && c.absorption.size() != c.indices.size()) {
        add("absorption needs one spectrum for each refractive index");
    }
    for (const Spectrum& a : c.absorption) {
        if (!(a.least() >= 0)) add("absorption is below 0");
    }
    if (c.fade && (!(c.fade->distance > 0) || !(c.fade->power >= 0) ||
                   !(c.fade->colour.least() >= 0) || !(c.fade->colour.greatest() <= 1))) {
        add("attenuation needs a distance above 0, a power of at least 0 and a "
            "colour between 0 and 1");
    }
    if (c.indices.size() != 2 && c.active()) {
        add("optical activity is known for uniaxial stones only");
    }
}

/// What is wrong with one gem by itself.
void check_gem(const Gem& gem, std::size_t number, std::vector<SceneFault>& out) {
    const auto add = [&](std::string message) { out.push_back({number, std::move(message)}); };

    if (gem.stone.facets.size() < 4) add("this stone is not closed");
    for (const Facet& f : gem.stone.facets) {
        if (!is_finite(f.normal) || !std::isfinite(f.distance)) {
            add("facet '" + f.name + "' is not finite");
        }
    }
    check_crystal(gem.crystal, add);
}

}  // namespace

std::vector<SceneFault> scene_faults(const Scene& scene) {
    std::vector<SceneFault> out;
    const NearbyGems gems(scene);
    const auto enough = [&] { return out.size() >= enough_faults; };
    for (const Disc& disc : scene.environment.discs) {
        constexpr double rounding = 1e-9;
        if (!(std::abs(length(disc.direction) - 1) < rounding) || !std::isfinite(disc.cos_radius)) {
            out.push_back(
                {std::nullopt, "a disc's direction must be a unit vector, its size finite"});
        }
    }
    // Inside a stone only facets are met: what stands there would be passed over in silence.
    for (const Light& light : scene.lights) {
        if (const auto gem = gems.around(light.position); gem && !enough()) {
            out.push_back({*gem, "a light source is inside this stone; move it out"});
        }
    }
    std::size_t work = 0;
    const auto too_much = [&](std::size_t gem) {
        if (work <= most_work) return false;
        out.push_back({gem,
                       "too many stones and things stand as close as this one to be compared: "
                       "the bound is " +
                           std::to_string(most_work) + " pairs"});
        return true;
    };
    for (const Thing& thing : scene.things) {
        if (enough()) break;
        std::optional<std::size_t> cut, last;
        const auto look_at = [&](std::size_t i) {
            work += 1 + polygons_of(thing) / 16;
            last = i;
            if (runs_through(thing, scene.gems[i].stone) && (!cut || i < *cut)) cut = i;
            return work <= most_work;
        };
        const std::vector<Vec3> bounds = outermost_points(thing);
        for (std::size_t i = 0; bounds.empty() && i < scene.gems.size(); ++i) {
            if (!look_at(i)) break;
        }
        if (!bounds.empty()) gems.near(bounds, look_at);
        if (cut) {
            out.push_back({*cut, thing.filter
                                     ? "a sheet runs through this stone; move it out"
                                     : "an opaque object is inside this stone, or runs through it; "
                                       "move it out"});
        }
        if (last && too_much(*last)) return out;
    }
    for (std::size_t i = 0; i < scene.gems.size() && !enough(); ++i) {
        const Gem& gem = scene.gems[i];
        check_gem(gem, i, out);
        if (gem.stone.vertices.empty()) continue;
        std::vector<std::size_t> others;
        gems.near(gem.stone.vertices, [&](std::size_t j) {
            if (j > i && ++work <= most_work) others.push_back(j);
            return work <= most_work;
        });
        std::sort(others.begin(), others.end());
        for (const std::size_t j : others) {
            Vec3 where;
            if (!enough() && overlap(gem.stone, scene.gems[j].stone, where)) {
                out.push_back({i, "this stone overlaps the one at " + scene.gems[j].name +
                                      "; move them apart"});
            }
        }
        if (too_much(i)) break;
    }
    return out;
}

std::vector<std::string> faults(const Scene& scene) {
    std::vector<std::string> out;
    for (const SceneFault& fault : scene_faults(scene)) {
        out.push_back((fault.gem ? scene.gems[*fault.gem].name : "environment") + ": " +
                      fault.message);
    }
    return out;
}

}  // namespace icespar
