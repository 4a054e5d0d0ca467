// Objects: primitives, groups and lamps, with the looks that pass from a group to what is in it.
#include <algorithm>
#include <cmath>

#include "parser/builder.hpp"
#include "parser/limits.hpp"

namespace icespar {

/// The texture moves with what comes after it; the optic axis turns with the stone, whatever the
/// order.
void Builder::apply(const Transform& t, Look& look) {
    if (look.pigment) look.pigment->place = look.pigment->place.then(t);
}

bool Builder::modifier(Cursor& cursor, Look& look, Transform& place) {
    step(cursor.peek().place);
    if (const auto t = read_transform(cursor)) {
        place = place.then(*t);
        apply(*t, look);
        return true;
    }
    const Item& item = cursor.peek();
    const Block* block = nullptr;
    if (item.kind == Item::Kind::block) block = item.block.get();
    if (item.kind == Item::Kind::value && item.value.block()) block = item.value.block()->get();
    if (item.kind == Item::Kind::value && item.value.empty()) {
        look.at_fault = true;
        cursor.take();
        return true;
    }
    if (item.kind == Item::Kind::word && item.word.empty()) {
        cursor.take();
        cursor.skip_values();
        return true;
    }
    if (!block) return false;
    const std::string_view word = block->word;
    if (word != "pigment" && word != "finish" && word != "texture" && word != "material" &&
        word != "interior") {
        return false;
    }
    cursor.take();
    const bool read = !block->broken && guarded([&] {
        if (word == "pigment") look.pigment = pigment(*block);
        if (word == "finish") look.finish = finish(*block, look.finish);
        if (word == "interior") look.interior = interior(*block);
        if (word == "texture" || word == "material") {
            Look more = texture(*block);
            if (more.pigment) look.pigment = std::move(more.pigment);
            if (more.finish) look.finish = more.finish;
            if (more.interior) look.interior = std::move(more.interior);
            look.at_fault = look.at_fault || more.at_fault;
        }
    });
    look.at_fault = look.at_fault || !read;
    return true;
}

/// The parts of any object, in the coordinates outside of it.
Parts Builder::object(const Block& block) {
    step(block.place);
    if (block.broken) return {};
    const std::string_view word = block.word;
    Parts parts;
    if (word == "union" || word == "merge" || word == "object") {
        parts = group(block);
    } else if (word == "gem") {
        parts.push_back(gem(block));
    } else if (word == "intersection") {
        parts.push_back(intersection(block));
    } else if (word == "light_source") {
        parts.push_back(lamp(block));
    } else {
        parts.push_back(primitive(block));
    }
    if (word != "union" && word != "merge" && word != "object") count_objects(1, block.place);
    return parts;
}

Parts Builder::group(const Block& block) {
    Parts parts;
    Look look;
    Transform place;
    bool empty = true, inverse = false;
    for (Cursor cursor(block); cursor.more();) {
        if (modifier(cursor, look, place)) continue;
        const Item& item = cursor.take();
        if (item.word == "inverse") {
            inverse = true;
            continue;
        }
        const BlockPtr* inner = item.kind == Item::Kind::block   ? &item.block
                                : item.kind == Item::Kind::value ? item.value.block()
                                                                 : nullptr;
        if (!inner) {
            throw Fault{item.place,
                        item.kind == Item::Kind::word
                            ? "'" + std::string(item.word) + "' needs '{' after it"
                            : "expected an object, found " + kind_of(item.value),
                        {}};
        }
        if (block.word == "object" && !empty) {
            throw Fault{item.place, "'object' takes one thing", "use 'union' for several"};
        }
        empty = false;
        Parts more;
        guarded([&] { more = object(**inner); });
        for (Part& part : more) {
            if (item.kind == Item::Kind::value) part.where = block.place;
            parts.push_back(std::move(part));
        }
        if (block.word != "object" || parts.size() > 1) count_objects(more.size(), block.place);
    }
    if (empty && !block.broken && diagnostics_.errors() == 0) {
        throw Fault{block.place, "this '" + std::string(block.word) + "' is empty", {}};
    }
    for (Part& part : parts) {
        part.inverse = part.inverse != inverse;
        part.place = part.place.then(place);
        apply(place, part.look);
        if (part.look.interior) part.look.interior->turn(place);
        // As in POV-Ray, a part with a pigment or finish of its own takes neither from the group.
        if (!part.look.pigment && !part.look.finish) {
            part.look.pigment = look.pigment;
            part.look.finish = look.finish;
        }
        part.look.at_fault = part.look.at_fault || look.at_fault;
        if (!part.look.interior && look.interior) {
            part.look.interior = look.interior;
            part.look.interior->turn(place);
        }
        // Within an object the one thing's own texture gives way to the object's.
        if (block.word != "object") part.of_union = true;
        if (!part.of_union) {
            if (look.pigment) part.look.pigment = look.pigment;
            if (look.finish) part.look.finish = look.finish;
        }
    }
    return parts;
}

namespace {

/// Takes the y axis to the unit vector n by a rotation, and the origin to `origin`.
Transform frame_with_y(const Vec3& n, const Vec3& origin) {
    const Vec3 a = any_perpendicular(n);
    const Vec3 b = cross(a, n);
    return {{Vec3{a.x, n.x, b.x}, Vec3{a.y, n.y, b.y}, Vec3{a.z, n.z, b.z}}, origin};
}

}  // namespace

Part Builder::primitive(const Block& block) {
    Part part;
    part.where = block.place;
    Cursor cursor(block);
    if (block.word == "plane") {
        part.kind = Part::Kind::plane;
        const Vec3 normal = cursor.vector("a normal");
        const double size = length(normal);
        if (!(size > 0)) throw Fault{cursor.place(), "the normal of a plane is not 0", {}};
        const Vec3 unit = normal / size;
        part.place = frame_with_y(unit, cursor.number("a distance from the origin") * unit);
    } else if (block.word == "sphere") {
        part.kind = Part::Kind::sphere;
        const Vec3 centre = cursor.vector("a centre");
        const double radius = cursor.number("a radius");
        if (!(radius > 0)) throw Fault{cursor.place(), "the radius of a sphere is above 0", {}};
        part.place =
            Transform::scaling({radius, radius, radius}).then(Transform::translation(centre));
    } else if (block.word == "box") {
        part.kind = Part::Kind::box;
        const Vec3 a = cursor.vector("a corner");
        const Vec3 b = cursor.vector("the opposite corner");
        const Vec3 low{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
        const Vec3 size{std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)};
        if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
            throw Fault{
                cursor.place(), "this box has no volume: its corners agree in a coordinate", {}};
        }
        part.place = Transform::scaling(size).then(Transform::translation(low));
    } else {
        throw Fault{block.place, "a '" + std::string(block.word) + "' is not an object by itself",
                    "put it into 'gem { ... }'"};
    }
    Transform place;
    while (cursor.more()) {
        if (modifier(cursor, part.look, place)) continue;
        const Item& item = cursor.take();
        if (item.word == "inverse") {
            part.inverse = !part.inverse;  // both sides of a surface look the same
            continue;
        }
        throw Fault{item.place,
                    "unexpected " +
                        (item.kind == Item::Kind::value ? kind_of(item.value)
                                                        : "'" + std::string(item.word) + "'") +
                        " in '" + std::string(block.word) + "'",
                    {}};
    }
    part.place = part.place.then(place);
    if (part.look.interior) part.look.interior->turn(place);
    return part;
}

Part Builder::lamp(const Block& block) {
    Part part;
    part.kind = Part::Kind::lamp;
    part.where = block.place;
    Light& light = part.light;
    Spectrum source = white();
    std::array<double, 5> colour{1, 1, 1, 0, 0};
    bool coloured = false, placed = false;
    Look none;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        if (item.kind == Item::Kind::value && item.value.numbers()) {
            if (!placed) {
                light.position = cursor.vector("a position");
                placed = true;
            } else {
                colour = cursor.colour("a colour");
                coloured = true;
            }
        } else if (item.word == "area_light") {
            cursor.take();
            light.edge_u = cursor.vector("its first edge");
            light.edge_v = cursor.vector("its second edge");
            if (cursor.next_is_number()) (void)cursor.number("a number of lamps", 1, 1e6);
            if (cursor.next_is_number()) (void)cursor.number("a number of lamps", 1, 1e6);
        } else if (item.word == "fade_distance") {
            cursor.take();
            light.fade_distance = cursor.number("fade_distance", 0, 1e12);
        } else if (item.word == "fade_power") {
            cursor.take();
            light.fade_power = cursor.number("fade_power", 0, 100);
        } else if (item.word == "illuminant" || item.word == "blackbody") {
            cursor.take();
            source = illuminant_named(cursor, item.word);
        } else if (!modifier(cursor, none, part.place)) {
            throw Fault{item.place, "unexpected " + kind_of(item.value) + " in 'light_source'", {}};
        }
    }
    if (!placed) throw Fault{block.place, "a light_source needs a position", "such as <0, 10, -5>"};
    if (!coloured && diagnostics_.errors() == 0) {
        diagnostics_.warning(block.place, "this light_source has no colour: it is taken as rgb 1");
    }
    light.light = source * reflectance_from_rgb({colour[0], colour[1], colour[2]});
    return part;
}

}  // namespace icespar
