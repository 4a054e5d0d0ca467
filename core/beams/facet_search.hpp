// The facets of a stone, laid out for the loops that ask them all, about the stone's own centre.
#pragma once

#include <cstddef>
#include <vector>

#include "beams/expansion.hpp"
#include "stone/stone.hpp"

namespace icespar {

/// Facets that share an edge with each facet.
[[nodiscard]] std::vector<std::vector<int>> neighbours(const Stone& stone);

/// Coordinates are relative to `centre`, so that a stone far from the origin loses no digits.
class FacetSearch {
public:
    explicit FacetSearch(const Stone& stone);

    [[nodiscard]] const Vec3& centre() const { return centre_; }
    [[nodiscard]] int facets() const { return facets_; }
    [[nodiscard]] Vec3 normal(int facet) const {
        const auto i = static_cast<std::size_t>(facet);
        return {planes_.x[i], planes_.y[i], planes_.z[i]};
    }
    [[nodiscard]] double distance(int facet) const {
        return planes_.distance[static_cast<std::size_t>(facet)];
    }

    /// The facet that a line from `origin` along `direction` (of any length) meets first, the one
    /// it left excepted, and the multiple of `direction` to it; -1 when none is ahead.
    [[nodiscard]] int exit(const Vec3& origin, const Vec3& direction, int left, double& t) const;

    /// The edge of a facet's neighbour, on the way of a beam.
    struct Edge {
        int neighbour;
        Affine inside;  ///< distance to the neighbour's plane, positive within the stone
    };
    /// Sets `edges` to those of `facet` that part of a polygon of points on its plane lies beyond.
    /// No other plane can cut the polygon: within all its neighbours a plane is the facet.
    void crossed(int facet, const Expansion& point, PolygonView polygon,
                 std::vector<Edge>& edges) const;

    /// Planes, each number of all of them side by side.
    struct Planes {
        std::vector<double> x, y, z, distance;
        void add(const Vec3& normal, double distance);
        /// To a multiple of a number, with planes that are never ahead and never near.
        void pad(std::size_t multiple);
    };
    [[nodiscard]] const Planes& planes() const { return planes_; }

private:
    int facets_;
    Vec3 centre_;
    Planes planes_, around_;                 ///< of all facets; of each facet's neighbours in turn
    std::vector<int> neighbours_;            ///< whose planes are `around_`
    std::vector<std::size_t> first_around_;  ///< of each facet, and the end
};

}  // namespace icespar
