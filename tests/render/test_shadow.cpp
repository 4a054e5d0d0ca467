// Shadows of balls, slabs and stones, sharp and soft.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

TEST_CASE("a ball's shadow ends where the tangent from the lamp does", "[surface]") {
    // Lamp at height 10, ball of radius 1 at height 5: half angle asin(1/5), radius 10 tan of it.
    Scene scene = lit_floor(lamp_at({0, 10, 0}));
    scene.things.push_back(ball({0, 5, 0}, 1));
    const double edge = 10 * std::tan(std::asin(0.2));
    const auto slanted = [&](double x) {
        const Vec3 from{x + 8, 3, 0};
        return trace_one(scene, {from, normalised(Vec3{x, 0, 0} - from), {0, 0, 1}}).s0;
    };
    CHECK(slanted(0) == 0);
    CHECK(slanted(edge - 1e-9) == 0);
    CHECK_THAT(slanted(edge + 1e-9), WithinAbs(10 / std::hypot(10, edge), 1e-6));
    // What stands beyond the lamp, or below the floor, shades nothing.
    scene.things[1] = ball({0, 12, 0}, 1);
    CHECK_THAT(slanted(0), WithinAbs(1, 1e-13));
    scene.things[1] = ball({0, -3, 0}, 1);
    CHECK_THAT(slanted(0), WithinAbs(1, 1e-13));
}

TEST_CASE("a ball shades its own far side", "[surface]") {
    Scene scene;
    scene.environment = night();
    scene.things = {ball({0, 0, 0}, 2)};
    scene.things[0].finish = {1, 0};
    scene.things[0].pigment.colours = {Spectrum(1.0)};
    scene.lights = {lamp_at({0, 1e6, 0})};
    for (const double angle : {0.0, 30.0, 60.0, 85.0, 95.0, 150.0}) {
        const Vec3 n{std::sin(angle * degree), std::cos(angle * degree), 0};
        const double expected = std::max(0.0, n.y);
        CAPTURE(angle);
        CHECK_THAT(trace_one(scene, {5.0 * n, -n, {0, 0, 1}}).s0, WithinAbs(expected, 1e-5));
    }
}

TEST_CASE("an area lamp's half shadow is the visible part of it", "[surface]") {
    // A wide slab at height 5 with its rim at x = 0, a lamp 2 wide at height 10: the floor at x
    // sees the lamp's points beyond -x.
    Light lamp = lamp_at({0, 10, 0});
    lamp.edge_u = {2, 0, 0};
    lamp.edge_v = {0, 0, 0.5};
    Scene scene = lit_floor(lamp);
    Thing slab;
    slab.shape = BoxShape{};
    slab.finish = {0, 0};
    slab.to_world =
        Transform::scaling({1e3, 0.01, 1e3}).then(Transform::translation({-1e3, 5, -500}));
    scene.things.push_back(slab);
    for (const double x : {0.2, 0.5, 0.9}) {
        // The line from (x, 0) to the lamp's point (u, 10) passes the slab at (x + u) / 2.
        double expected = 0;
        constexpr int n = 400;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < 20; ++j) {
                const double u = 2 * ((i + 0.5) / n - 0.5), v = 0.5 * ((j + 0.5) / 20 - 0.5);
                const double at = x + (u - x) * (u > x ? 0.5 : 0.501);  // lower or upper rim
                if (at > 0) expected += 10 / std::hypot(10, u - x, v) / (n * 20);
            }
        }
        Scene view = scene;
        view.camera.location = {x + 5, 4, 0};
        view.camera.direction = {-5, -4, 0};
        view.camera.right = {0, 0, 1e-4};
        view.camera.up = {-4e-5, 5e-5, 0};
        RenderOptions options;
        options.width = options.height = 16;
        options.samples = 256;
        const double seen = luminance_of(render(view, options).image);
        CAPTURE(x, seen, expected);
        // 65536 draws of a yes or no, each at a wavelength of its own: a standard error near 0.003.
        CHECK_THAT(seen, WithinAbs(expected, 0.012));
    }
}

TEST_CASE("a stone between lamp and floor casts a shadow", "[surface]") {
    Scene scene = lit_floor(lamp_at({0, 10, 0}));
    scene.gems.push_back(
        {cube_stone().transformed(Transform::translation({0, 5, 0})), glass(1.5), "cube"});
    const auto slanted = [&](double x) {
        const Vec3 from{x + 8, 3, 0};
        return trace_one(scene, {from, normalised(Vec3{x, 0, 0} - from), {0, 0, 1}}).s0;
    };
    // The upper rim is 1 aside at height 6. In the shadow, a little of the lit floor shows in the
    // stone's faces.
    CHECK(slanted(0) < 0.02);
    CHECK(slanted(10.0 / 4 - 0.01) < 0.02);
    CHECK(slanted(10.0 / 4 + 0.01) > 0.9);
}
