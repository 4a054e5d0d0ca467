// Pigments: plain colours, cells and lines, colour maps and pictures.
#include <algorithm>
#include <cmath>

#include "math/error.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

const Block* block_of(const Item& item) {
    if (item.kind == Item::Kind::block) return item.block.get();
    return item.value.block() ? item.value.block()->get() : nullptr;
}

}  // namespace

Pigment PigmentLook::placed() const {
    Pigment out = pigment;
    out.to_pattern = place.then(mirror()).inverse();
    return out;
}

PigmentLook Builder::pigment(const Block& block) {
    PigmentLook look;
    look.where = block.place;
    bool coloured = false;
    for (Cursor cursor(block); cursor.more();) {
        step(cursor.peek().place);
        if (const auto t = read_transform(cursor)) {
            look.place = look.place.then(*t);
            continue;
        }
        const Item& item = cursor.peek();
        const Block* inner = block_of(item);
        if (inner && inner->broken) throw Poisoned{item.place};
        if (item.kind == Item::Kind::value && item.value.empty()) throw Poisoned{item.place};
        if (next_is_ink(cursor)) {
            const Ink colour = ink(cursor, "a colour");
            look.pigment = {};
            look.pigment.colours = {colour.spectrum};
            look.tint = colour.rgb;
            look.clear = colour.clear();
            coloured = true;
            continue;
        }
        cursor.take();
        if (inner && (inner->word == "color_map" || inner->word == "colour_map")) {
            color_map(*inner, look);
        } else if (inner && inner->word == "image_map") {
            image_map(*inner, look);
            coloured = true;
        } else if (inner && inner->word == "pigment") {
            look = pigment(*inner);
            coloured = true;
        } else if (item.kind == Item::Kind::value) {
            throw Fault{item.place, "expected a pigment, found " + kind_of(item.value), {}};
        } else if (item.word == "checker" || item.word == "grid") {
            const bool checker = item.word == "checker";
            look.pigment.kind = checker ? Pigment::Kind::checker : Pigment::Kind::grid;
            const Ink a = ink(cursor, checker ? "its first colour" : "the colour of the lines");
            const Ink b = ink(cursor, checker ? "its second colour" : "the colour of the ground");
            look.pigment.colours = {a.spectrum, b.spectrum};
            look.clear = a.clear() || b.clear();
            coloured = true;
        } else if (item.word == "line") {
            look.pigment.line_width = cursor.number("the width of a line in cells", 0, 1);
        } else if (item.word == "gradient") {
            const Vec3 axis = cursor.vector("an axis");
            if (!(length(axis) > 0)) throw Fault{cursor.place(), "an axis is not 0", {}};
            look.pigment.kind = Pigment::Kind::gradient;
            look.pigment.axis = normalised(axis);
            if (look.pigment.stops.empty()) {
                look.pigment.colours = {Spectrum(0.0), Spectrum(1.0)};
                look.pigment.stops = {0, 1};
            }
            coloured = true;
        } else if (item.word.empty()) {
            cursor.skip_values();
            coloured = true;
        } else {
            throw Fault{item.place, "unexpected '" + std::string(item.word) + "' in 'pigment'", {}};
        }
    }
    if (!coloured && !look.pigment.stops.empty()) {
        throw Fault{block.place, "this pigment has a colour map, and no pattern to show it",
                    "write pigment { gradient y color_map { ... } }"};
    }
    if (!coloured)
        throw Fault{block.place, "this pigment has no colour",
                    "write pigment { rgb <0.5, 0.5, 1> }"};
    if (look.pigment.kind != Pigment::Kind::gradient && !look.pigment.stops.empty()) {
        throw Fault{block.place, "a colour map belongs to a gradient", {}};
    }
    return look;
}

/// Entries [0.2 COLOUR], or as of old [0.2 0.5 COLOUR COLOUR].
void Builder::color_map(const Block& block, PigmentLook& look) {
    auto& stops = look.pigment.stops;
    auto& colours = look.pigment.colours;
    stops.clear();
    colours.clear();
    const auto add = [&](double at, const Ink& colour) {
        stops.push_back(at);
        colours.push_back(colour.spectrum);
        look.clear = look.clear || colour.clear();
    };
    for (const Item& item : block.items) {
        step(item.place);
        if (const Block* map = item.kind == Item::Kind::entry ? nullptr : block_of(item)) {
            color_map(*map, look);
            continue;
        }
        if (item.kind == Item::Kind::value && item.value.empty()) throw Poisoned{item.place};
        if (item.kind != Item::Kind::entry) {
            throw Fault{item.place, "a colour map is made of entries such as [0.5 rgb 1]", {}};
        }
        Cursor entry(*item.block);
        const double at = entry.number("a place from 0 to 1");
        double to = at;
        const bool stretch = entry.next_is(Item::Kind::value) && entry.peek().value.numbers() &&
                             entry.peek().value.numbers()->size == 1;
        if (stretch) to = entry.number("a place from 0 to 1");
        if (to < at || (!stops.empty() && at < stops.back())) {
            throw Fault{item.place, "the places of a colour map do not fall", {}};
        }
        const Ink first = ink(entry, "a colour");
        add(at, first);
        if (stretch && entry.more()) add(to, ink(entry, "the colour at the end"));
        if (entry.more()) throw Fault{entry.peek().place, "one colour is enough here", {}};
    }
    if (stops.empty()) throw Fault{block.place, "this colour map is empty", {}};
}

void Builder::image_map(const Block& block, PigmentLook& look) {
    look.pigment.kind = Pigment::Kind::picture;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        if (item.kind == Item::Kind::value) {
            const std::string file = cursor.text("the name of a picture");
            look.pigment.picture = picture(file, cursor.place());
            continue;
        }
        cursor.take();
        if (item.word == "map_type") {
            const double type = cursor.number("a map_type");
            if (type != 0 && type != 1) {
                throw Fault{cursor.place(), "a picture is laid flat (map_type 0) or round (1)", {}};
            }
            look.pigment.projection =
                type == 0 ? Pigment::Projection::plane : Pigment::Projection::sphere;
        } else if (item.word == "once") {
            look.pigment.once = true;
        } else if (item.word == "interpolate") {
            look.pigment.smooth = cursor.number("a kind of interpolation", 0, 4) > 0;
        } else if (item.word == "png" || item.word == "exr") {
            // The file's name says so, too.
        } else {
            cursor.skip_values();
        }
    }
    if (!look.pigment.picture) {
        throw Fault{block.place, "this image_map has no picture",
                    "write image_map { \"file.png\" }"};
    }
    // Shares of red, green and blue: reflectances of colours are linear in them.
    look.pigment.colours = {reflectance_from_rgb({1, 0, 0}), reflectance_from_rgb({0, 1, 0}),
                            reflectance_from_rgb({0, 0, 1})};
}

std::shared_ptr<const Picture> Builder::picture(const std::string& file, const Place& place) {
    const std::string path = file_named(file, place);
    std::shared_ptr<const Picture>& known = pictures_[path];
    if (!known) {
        try {
            known = std::make_shared<const Picture>(read_picture(path));
        } catch (const Error& error) {
            throw Fault{place, error.what(), {}};
        }
    }
    return known;
}

std::string Builder::file_named(const std::string& file, const Place& place) const {
    const auto found = sources_.find(file, sources_.file(place.file).folder);
    if (found.path) return found.path->string();
    if (found.forbidden) {
        throw Fault{place, "'" + printable(file) + "' lies outside the scene's folder",
                    "move it beside the scene, or allow its folder with --allow"};
    }
    throw Fault{place, "there is no file '" + printable(file) + "'", {}};
}

}  // namespace icespar
