// Optical activity in stones: quartz along its axis turns the plane of polarisation.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

Stone plate(double thickness) {
    return box_stone({-1e4, -1e4, -thickness / 2}, {1e4, 1e4, thickness / 2});
}

/// Linear light along x from below, darkness above.
Environment linear_from_below() {
    Environment e = slope({0, 0, -1});
    e.state = {1, 1, 0, 0};
    return e;
}

const SensorRay down{{0, 0, 60}, {0, 0, -1}, {1, 0, 0}};

Stokes through(const Crystal& crystal, double thickness, const SensorRay& ray = down,
               double nm = 589.3) {
    TraceOptions options;
    options.wavelength_nm = nm;
    options.max_hits = 2;
    return trace_one(scene_of(plate(thickness), crystal, linear_from_below()), ray, options);
}

}  // namespace

TEST_CASE("a quartz plate along its axis turns light by its rotary power times its thickness",
          "[active][slab]") {
    for (const double rotation : {21.75, -21.75, 5.0}) {
        for (const double mm : {0.5, 1.0, 3.0, 20.0}) {
            const Stokes s = through(active_quartz({0, 0, 1}, rotation), mm);
            // Clockwise for the receiver is from x towards -y.
            const double twice = -2 * rotation * mm * degree;
            CAPTURE(rotation, mm, text(s));
            CHECK(std::abs(s.s1 / s.s0 - std::cos(twice)) < 1e-5);
            CHECK(std::abs(s.s2 / s.s0 - std::sin(twice)) < 1e-5);
            CHECK(std::abs(s.s3 / s.s0) < 1e-4);
        }
    }
}

TEST_CASE("the rotation is the same for a receiver on the other side", "[active][slab]") {
    const Stokes s = through(active_quartz({0, 0, -1}), 2);
    CHECK(std::abs(std::atan2(s.s2, s.s1) + 2 * 2 * 21.75 * degree) < 1e-5);
}

TEST_CASE("all light that gets through a plate has turned alike: what goes back unwinds",
          "[active][slab]") {
    const Scene scene = scene_of(plate(2), active_quartz({0, 0, 1}), linear_from_below());
    const Stokes s = trace_one(scene, down);
    const double r = std::pow((1.5443 - 1) / (1.5443 + 1), 2);
    CHECK(std::abs(s.s0 - (1 - r) / (1 + r)) < 1e-5);
    CHECK(std::abs(std::hypot(s.s1, s.s2) / s.s0 - 1) < 1e-5);
    CHECK(std::abs(std::atan2(s.s2, s.s1) + 2 * 2 * 21.75 * degree) < 1e-5);
}

TEST_CASE("coloured active quartz turns what it lets through", "[active][absorption]") {
    Crystal crystal = active_quartz({0, 0, 1});
    const Stokes clear = through(crystal, 2);
    crystal.absorption = {Spectrum(0.3), Spectrum(0.1)};
    const Stokes s = through(crystal, 2);
    CHECK(difference(s, std::exp(-0.3 * 2) * clear) < 1e-9);
}

TEST_CASE("a wedge of quartz turns light by the length of its path", "[active]") {
    // The lower face is inclined by 2 degrees; rays at different places go through more or less.
    const double tilt = 2 * degree;
    const Vec3 lower{std::sin(tilt), 0, -std::cos(tilt)};
    const std::vector<FacetPlane> planes{{{0, 0, 1}, 0, "top"}, {lower, 4, "lower"},
                                         {{1, 0, 0}, 9, "a"},   {{-1, 0, 0}, 9, "b"},
                                         {{0, 1, 0}, 9, "c"},   {{0, -1, 0}, 9, "d"}};
    const Scene scene =
        scene_of(Stone::from_planes(planes), active_quartz({0, 0, 1}), linear_from_below());
    TraceOptions options;
    options.max_hits = 2;
    for (const double x : {-5.0, -1.0, 0.5, 4.0}) {
        const SensorRay ray{{x, 0, 60}, {0, 0, -1}, {1, 0, 0}};
        const Stokes s = trace_one(scene, ray, options);
        const double depth = (4 - x * std::sin(tilt)) / std::cos(tilt);
        const double twice = -2 * 21.75 * depth * degree;
        CAPTURE(x);
        CHECK(std::abs(s.s1 / s.s0 - std::cos(twice)) < 2e-3);
        CHECK(std::abs(s.s2 / s.s0 - std::sin(twice)) < 2e-3);
    }
}

TEST_CASE("where activity fades the picture becomes that of the crystal without it", "[active]") {
    testing::Random random(4);
    const auto rays = random_rays(random, 8, 5, 0.6);
    const Vec3 axis = random.direction();
    TraceOptions options;
    options.max_hits = 4;
    const Scene clear = scene_of(brilliant_stone(), quartz(axis), slope({0, 1, 0}));
    const Scene active = scene_of(brilliant_stone(), active_quartz(axis, 1e-9), slope({0, 1, 0}));
    const Traced a = trace(clear, rays, options), b = trace(active, rays, options);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        CHECK(difference(a.stokes[i], b.stokes[i]) < 1e-6);
    }
}
