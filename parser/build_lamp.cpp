// light_source: points, spots, cylinders and parallel beams, with area and fading.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parser/builder.hpp"

namespace icespar {

Part Builder::lamp(const Block& block) {
    Part part;
    part.kind = Part::Kind::lamp;
    part.where = block.place;
    Light& light = part.light;
    Spectrum source = white();
    Spectrum colour{1.0};
    bool coloured = false, placed = false;
    std::optional<double> radius, falloff, tightness;
    part.point_at = {0, 0, 1};
    Look none;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        const std::string_view word = item.kind == Item::Kind::word ? item.word : "";
        if (!placed && item.kind == Item::Kind::value && item.value.numbers()) {
            light.position = cursor.vector("a position");
            placed = true;
        } else if (next_is_ink(cursor)) {
            colour = ink(cursor, "a colour").spectrum;
            coloured = true;
        } else if (word == "area_light") {
            cursor.take();
            light.edge_u = cursor.vector("its first edge");
            light.edge_v = cursor.vector("its second edge");
            if (cursor.next_is_number()) (void)cursor.number("a number of lamps", 1, 1e6);
            if (cursor.next_is_number()) (void)cursor.number("a number of lamps", 1, 1e6);
        } else if (word == "spotlight" || word == "cylinder") {
            cursor.take();
            light.kind = word == "spotlight" ? Light::Kind::spot : Light::Kind::cylinder;
        } else if (word == "parallel" || word == "shadowless" || word == "circular" ||
                   word == "orient") {
            cursor.take();
            (word == "parallel"     ? light.parallel
             : word == "shadowless" ? light.shadowless
             : word == "circular"   ? light.circular
                                    : light.orient) = true;
        } else if (word == "point_at") {
            cursor.take();
            part.point_at = cursor.vector("a point");
        } else if (word == "radius" || word == "falloff" || word == "tightness") {
            cursor.take();
            const double value = cursor.number(word, 0, 1e9);
            (word == "radius" ? radius : word == "falloff" ? falloff : tightness) = value;
        } else if (word == "fade_distance") {
            cursor.take();
            light.fade_distance = cursor.number("fade_distance", 0, 1e12);
        } else if (word == "fade_power") {
            cursor.take();
            light.fade_power = cursor.number("fade_power", 0, 100);
        } else if (word == "illuminant" || word == "blackbody") {
            cursor.take();
            source = illuminant_named(cursor, word);
        } else if (!modifier(cursor, none, part.place)) {
            if (excused(block)) throw Poisoned{item.place};
            throw unexpected(item, "light_source");
        }
    }
    if (!placed && excused(block)) throw Poisoned{block.place};
    if (!placed) throw Fault{block.place, "a light_source needs a position", "such as <0, 10, -5>"};
    if (!coloured && diagnostics_.errors() == 0) {
        diagnostics_.warning(block.place, "this light_source has no colour: it is taken as rgb 1");
    }
    light.light = source * colour;
    light.tightness = tightness.value_or(0);
    if (light.kind == Light::Kind::spot) {
        const double degree = std::numbers::pi / 180;
        light.radius = radius.value_or(30) * degree;
        light.falloff = std::max(falloff.value_or(45) * degree, light.radius);
        if (light.falloff >= 90 * degree) light.falloff = 90 * degree;
    } else if (light.kind == Light::Kind::cylinder) {
        light.falloff = falloff.value_or(1);
        light.radius = std::min(radius.value_or(0.75), light.falloff);
        if (!(light.falloff > 0)) {
            throw Fault{block.place, "the 'falloff' of a cylinder of light is above 0", {}};
        }
    }
    if ((light.kind != Light::Kind::point || light.parallel) &&
        !(length(part.point_at - light.position) > 0)) {
        throw Fault{block.place, "this light_source points at where it stands",
                    "give it another 'point_at'"};
    }
    return part;
}

}  // namespace icespar
