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
        Random random{0};
        int left = -1, hits = 0;  ///< the facet it goes on from, and its faces so far
        int owner = 0;            ///< whatever the caller knows it by
        bool extraordinary = false;
    };
    struct Exit {
        Vec3 position, k, fan;
        double weight;
        Vec3 s;  ///< of any length; p is k x s
        double out_s,
            out_p;  ///< in proportion to the amplitudes of what a mode of amplitude 1 sends
        int hits, owner;
        int facet;  ///< by which it leaves
    };
    void add(const Ray& ray) { waiting_.push_back(ray); }

    /// Follows all rays to their ends, and shows each exit to see(exit). One of less than
    /// `threshold` survives with a probability in proportion; none meets more than `most_hits`
    /// faces, if that is not 0. Returns the weight given up.
    template <class See>
    double follow(double threshold, int most_hits, const See& see, Lanes width = widest_lanes()) {
        whole_ = false;
        return run(threshold, most_hits, see, width);
    }
    /// The same for rays of weight 1 that leave the stone once, whole: what passes at a face and
    /// what stays have chances as their powers.
    template <class See>
    double follow_whole(int most_hits, const See& see, Lanes width = widest_lanes()) {
        whole_ = true;
        return run(1, most_hits, see, width);
    }

    [[nodiscard]] std::uint64_t events() const { return events_; }  ///< of all so far

private:
    template <class See>
    double run(double threshold, int most_hits, const See& see, Lanes width) {
        begin(threshold, most_hits, width);
        while (step()) {
            for (int lane = 0; lane < RayLanes::size; ++lane) {
                if (busy_[static_cast<std::size_t>(lane)] && arrive(lane)) see(exit(lane));
            }
        }
        waiting_.clear();
        return lost_;
    }
    void begin(double threshold, int most_hits, Lanes width);
    void start(int lane, const Ray& ray);
    /// Fills lanes and takes them on by a face; false when none is left.
    [[nodiscard]] bool step();
    /// Decides whether the ray goes on. True if something left the stone, or the whole ray.
    [[nodiscard]] bool arrive(int lane);
    /// At the face that lanes did not solve: whether the ray goes on.
    [[nodiscard]] bool meet(int lane);
    [[nodiscard]] Exit exit(int lane) const;

    Medium air_, crystal_;
    IndexSurface surface_{air_};
    const FacetSearch& facets_;
    RayStone stone_{};
    RayLanes lanes_{};
    void (*step_)(const RayStone&, double, RayLanes&) = step_baseline;
    double threshold_ = 0;
    int most_hits_ = 0;
    bool whole_ = false;
    std::array<Ray, RayLanes::size> rays_{};
    std::array<bool, RayLanes::size> busy_{};
    std::vector<Ray> waiting_;
    std::size_t next_ = 0;  ///< of those that wait
    double lost_ = 0;
    std::uint64_t events_ = 0;
};

}  // namespace icespar
