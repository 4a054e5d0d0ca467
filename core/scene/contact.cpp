// Surfaces as polygons, clipped by the facets of a stone; spheres by their distance.
#include "scene/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace icespar {
namespace {

/// What is not a wrong picture: of the stone's size.
constexpr double shallow = 1e-3, rounding = 1e-9;
/// Rims and mantles in so many pieces, which miss the true circle by half of `shallow`.
constexpr int pieces = 96;

using Polygon = std::vector<Vec3>;

Vec3 on_rim(double radius, double y, int piece) {
    const double turn = 2 * std::numbers::pi * piece / pieces;
    return {radius * std::cos(turn), y, radius * std::sin(turn)};
}

/// A ring from radius r at height y to radius s at height h: discs, and the mantles of cones.
template <class F>
bool any_of_ring(double r, double y, double s, double h, F&& f) {
    for (int i = 0; i < pieces; ++i) {
        if (f(Polygon{on_rim(r, y, i), on_rim(r, y, i + 1), on_rim(s, h, i + 1), on_rim(s, h, i)}))
            return true;
    }
    return false;
}

template <class F>
bool any_of_box(F&& f) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {0.0, 1.0}) {
            Polygon face{{side, 0, 0}, {side, 1, 0}, {side, 1, 1}, {side, 0, 1}};
            for (Vec3& v : face) {
                if (axis == 1) v = {v.y, v.x, v.z};
                if (axis == 2) v = {v.z, v.y, v.x};
            }
            if (f(face)) return true;
        }
    }
    return false;
}

/// Whether f(polygon) holds for a polygon of the shape, in its own space; planes and spheres have
/// none.
template <class F>
bool any_polygon(const Shape& shape, F&& f) {
    if (std::holds_alternative<BoxShape>(shape)) return any_of_box(f);
    if (std::holds_alternative<SquareShape>(shape))
        return f(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
    if (const auto* disc = std::get_if<DiscShape>(&shape)) {
        // The hole's corners stand off, so that what fills the hole does not touch the disc.
        const double hole = disc->hole / std::cos(std::numbers::pi / pieces);
        return hole < 1 && any_of_ring(1, 0, hole, 0, f);
    }
    if (const auto* cone = std::get_if<ConeShape>(&shape)) {
        if (any_of_ring(1, 0, cone->top, 1, f)) return true;
        return !cone->open && (any_of_ring(1, 0, 0, 0, f) || any_of_ring(cone->top, 1, 0, 1, f));
    }
    if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
        const auto& v = mesh->mesh->vertices;
        for (const auto& [a, b, c] : mesh->mesh->triangles) {
            if (f(Polygon{v[a], v[b], v[c]})) return true;
        }
    }
    return false;
}

/// Whether the facets, moved inwards by the slack, leave something of the polygon.
bool reaches(Polygon polygon, const Stone& stone, double slack) {
    for (const Facet& f : stone.facets) {
        Polygon left;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double p = f.distance - slack - dot(f.normal, a);
            const double q = f.distance - slack - dot(f.normal, b);
            if (p > 0) left.push_back(a);
            if ((p > 0) != (q > 0)) left.push_back(a + (p / (p - q)) * (b - a));
        }
        polygon = std::move(left);
        if (polygon.size() < 3) return false;
    }
    return true;
}

double distance_to_segment(const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double t = std::clamp(-dot(a, along) / dot(along, along), 0.0, 1.0);
    return length(a + t * along);
}

/// Of the convex polygon from the origin, where that lies outside of its plane; else of its rim.
double distance_to(const Polygon& corners) {
    double least = std::numeric_limits<double>::infinity();
    Vec3 normal;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        least = std::min(least, distance_to_segment(a, b));
        normal += cross(a, b);
    }
    const double height = dot(normal, corners[0]) / length(normal);
    const Vec3 foot = (height / length(normal)) * normal;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if (dot(normal, cross(b - a, foot - a)) < 0) return least;
    }
    return std::min(least, std::abs(height));
}

double size_of(const Stone& stone) {
    double size = 0;
    for (const Vec3& v : stone.vertices) size = std::max(size, length(v - stone.vertices[0]));
    return size;
}

/// In the sphere's own space, where it is the unit sphere.
bool runs_through_sphere(const Stone& stone) {
    double farthest = 0, nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& v : stone.vertices) farthest = std::max(farthest, length(v));
    const bool centre_inside = std::all_of(stone.facets.begin(), stone.facets.end(),
                                           [](const Facet& f) { return f.distance > 0; });
    if (centre_inside) nearest = 0;
    for (const Facet& f : stone.facets) {
        if (centre_inside) break;
        Polygon corners;
        for (const std::uint32_t c : f.corners) corners.push_back(stone.vertices[c]);
        nearest = std::min(nearest, distance_to(corners));
    }
    const double slack = shallow * std::min(size_of(stone), 1.0);
    return nearest < 1 - slack && farthest > 1 + slack;
}

}  // namespace

std::vector<Vec3> outermost_points(const Thing& thing) {
    std::vector<Vec3> out;
    const auto add = [&](const Vec3& p) { out.push_back(thing.to_world.point(p)); };
    if (std::holds_alternative<PlaneShape>(thing.shape)) return out;
    if (const auto* mesh = std::get_if<MeshShape>(&thing.shape)) {
        for (const Vec3& v : mesh->mesh->vertices) add(v);
        return out;
    }
    const bool flat = is_flat(thing.shape);
    const bool cube = std::holds_alternative<BoxShape>(thing.shape) ||
                      std::holds_alternative<SquareShape>(thing.shape);
    const bool ball = std::holds_alternative<SphereShape>(thing.shape);
    for (const double x : {cube ? 0.0 : -1.0, 1.0}) {
        for (const double y : {ball ? -1.0 : 0.0, flat ? 0.0 : 1.0}) {
            for (const double z : {cube ? 0.0 : -1.0, 1.0}) add({x, y, z});
        }
    }
    return out;
}

std::size_t polygons_of(const Thing& thing) {
    if (const auto* mesh = std::get_if<MeshShape>(&thing.shape))
        return mesh->mesh->triangles.size();
    return std::holds_alternative<ConeShape>(thing.shape) ? 3 * pieces : pieces;
}

bool runs_through(const Thing& thing, const Stone& stone) {
    if (stone.vertices.empty()) return false;
    if (std::holds_alternative<SphereShape>(thing.shape))
        return runs_through_sphere(stone.transformed(thing.to_world.inverse()));
    const double size = size_of(stone);
    if (std::holds_alternative<PlaneShape>(thing.shape)) {
        const Vec3 origin = thing.to_world.point({0, 0, 0});
        const Vec3 normal = normalised(thing.to_world.normal({0, 1, 0}));
        double low = 0, high = 0;
        for (const Vec3& v : stone.vertices) {
            const double height = dot(normal, v - origin);
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return std::min(-low, high) > shallow * size;
    }
    const double slack = (thing.filter ? rounding : shallow) * size;
    return any_polygon(thing.shape, [&](Polygon polygon) {
        for (Vec3& v : polygon) v = thing.to_world.point(v);
        return reaches(std::move(polygon), stone, slack);
    });
}

}  // namespace icespar
