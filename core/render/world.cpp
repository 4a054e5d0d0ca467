// Rays against gems and things, all in double.
#include "render/world.hpp"

#include <algorithm>
#include <limits>

#include "render/bounded_objects.hpp"

namespace icespar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// With no more bounded objects than this, asking all is cheaper than a tree (bench/).
constexpr std::size_t few_objects = 4;

/// Room for the float rays of the tree: its boxes grow by this part of the scene's coordinates.
constexpr double float_slack = 4e-6;

struct Crossing {
    double near = -infinity, far = infinity;
    int near_axis = -1, far_axis = -1;
};

/// The ray's stay between the planes 0 and 1 of each axis.
Crossing in_unit_cube(const Vec3& o, const Vec3& d) {
    Crossing c;
    const double origin[3] = {o.x, o.y, o.z}, direction[3] = {d.x, d.y, d.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < 0 || origin[axis] > 1) c.far = -infinity;
            continue;
        }
        double a = -origin[axis] / direction[axis], b = (1 - origin[axis]) / direction[axis];
        if (a > b) std::swap(a, b);
        if (a > c.near) {
            c.near = a;
            c.near_axis = axis;
        }
        if (b < c.far) {
            c.far = b;
            c.far_axis = axis;
        }
    }
    return c;
}

}  // namespace

FacetPlanes::FacetPlanes(const Stone& stone) {
    for (const Facet& f : stone.facets) {
        nx.push_back(f.normal.x);
        ny.push_back(f.normal.y);
        nz.push_back(f.normal.z);
        distance.push_back(f.distance);
    }
}

int FacetPlanes::exit(const Vec3& o, const Vec3& d, int left_facet, double& nearest) const {
    int facet = -1;
    nearest = infinity;
    for (std::size_t i = 0; i < nx.size(); ++i) {
        const double ahead = nx[i] * d.x + ny[i] * d.y + nz[i] * d.z;
        if (!(ahead > 0) || static_cast<int>(i) == left_facet) continue;
        const double t = (distance[i] - (nx[i] * o.x + ny[i] * o.y + nz[i] * o.z)) / ahead;
        if (t < nearest) {
            nearest = t;
            facet = static_cast<int>(i);
        }
    }
    nearest = std::max(nearest, 0.0);
    return facet;
}

int FacetPlanes::entry(const Vec3& o, const Vec3& d, double& distance_in) const {
    double in = -infinity, out = infinity;
    int facet = -1;
    for (std::size_t i = 0; i < nx.size(); ++i) {
        const double ahead = nx[i] * d.x + ny[i] * d.y + nz[i] * d.z;
        const double gap = distance[i] - (nx[i] * o.x + ny[i] * o.y + nz[i] * o.z);
        if (ahead == 0) {
            if (gap < 0) return -1;
            continue;
        }
        const double t = gap / ahead;
        if (ahead < 0) {
            if (t > in) {
                in = t;
                facet = static_cast<int>(i);
            }
        } else {
            out = std::min(out, t);
        }
    }
    if (!(in < out) || in < 0) return -1;
    distance_in = in;
    return facet;
}

World::World(const Scene& scene)
    : World(scene, scene.gems.size() + scene.things.size() > few_objects) {}

World::World(const Scene& scene, bool use_tree) : scene_(scene) {
    for (const Gem& gem : scene.gems) {
        planes_.emplace_back(gem.stone);
        Bounds b{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
        for (const Vec3& v : gem.stone.vertices) {
            b.low = {std::min(b.low.x, v.x), std::min(b.low.y, v.y), std::min(b.low.z, v.z)};
            b.high = {std::max(b.high.x, v.x), std::max(b.high.y, v.y), std::max(b.high.z, v.z)};
        }
        bounds_.push_back(b);
    }
    for (std::size_t i = 0; i < scene.things.size(); ++i) {
        const Thing& thing = scene.things[i];
        into_thing_.push_back(thing.to_world.inverse());
        if (std::holds_alternative<PlaneShape>(thing.shape)) {
            unbounded_.push_back(static_cast<int>(i));
            continue;
        }
        bounded_.push_back(static_cast<int>(i));
        const bool sphere = std::holds_alternative<SphereShape>(thing.shape);
        const Vec3 centre = thing.to_world.point(sphere ? Vec3{} : Vec3{0.5, 0.5, 0.5});
        const double half = sphere ? 1 : 0.5;
        const Vec3 a = half * thing.to_world.vector({1, 0, 0});
        const Vec3 b = half * thing.to_world.vector({0, 1, 0});
        const Vec3 c = half * thing.to_world.vector({0, 0, 1});
        const Vec3 reach{std::abs(a.x) + std::abs(b.x) + std::abs(c.x),
                         std::abs(a.y) + std::abs(b.y) + std::abs(c.y),
                         std::abs(a.z) + std::abs(b.z) + std::abs(c.z)};
        bounds_.push_back({centre - reach, centre + reach});
    }
    if (use_tree && !bounds_.empty()) {
        std::vector<Bounds> bounds = bounds_;
        double far = 0;
        for (const Bounds& b : bounds) far = std::max({far, length(b.low), length(b.high)});
        const Vec3 slack = float_slack * far * Vec3{1, 1, 1};
        for (Bounds& b : bounds) b = {b.low - slack, b.high + slack};
        tree_ = std::make_unique<BoundedObjects>(*this, bounds);
    }
}

World::~World() = default;

bool World::meet(int object, const Ray& ray, const Departure& from, Hit& hit) const {
    const int gems = static_cast<int>(planes_.size());
    if (object >= gems) {
        return meet_thing(bounded_[static_cast<std::size_t>(object - gems)], ray, from, hit);
    }
    if (object == from.gem) return false;
    double distance = 0;
    const int facet = planes(object).entry(ray.origin, ray.direction, distance);
    if (facet < 0 || !(distance < hit.distance)) return false;
    hit = {distance, object, -1, facet, {}};
    return true;
}

bool World::meet_thing(int index, const Ray& ray, const Departure& from, Hit& hit) const {
    const Thing& thing = scene_.things[static_cast<std::size_t>(index)];
    const Transform& back = into_thing_[static_cast<std::size_t>(index)];
    const Vec3 o = back.point(ray.origin), d = back.vector(ray.direction);
    // Things are seen, not looked through: a start on their own surface is left by this much.
    const double start = from.thing == index ? 1e-10 * (1 + length(o)) / length(d) : 0;
    double t = infinity;
    Vec3 normal;
    if (std::holds_alternative<PlaneShape>(thing.shape)) {
        if (from.thing == index || d.y == 0) return false;
        t = -o.y / d.y;
        normal = {0, 1, 0};
    } else if (std::holds_alternative<SphereShape>(thing.shape)) {
        // Both roots without cancellation: the foot of the perpendicular first (Haines et al.
        // 2019).
        const double dd = dot(d, d), b = -dot(o, d);
        const Vec3 foot = o + (b / dd) * d;
        const double gap = 1 - dot(foot, foot);
        if (gap < 0) return false;
        const double q = b + std::copysign(std::sqrt(dd * gap), b);
        double near = (dot(o, o) - 1) / q, far = q / dd;
        if (near > far) std::swap(near, far);
        t = near > start ? near : far;
        normal = o + t * d;
    } else {
        const Crossing c = in_unit_cube(o, d);
        if (!(c.near <= c.far)) return false;
        const bool outside = c.near > start;
        t = outside ? c.near : c.far;
        const int axis = outside ? c.near_axis : c.far_axis;
        normal = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    }
    if (!(t > start) || !(t < hit.distance)) return false;
    Vec3 n = normalised(thing.to_world.normal(normal));
    if (dot(n, ray.direction) > 0) n = -n;
    hit = {t, -1, index, -1, n};
    return true;
}

bool World::nearest(const Ray& ray, const Departure& from, Hit& hit) const {
    hit = Hit{};
    hit.distance = infinity;
    bool found = false;
    for (const int thing : unbounded_) found |= meet_thing(thing, ray, from, hit);
    if (tree_) return tree_->nearest(ray, from, hit) || found;
    const int objects = static_cast<int>(planes_.size() + bounded_.size());
    for (int i = 0; i < objects; ++i) found |= meet(i, ray, from, hit);
    return found;
}

bool World::blocked(const Ray& ray, const Departure& from, double distance) const {
    Hit hit;
    return nearest(ray, from, hit) && hit.distance < distance * (1 - 1e-12);
}

}  // namespace icespar
