// Fisheyes, lenses and analysers.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/camera.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

TEST_CASE("a fisheye's angles grow evenly from the middle, and end at a circle", "[camera]") {
    Camera camera;
    camera.kind = Camera::Kind::fisheye;
    camera.fisheye_angle = 150 * degree;
    camera.right = {4.0 / 3, 0, 0};
    const auto direction = [&](double u, double v) {
        const auto branch = camera_branch(camera, u, v, 0.5, 0.5);
        REQUIRE(branch);
        return branch->ray;
    };
    CHECK(length(direction(0.5, 0.5) - Vec3{0, 0, -1}) < 1e-15);
    // Half way to the upper edge is half of half the angle.
    const double angle = 37.5 * degree;
    CHECK(length(direction(0.5, 0.25) - Vec3{0, std::sin(angle), -std::cos(angle)}) < 1e-14);
    // The same distance to the right, in a picture 4/3 as wide as high.
    CHECK(length(direction(0.5 + 0.25 * 0.75, 0.5) - Vec3{std::sin(angle), 0, -std::cos(angle)}) <
          1e-14);
    CHECK_FALSE(camera_branch(camera, 0.01, 0.5, 0.5, 0.5));
    // A picture has no light there.
    Scene scene;
    scene.environment = furnace();
    scene.camera = camera;
    const Image image = render(scene, small(16, 4)).image;
    CHECK(image.rgb[0] == 0);
    CHECK_THAT(image.rgb[(8 * 16 + 8) * 3], WithinAbs(1, 1e-6));
}

TEST_CASE("all rays of a lens meet where it is focused", "[camera]") {
    Random random(4);
    for (const auto kind : {Camera::Kind::perspective, Camera::Kind::orthographic}) {
        Camera camera;
        camera.kind = kind;
        camera.lens_radius = 0.3;
        camera.focal_distance = 7;
        const double u = random.uniform(), v = random.uniform();
        Camera pinhole = camera;
        pinhole.lens_radius = 0;
        const auto middle = camera_branch(pinhole, u, v, 0, 0);
        const Vec3 focus = middle->position + (7 / -middle->ray.z) * middle->ray;
        double widest = 0;
        for (int i = 0; i < 200; ++i) {
            const auto b = camera_branch(camera, u, v, random.uniform(), random.uniform());
            const Vec3 at = b->position + (7 / -b->ray.z) * b->ray;
            CHECK(length(at - focus) < 1e-13);
            CHECK(b->position.z == middle->position.z);
            widest = std::max(widest, length(b->position - middle->position));
        }
        CHECK(widest <= 0.3);
        CHECK(widest > 0.28);
    }
}

TEST_CASE("what is out of focus is spread over the lens's disc of confusion", "[camera]") {
    // A glowing half plane at twice the focal distance: its edge is smeared over r either side.
    Scene scene;
    scene.environment = night();
    Thing wall;
    wall.shape = BoxShape{};
    wall.to_world = Transform::scaling({100, 200, 1}).then(Transform::translation({0, -100, -21}));
    wall.finish = {0, 1};
    scene.things = {wall};
    scene.camera.direction = {0, 0, -1};
    scene.camera.right = {0.1, 0, 0};
    scene.camera.up = {0, 0.1, 0};
    scene.camera.lens_radius = 1;
    scene.camera.focal_distance = 10;
    RenderOptions options = small(1, 4096);
    options.width = 5;
    const Image image = render(scene, options).image;
    // At distance 20 a pixel's rays spread over a disc of radius 1, about x = 20 * 0.02 * k.
    const auto share = [](double x) {
        return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::numbers::pi;
    };
    for (int k = 0; k < 5; ++k) {
        const double x = 0.4 * (k - 2);
        CAPTURE(k);
        CHECK_THAT(image.rgb[static_cast<std::size_t>(3 * k)], WithinAbs(share(x), 0.02));
    }
}

TEST_CASE("an analyser shows one polarisation of the light", "[camera][convention]") {
    Scene scene;
    scene.environment = furnace();
    scene.environment.state = {1, 0.3, -0.5, 0.6};
    scene.camera.direction = {0, 0, -1};
    scene.camera.right = {1e-3, 0, 0};
    scene.camera.up = {0, 1e-3, 0};
    const auto bright = [&](const Jones& analyser) {
        scene.camera.analyser = analyser;
        RenderOptions options = small(1, 8);
        options.stokes = true;
        const Image image = render(scene, options).image;
        // What has passed is fully polarised.
        const double s0 = image.rgb[0];
        CHECK_THAT(std::hypot(image.rgb_stokes[0], image.rgb_stokes[1], image.rgb_stokes[2]),
                   WithinAbs(s0, 1e-6));
        return s0;
    };
    for (const double angle : {0.0, 30.0, 45.0, 100.0}) {
        const double two = 2 * angle * degree;
        CHECK_THAT(bright(jones_polariser(angle * degree)),
                   WithinAbs(0.5 * (1 + 0.3 * std::cos(two) - 0.5 * std::sin(two)), 1e-6));
    }
    const std::complex<double> i(0, 0.5);
    CHECK_THAT(bright({{{{0.5, i}, {-i, 0.5}}}}), WithinAbs(0.8, 1e-6));
    CHECK_THAT(bright({{{{0.5, -i}, {i, 0.5}}}}), WithinAbs(0.2, 1e-6));
}
