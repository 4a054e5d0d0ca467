// The shapes of stones as half-spaces or points: cut, hull, box, intersection and design files.
#include <algorithm>
#include <cmath>

#include "designs/design.hpp"
#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace {

/// GemCad's x, y, z (table up along z) are the language's x, z, y: this keeps a stone's handedness.
Vec3 from_gemcad(const Vec3& v) { return {v.x, v.z, v.y}; }

void bounded(std::size_t count, const Place& place) {
    if (count > limits::stone_points) {
        throw Fault{place,
                    "a stone of more than " + std::to_string(limits::stone_points) +
                        " planes or points, the bound",
                    {}};
    }
}

FacetPlane half_space(const Vec3& normal, double distance, std::string name = {}) {
    return {normal, distance, std::move(name)};
}

}  // namespace

void Builder::transform_shape(const Transform& t, Solid& solid) {
    for (Vec3& p : solid.points) p = t.point(p);
    if (solid.mesh) {
        auto moved = std::make_shared<TriangleMesh>(*solid.mesh);
        for (Vec3& v : moved->vertices) v = t.point(v);
        solid.mesh = std::move(moved);
    }
    for (FacetPlane& plane : solid.planes) {
        const Vec3 on = plane.normal * (plane.distance / dot(plane.normal, plane.normal));
        plane.normal = t.normal(plane.normal);
        plane.distance = dot(plane.normal, t.point(on));
    }
}

void Builder::as_planes(Solid& solid) {
    if (solid.points.empty() && !solid.mesh) return;
    try {
        const Stone stone = polyhedron(solid);
        for (const Facet& f : stone.facets) solid.planes.push_back({f.normal, f.distance, f.name});
        solid.points.clear();
        solid.mesh.reset();
    } catch (const Error& error) {
        throw Fault{solid.where, error.what(), {}};
    }
}

void Builder::shape(const Block& block, Solid& solid) {
    step(block.place);
    if (block.broken) {
        solid.at_fault = true;
        return;
    }
    const std::string_view word = block.word;
    if (word == "cut") return cut(block, solid);
    if (word == "hull") return hull(block, solid);
    if (word == "box") return box_planes(block, solid);
    if (word == "intersection" || word == "object") return intersected(block, solid);
    if (word == "mesh" || word == "mesh2") {
        solid.mesh = mesh(block);
        bounded(solid.mesh->vertices.size(), block.place);
        for (Cursor cursor(block); cursor.more();) {
            if (const auto t = read_transform(cursor)) {
                transform_shape(*t, solid);
            } else {
                cursor.take();
            }
        }
        return;
    }
    if (word == "plane") {
        Cursor cursor(block);
        const Vec3 normal = cursor.vector("a normal");
        if (!(length(normal) > 0))
            throw Fault{cursor.place(), "the normal of a plane is not 0", {}};
        const double distance = cursor.number("a distance from the origin");
        solid.planes.push_back(half_space(normalised(normal), distance));
        while (cursor.more()) {
            if (const auto t = read_transform(cursor)) {
                transform_shape(*t, solid);
            } else {
                Look look;
                Transform none;
                if (modifier(cursor, look, none)) continue;
                if (cursor.take().word == "inverse") {
                    solid.planes[0].normal = -solid.planes[0].normal;
                    solid.planes[0].distance = -solid.planes[0].distance;
                }
            }
        }
        return;
    }
    throw Fault{block.place, "a '" + std::string(word) + "' is no shape of a stone",
                "use cut, hull, box, mesh, or intersection of planes and boxes"};
}

void Builder::box_planes(const Block& block, Solid& solid) {
    const Part part = primitive(block);
    // The unit cube 0 .. 1, moved to where the box is.
    solid.planes = {half_space({1, 0, 0}, 1),  half_space({0, 1, 0}, 1),
                    half_space({0, 0, 1}, 1),  half_space({-1, 0, 0}, 0),
                    half_space({0, -1, 0}, 0), half_space({0, 0, -1}, 0)};
    transform_shape(part.place, solid);
}

/// An intersection of shapes, or an object that holds one; what it looks like is the stone's
/// business.
void Builder::intersected(const Block& block, Solid& solid) {
    int shapes = 0;
    bool inverse = false;
    for (Cursor cursor(block); cursor.more();) {
        step(cursor.peek().place);
        if (const auto t = read_transform(cursor)) {
            transform_shape(*t, solid);
            continue;
        }
        Look look;
        Transform none;
        if (modifier(cursor, look, none)) continue;
        const Item& item = cursor.take();
        if (item.word == "inverse") {
            inverse = true;
            continue;
        }
        const Block* inner = item.kind == Item::Kind::block ? item.block.get()
                             : item.value.block()           ? item.value.block()->get()
                                                            : nullptr;
        if (!inner)
            throw Fault{item.place, "expected a shape in '" + std::string(block.word) + "'", {}};
        Solid more{.where = inner->place};
        shape(*inner, more);
        solid.at_fault = solid.at_fault || more.at_fault;
        solid.facet_places.merge(more.facet_places);
        if (++shapes == 1 && block.word == "object") {
            solid.points = std::move(more.points);
            solid.mesh = std::move(more.mesh);
        } else {
            as_planes(more);
        }
        solid.planes.insert(solid.planes.end(), more.planes.begin(), more.planes.end());
        bounded(solid.planes.size(), block.place);
    }
    if (inverse) {
        if (solid.planes.size() != 1) {
            throw Fault{block.place, "only a plane can be turned inside out within a stone", {}};
        }
        solid.planes[0].normal = -solid.planes[0].normal;
        solid.planes[0].distance = -solid.planes[0].distance;
    }
}

void Builder::hull(const Block& block, Solid& solid) {
    for (Cursor cursor(block); cursor.more();) {
        step(cursor.peek().place);
        if (const auto t = read_transform(cursor)) {
            transform_shape(*t, solid);
        } else if (const auto* array = cursor.peek().value.array()) {
            for (const Value& element : (*array)->elements) {
                const Numbers* n = element.numbers();
                if (!n || n->size != 3) {
                    throw Fault{
                        cursor.peek().place, "a hull is made of points, and this array is not", {}};
                }
                solid.points.push_back({n->c[0], n->c[1], n->c[2]});
            }
            cursor.take();
        } else {
            const Item& item = cursor.peek();
            if (item.kind == Item::Kind::value && item.value.numbers() &&
                item.value.numbers()->size == 1) {
                throw Fault{item.place, "a point of a hull is a vector of 3, not a float", {}};
            }
            solid.points.push_back(cursor.vector("a point"));
        }
        bounded(solid.points.size(), block.place);
    }
    if (solid.points.size() < 4) {
        throw Fault{block.place,
                    "a hull needs at least four points, and this one has " +
                        std::to_string(solid.points.size()),
                    {}};
    }
}

void Builder::cut(const Block& block, Solid& solid) {
    double gear = 96, offset = 0;
    int facets = 0;
    for (Cursor cursor(block); cursor.more();) {
        if (const auto t = read_transform(cursor)) {
            transform_shape(*t, solid);
            continue;
        }
        const Item& item = cursor.take();
        if (item.word == "gear") {
            gear = cursor.number("the number of teeth");
            if (gear == 0 || gear != std::floor(gear)) {
                throw Fault{cursor.place(), "a gear has a whole number of teeth, not 0", {}};
            }
        } else if (item.word == "offset") {
            offset = cursor.number("an offset in teeth");
        } else if (item.word == "facet" && item.kind == Item::Kind::block) {
            ++facets;
            const std::size_t before = solid.planes.size();
            guarded([&] {
                if (!item.block->broken) facet(*item.block, gear, offset, solid);
            });
            if (solid.planes.size() == before) solid.at_fault = true;
            bounded(solid.planes.size(), block.place);
        } else if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
        } else {
            throw unexpected(item, "cut");
        }
    }
    if (facets == 0) throw Fault{block.place, "this cut has no facets", {}};
}

void Builder::facet(const Block& block, double gear, double offset, Solid& solid) {
    std::string name;
    std::optional<double> angle, distance;
    std::vector<double> indices;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        if (item.kind == Item::Kind::value && item.value.text()) {
            name = cursor.text("a name");
            continue;
        }
        cursor.take();
        if (item.word == "name") {
            name = cursor.text("a name");
        } else if (item.word == "angle") {
            angle = cursor.number("the angle of a facet", -90, 90);
        } else if (item.word == "distance") {
            distance = cursor.number("a distance from the stone's centre");
        } else if (item.word == "index") {
            do {
                indices.push_back(cursor.number("a tooth of the gear"));
            } while (cursor.next_is_number());
        } else if (item.word == "every") {
            const double by = cursor.number("a number of teeth");
            const double teeth = std::abs(gear);
            const double count = by > 0 ? teeth / by : 0;
            if (!(count >= 1) || std::abs(count - std::round(count)) > 1e-9 ||
                count > static_cast<double>(limits::stone_points)) {
                throw Fault{cursor.place(),
                            "'every' divides the gear of " +
                                std::to_string(static_cast<long long>(teeth)) + " teeth evenly",
                            {}};
            }
            double from = 0;
            if (cursor.accept_word("from")) from = cursor.number("a tooth of the gear");
            for (int i = 0; i < static_cast<int>(std::round(count)); ++i)
                indices.push_back(from + i * by);
        } else if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
            solid.at_fault = true;
            return;
        } else {
            throw unexpected(item, "facet");
        }
    }
    if (!angle || !distance) {
        throw Fault{block.place, std::string("this facet has no ") + (angle ? "distance" : "angle"),
                    "write facet { \"P1\" angle -41 distance 0.65 every 6 from 3 }"};
    }
    if (indices.empty()) {
        if (*angle != 0) {
            throw Fault{block.place, "this facet has no index",
                        "add 'index 0 6 12 ...' or 'every 6 from 0'"};
        }
        indices.push_back(0);
    }
    if (name.empty())
        name = "line " +
               std::to_string(sources_.line_column(block.place.file, block.place.begin).line);
    solid.facet_places.try_emplace(name, block.place);
    const bool pavilion = std::signbit(*angle) || (*angle == 0 && *distance < 0);
    for (const double index : indices) {
        FacetPlane plane = cut_plane(*angle, *distance, index, gear, offset, pavilion, name);
        plane.normal = from_gemcad(plane.normal);
        solid.planes.push_back(std::move(plane));
    }
}

void Builder::design(const Place& place, const std::string& file, Solid& solid) {
    const std::string path = file_named(file, place);
    try {
        const Design design = read_design(path);
        bounded(design.facet_count(), place);
        for (const FacetPlane& plane : design.planes()) {
            solid.planes.push_back({from_gemcad(plane.normal), plane.distance, plane.name});
        }
    } catch (const Error& error) {
        // By the name that the scene gives it, not by its place on this machine.
        std::string message = error.what();
        if (message.starts_with(path)) message.replace(0, path.size(), printable(file));
        throw Fault{place, message, {}};
    }
}

}  // namespace icespar
