// The facets of a stone, laid out for the loops that ask them all, about the stone's own centre.
#pragma once

#include <cstddef>
#include <vector>

#include "stone/stone.hpp"

namespace icespar {

/// Coordinates are relative to `centre`, so that a stone far from the origin loses no digits.
class FacetSearch {
public:
    explicit FacetSearch(const Stone& stone);

    [[nodiscard]] const Vec3& centre() const { return centre_; }
    [[nodiscard]] int facets() const { return facets_; }
    [[nodiscard]] Vec3 normal(int facet) const {
        const auto i = static_cast<std::size_t>(facet);
        return {nx_[i], ny_[i], nz_[i]};
    }
    [[nodiscard]] double distance(int facet) const {
        return distance_[static_cast<std::size_t>(facet)];
    }

    /// What a search leaves behind for `near`.
    struct Scratch {
        std::vector<double> gap, ahead;
        std::vector<int> near;
    };
    [[nodiscard]] Scratch scratch() const;

    /// The facet that a line from `origin` along `direction` (of any length) meets first, the one
    /// it left excepted, and the multiple of `direction` to it; -1 when none is ahead.
    [[nodiscard]] int exit(const Vec3& origin, const Vec3& direction, int left, double& t,
                           Scratch& scratch) const;

    /// After `exit`: the other facets whose planes lie nearer than `reach` to the point `t` times
    /// the direction further, or before it.
    void near(int exit, int left, double t, double reach, Scratch& scratch) const;

private:
    int facets_;
    Vec3 centre_;
    std::vector<double> nx_, ny_, nz_, distance_;  ///< padded with planes that are never ahead
};

}  // namespace icespar
