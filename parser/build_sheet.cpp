// sheet: thin ideal filters, and how they turn with their transforms.
#include <cmath>

#include "parser/builder.hpp"

namespace icespar {

Part Builder::sheet(const Block& block) {
    Part part;
    part.where = block.place;
    Filter filter;
    bool chosen = false;
    std::optional<Vec3> axis;
    Transform place;
    Cursor cursor(block);
    const Vec3 corner = cursor.vector("a corner");
    const Vec3 u = cursor.vector("an edge");
    const Vec3 v = cursor.vector("the other edge");
    const Vec3 normal = cross(u, v);
    if (!(length(normal) > 0)) {
        throw Fault{cursor.place(), "this sheet has no area: its edges lie in a line", {}};
    }
    while (cursor.more()) {
        if (const auto t = read_transform(cursor)) {
            place = place.then(*t);
            continue;
        }
        const Item& item = cursor.take();
        const bool word = item.kind == Item::Kind::word;
        if (word &&
            (item.word == "polariser" || item.word == "waveplate" || item.word == "neutral")) {
            if (chosen) {
                throw Fault{item.place, "this sheet is a filter already",
                            "put two sheets one behind the other"};
            }
            chosen = true;
            if (item.word == "polariser") filter.kind = Filter::Kind::polariser;
            if (item.word == "waveplate") {
                filter.kind = Filter::Kind::waveplate;
                filter.retardance_nm = cursor.number("a retardance in nm", 0, 1e9);
            }
            if (item.word == "neutral") {
                filter.kind = Filter::Kind::neutral;
                filter.transmission = cursor.number("the transmission of a neutral filter", 0, 1);
            }
        } else if (word && item.word == "axis") {
            axis = cursor.vector("a direction");
            const Vec3 across = *axis - (dot(*axis, normal) / dot(normal, normal)) * normal;
            if (!(length(across) > 1e-9 * length(*axis))) {
                throw Fault{cursor.place(), "the axis of a sheet lies in it, not across it", {}};
            }
        } else if (word && item.word.empty()) {
            cursor.skip_values();
            chosen = true;
        } else if (item.kind == Item::Kind::value && item.value.empty()) {
            throw Poisoned{item.place};
        } else {
            throw Fault{item.place, "a sheet is a polariser, waveplate or neutral filter", {}};
        }
    }
    if (!chosen) {
        throw Fault{block.place, "this sheet is no filter",
                    "add 'polariser axis <...>', 'waveplate NM axis <...>' or 'neutral 0.5'"};
    }
    filter.axis = axis.value_or(u);
    part.shape = SquareShape{};
    part.filter = filter;
    const Vec3 up = normal / length(normal);
    part.place =
        Transform({Vec3{u.x, up.x, v.x}, Vec3{u.y, up.y, v.y}, Vec3{u.z, up.z, v.z}}, corner)
            .then(place);
    part.filter->axis = place.vector(filter.axis);
    return part;
}

void Builder::finish_sheet(const Part& part) {
    Thing thing;
    thing.shape = part.shape;
    thing.to_world = part.place.then(mirror());
    thing.finish = {0, 0};
    thing.filter = part.filter;
    // The axis, made to lie in the sheet.
    const Vec3 normal =
        normalised(cross(thing.to_world.vector({1, 0, 0}), thing.to_world.vector({0, 0, 1})));
    const Vec3 axis = mirrored(part.filter->axis);
    thing.filter->axis = normalised(axis - dot(axis, normal) * normal);
    scene_.things.push_back(std::move(thing));
}

}  // namespace icespar
