// Rays against planes, boxes, spheres, cones, discs and triangles, in double.
#include "render/meet_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace icespar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool meet(const PlaneShape&, const Vec3& o, const Vec3& d, double start, Meeting& out) {
    if (d.y == 0) return false;
    out = {-o.y / d.y, {0, 1, 0}};
    return out.distance > start;
}

bool meet(const SquareShape&, const Vec3& o, const Vec3& d, double start, Meeting& out) {
    if (!meet(PlaneShape{}, o, d, start, out)) return false;
    const double x = o.x + out.distance * d.x, z = o.z + out.distance * d.z;
    return x >= 0 && x <= 1 && z >= 0 && z <= 1;
}

bool meet(const DiscShape& disc, const Vec3& o, const Vec3& d, double start, Meeting& out) {
    if (!meet(PlaneShape{}, o, d, start, out)) return false;
    const double r = std::hypot(o.x + out.distance * d.x, o.z + out.distance * d.z);
    return r <= 1 && r >= disc.hole;
}

/// The ray's stay between the planes 0 and 1 of each axis.
bool meet(const BoxShape&, const Vec3& o, const Vec3& d, double start, Meeting& out) {
    double near = -infinity, far = infinity;
    int near_axis = -1, far_axis = -1;
    const double origin[3] = {o.x, o.y, o.z}, direction[3] = {d.x, d.y, d.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < 0 || origin[axis] > 1) return false;
            continue;
        }
        double a = -origin[axis] / direction[axis], b = (1 - origin[axis]) / direction[axis];
        if (a > b) std::swap(a, b);
        if (a > near) {
            near = a;
            near_axis = axis;
        }
        if (b < far) {
            far = b;
            far_axis = axis;
        }
    }
    if (!(near <= far)) return false;
    const bool outside = near > start;
    const int axis = outside ? near_axis : far_axis;
    out = {outside ? near : far,
           {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}};
    return out.distance > start;
}

bool meet(const SphereShape&, const Vec3& o, const Vec3& d, double start, Meeting& out) {
    // Both roots without cancellation: the foot of the perpendicular first (Haines et al. 2019).
    const double dd = dot(d, d), b = -dot(o, d);
    const Vec3 foot = o + (b / dd) * d;
    const double gap = 1 - dot(foot, foot);
    if (gap < 0) return false;
    const double q = b + std::copysign(std::sqrt(dd * gap), b);
    double near = (dot(o, o) - 1) / q, far = q / dd;
    if (near > far) std::swap(near, far);
    const double t = near > start ? near : far;
    out = {t, o + t * d};
    return t > start;
}

/// The mantle is x^2 + z^2 = (1 + slope y)^2 for y from 0 to 1.
bool meet(const ConeShape& cone, const Vec3& origin, const Vec3& d, double start, Meeting& out) {
    // Seen from the point of the ray nearest to the middle, so that distance costs no digits.
    const double to_middle = -dot(origin - Vec3{0, 0.5, 0}, d) / dot(d, d);
    const Vec3 o = origin + to_middle * d;
    const double slope = cone.top - 1;
    bool found = false;
    const auto consider = [&](double t, const Vec3& normal) {
        t += to_middle;
        if (!(t > start) || (found && t >= out.distance)) return;
        out = {t, normal};
        found = true;
    };
    const double r0 = 1 + slope * o.y, dr = slope * d.y;
    const double a = d.x * d.x + d.z * d.z - dr * dr;
    const double half_b = o.x * d.x + o.z * d.z - r0 * dr;
    const double c = o.x * o.x + o.z * o.z - r0 * r0;
    const double discriminant = half_b * half_b - a * c;
    if (discriminant >= 0) {
        const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
        for (const double t : {a != 0 ? q / a : infinity, q != 0 ? c / q : infinity}) {
            const double y = o.y + t * d.y;
            if (!(y >= 0 && y <= 1)) continue;
            const double r = 1 + slope * y;
            consider(t, {o.x + t * d.x, -slope * r, o.z + t * d.z});
        }
    }
    if (!cone.open && d.y != 0) {
        for (const double y : {0.0, 1.0}) {
            const double t = (y - o.y) / d.y, r = y == 0 ? 1 : cone.top;
            const double x = o.x + t * d.x, z = o.z + t * d.z;
            if (x * x + z * z <= r * r) consider(t, {0, 1, 0});
        }
    }
    return found;
}

/// a b - c d with the right sign, whatever cancels (Kahan; Jeannerod, Louvet & Muller 2013).
double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

bool meet(const MeshShape&, const Vec3&, const Vec3&, double, Meeting&) { return false; }

}  // namespace

bool meet_shape(const Shape& shape, const Vec3& origin, const Vec3& direction, double start,
                Meeting& out) {
    return std::visit([&](const auto& s) { return meet(s, origin, direction, start, out); }, shape);
}

bool meet_triangle(const std::vector<Vec3>& vertices, const std::array<std::uint32_t, 3>& triangle,
                   const Vec3& o, const Vec3& d, double start, Meeting& out) {
    // Seen along the ray, which becomes a point: corners are moved alike for all triangles that
    // share them, and the signs after that are exact (after Woop, Benthin & Wald 2013).
    const double size[3] = {std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const std::size_t z = static_cast<std::size_t>(std::max_element(size, size + 3) - size);
    const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
    const std::array<double, 3> along{d.x, d.y, d.z};
    const double shear_x = along[x] / along[z], shear_y = along[y] / along[z];
    std::array<Vec3, 3> seen;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 from = vertices[triangle[i]] - o;
        const std::array<double, 3> v{from.x, from.y, from.z};
        seen[i] = {v[x] - shear_x * v[z], v[y] - shear_y * v[z], v[z]};
    }
    const double u = difference_of_products(seen[1].x, seen[2].y, seen[2].x, seen[1].y);
    const double v = difference_of_products(seen[2].x, seen[0].y, seen[0].x, seen[2].y);
    const double w = difference_of_products(seen[0].x, seen[1].y, seen[1].x, seen[0].y);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const double sum = u + v + w;
    if (sum == 0) return false;
    out.distance = (u * seen[0].z + v * seen[1].z + w * seen[2].z) / (sum * along[z]);
    const Vec3& a = vertices[triangle[0]];
    out.normal = cross(vertices[triangle[1]] - a, vertices[triangle[2]] - a);
    return out.distance > start;
}

Reach reach_of(const Shape& shape) {
    if (std::holds_alternative<BoxShape>(shape)) return {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}};
    if (std::holds_alternative<DiscShape>(shape)) return {{}, {1, 0, 1}};
    if (std::holds_alternative<SquareShape>(shape)) return {{0.5, 0, 0.5}, {0.5, 0, 0.5}};
    if (const auto* cone = std::get_if<ConeShape>(&shape)) {
        const double r = std::max(1.0, cone->top);
        return {{0, 0.5, 0}, {r, 0.5, r}};
    }
    return {{}, {1, 1, 1}};
}

}  // namespace icespar
