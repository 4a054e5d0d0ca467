// Facet events in random stones, millions at a time: no ray lost, no NaN, no negative power, no
// light out of nothing.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "math/random.hpp"
#include "render/walker.hpp"
#include "support/gem_scenes.hpp"

namespace icespar::testing {
namespace {

/// Follows a ray's branches that matter until they have met so many facets, and weighs everything.
struct Auditor {
    static constexpr int most_meetings = 20'000;
    static constexpr double least_weight = 1e-9;

    bool admit(const Branch&) const { return true; }
    bool may_meet(const Branch& b) {
        going_on = ++meetings <= most_meetings && b.weight > least_weight;
        return going_on;
    }
    void lose(const Stokes& s) {
        lost += going_on ? 1U : 0U;
        weigh(s);
    }
    void absorb(const Stokes& s) { weigh(s); }
    void see(const Emitter&, const Stokes& s, bool) { weigh(s); }
    void see_at_wavelength(double, const Stokes&) {}
    [[nodiscard]] int diffuse_rays(const Branch&) const { return 0; }
    [[nodiscard]] std::pair<double, double> light_point() const { return {0.5, 0.5}; }
    [[nodiscard]] std::pair<double, double> diffuse_point(int, int) const { return {0.5, 0.5}; }

    void weigh(const Stokes& s) {
        const double polarised = polarised_part(s);
        if (!std::isfinite(s.s0 + polarised)) ++not_finite;
        if (s.s0 < 0) ++negative;
        if (polarised > s.s0 * (1 + 1e-12)) ++overpolarised;
        sum += s.s0;
    }
    /// After a ray in which light neither begins nor ends.
    void close() {
        ++rays;
        if (!(std::abs(sum - 1) <= imbalance)) imbalance = std::abs(sum - 1);
        sum = 0;
        meetings = 0;
    }

    bool going_on = false;
    int meetings = 0;
    double sum = 0, imbalance = 0;
    std::uint64_t rays = 0, lost = 0, not_finite = 0, negative = 0, overpolarised = 0, events = 0;
};

/// Any of the kinds there are; uniaxial ones half the time.
Crystal random_crystal(Random& random) {
    const double n = 1.3 + 1.7 * random.uniform();
    switch (static_cast<int>(32 * random.uniform())) {
        case 0:
        case 1:
            return glass(n);
        case 2:
            return biaxial(n, n + 0.1 * random.uniform(), n + 0.2, random);
        case 3:
            return active_quartz(random.direction());
        case 4:
            return calcite({0, 0, 1});
        default:
            return uniaxial(n, n + (random.uniform() - 0.3) * std::pow(10, -4 * random.uniform()),
                            random.direction());
    }
}

/// Designs, or the hull of random points.
Stone random_stone(Random& random, int number) {
    if (number % 4 == 0) return brilliant_stone();
    if (number % 4 == 1) return rhomb_stone();
    std::vector<Vec3> points(8 + static_cast<std::size_t>(60 * random.uniform()));
    for (Vec3& p : points) p = (0.6 + 0.4 * random.uniform()) * random.direction();
    return Stone::from_points(points);
}

/// At anything, at a corner, or along the stone's z.
Branch first_branch(Random& random, const Stone& stone, int ray) {
    if (ray % 3 == 0) {
        const SensorRay r = random_ray(random, 3, 0.5);
        return Branch::from_sensor(r.origin, r.direction, r.x_axis);
    }
    Vec3 direction = ray % 3 == 1 ? random.direction() : Vec3{0, 0, -1};
    const auto corner =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(stone.vertices.size()));
    const Vec3 target = 0.999999 * stone.vertices[corner];
    return Branch::from_sensor(target - 3 * direction, direction,
                               random.perpendicular_to(direction));
}

bool stress(double wanted, std::uint64_t seed) {
    constexpr int rays_each = 30, stones_at_once = 64;
    tbb::enumerable_thread_specific<Auditor> auditors;
    Auditor all;
    int stones = 0;
    while (static_cast<double>(all.events) < wanted) {
        tbb::parallel_for(stones, stones + stones_at_once, [&](int number) {
            Random random(mixed(seed + static_cast<std::uint64_t>(number)));
            const Scene scene = scene_of(random_stone(random, number), random_crystal(random));
            const Needs needs = needs_of(scene);
            const World world(scene, needs.tree);
            const Palette palette(scene, 0);
            Walker<Auditor> walker(world, palette, needs, false);
            Auditor& auditor = auditors.local();
            for (int ray = 0; ray < rays_each; ++ray) {
                walker.walk(first_branch(random, scene.gems[0].stone, ray), 589.3, auditor);
                auditor.close();
            }
            auditor.events += walker.events();
        });
        stones += stones_at_once;
        all = {};
        for (const Auditor& a : auditors) {
            all.rays += a.rays;
            all.lost += a.lost;
            all.not_finite += a.not_finite;
            all.negative += a.negative;
            all.overpolarised += a.overpolarised;
            all.events += a.events;
            all.imbalance = std::max(all.imbalance, a.imbalance);
        }
    }
    std::printf(
        "%llu facet events of %llu rays in %d stones: %llu branches lost, %llu not finite, %llu "
        "negative, %llu polarised beyond 1; light differs from 1 by %.1e at most\n",
        static_cast<unsigned long long>(all.events), static_cast<unsigned long long>(all.rays),
        stones, static_cast<unsigned long long>(all.lost),
        static_cast<unsigned long long>(all.not_finite),
        static_cast<unsigned long long>(all.negative),
        static_cast<unsigned long long>(all.overpolarised), all.imbalance);
    return all.lost + all.not_finite + all.negative + all.overpolarised == 0 &&
           all.imbalance < 1e-9;
}

}  // namespace
}  // namespace icespar::testing

/// stress [EVENTS [SEED]], 10^7 events by default. Ends with 1 when anything was wrong.
int main(int argc, char** argv) {
    const double events = argc > 1 ? std::strtod(argv[1], nullptr) : 1e7;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    return icespar::testing::stress(events, seed) ? 0 : 1;
}
