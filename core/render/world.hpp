// What a ray outside the stones meets: gems, things, and how far away.
#pragma once

#include <memory>
#include <vector>

#include "render/bright_sky.hpp"
#include "scene/scene.hpp"

namespace icespar {

struct Ray {
    Vec3 origin, direction;  ///< unit direction
};

/// The object a ray has just left; a convex gem, a plane or a triangle cannot be met again at once.
struct Departure {
    int gem = -1, thing = -1;
    int triangle = -1;  ///< of a mesh
};

struct Hit {
    double distance = 0;
    int gem = -1, thing = -1;  ///< exactly one of them is set
    int facet = -1;            ///< of the gem
    Vec3 normal{};             ///< of the thing, unit, towards the ray's origin
    int triangle = -1;         ///< of a mesh
};

/// Facet planes laid out for the loop that asks them all.
struct FacetPlanes {
    std::vector<double> nx, ny, nz, distance;
    double skin = 0;  ///< how deep a point of the surface may lie within by rounding
    explicit FacetPlanes(const Stone& stone);

    /// The facet through which a ray inside leaves, the one just left excepted. The least distance
    /// over the planes ahead; a position that rounding put beyond a plane leaves there at once.
    [[nodiscard]] int exit(const Vec3& origin, const Vec3& direction, int left_facet,
                           double& distance) const;

    /// Where a ray from outside, or from the skin, enters, or -1.
    [[nodiscard]] int entry(const Vec3& origin, const Vec3& direction, double& distance) const;
};

struct Bounds {
    Vec3 low, high;
};

class BoundedObjects;

/// The scene arranged for intersection, and its bright directions. Keeps references into it.
class World {
public:
    /// `use_tree`: let Embree find bounded objects; otherwise all are asked in turn (cheaper for a
    /// few).
    World(const Scene& scene, bool use_tree);
    explicit World(const Scene& scene);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    [[nodiscard]] bool nearest(const Ray& ray, const Departure& from, Hit& hit) const;
    /// Whether anything (gems count) stands between the ray's origin and `distance`.
    [[nodiscard]] bool blocked(const Ray& ray, const Departure& from, double distance) const;

    [[nodiscard]] const FacetPlanes& planes(int gem) const {
        return planes_[static_cast<std::size_t>(gem)];
    }
    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const BrightSky& bright_sky() const { return bright_sky_; }
    /// Boxes around gems, then around bounded things; and which things have none (planes).
    [[nodiscard]] const std::vector<Bounds>& bounds() const { return bounds_; }
    [[nodiscard]] const std::vector<int>& unbounded() const { return unbounded_; }

private:
    friend class BoundedObjects;
    struct Bounded {
        int thing, triangle;  ///< triangle: -1 for the whole thing
    };

    /// Updates `hit` when object number `object` (gems first, then bounded things) is nearer.
    bool meet(int object, const Ray& ray, const Departure& from, Hit& hit) const;
    [[nodiscard]] bool in_front(double distance, const Hit& hit) const;
    bool meet_thing(int thing, const Ray& ray, const Departure& from, Hit& hit) const;
    bool meet_part(int thing, int triangle, const Ray& ray, const Departure& from, Hit& hit) const;

    const Scene& scene_;
    BrightSky bright_sky_;
    std::vector<FacetPlanes> planes_;
    std::vector<Transform> into_thing_;      ///< world to object space
    std::vector<std::vector<Vec3>> meshes_;  ///< corners of each thing's triangles, in the world
    std::vector<Bounds> bounds_;             ///< of gems, then of things but planes
    std::vector<int> unbounded_;             ///< planes
    std::vector<Bounded> bounded_;           ///< all other things
    std::unique_ptr<BoundedObjects> tree_;
};

}  // namespace icespar
