// Pictures by beams against pictures by rays, which are the reference.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/compare_engines.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

TEST_CASE("beams and rays make the same picture of a stone below a sky with lamps",
          "[beams][statistics]") {
    const int kind = GENERATE(0, 1, 2);
    const Crystal crystal = kind == 0   ? glass(2.417)
                            : kind == 1 ? zircon(normalised({2, 1, 1}))
                                        : calcite({0, 0, 1});
    CAPTURE(kind);
    compare_engines(lit(picture_scene(crystal, slope(normalised({1, 2, 4})))), 256, 64, 12);
}

TEST_CASE("beams and rays agree on the polarisation of a picture", "[beams][statistics]") {
    compare_engines(lit(picture_scene(calcite(normalised({2, 1, 1})), slope({1, 0, 0}))), 128, 32,
                    10, true);
}

TEST_CASE("beams and rays agree on a dispersive stone in a parallel view", "[beams][statistics]") {
    Crystal diamond{{IndexFunction::cauchy(2.3784, 0.0134)}, {0, 0, 1}};
    Scene scene = lit(picture_scene(diamond, slope(normalised({1, 2, 4}))));
    scene.camera.kind = Camera::Kind::orthographic;
    scene.camera.right = {2.2, 0, 0};
    scene.camera.up = {0, 2.2, 0};
    compare_engines(scene, 256, 64, 12);
}

TEST_CASE("beams paint the colours of a crystal that splits and disperses light as rays do",
          "[beams][statistics]") {
    Crystal crystal = zircon(normalised({2, 1, 1}));
    crystal.indices = {IndexFunction::cauchy(1.88, 0.013), IndexFunction::cauchy(1.93, 0.019)};
    compare_engines(lit(picture_scene(crystal, slope(normalised({1, 2, 4})))), 128, 64, 8);
}

TEST_CASE("beams that leave a stone go on as rays to what stands around", "[beams][statistics]") {
    Scene scene = lit(picture_scene(calcite({0, 0, 1}), slope({0, 1, 0})));
    Thing floor;
    floor.shape = PlaneShape{};
    // The plane y = 0 turned to z = -1.2.
    floor.to_world = {{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}, {0, 0, -1.2}};
    floor.pigment.kind = Pigment::Kind::checker;
    floor.pigment.colours = {Spectrum(1.0), Spectrum(0.0)};
    floor.pigment.to_pattern = Transform::scaling({2, 2, 2});
    floor.finish = {0.5, 0.5};
    scene.things.push_back(floor);
    scene.gems.push_back(
        {cube_stone().transformed(Transform::translation({2.2, 0, 0})), glass(1.6), "cube"});
    compare_engines(scene, 256, 64, 12);
}

TEST_CASE("a prism spreads the edge of a lit wall as Snell's law says, by beams that go on as rays",
          "[beams]") {
    // Seen straight down through its level face, its lower one slopes. Left of its edge all is
    // dark.
    const double slope_angle = 20 * degree, depth = 6, width = 1.2;
    const IndexFunction index = IndexFunction::cauchy(1.6, 0.05);
    std::vector<FacetPlane> planes = box_planes({-2, -2, -2}, {2, 2, 0});
    planes.push_back(
        {{std::sin(slope_angle), 0, -std::cos(slope_angle)}, std::cos(slope_angle), "slope"});
    Scene scene = scene_of(Stone::from_planes(planes), {{index}, {0, 0, 1}}, night());
    scene.camera.kind = Camera::Kind::orthographic;
    scene.camera.location = {0, 0, 4};
    scene.camera.direction = {0, 0, -1};
    scene.camera.right = {width, 0, 0};
    scene.camera.up = {0, width, 0};
    // Beyond the face a ray leans to the left; from x it goes down from x tan(slope) - 1.
    const auto lean = [&](double nm) {
        return std::tan(std::asin(index(nm) * std::sin(slope_angle)) - slope_angle);
    };
    const double edge = -(depth - 1) * lean(550);
    const auto seen_at = [&](double nm) {
        return (edge + (depth - 1) * lean(nm)) / (1 - std::tan(slope_angle) * lean(nm));
    };
    Thing wall;
    wall.shape = BoxShape{};
    wall.to_world =
        Transform::scaling({100, 100, 1}).then(Transform::translation({edge, -50, -depth - 1}));
    wall.finish = {0, 1};
    scene.things.push_back(wall);
    const auto picture = [&](Engine engine, int samples) {
        RenderOptions options = small(8, samples);
        options.engine = engine;
        const Rendering r = render(scene, options);
        REQUIRE(r.report.engine == engine);
        std::array<double, 3> mean{};
        for (std::size_t c = 0; c < 3; ++c) mean[c] = mean_of(r.image.rgb, c, 3);
        return mean;
    };
    const auto rays = picture(Engine::rays, 1024), beams = picture(Engine::beams, 32);
    // Red is bent less, so more of it is seen; between 460 and 610 nm at the least.
    const double spread = (seen_at(460) - seen_at(610)) / width;
    CHECK(spread > 0.2);
    CHECK(rays[0] - rays[2] > 0.5 * spread);
    for (std::size_t c = 0; c < 3; ++c) {
        CAPTURE(c, rays, beams);
        CHECK(std::abs(beams[c] - rays[c]) < 0.1 * spread);
    }
}

TEST_CASE("the size of a stone and its place change no picture by beams", "[beams]") {
    const bool pixels = GENERATE(false, true);
    const Scene scene = lit(picture_scene(zircon(normalised({2, 1, 1})), slope({1, 0, 0})));
    const auto picture = [&](double scale, const Vec3& by) {
        Scene moved = scene;
        Gem& gem = moved.gems[0];
        gem.stone = gem.stone.transformed(
            Transform::scaling({scale, scale, scale}).then(Transform::translation(by)));
        Camera& c = moved.camera;
        c.location = scale * c.location + by;
        c.direction = scale * c.direction;
        c.right = scale * c.right;
        c.up = scale * c.up;
        RenderOptions options = small(16, 16);
        options.engine = Engine::beams;
        options.forced.pixels = pixels;
        return render(moved, options).image.rgb;
    };
    const auto here = picture(1, {});
    const auto worst = [&](const std::vector<float>& other) {
        // Roulette may turn on a rounding: a few pixels differ by their noise, or a few blocks of
        // sixteen.
        std::vector<double> all;
        for (std::size_t i = 0; i < here.size(); ++i) {
            all.push_back(std::abs(double(here[i]) - other[i]));
        }
        std::sort(all.begin(), all.end());
        return all[pixels ? all.size() * 9 / 10 : all.size() / 4];
    };
    CAPTURE(pixels);
    CHECK(worst(picture(1e-3, {})) < 1e-6);
    CHECK(worst(picture(1e6, {})) < 1e-6);
    CHECK(worst(picture(1, {1e6, -1e6, 1e6})) < 1e-4);
}

TEST_CASE("any number of threads makes the same picture by beams, bit for bit", "[beams]") {
    const Scene scene = lit(picture_scene(calcite({0, 0, 1}), slope({1, 0, 0})));
    RenderOptions options = small(40, 8);
    options.engine = Engine::beams;
    const auto one = render(scene, options).image.rgb;
    for (const int threads : {2, 7}) {
        options.threads = threads;
        CHECK(render(scene, options).image.rgb == one);
    }
}

TEST_CASE("the error that one pass of beams tells of itself is the error it has",
          "[beams][statistics]") {
    const bool dispersive = GENERATE(false, true);
    CAPTURE(dispersive);
    Crystal crystal = zircon(normalised({2, 1, 1}));
    if (dispersive) crystal = {{IndexFunction::cauchy(2.3784, 0.0134)}, {0, 0, 1}};
    const Scene scene = lit(picture_scene(crystal, slope({1, 2, 0})));
    RenderOptions options = small(24, dispersive ? 512 : 4096);
    options.engine = Engine::beams;
    const auto reference = render(scene, options).image.rgb;
    for (const int samples : {8, 32}) {
        options.samples = samples;
        const Rendering r = render(scene, options);
        double square = 0, mean = 0;
        for (std::size_t i = 0; i < reference.size(); i += 3) {
            const auto y = [&](const std::vector<float>& v) {
                return xyz_from_rgb({v[i], v[i + 1], v[i + 2]})[1];
            };
            square += std::pow(y(r.image.rgb) - y(reference), 2);
            mean += y(reference);
        }
        const double pixels = static_cast<double>(reference.size()) / 3;
        const double error = std::sqrt(square / pixels) / (mean / pixels);
        CAPTURE(samples, error, r.report.error);
        CHECK(r.report.error > 0.7 * error);
        CHECK(r.report.error < 1.5 * error);
    }
}

TEST_CASE("beams go on until the error that was asked for is reached", "[beams][bounds]") {
    const Scene scene = lit(picture_scene(glass(2.417), slope({1, 2, 0})));
    RenderOptions options = small(24, 0);
    options.engine = Engine::beams;
    options.error = 0.02;
    const Rendering r = render(scene, options);
    CHECK(r.report.error <= 0.02);
    CHECK(r.report.error > 0.002);
}

TEST_CASE("the engine beams is refused where there is no stone", "[beams][bounds]") {
    Scene scene;
    scene.environment = furnace();
    RenderOptions options = small(4, 1);
    options.engine = Engine::beams;
    CHECK_THROWS_WITH(render(scene, options), Catch::Matchers::Contains("no stone"));
    options.engine = Engine::automatic;
    CHECK(render(scene, options).report.engine == Engine::rays);
}

TEST_CASE("a dispersive stone in a furnace is lost in it, by however many samples", "[beams]") {
    Crystal diamond{{IndexFunction::cauchy(2.3784, 0.0134)}, {0, 0, 1}};
    RenderOptions options = small(2, 200'000);
    options.engine = Engine::beams;
    const auto found = render(picture_scene(diamond, furnace()), options);
    for (const float v : found.image.rgb) CHECK_THAT(v, WithinAbs(1, 2e-3));  // roulette
}
