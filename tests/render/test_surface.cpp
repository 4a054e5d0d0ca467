// Opaque surfaces: how bright lamps, surroundings and their own glow make them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;
using Draws = icespar::testing::Random;

TEST_CASE("under an even sky a diffuse plane is as bright as diffuse times pigment", "[surface]") {
    Scene scene;
    scene.environment = furnace();
    for (const double diffuse : {1.0, 0.6}) {
        for (const double pigment : {1.0, 0.25}) {
            scene.things = {floor_of(diffuse, pigment)};
            CAPTURE(diffuse, pigment);
            CHECK_THAT(seen_at(scene, 3, -4), WithinAbs(diffuse * pigment, 1e-13));
            CHECK_THAT(pictured(scene, 3, -4, 32), WithinAbs(diffuse * pigment, 0.01));
        }
    }
}

TEST_CASE("a sky that is brighter above lights a floor by the cosine-weighted mean", "[surface]") {
    // Radiance (1 + y) / 2 over the hemisphere, weighted by y / pi: 1/2 + 1/3.
    Scene scene;
    scene.environment = slope({0, 1, 0});
    scene.things = {floor_of(1, 1)};
    CHECK_THAT(seen_at(scene, 0, 0), WithinAbs(5.0 / 6, 1e-3));
    CHECK_THAT(pictured(scene, 0, 0, 64), WithinAbs(5.0 / 6, 3e-3));
}

TEST_CASE("a lamp of colour 1 straight above shows diffuse times pigment, POV-Ray's scale",
          "[surface]") {
    for (const double height : {0.5, 7.0}) {
        CHECK_THAT(seen_at(lit_floor(lamp_at({0, height, 0}), 0.6, 0.5), 0, 0),
                   WithinAbs(0.3, 1e-13));
        CHECK_THAT(seen_at(lit_floor(lamp_at({0, height, 0}, 2.5), 0.6, 0.5), 0, 0),
                   WithinAbs(0.75, 1e-13));
    }
}

TEST_CASE("a lamp aside lights by the cosine of its angle, from either side of a plane",
          "[surface]") {
    for (const double angle : {10.0, 45.0, 80.0}) {
        const double r = 5 * std::tan(angle * degree);
        CAPTURE(angle);
        const Scene scene = lit_floor(lamp_at({r, 5, 0}));
        CHECK_THAT(seen_at(scene, 0, 0), WithinAbs(std::cos(angle * degree), 1e-12));
        // From below, the side that is seen is not the one that is lit.
        const Vec3 up{0, 1, 0};
        CHECK(trace_one(scene, {{0, -4, 0}, up, {1, 0, 0}}).s0 == 0);
        const Scene under = lit_floor(lamp_at({r, -5, 0}));
        CHECK_THAT(trace_one(under, {{0, -4, 0}, up, {1, 0, 0}}).s0,
                   WithinAbs(std::cos(angle * degree), 1e-12));
    }
}

TEST_CASE("lamps fade as POV-Ray's: 2 / (1 + (d / fade_distance)^fade_power)", "[surface]") {
    const struct {
        double distance, power, height, expected;
    } rows[] = {
        {4, 2, 4, 1},       {4, 2, 8, 0.4}, {4, 2, 2, 1.6}, {4, 1, 12, 0.5},
        {2, 3, 6, 1. / 14}, {0, 2, 9, 1},   {3, 0, 9, 1},
    };
    for (const auto& row : rows) {
        Light lamp = lamp_at({0, row.height, 0});
        lamp.fade_distance = row.distance;
        lamp.fade_power = row.power;
        CAPTURE(row.distance, row.power, row.height);
        CHECK_THAT(seen_at(lit_floor(lamp), 0, 0), WithinAbs(row.expected, 1e-13));
    }
}

TEST_CASE("a lamp's colour is D65 times its rgb, and pigments colour it", "[surface]") {
    Light lamp = lamp_at({0, 5, 0});
    lamp.light = reflectance_from_rgb({0.9, 0.5, 0.2}) * white();
    Scene scene = lit_floor(lamp, 0.8, 1);
    scene.camera.location = {0, 2, 0.001};
    scene.camera.direction = {0, -1, 0};
    scene.camera.right = {1e-4, 0, 0};
    scene.camera.up = {0, 0, -1e-4};
    RenderOptions options;
    options.width = options.height = 8;
    options.samples = 200;
    const Image image = render(scene, options).image;
    CHECK_THAT(mean_of(image.rgb, 0, 3), WithinAbs(0.72, 0.01));
    CHECK_THAT(mean_of(image.rgb, 1, 3), WithinAbs(0.40, 0.01));
    CHECK_THAT(mean_of(image.rgb, 2, 3), WithinAbs(0.16, 0.01));
}

TEST_CASE("a surface that emits is as bright as emission times pigment, from any side",
          "[surface]") {
    Scene scene;
    scene.environment = night();
    Thing glow = ball({0, 0, 0}, 1);
    glow.pigment.colours = {Spectrum(0.5)};
    glow.finish = {0, 3};
    scene.things = {glow};
    Draws random(8);
    for (int i = 0; i < 20; ++i) {
        const SensorRay ray = random_ray(random, 4, 0.5);
        CHECK(difference(trace_one(scene, ray), {1.5, 0, 0, 0}) <= 1e-14);
    }
    // It lights a floor as well: a ball seen from its foot under half angle a fills sin^2 a of the
    // cosine-weighted sky.
    scene.things.push_back(floor_of(1, 1));
    scene.things[0] = ball({0, 2, 0}, 1);
    scene.things[0].pigment.colours = {Spectrum(1.0)};
    scene.things[0].finish = {0, 1};
    scene.camera.location = {5, 1, 0};
    scene.camera.direction = {-5, -1, 0};
    scene.camera.right = {0, 0, 1e-4};
    scene.camera.up = {-1e-5, 5e-5, 0};
    RenderOptions options;
    options.width = options.height = 16;
    options.samples = 64;
    CHECK_THAT(luminance_of(render(scene, options).image), WithinAbs(0.25, 0.015));
}

TEST_CASE("a glowing floor seen through a stone is the furnace of a stone", "[surface][furnace]") {
    Draws random(12);
    Scene scene = scene_of(brilliant_stone(), calcite(random.direction()), night());
    Thing room;
    room.shape = SphereShape{};
    room.to_world = Transform::scaling({9, 9, 9});
    room.pigment.colours = {Spectrum(1.0)};
    room.finish = {0, 1};
    scene.things.push_back(room);
    const auto rays = random_rays(random, 60, 5, 0.8);
    TraceOptions options;
    options.max_hits = 6;
    const Traced traced = trace(scene, rays, options);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        CHECK(difference(traced.stokes[i] + traced.dropped[i], {1, 0, 0, 0}) <= 1e-12);
    }
}

TEST_CASE("a pattern is seen where it lies", "[surface][pattern]") {
    Scene scene;
    scene.environment = night();
    Thing board;
    board.pigment.kind = Pigment::Kind::checker;
    board.pigment.colours = {Spectrum(0.8)};
    board.pigment.colours.push_back(Spectrum(0.1));
    board.finish = {0, 1};
    scene.things = {board};
    CHECK_THAT(seen_at(scene, 0.5, 0.5), WithinAbs(0.8, 1e-14));
    CHECK_THAT(seen_at(scene, -0.5, 0.5), WithinAbs(0.1, 1e-14));
    CHECK_THAT(seen_at(scene, 7.5, -2.5), WithinAbs(0.8, 1e-14));
    CHECK_THAT(seen_at(scene, 1e4 + 0.5, 0.5), WithinAbs(0.8, 1e-14));
}
