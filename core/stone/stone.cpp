// Moving finished stones, measuring them, and telling whether two are in each other's way.
#include "stone/stone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stone/polyhedron.hpp"

namespace icespar {
namespace {

struct Extent {
    double low, high;
};

Extent extent(std::span<const Vec3> points, const Vec3& direction) {
    Extent e{dot(points[0], direction), dot(points[0], direction)};
    for (const Vec3& p : points) {
        const double at = dot(p, direction);
        e.low = std::min(e.low, at);
        e.high = std::max(e.high, at);
    }
    return e;
}

double width(std::span<const Vec3> points, const Vec3& direction) {
    const Extent e = extent(points, direction);
    return e.high - e.low;
}

/// z of (b - a) x (c - a).
double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The outline seen along z, counter-clockwise (Andrew 1979, monotone chain).
std::vector<Vec3> outline(std::vector<Vec3> points) {
    for (Vec3& p : points) p.z = 0;
    std::sort(points.begin(), points.end(),
              [](const Vec3& a, const Vec3& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Vec3> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t start = hull.size();
        for (const Vec3& p : points) {
            while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

}  // namespace

Stone Stone::transformed(const Transform& t) const {
    Stone out = *this;
    const double determinant = t.determinant();
    const Vec3 shift = t.point({});
    for (Vec3& v : out.vertices) v = t.point(v);
    for (Facet& facet : out.facets) {
        const Vec3 normal = t.normal(facet.normal);
        const double norm = length(normal);
        facet.normal = normal / norm;
        facet.distance = facet.distance / norm + dot(facet.normal, shift);
        facet.area *= std::abs(determinant) * norm;
        if (determinant < 0) std::reverse(facet.corners.begin() + 1, facet.corners.end());
    }
    out.volume *= std::abs(determinant);
    return out;
}

GirdleSize girdle_size(const Stone& stone) {
    GirdleSize size;
    if (stone.vertices.empty()) return size;
    size.height = width(stone.vertices, {0, 0, 1});
    // The least width of a convex outline is across one of its edges; among equals (a regular
    // polygon's edges differ by rounding) the greatest length counts.
    const std::vector<Vec3> corners = outline(stone.vertices);
    size.width = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 edge = corners[(i + 1) % corners.size()] - corners[i];
        const Vec3 along = normalised(edge);
        const double across = width(corners, {along.y, -along.x, 0});
        const double rounding = 1e-9 * across;
        if (across > size.width + rounding) continue;
        const double length_here = width(corners, along);
        size.length =
            across < size.width - rounding ? length_here : std::max(size.length, length_here);
        size.width = std::min(size.width, across);
    }
    return size;
}

bool overlap(const Stone& a, const Stone& b, Vec3& where) {
    if (a.vertices.empty() || b.vertices.empty()) return false;
    // How deep stones may go into one another by rounding of their places and sizes.
    double size = 0, farthest = 0;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (const Stone* stone : {&a, &b}) {
            const Extent e = extent(stone->vertices, axis);
            size = std::max(size, e.high - e.low);
            farthest = std::max({farthest, std::abs(e.low), std::abs(e.high)});
        }
    }
    const double rounding = 1e-9 * size + 1e-14 * farthest;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Extent in_a = extent(a.vertices, axis), in_b = extent(b.vertices, axis);
        if (std::min(in_a.high, in_b.high) - std::max(in_a.low, in_b.low) <= rounding) return false;
    }

    std::vector<HalfSpace> planes;
    for (const Stone* stone : {&a, &b}) {
        for (const Facet& facet : stone->facets) planes.push_back({facet.normal, facet.distance});
    }
    const InnerBall common = inner_ball(planes);
    if (common.radius <= rounding) return false;
    where = common.centre;
    return true;
}

}  // namespace icespar
