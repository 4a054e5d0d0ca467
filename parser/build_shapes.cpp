// The shapes of stones as half-spaces or points: hull, box, mesh and intersection.
#include "math/error.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

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
        bound_stone(solid.mesh->vertices.size(), block.place);
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
        bound_stone(solid.planes.size(), block.place);
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
        bound_stone(solid.points.size(), block.place);
    }
    if (solid.points.size() < 4) {
        throw Fault{block.place,
                    "a hull needs at least four points, and this one has " +
                        std::to_string(solid.points.size()),
                    {}};
    }
}

}  // namespace icespar
