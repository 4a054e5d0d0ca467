// What holds for the whole scene: global_settings, and the unit of its lengths.
#include <algorithm>
#include <array>
#include <utility>

#include "parser/builder.hpp"

namespace icespar {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 5> units_mm{
    {{"um", 1e-3}, {"mm", 1}, {"cm", 10}, {"in", 25.4}, {"m", 1000}}};

}  // namespace

void Builder::global_settings(const Block& block) {
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "assumed_gamma") {
            if (cursor.next_is_number() && cursor.number("a gamma") != 1) {
                diagnostics_.warning(cursor.place(),
                                     "colours are linear here, as with assumed_gamma 1",
                                     "where they come out pale, write srgb instead of rgb");
            }
        } else if (item.word == "max_trace_level") {
            scene_.max_trace_level = static_cast<int>(cursor.number("max_trace_level", 1, 100000));
        } else if (item.word == "ambient_light") {
            const auto c = cursor.colour("a colour");
            ambient_light_ = {c[0], c[1], c[2]};
        } else if (item.word == "unit" && cursor.next_is(Item::Kind::word)) {
            const std::string_view name = cursor.take().word;
            const auto* found = std::find_if(units_mm.begin(), units_mm.end(),
                                             [&](const auto& unit) { return unit.first == name; });
            if (found == units_mm.end()) {
                throw Fault{cursor.place(), "'" + std::string(name) + "' is no unit of length",
                            "there are um, mm, cm, in and m, or a number of millimetres"};
            }
            unit_mm_ = found->second;
        } else if (item.word == "unit" || item.word == "mm_per_unit") {
            unit_mm_ = cursor.number("a length in millimetres", 1e-9, 1e9);
        } else if (item.kind == Item::Kind::value && !item.value.empty()) {
            throw unexpected(item, "global_settings");
        } else if (item.kind == Item::Kind::word && item.word.empty()) {
            cursor.skip_values();
        } else if (item.kind != Item::Kind::value) {
            throw unexpected(item, "global_settings");
        }
    }
}

/// The core's lengths are millimetres: absorption, activity and the phase of waves depend on them.
void Builder::to_millimetres() {
    const double u = unit_mm_;
    const Transform scaling = Transform::scaling({u, u, u});
    Camera& camera = scene_.camera;
    for (Vec3* v : {&camera.location, &camera.direction, &camera.right, &camera.up}) *v = u * *v;
    camera.lens_radius *= u;
    camera.focal_distance *= u;
    for (Gem& gem : scene_.gems) {
        gem.stone = gem.stone.transformed(scaling);
        if (gem.crystal.fade) gem.crystal.fade->distance *= u;
    }
    for (Thing& thing : scene_.things) {
        thing.to_world = thing.to_world.then(scaling);
        thing.pigment.to_pattern = scaling.inverse().then(thing.pigment.to_pattern);
    }
    for (Light& light : scene_.lights) {
        for (Vec3* v : {&light.position, &light.edge_u, &light.edge_v}) *v = u * *v;
        light.fade_distance *= u;
        if (light.kind != Light::Kind::cylinder) continue;
        light.radius *= u;
        light.falloff *= u;
    }
}

}  // namespace icespar
