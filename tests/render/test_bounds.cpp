// When a render stops, what it reports, and what it refuses to start.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include "math/error.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

TEST_CASE("so many samples are taken as were asked", "[render][bounds]") {
    const Scene scene = picture_scene(glass(1.5), slope({0, 1, 0}));
    for (const int samples : {1, 5, 8, 19}) {
        RenderOptions options = small(20, samples);
        std::vector<double> done;
        const Rendering out = render(scene, options, [&](const Progress& p) {
            done.push_back(p.done);
            return true;
        });
        CHECK(out.report.samples == samples);
        CHECK(out.report.paths == 400u * static_cast<unsigned>(samples));
        CHECK_FALSE(out.report.interrupted);
        REQUIRE_FALSE(done.empty());
        CHECK(std::is_sorted(done.begin(), done.end()));
        CHECK(done.back() == 1);
        CHECK(out.image.rgb.size() == 1200);
        CHECK(out.image.metadata.at("samples") == std::to_string(samples));
    }
}

TEST_CASE("an error bound is kept, and the estimate is of the size of the true error",
          "[render][bounds]") {
    const Scene scene = picture_scene(zircon({0, 1, 0}), slope({0, 1, 0}));
    RenderOptions options = small(16, 0);
    options.error = 0.03;
    const Rendering out = render(scene, options);
    CHECK(out.report.error <= 0.03);
    CHECK(out.report.error > 0);
    CHECK(out.report.samples >= 2);
    options.seed = 77;
    options.error = 0.006;
    const Rendering fine = render(scene, options);
    CHECK(fine.report.samples > 5 * out.report.samples);
    double squares = 0, mean = 0;
    const auto pixels = static_cast<double>(fine.image.rgb.size() / 3);
    const auto luminance = [](const Image& image, std::size_t p) {
        return xyz_from_rgb({image.rgb[p], image.rgb[p + 1], image.rgb[p + 2]})[1];
    };
    for (std::size_t p = 0; p < fine.image.rgb.size(); p += 3) {
        squares += std::pow(luminance(out.image, p) - luminance(fine.image, p), 2) / pixels;
        mean += luminance(fine.image, p) / pixels;
    }
    const double measured = std::sqrt(squares) / mean;
    CAPTURE(measured, out.report.error);
    // The estimate does not know how evenly the samples lie: it may be too high, not too low.
    CHECK(measured < 1.2 * out.report.error);
    CHECK(measured > 0.1 * out.report.error);
}

TEST_CASE("a time bound is kept", "[render][bounds]") {
    const Scene scene = picture_scene(zircon({0, 1, 0}), slope({0, 1, 0}));
    RenderOptions options = small(32, 0);
    options.seconds = 0.3;
    const auto start = std::chrono::steady_clock::now();
    const Rendering out = render(scene, options);
    const double took =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    CHECK(took >= 0.3);
    CHECK(took < 5);  // the machine may be busy
    CHECK(out.report.samples >= 1);
    CHECK_FALSE(out.report.interrupted);
    CHECK(*std::min_element(out.image.rgb.begin(), out.image.rgb.end()) > 0);
}

TEST_CASE("a render that is broken off keeps the pixels that are finished, and counts no others",
          "[render][bounds]") {
    Scene scene;
    scene.environment = furnace();
    scene.camera = towards_origin(0.1);
    // One stone fills the view, and one event is the bound: paths and events are as many.
    scene.gems.push_back({cube_stone(), glass(1.5), "cube"});
    scene.max_trace_level = 1;
    const Rendering out = render(scene, small(128, 1000), [](const Progress&) { return false; });
    CHECK(out.report.interrupted);
    std::size_t finished = 0;
    bool whole = true;
    for (std::size_t p = 0; p < out.image.rgb.size(); p += 3) {
        if (out.image.rgb[p] == 0) continue;
        ++finished;
        whole = whole && std::abs(out.image.rgb[p] - 0.04) < 1e-4;
    }
    CAPTURE(finished);
    CHECK(whole);
    CHECK(finished > 0);
    CHECK(finished < 128 * 128);
    CHECK(out.report.paths == out.report.events);
    CHECK_THAT(out.report.dropped, WithinAbs(0.96, 1e-4));
}

TEST_CASE("a closed room of perfectly white walls is rendered in bounded time",
          "[render][bounds]") {
    Scene scene;
    Thing room;
    room.shape = BoxShape{};
    room.to_world =
        Transform::translation({-0.5, -0.5, -0.5}).then(Transform::scaling({10, 10, 10}));
    room.pigment.colours = {Spectrum(5.0)};
    room.finish = {1, 0};
    scene.things.push_back(room);
    scene.lights.push_back(lamp_at({0, 1, 0}));
    const Rendering out = render(scene, small(4, 8), {});
    CHECK(out.report.samples == 8);
    CHECK(out.report.bad_samples == 0);
}

TEST_CASE("what stands inside a stone is refused, not passed over", "[render][bounds]") {
    Scene scene;
    scene.gems.push_back({cube_stone(), glass(1.5), "cube"});
    CHECK(faults(scene).empty());
    scene.lights.push_back(lamp_at({0, 0, 0.1}));
    REQUIRE(faults(scene).size() == 1);
    CHECK_THAT(faults(scene)[0], Contains("light source is inside"));
    Thing ball;
    ball.shape = SphereShape{};
    ball.to_world = Transform::scaling({0.1, 0.1, 0.1});
    scene.things.push_back(ball);
    REQUIRE(faults(scene).size() == 2);
    CHECK_THAT(faults(scene)[1], Contains("opaque object is inside"));
}

TEST_CASE("options that make no sense are refused with what would", "[render][bounds]") {
    const Scene scene = picture_scene(glass(1.5), furnace());
    const auto message = [&](auto change) -> std::string {
        RenderOptions options = small(4, 1);
        change(options);
        try {
            (void)render(scene, options);
        } catch (const Error& e) {
            return e.what();
        }
        return "no error";
    };
    using O = RenderOptions;
    CHECK_THAT(message([](O& o) { o.width = 0; }), Contains("size"));
    CHECK_THAT(message([](O& o) { o.height = -3; }), Contains("size"));
    CHECK_THAT(message([](O& o) { o.width = 65537; }), Contains("65536"));
    CHECK_THAT(message([](O& o) { o.samples = -1; }), Contains("samples"));
    CHECK_THAT(message([](O& o) { o.threads = -1; }), Contains("threads"));
    CHECK_THAT(message([](O& o) { o.error = -0.1; }), Contains("error"));
    CHECK_THAT(message([](O& o) { o.error = NAN; }), Contains("error"));
    CHECK_THAT(message([](O& o) { o.seconds = INFINITY; }), Contains("time"));
    CHECK_THAT(message([](O& o) { o.bands = 401; }), Contains("400"));
    CHECK_THAT(message([](O& o) { o.bands = -1; }), Contains("bands"));
}

TEST_CASE("scenes and rays that make no sense are refused with what is wrong", "[render][bounds]") {
    const auto of_scene = [](auto change) -> std::string {
        Scene scene = picture_scene(zircon({0, 0, 1}), furnace());
        change(scene);
        try {
            (void)render(scene, small(4, 1));
        } catch (const Error& e) {
            return e.what();
        }
        return "no error";
    };
    CHECK_THAT(of_scene([](Scene& s) { s.gems[0].crystal.axis = {0, 0, 0}; }), Contains("axis"));
    CHECK_THAT(of_scene([](Scene& s) { s.gems[0].crystal.axis = {0, 0, NAN}; }), Contains("axis"));
    CHECK_THAT(of_scene([](Scene& s) { s.gems[0].crystal.indices[1] = IndexFunction(0.9); }),
               Contains("index"));
    CHECK_THAT(of_scene([](Scene& s) { s.gems[0].crystal.indices[0] = IndexFunction(NAN); }),
               Contains("index"));
    CHECK_THAT(of_scene([](Scene& s) { s.gems.push_back(s.gems[0]); }), Contains("overlap"));
    CHECK_THAT(of_scene([](Scene& s) { s.camera.location = {}; }), Contains("camera"));
    CHECK_THAT(of_scene([](Scene& s) { s.camera.right = s.camera.up; }), Contains("camera"));

    const Scene scene = picture_scene(glass(1.5), furnace());
    const auto of_ray = [&](const SensorRay& ray, const TraceOptions& options) -> std::string {
        try {
            (void)trace(scene, std::span(&ray, 1), options);
        } catch (const Error& e) {
            return e.what();
        }
        return "no error";
    };
    const SensorRay good{{0, 0, 5}, {0, 0, -1}, {1, 0, 0}};
    const auto changed = [&](auto change) {
        SensorRay ray = good;
        TraceOptions options;
        change(ray, options);
        return of_ray(ray, options);
    };
    using R = SensorRay;
    using T = TraceOptions;
    CHECK(changed([](R&, T&) {}) == "no error");
    CHECK_THAT(changed([](R& r, T&) { r.direction = {}; }), Contains("directions[0]"));
    CHECK_THAT(changed([](R& r, T&) { r.direction.y = NAN; }), Contains("directions[0]"));
    CHECK_THAT(changed([](R& r, T&) { r.origin.x = INFINITY; }), Contains("origins[0]"));
    CHECK_THAT(changed([](R& r, T&) { r.origin = {}; }), Contains("origins[0]"));
    CHECK_THAT(changed([](R& r, T&) { r.x_axis = {0, 0, 2}; }), Contains("x_axis[0]"));
    CHECK_THAT(changed([](R& r, T&) { r.x_axis = {}; }), Contains("x_axis[0]"));
    CHECK_THAT(changed([](R&, T& t) { t.wavelength_nm = 300; }), Contains("wavelength"));
    CHECK_THAT(changed([](R&, T& t) { t.max_hits = -1; }), Contains("max_hits"));
    CHECK_THAT(changed([](R&, T& t) { t.threshold = NAN; }), Contains("threshold"));
}
