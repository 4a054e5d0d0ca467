// Stones: gems and intersections, from their shape to the polyhedron.
#include <algorithm>
#include <cmath>
#include <span>

#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace {

/// Each is built in exact arithmetic, which takes a millisecond or more; instances share one.
constexpr std::size_t most_solids = 8'000 / limits::share;

/// What was meant by a value that stands in a gem by itself.
std::string hint_of_shape(const Value& value) {
    if (value.text()) return "write design \"" + printable(*value.text()) + "\"";
    const Numbers* n = value.numbers();
    if (n && !n->colour && n->size == 3) return "points stand in hull { ... }";
    if (n && n->colour) return "a stone's colour is that of its crystal";
    return {};
}

}  // namespace

std::pair<std::shared_ptr<Solid>, bool> Builder::solid_of(const Block& block) {
    std::shared_ptr<Solid>& known = solids_[&block];
    if (known) return {known, false};
    if (solids_.size() > most_solids) {
        diagnostics_.fatal(
            block.place,
            "more than " + std::to_string(most_solids) + " different stones and meshes, the bound",
            "declare a stone once and place it by object { ... }");
    }
    known = std::make_shared<Solid>();
    known->where = block.place;
    return {known, true};
}

Part Builder::gem(const Block& block) {
    Part part;
    part.kind = Part::Kind::stone;
    part.gem = true;
    part.where = block.place;
    const auto [known, first_time] = solid_of(block);
    part.solid = known;
    Transform place;
    bool shaped = false;
    const auto take_shape = [&, new_one = first_time](const Place& where, auto&& read) {
        if (shaped)
            throw Fault{where, "this gem has a shape already",
                        "a gem has one; use 'intersection' to combine"};
        shaped = true;
        if (!new_one) return;
        try {
            read();
        } catch (...) {
            part.solid->at_fault = true;
            throw;
        }
    };
    for (Cursor cursor(block); cursor.more();) {
        if (modifier(cursor, part.look, place)) continue;
        const Item& item = cursor.take();
        if (item.word == "design") {
            const std::string file = cursor.text("the name of a file");
            take_shape(cursor.place(),
                       [&] { part.solid->design = design(cursor.place(), file, *part.solid); });
        } else if (item.word == "scale_to") {
            if (!cursor.accept_word("width")) {
                throw Fault{cursor.place(), "'scale_to' needs 'width' and a length after it", {}};
            }
            const double width = cursor.number("a width");
            if (!(width > 0)) throw Fault{cursor.place(), "the width of a stone is above 0", {}};
            part.solid->width = width;
        } else if (const Block* inner = item.kind == Item::Kind::block ? item.block.get()
                                        : item.value.block()           ? item.value.block()->get()
                                                                       : nullptr) {
            take_shape(item.place, [&] { shape(*inner, *part.solid); });
        } else if (item.kind == Item::Kind::word) {
            throw Fault{item.place, "'" + std::string(item.word) + "' needs '{' after it", {}};
        } else {
            throw unexpected(item, "gem", hint_of_shape(item.value));
        }
    }
    if (!shaped && excused(block)) throw Poisoned{block.place};
    if (!shaped) {
        throw Fault{block.place, "this gem has no shape",
                    "add cut, design, hull, box, mesh or intersection"};
    }
    if (part.look.interior) part.look.interior->turn(place);
    part.place = place;
    return part;
}

Part Builder::intersection(const Block& block) {
    Part part;
    part.kind = Part::Kind::stone;
    part.where = block.place;
    const auto [known, first_time] = solid_of(block);
    part.solid = known;
    Transform place;
    for (Cursor cursor(block); cursor.more();) {
        if (modifier(cursor, part.look, place)) continue;
        const Item& item = cursor.take();
        const Block* inner = item.kind == Item::Kind::block ? item.block.get()
                             : item.value.block()           ? item.value.block()->get()
                                                            : nullptr;
        if (!inner) throw Fault{item.place, "expected a shape in 'intersection'", {}};
        if (!first_time) continue;
        Solid more{.where = inner->place};
        shape(*inner, more);
        as_planes(more);
        part.solid->planes.insert(part.solid->planes.end(), more.planes.begin(), more.planes.end());
        part.solid->facet_places.merge(more.facet_places);
    }
    if (part.look.interior) part.look.interior->turn(place);
    part.place = place;
    return part;
}

Stone Builder::polyhedron(const Solid& solid) {
    if (const auto known = designs_.find(solid.design); known != designs_.end())
        return known->second;
    if (!solid.design.empty())
        return designs_.emplace(solid.design, Stone::from_planes(solid.planes)).first->second;
    if (solid.mesh) return Stone::from_mesh(solid.mesh->vertices, solid.mesh->triangles);
    return solid.points.empty() ? Stone::from_planes(solid.planes)
                                : Stone::from_points(solid.points);
}

/// The polyhedron, built once; nothing when it cannot be, which is reported once.
const Stone* Builder::stone_of(Solid& solid) {
    if (solid.stone) return &*solid.stone;
    if (solid.at_fault) return nullptr;
    try {
        solid.stone = polyhedron(solid);
        std::vector<std::string_view> nameless;
        for (const std::string& name : solid.stone->unreached) {
            const auto place = solid.facet_places.find(name);
            if (place == solid.facet_places.end()) {
                const bool told =
                    std::find(nameless.begin(), nameless.end(), name) != nameless.end();
                if (!told) nameless.push_back(name);
            } else {
                diagnostics_.warning(place->second, "facet '" + name + "' does not reach the stone",
                                     "is its distance too large?");
            }
        }
        if (!nameless.empty()) {
            const std::size_t shown = std::min<std::size_t>(nameless.size(), 6);
            std::string text =
                listed(std::span(nameless).first(shown), shown < nameless.size() ? ", " : " and ");
            if (shown < nameless.size())
                text += " and " + std::to_string(nameless.size() - shown) + " more";
            diagnostics_.warning(
                solid.where,
                text + (nameless.size() == 1 ? " does" : " do") + " not reach the stone",
                nameless.size() == 1 ? "is its distance too large?"
                                     : "are their distances too large?");
        }
        if (solid.width) {
            // girdle_size looks along z; the table of our stones is up, along y.
            const Transform up_to_z({Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}}, Vec3{});
            const double width = girdle_size(solid.stone->transformed(up_to_z)).width;
            const double f = *solid.width / width;
            solid.stone = solid.stone->transformed(Transform::scaling({f, f, f}));
        }
        return &*solid.stone;
    } catch (const Error& error) {
        solid.at_fault = true;
        diagnostics_.error(solid.where, error.what());
        return nullptr;
    }
}

}  // namespace icespar
