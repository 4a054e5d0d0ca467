// The stones of a scene by place, so that a scene of very many is searched in short time.
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "scene/scene.hpp"

namespace icespar {

class NearbyGems {
public:
    explicit NearbyGems(const Scene& scene);
    /// The gem that holds the point in its interior.
    [[nodiscard]] std::optional<std::size_t> around(const Vec3& point) const;
    /// Calls found(i) for every gem whose bounds meet those of the points, until it returns false.
    template <class F>
    void near(const std::vector<Vec3>& points, F&& found) const {
        const auto end = tree_.qend();
        for (auto i = tree_.qbegin(boost::geometry::index::intersects(bounds_of(points))); i != end;
             ++i) {
            if (!found(i->second)) return;
        }
    }

private:
    using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
    using Bounds = boost::geometry::model::box<Corner>;
    static Bounds bounds_of(const std::vector<Vec3>& points);

    const Scene& scene_;
    boost::geometry::index::rtree<std::pair<Bounds, std::size_t>, boost::geometry::index::rstar<16>>
        tree_;
};

/// Whether the point lies within the stone, not on its surface.
[[nodiscard]] bool inside(const Stone& stone, const Vec3& point);

}  // namespace icespar
