// The scene's blocks one by one, and its things and stones once all transforms are known.
#include <algorithm>
#include <cmath>

#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/limits.hpp"
#include "parser/words.hpp"

namespace icespar {

Builder::Builder(const Sources& sources, Diagnostics& diagnostics)
    : sources_(sources), diagnostics_(diagnostics) {}

void Builder::step(const Place& place) {
    where_ = place;
    if (++steps_ > limits::build_steps) {
        diagnostics_.fatal(place,
                           "the scene takes more than " + std::to_string(limits::build_steps) +
                               " steps to build, the bound",
                           "do declared objects hold each other many times over?");
    }
}

void Builder::count_objects(std::size_t more, const Place& place) {
    objects_ += more;
    if (objects_ > limits::objects) {
        diagnostics_.fatal(place, "more than " + std::to_string(limits::objects) +
                                      " objects, instances counted: the bound");
    }
}

Scene Builder::build(const Block& block) {
    // What global_settings and defaults say holds for the whole scene, wherever it stands.
    for (const Item& item : block.items) {
        if (item.kind != Item::Kind::block) continue;
        if (item.word == "global_settings") guarded([&] { global_settings(*item.block); });
        if (item.word == "pigment") guarded([&] { defaults_.pigment = pigment(*item.block); });
        if (item.word == "finish") guarded([&] { defaults_.finish = finish(*item.block, {}); });
        if (item.word == "texture") {
            guarded([&] {
                const Look look = texture(*item.block);
                if (look.pigment) defaults_.pigment = look.pigment;
                if (look.finish) defaults_.finish = look.finish;
            });
        }
    }
    scene_.camera = build_camera(Block{"camera", block.place, {}});
    bool after_word = false;  // whose block is missing: the values that follow belong to it
    for (const Item& item : block.items) {
        step(item.place);
        guarded([&] {
            if (item.kind == Item::Kind::value && after_word && !item.value.block()) return;
            after_word = item.kind == Item::Kind::word;
            if (after_word) {
                if (item.word.empty()) return;
                throw Fault{item.place, "'" + std::string(item.word) + "' needs '{' after it", {}};
            }
            BlockPtr inner = item.block;
            if (item.kind == Item::Kind::value) {
                if (item.value.empty()) return;
                const BlockPtr* declared = item.value.block();
                if (!declared)
                    throw Fault{
                        item.place, kind_of(item.value) + " by itself means nothing here", {}};
                inner = *declared;
            }
            if (item.kind == Item::Kind::entry) {
                throw Fault{item.place, "'[' means nothing here", {}};
            }
            const std::string_view word = inner->word;
            if (inner->broken) return;
            const bool set_before =
                item.kind == Item::Kind::block && (word == "global_settings" || word == "pigment" ||
                                                   word == "finish" || word == "texture");
            if (set_before) {
                return;
            } else if (word == "camera") {
                camera_place_ = item.place;
                try {
                    scene_.camera = build_camera(*inner);
                } catch (const Fault&) {
                    if (!excused(*inner)) throw;
                }
            } else if (word == "background") {
                background(*inner);
            } else if (word == "sky_sphere") {
                sky_sphere(*inner);
            } else if (word == "environment") {
                environment(*inner);
            } else if (const auto words = words_in("scene");
                       std::find(words->begin(), words->end(), word) != words->end()) {
                for (const Part& part : object(*inner)) guarded([&] { finish_part(part); });
            } else {
                throw Fault{item.place,
                            "a '" + std::string(word) + "' by itself means nothing here",
                            "put it into an object"};
            }
        });
    }
    if (unit_mm_ != 1) to_millimetres();
    return std::move(scene_);
}

void Builder::finish_part(const Part& part) {
    step(part.where);
    if (part.look.at_fault) return;
    const double volume = part.place.determinant();
    if (!is_finite(part.place.point({1, 1, 1})) || !std::isnormal(volume)) {
        throw Fault{
            part.where, "this object's transforms leave it without a size, or without an end", {}};
    }
    if (part.kind == Part::Kind::lamp) {
        Light light = part.light;
        light.position = mirrored(part.place.point(light.position));
        light.edge_u = mirrored(part.place.vector(light.edge_u));
        light.edge_v = mirrored(part.place.vector(light.edge_v));
        const Vec3 towards = mirrored(part.place.point(part.point_at)) - light.position;
        if (light.kind != Light::Kind::point || light.parallel) {
            light.direction = normalised(towards);
        }
        scene_.lights.push_back(std::move(light));
        return;
    }
    if (part.filter) return finish_sheet(part);
    const bool clear = !part.look.pigment || part.look.pigment->clear;
    if (part.kind == Part::Kind::stone) {
        if (!part.look.interior) {
            throw Fault{
                part.where,
                part.gem ? "this gem has no interior: of what is it made?"
                         : "an intersection makes a stone, and this one has no interior",
                "add interior { crystal { mineral \"quartz\" axis y } }, or interior { ior 1.5 }"};
        }
        if (!part.gem && !clear) {
            throw Fault{part.where, "an intersection with an opaque pigment cannot be rendered",
                        "make it transparent (rgbt 1), or use 'box'"};
        }
        return finish_stone(part, *part.solid);
    }
    if (part.look.interior && clear) {
        if (part.solid) return finish_stone(part, *part.solid);
        if (!std::holds_alternative<BoxShape>(part.shape)) {
            throw Fault{part.where, "a stone has flat facets: this shape cannot be made of glass",
                        "use 'hull' with points on it, or an opaque pigment"};
        }
        if (!unit_box_) {
            unit_box_ = std::make_shared<Solid>();
            for (const double x : {0.0, 1.0}) {
                for (const double y : {0.0, 1.0}) {
                    for (const double z : {0.0, 1.0}) unit_box_->points.push_back({x, y, z});
                }
            }
            unit_box_->where = part.where;
        }
        return finish_stone(part, *unit_box_);
    }
    finish_thing(part);
}

void Builder::finish_thing(const Part& part) {
    Thing thing;
    thing.shape = part.shape;
    thing.to_world = part.place.then(mirror());
    const std::optional<PigmentLook>& look =
        part.look.pigment ? part.look.pigment : defaults_.pigment;
    if (look) {
        if (look->clear) {
            throw Fault{look->where, "a transparent thing needs an interior with an ior",
                        "add interior { ior 1.5 }, or use an opaque colour"};
        }
        thing.pigment = look->placed();
    } else {
        if (diagnostics_.errors() > 0) return;
        diagnostics_.warning(part.where, "a thing without pigment is black, as in POV-Ray",
                             "add pigment { rgb 1 }");
        thing.pigment.colours = {Spectrum(0.0)};
    }
    if (part.look.interior) {
        diagnostics_.warning(part.look.interior->where,
                             "the interior of an opaque thing is never seen");
    }
    const std::optional<FinishLook>& surface =
        part.look.finish ? part.look.finish : defaults_.finish;
    if (surface) thing.finish = *surface;
    scene_.things.push_back(std::move(thing));
}

void Builder::finish_stone(const Part& part, Solid& solid) {
    if (part.inverse) {
        throw Fault{part.where, "a stone cannot be turned inside out", "leave out 'inverse'"};
    }
    if (part.look.pigment && !part.look.pigment->clear) {
        diagnostics_.warning(part.look.pigment->where,
                             "a gem has no pigment: light goes through it", {}, "gem pigment");
    } else if (part.look.pigment) {
        const auto& c = part.look.pigment->tint;
        if (c[3] > 0 && (c[0] != c[1] || c[1] != c[2])) {
            diagnostics_.warning(part.look.pigment->where,
                                 "a stone is not coloured by its surface: it is rendered clear", {},
                                 "gem pigment");
        }
    }
    const Stone* stone = stone_of(solid);
    if (!stone) return;
    Gem gem;
    try {
        gem.stone = stone->transformed(part.place.then(mirror()));
    } catch (const Error& error) {
        throw Fault{part.where, error.what(), {}};
    }
    gem.crystal = part.look.interior->crystal;
    if (gem.crystal.birefringent()) {
        Vec3 &axis = gem.crystal.axis, &third = gem.crystal.third_axis;
        axis = mirrored(axis);
        axis = axis / length(axis);
        third = mirrored(third);
        third = third - dot(third, axis) * axis;
        third = third / length(third);
        if (!is_finite(axis) || (gem.crystal.indices.size() == 3 && !is_finite(third))) {
            throw Fault{part.look.interior->where,
                        "the optic axis is lost in this object's transforms",
                        {}};
        }
    } else {
        // Nothing lies along the axes of an isotropic stone; transforms may have stretched them.
        gem.crystal.axis = Crystal().axis;
        gem.crystal.third_axis = Crystal().third_axis;
    }
    gem.name = sources_.file_and_line(part.where);
    gem_places_.push_back(part.where);
    scene_.gems.push_back(std::move(gem));
}

}  // namespace icespar
