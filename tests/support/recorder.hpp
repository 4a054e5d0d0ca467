// Follows a ray through a scene and keeps every branch that leaves the stones.
#pragma once

#include <utility>
#include <vector>

#include "render/walker.hpp"

namespace icespar::testing {

/// A guide for Walker that takes no chances.
struct Recorder {
    int most_hits = 0;        ///< interface events of a path
    double least_weight = 0;  ///< of a branch that is continued
    std::vector<Branch> out{};
    int stuck = 0;  ///< branches that found no way on, which must not happen

    bool admit(const Branch& b) {
        if (b.gem < 0 && b.hits > 0) out.push_back(b);
        return true;
    }
    bool may_meet(const Branch& b) {
        going_on = b.hits < most_hits && b.weight >= least_weight;
        return going_on;
    }
    void lose(const Stokes&) { stuck += going_on ? 1 : 0; }
    void absorb(const Stokes&) {}
    void see(const Emitter&, const Stokes&, bool) {}
    void see_at_wavelength(double, const Stokes&) {}
    [[nodiscard]] int diffuse_rays(const Branch&) const { return 0; }
    [[nodiscard]] std::pair<double, double> light_point() const { return {0.5, 0.5}; }
    [[nodiscard]] std::pair<double, double> diffuse_point(int, int) const { return {0.5, 0.5}; }
    bool going_on = false;  ///< may_meet said yes to the branch at hand
};

/// What leaves after up to `most_hits` events, at 589.3 nm.
inline Recorder recorded(const World& world, const Palette& palette, const Vec3& origin,
                         const Vec3& direction, int most_hits, double least_weight = 0) {
    Recorder recorder{most_hits, least_weight};
    Walker<Recorder> walker(world, palette, needs_of(world.scene()), false);
    walker.walk(Branch::from_sensor(origin, direction, any_perpendicular(direction)), 589.3,
                recorder);
    return recorder;
}

}  // namespace icespar::testing
