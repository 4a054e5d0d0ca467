// Embree's tree over the boxes of gems and bounded things; the hits themselves are found in double.
#pragma once

#include <memory>
#include <vector>

#include "render/world.hpp"

namespace icespar {

class BoundedObjects {
public:
    BoundedObjects(const World& world, const std::vector<Bounds>& bounds);
    ~BoundedObjects();
    BoundedObjects(const BoundedObjects&) = delete;
    BoundedObjects& operator=(const BoundedObjects&) = delete;

    /// Improves `hit` (whose distance is the bound to beat) with the nearest object.
    bool nearest(const Ray& ray, const Departure& from, Hit& hit) const;

    /// For the tree's callbacks.
    bool meet(unsigned object, const Ray& ray, const Departure& from, Hit& hit) const {
        return world_.meet(static_cast<int>(object), ray, from, hit);
    }
    [[nodiscard]] const Bounds& bounds(unsigned object) const { return bounds_[object]; }

private:
    const World& world_;
    std::vector<Bounds> bounds_;
    Vec3 centre_;
    double radius_ = 0;
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

}  // namespace icespar
