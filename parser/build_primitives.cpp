// Primitives: plane, sphere, box, cylinder, cone, disc and triangle, and meshes as things.
#include <algorithm>
#include <cmath>

#include "parser/builder.hpp"

namespace icespar {
namespace {

/// Takes the y axis to the unit vector n by a rotation, and the origin to `origin`.
Transform frame_with_y(const Vec3& n, const Vec3& origin) {
    const Vec3 a = any_perpendicular(n);
    const Vec3 b = cross(a, n);
    return {{Vec3{a.x, n.x, b.x}, Vec3{a.y, n.y, b.y}, Vec3{a.z, n.z, b.z}}, origin};
}

double radius(Cursor& cursor, std::string_view what, bool may_be_0 = false) {
    const double r = cursor.number(what);
    if (!(r > 0 || (r == 0 && may_be_0))) {
        throw Fault{cursor.place(),
                    std::string(what) + (may_be_0 ? " is not negative" : " is above 0"),
                    {}};
    }
    return r;
}

Transform sized(double across, double along, const Vec3& axis, const Vec3& origin) {
    return Transform::scaling({across, along, across}).then(frame_with_y(axis, origin));
}

void plane(Cursor& cursor, Part& part) {
    const Vec3 normal = cursor.vector("a normal");
    const double size = length(normal);
    if (!(size > 0)) throw Fault{cursor.place(), "the normal of a plane is not 0", {}};
    const Vec3 unit = normal / size;
    part.shape = PlaneShape{};
    part.place = frame_with_y(unit, cursor.number("a distance from the origin") * unit);
}

void sphere(Cursor& cursor, Part& part) {
    const Vec3 centre = cursor.vector("a centre");
    const double r = cursor.number("a radius");
    if (!(r > 0)) throw Fault{cursor.place(), "the radius of a sphere is above 0", {}};
    part.shape = SphereShape{};
    part.place = Transform::scaling({r, r, r}).then(Transform::translation(centre));
}

void box(Cursor& cursor, Part& part) {
    const Vec3 a = cursor.vector("a corner");
    const Vec3 b = cursor.vector("the opposite corner");
    const Vec3 low{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    const Vec3 size{std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)};
    if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
        throw Fault{
            cursor.place(), "this box has no volume: its corners agree in a coordinate", {}};
    }
    part.shape = BoxShape{};
    part.place = Transform::scaling(size).then(Transform::translation(low));
}

/// Cylinders and cones: the wider end is the foot.
void cone(Cursor& cursor, Part& part, bool cylinder) {
    Vec3 foot = cursor.vector("the middle of an end");
    double foot_radius = cylinder ? 0 : radius(cursor, "the radius of an end", true);
    Vec3 head = cursor.vector("the middle of the other end");
    double head_radius = cylinder ? radius(cursor, "the radius of a cylinder")
                                  : radius(cursor, "the radius of an end", true);
    if (cylinder) foot_radius = head_radius;
    if (head_radius > foot_radius) {
        std::swap(head, foot);
        std::swap(head_radius, foot_radius);
    }
    const double height = length(head - foot);
    if (!(height > 0)) throw Fault{cursor.place(), "its two ends are in one place", {}};
    if (!(foot_radius > 0)) throw Fault{cursor.place(), "one end of a cone has a radius", {}};
    const bool open = cursor.accept_word("open");
    part.shape = ConeShape{head_radius / foot_radius, open};
    part.place = sized(foot_radius, height, (head - foot) / height, foot);
}

void disc(Cursor& cursor, Part& part) {
    const Vec3 centre = cursor.vector("a centre");
    const Vec3 normal = cursor.vector("a normal");
    if (!(length(normal) > 0)) throw Fault{cursor.place(), "the normal of a disc is not 0", {}};
    const double r = radius(cursor, "the radius of a disc");
    double hole = 0;
    if (cursor.next_is_number()) hole = radius(cursor, "the radius of a hole", true);
    if (!(hole < r)) throw Fault{cursor.place(), "the hole of a disc is smaller than it", {}};
    part.shape = DiscShape{hole / r};
    part.place = sized(r, r, normalised(normal), centre);
}

void triangle(Cursor& cursor, Part& part, bool smooth) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (int i = 0; i < 3; ++i) {
        mesh->vertices.push_back(cursor.vector("a corner"));
        if (smooth) (void)cursor.vector("a normal");
    }
    mesh->triangles.push_back({0, 1, 2});
    const Vec3 area =
        cross(mesh->vertices[1] - mesh->vertices[0], mesh->vertices[2] - mesh->vertices[0]);
    if (!(length(area) > 0)) {
        throw Fault{cursor.place(), "this triangle has no area: its corners lie in a line", {}};
    }
    part.shape = MeshShape{std::move(mesh)};
}

}  // namespace

Part Builder::primitive(const Block& block) {
    Part part;
    part.where = block.place;
    Cursor cursor(block);
    Transform place;
    const std::string_view word = block.word;
    if (word == "plane") {
        plane(cursor, part);
    } else if (word == "sphere") {
        sphere(cursor, part);
    } else if (word == "box") {
        box(cursor, part);
    } else if (word == "cylinder" || word == "cone") {
        cone(cursor, part, word == "cylinder");
    } else if (word == "disc") {
        disc(cursor, part);
    } else if (word == "triangle" || word == "smooth_triangle") {
        if (word == "smooth_triangle") warn_of_normals(block.place);
        triangle(cursor, part, word == "smooth_triangle");
    } else if (word == "mesh" || word == "mesh2") {
        auto [known, first_time] = solid_of(block);
        if (first_time) {
            try {
                known->mesh = mesh(block);
            } catch (...) {
                known->at_fault = true;
                throw;
            }
        }
        if (known->at_fault) throw Poisoned{block.place};
        part.shape = MeshShape{known->mesh};
        part.solid = known;
    } else {
        throw Fault{block.place, "a '" + std::string(block.word) + "' is not an object by itself",
                    "put it into 'gem { ... }'"};
    }
    while (cursor.more()) {
        if (modifier(cursor, part.look, place)) continue;
        const Item& item = cursor.take();
        if (item.word == "inverse") {
            part.inverse = !part.inverse;  // both sides of a surface look the same
            continue;
        }
        if (part.solid) continue;  // of a mesh: read above
        if (excused(block)) throw Poisoned{item.place};
        throw unexpected(item, block.word);
    }
    part.place = part.place.then(place);
    if (part.look.interior) part.look.interior->turn(place);
    return part;
}

}  // namespace icespar
