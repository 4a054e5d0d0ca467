// Rays against gems and things, all in double.
#include "render/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/bounded_objects.hpp"
#include "render/meet_shape.hpp"
#include "render/needs.hpp"
#include "stone/rounding.hpp"

namespace icespar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Room for the float rays of the tree: its boxes grow by this part of the scene's coordinates.
constexpr double float_slack = 4e-6;

void grow(Bounds& b, const Vec3& v) {
    b.low = {std::min(b.low.x, v.x), std::min(b.low.y, v.y), std::min(b.low.z, v.z)};
    b.high = {std::max(b.high.x, v.x), std::max(b.high.y, v.y), std::max(b.high.z, v.z)};
}

/// Things are seen, not looked through: a start on their own surface is left by this much. What
/// leaves a stone that stands on a thing, though, meets it at once, on whichever side of it
/// rounding put the start.
double first_distance(const Departure& from, int thing, const Vec3& origin) {
    constexpr double own = 1e-10, contact = 1e-9;
    if (from.thing == thing) return own * (1 + length(origin));
    return from.gem >= 0 ? -contact * (1 + length(origin)) : 0;
}

constexpr Bounds nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

}  // namespace

FacetPlanes::FacetPlanes(const Stone& stone) {
    for (const Facet& f : stone.facets) {
        nx.push_back(f.normal.x);
        ny.push_back(f.normal.y);
        nz.push_back(f.normal.z);
        distance.push_back(f.distance);
    }
    skin = rounding_of(stone);
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
    if (!(in < out) || !(out > 0)) return -1;
    if (in < 0) {
        // What starts on a face of this stone, of another or of the floor it stands on.
        const auto i = static_cast<std::size_t>(facet);
        if (distance[i] - (nx[i] * o.x + ny[i] * o.y + nz[i] * o.z) > skin) return -1;
        in = 0;
    }
    distance_in = in;
    return facet;
}

World::World(const Scene& scene) : World(scene, needs_of(scene).tree) {}

World::World(const Scene& scene, bool use_tree)
    : scene_(scene), bright_sky_(scatters(scene) ? scene.environment : Environment{}) {
    std::vector<Bounds> bounds;  // as `bounds_`, but triangle by triangle
    for (const Gem& gem : scene.gems) {
        planes_.emplace_back(gem.stone);
        Bounds& b = bounds.emplace_back(nothing);
        for (const Vec3& v : gem.stone.vertices) grow(b, v);
        bounds_.push_back(b);
    }
    meshes_.resize(scene.things.size());
    for (std::size_t i = 0; i < scene.things.size(); ++i) {
        const Thing& thing = scene.things[i];
        into_thing_.push_back(thing.to_world.inverse());
        if (std::holds_alternative<PlaneShape>(thing.shape)) {
            unbounded_.push_back(static_cast<int>(i));
            continue;
        }
        if (const auto* shape = std::get_if<MeshShape>(&thing.shape)) {
            Bounds& whole = bounds_.emplace_back(nothing);
            for (const Vec3& v : shape->mesh->vertices) {
                meshes_[i].push_back(thing.to_world.point(v));
                grow(whole, meshes_[i].back());
            }
            for (std::size_t t = 0; t < shape->mesh->triangles.size(); ++t) {
                bounded_.push_back({static_cast<int>(i), static_cast<int>(t)});
                Bounds& b = bounds.emplace_back(nothing);
                for (const auto corner : shape->mesh->triangles[t]) grow(b, meshes_[i][corner]);
            }
            continue;
        }
        bounded_.push_back({static_cast<int>(i), -1});
        const Reach box = reach_of(thing.shape);
        const Vec3 centre = thing.to_world.point(box.centre);
        const Vec3 a = thing.to_world.vector({box.half.x, 0, 0});
        const Vec3 b = thing.to_world.vector({0, box.half.y, 0});
        const Vec3 c = thing.to_world.vector({0, 0, box.half.z});
        const Vec3 reach{std::abs(a.x) + std::abs(b.x) + std::abs(c.x),
                         std::abs(a.y) + std::abs(b.y) + std::abs(c.y),
                         std::abs(a.z) + std::abs(b.z) + std::abs(c.z)};
        bounds.push_back({centre - reach, centre + reach});
        bounds_.push_back(bounds.back());
    }
    if (use_tree && !bounds.empty()) {
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
        const Bounded& b = bounded_[static_cast<std::size_t>(object - gems)];
        return b.triangle < 0 ? meet_thing(b.thing, ray, from, hit)
                              : meet_part(b.thing, b.triangle, ray, from, hit);
    }
    if (object == from.gem) return false;
    double distance = 0;
    const int facet = planes(object).entry(ray.origin, ray.direction, distance);
    // A thing that touches the facet from outside covers it.
    const double covered = hit.thing >= 0 ? planes(object).skin : 0;
    if (facet < 0 || !(distance < hit.distance - covered)) return false;
    hit = {distance, object, -1, facet, {}};
    return true;
}

/// Whether a thing at this distance hides what was hit so far; it does hide a facet that it
/// touches.
bool World::in_front(double distance, const Hit& hit) const {
    return distance < hit.distance + (hit.gem >= 0 ? planes(hit.gem).skin : 0);
}

bool World::meet_thing(int index, const Ray& ray, const Departure& from, Hit& hit) const {
    const Thing& thing = scene_.things[static_cast<std::size_t>(index)];
    if (from.thing == index && is_flat(thing.shape)) return false;
    const Transform& back = into_thing_[static_cast<std::size_t>(index)];
    const Vec3 o = back.point(ray.origin), d = back.vector(ray.direction);
    const double start = first_distance(from, index, o) / length(d);
    Meeting met;
    if (!meet_shape(thing.shape, o, d, start, met) || !in_front(met.distance, hit)) return false;
    Vec3 n = normalised(thing.to_world.normal(met.normal));
    if (dot(n, ray.direction) > 0) n = -n;
    hit = {std::max(met.distance, 0.0), -1, index, -1, n};
    return true;
}

bool World::meet_part(int index, int triangle, const Ray& ray, const Departure& from,
                      Hit& hit) const {
    const auto i = static_cast<std::size_t>(index);
    if (from.thing == index && from.triangle == triangle) return false;
    const TriangleMesh& mesh = *std::get<MeshShape>(scene_.things[i].shape).mesh;
    const double start = first_distance(from, index, ray.origin);
    Meeting met;
    if (!meet_triangle(meshes_[i], mesh.triangles[static_cast<std::size_t>(triangle)], ray.origin,
                       ray.direction, start, met) ||
        !in_front(met.distance, hit)) {
        return false;
    }
    Vec3 n = normalised(met.normal);
    if (dot(n, ray.direction) > 0) n = -n;
    hit = {std::max(met.distance, 0.0), -1, index, -1, n, triangle};
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
