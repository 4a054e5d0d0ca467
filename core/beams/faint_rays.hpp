// What survives by chance in a crystal goes on as rays, several at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "beams/facet_search.hpp"
#include "beams/index_surface.hpp"
#include "beams/ray_lanes.hpp"
#include "crystal/medium.hpp"
#include "interface/batch.hpp"
#include "math/random.hpp"

namespace icespar {

/// Rays of single modes through a transparent uniaxial stone in air. At each face what passes is an
/// exit, and of the two reflected modes one goes on for both, chosen by its power: as the weights
/// of the exits are those of unpolarised light, polarisation takes no part (docs/method.md).
class FaintRays {
public:
    explicit FaintRays(const FacetSearch& facets);
    /// As a BeamTracer's. `spectral`: fans are carried.
    void set_medium(const Medium& crystal, bool spectral = false, double dn_o = 0, double dn_e = 0);

    struct Ray {
        Vec3 position, k, field;  ///< from the facets' centre; the mode's E, of unit length
        Vec3 fan;                 ///< dk/dc, if spectral
        double weight = 0;
        std::uint64_t seed = 0;
        int left = -1, hits = 0;  ///< the facet it goes on from, and its faces so far
        int owner = 0;            ///< whatever the caller knows it by
        bool extraordinary = false;
    };
    struct Exit {
        Vec3 k, fan;
        double weight;
        int owner;
    };
    void add(const Ray& ray) { waiting_.push_back(ray); }

    /// Follows all rays to their ends. One of less than `threshold` survives with a probability in
    /// proportion; none meets more than `most_hits` faces, if that is not 0.
    void follow(double threshold, int most_hits, Lanes width = widest_lanes());

    /// Of the last `follow`.
    [[nodiscard]] const std::vector<Exit>& exits() const { return exits_; }
    [[nodiscard]] double lost() const { return lost_; }
    [[nodiscard]] std::uint64_t events() const { return events_; }  ///< of all so far

private:
    void start(int lane, const Ray& ray);
    /// Whether the ray goes on.
    [[nodiscard]] bool meet(int lane, double threshold);

    Medium air_, crystal_;
    IndexSurface surface_{air_};
    const FacetSearch& facets_;
    RayStone stone_{};
    RayLanes lanes_{};
    std::array<Ray, RayLanes::size> rays_{};
    std::vector<Ray> waiting_;
    std::vector<Exit> exits_;
    double lost_ = 0;
    std::uint64_t events_ = 0;
};

}  // namespace icespar
