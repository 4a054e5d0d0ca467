// Moving finished stones, measuring them, and telling whether two are in each other's way.
#include "stone/stone.hpp"

#include <algorithm>
#include <cmath>

#include "stone/polyhedron.hpp"
#include "stone/rounding.hpp"

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
    if (stone.vertices.empty()) return {};
    const auto size = [&](const Vec3& axis) {
        const Extent e = extent(stone.vertices, axis);
        return e.high - e.low;
    };
    const auto [width, length] = std::minmax({size({1, 0, 0}), size({0, 1, 0})});
    return {length, width, size({0, 0, 1})};
}

double rounding_of(const Stone& stone) {
    double size = 0, farthest = 0;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Extent e = extent(stone.vertices, axis);
        size = std::max(size, e.high - e.low);
        farthest = std::max({farthest, std::abs(e.low), std::abs(e.high)});
    }
    return 1e-9 * size + 1e-14 * farthest;
}

bool overlap(const Stone& a, const Stone& b, Vec3& where) {
    if (a.vertices.empty() || b.vertices.empty()) return false;
    const double rounding = std::max(rounding_of(a), rounding_of(b));
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
