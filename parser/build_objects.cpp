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
    } else if (word == "sheet") {
        parts.push_back(sheet(block));
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
        if (part.filter) part.filter->axis = place.vector(part.filter->axis);
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

}  // namespace icespar
