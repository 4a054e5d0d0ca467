// Pictures: the same bits, and means that agree with the deterministic tree.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "crystal/mineral.hpp"
#include "render/film.hpp"
#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

struct Mean {
    double value = 0, standard_error = 0;
};

/// The mean of a channel over pixels that are equal in the mean.
Mean mean_and_error(const std::vector<float>& values, std::size_t offset, std::size_t stride) {
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = offset; i < values.size(); i += stride) {
        sum += values[i];
        squares += static_cast<double>(values[i]) * values[i];
        ++count;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1))};
}

}  // namespace

TEST_CASE("a picture is the same to the last bit for any number of threads", "[render][bits]") {
    const Vec3 axis = normalised(Vec3{1, 2, 1});
    Scene scene = picture_scene(zircon(axis), slope({0, 1, 0}));
    Thing floor;
    floor.to_world = Transform::translation({0, -2, 0});
    scene.things.push_back(floor);
    Light lamp;
    lamp.position = {1, 4, 3};
    lamp.edge_u = {1, 0, 0};
    lamp.edge_v = {0, 0, 1};
    scene.lights.push_back(lamp);
    RenderOptions options = small(40, 9);
    options.stokes = true;
    options.bands = GENERATE(0, 4);
    const Image one = render(scene, options).image;
    for (const int threads : {1, 2, 7}) {
        options.threads = threads;
        const Image again = render(scene, options).image;
        CAPTURE(threads);
        CHECK(again.rgb == one.rgb);
        CHECK(again.rgb_stokes == one.rgb_stokes);
        CHECK(again.spectral == one.spectral);
    }
    options.seed = 1;
    CHECK(render(scene, options).image.rgb != one.rgb);
}

TEST_CASE("a picture of a furnace is 1 in the mean, and unpolarised", "[render][furnace]") {
    const int kind = GENERATE(0, 1);
    const Scene scene = picture_scene(kind == 0 ? glass(2.417) : zircon({0.6, 0.8, 0}), furnace());
    RenderOptions options = small(24, 32);
    options.stokes = true;
    const Rendering out = render(scene, options);
    CHECK(out.report.dropped == 0);
    CHECK(out.report.bad_samples == 0);
    CAPTURE(kind);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Mean s0 = mean_and_error(out.image.rgb, channel, 3);
        CAPTURE(channel, s0.value, s0.standard_error);
        CHECK(std::abs(s0.value - 1) <= 5 * s0.standard_error + 1e-6);
        CHECK(s0.standard_error < 0.01);
        for (std::size_t s = 0; s < 3; ++s) {
            const Mean m = mean_and_error(out.image.rgb_stokes, channel * 3 + s, 9);
            CAPTURE(s, m.value, m.standard_error);
            CHECK(std::abs(m.value) <= 5 * m.standard_error + 1e-6);
        }
    }
}

TEST_CASE("what a depth bound keeps back from a furnace is what it reports as dropped",
          "[render][furnace]") {
    for (const int level : {1, 3, 6}) {
        Scene scene = picture_scene(calcite({0, 0.6, 0.8}), furnace());
        scene.max_trace_level = level;
        const Rendering out = render(scene, small(16, 16));
        const Mean s0 = mean_and_error(out.image.rgb, 1, 3);
        CAPTURE(level, s0.value, out.report.dropped);
        CHECK(out.report.dropped > 0.001);
        CHECK_THAT(s0.value + out.report.dropped, WithinAbs(1, 0.01));
        // Without roulette's chance the balance is exact.
        if (level == 1) CHECK_THAT(s0.value + out.report.dropped, WithinAbs(1, 1e-6));
    }
}

TEST_CASE("chance changes no mean: a zircon's picture agrees with its whole tree",
          "[render][statistics]") {
    Scene scene = picture_scene(zircon(normalised(Vec3{2, 1, 1})), slope(normalised({1, 2, 4})));
    // A flat spectrum and no dispersion: every wavelength shows the same.
    constexpr int size = 6, rays_across = 7;
    RenderOptions options = small(size, 400);
    options.stokes = true;
    const double cell = 0.004;  // so small that a pixel's rays take the same facets, mostly
    scene.camera = towards_origin(size * cell);
    scene.camera.location = {0.31, 0.17, 6};
    const Image image = render(scene, options).image;

    std::vector<SensorRay> rays;
    constexpr int across = size * rays_across;
    for (int y = 0; y < across; ++y) {
        for (int x = 0; x < across; ++x) {
            const Vec3 d = scene.camera.direction +
                           ((x + 0.5) / across - 0.5) * scene.camera.right +
                           (0.5 - (y + 0.5) / across) * scene.camera.up;
            rays.push_back({scene.camera.location, d, scene.camera.right});
        }
    }
    TraceOptions whole;
    whole.threshold = 1e-5;
    const Traced traced = trace(scene, rays, whole);
    Stokes expected, dropped;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        expected += (1.0 / static_cast<double>(rays.size())) * traced.stokes[i];
        dropped += (1.0 / static_cast<double>(rays.size())) * traced.dropped[i];
    }
    const double unknown = dropped.s0;
    CHECK(unknown < 0.01);
    const Mean s0 = mean_and_error(image.rgb, 1, 3);
    CAPTURE(s0.value, s0.standard_error, expected.s0, unknown);
    CHECK(s0.standard_error < 0.01);
    CHECK(s0.value >= expected.s0 - 5 * s0.standard_error - 1e-3);
    CHECK(s0.value <= expected.s0 + unknown + 5 * s0.standard_error + 1e-3);
    for (std::size_t s = 0; s < 3; ++s) {
        const Mean m = mean_and_error(image.rgb_stokes, 3 + s, 9);
        const double wanted = s == 0 ? expected.s1 : s == 1 ? expected.s2 : expected.s3;
        CAPTURE(s, m.value, m.standard_error, wanted);
        CHECK(std::abs(m.value - wanted) <= 5 * m.standard_error + unknown + 1e-3);
    }
}

TEST_CASE("a diamond's fire leaves a white furnace white", "[render][colour]") {
    const Mineral* diamond = find_mineral("diamond");
    REQUIRE(diamond != nullptr);
    REQUIRE(diamond->indices[0].dispersive());
    const Scene scene = picture_scene({diamond->indices, {0, 0, 1}}, furnace());
    const Image image = render(scene, small(24, 64)).image;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Mean m = mean_and_error(image.rgb, channel, 3);
        CAPTURE(channel, m.value, m.standard_error);
        CHECK(std::abs(m.value - 1) <= 5 * m.standard_error + 1e-4);
        CHECK(m.standard_error < 0.01);
    }
}

TEST_CASE("a diamond shows colours where its surroundings are not even", "[render][colour]") {
    const Scene even = picture_scene(glass(2.417), slope({1, 0, 0}));
    const Scene fire =
        picture_scene({find_mineral("diamond")->indices, {0, 0, 1}}, slope({1, 0, 0}));
    const auto tint = [](const Image& image) {
        double most = 0;
        for (std::size_t p = 0; p < image.rgb.size(); p += 3) {
            most = std::max(most, std::abs(static_cast<double>(image.rgb[p]) - image.rgb[p + 2]));
        }
        return most;
    };
    CHECK(tint(render(even, small(16, 16)).image) < 1e-5);
    CHECK(tint(render(fire, small(16, 64)).image) > 0.02);
}

TEST_CASE("the bands of a daylit sky hold its spectrum, and its luminance", "[render][colour]") {
    Scene scene;
    scene.environment = furnace();
    scene.camera = towards_origin(1);
    const int bands = GENERATE(5, 40, 80);
    RenderOptions options = small(4, 8);
    options.bands = bands;
    const Image image = render(scene, options).image;
    REQUIRE(image.wavelengths_nm.size() == static_cast<std::size_t>(bands));
    REQUIRE(image.spectral_components == 1);
    const double width = 400.0 / bands;
    CHECK_THAT(image.wavelengths_nm.front(), WithinAbs(380 + width / 2, 1e-9));
    CHECK_THAT(image.wavelengths_nm.back(), WithinAbs(780 - width / 2, 1e-9));
    double luminance = 0;
    for (std::size_t b = 0; b < image.wavelengths_nm.size(); ++b) {
        const double centre = image.wavelengths_nm[b];
        double mean_observer = 0, mean_daylight = 0;
        for (int i = 0; i < 200; ++i) {
            const double nm = centre + width * ((i + 0.5) / 200 - 0.5);
            mean_observer += observer(nm)[1] / 200;
            mean_daylight += white()(nm) / 200;
        }
        luminance += image.spectral[b] * mean_observer * width;
        CHECK_THAT(image.spectral[b], WithinAbs(mean_daylight, 1e-4));
    }
    CHECK_THAT(luminance, WithinAbs(1, bands == 5 ? 0.05 : 2e-3));
    CHECK_THAT(image.rgb[0], WithinAbs(1, 1e-5));
    CHECK_THAT(image.rgb[1], WithinAbs(1, 1e-5));
    CHECK_THAT(image.rgb[2], WithinAbs(1, 1e-5));
}

TEST_CASE("bands seen through a dispersive stone hold the furnace's spectrum too",
          "[render][colour]") {
    Scene scene = picture_scene({find_mineral("diamond")->indices, {0, 0, 1}}, furnace());
    scene.camera = towards_origin(0.8);  // nothing but stone
    RenderOptions options = small(24, 64);
    options.bands = 4;
    options.stokes = true;
    const Image image = render(scene, options).image;
    REQUIRE(image.spectral_components == 4);
    for (std::size_t b = 0; b < 4; ++b) {
        double of_day = 0;
        for (int i = 0; i < 200; ++i) {
            of_day += white()(image.wavelengths_nm[b] + 100 * ((i + 0.5) / 200 - 0.5)) / 200;
        }
        const Mean s0 = mean_and_error(image.spectral, b * 4, 16);
        CAPTURE(b, s0.value, s0.standard_error, of_day);
        CHECK(std::abs(s0.value - of_day) <= 5 * s0.standard_error + 1e-4);
        CHECK(s0.standard_error < 0.02);
        for (std::size_t s = 1; s < 4; ++s) {
            const Mean m = mean_and_error(image.spectral, b * 4 + s, 16);
            CHECK(std::abs(m.value) <= 5 * m.standard_error + 1e-6);
        }
    }
}

TEST_CASE("wavelengths drawn evenly add up to white, each as bright as it is rare", "[render]") {
    const bool uniform = GENERATE(false, true);
    const WavelengthSampler wavelengths(uniform);
    constexpr int count = 200000;
    Rgb sum{};
    double range = 0, before = shortest_nm;
    bool rises = true;
    for (int i = 0; i < count; ++i) {
        const auto draw = wavelengths.draw((i + 0.5) / count);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += draw.rgb[c] / count;
        range += draw.per_density / count;
        rises = rises && draw.wavelength_nm >= before;
        before = draw.wavelength_nm;
    }
    CHECK(rises);
    CHECK(before <= longest_nm);
    // The midpoint rule over cells of constant density.
    const Rgb white = rgb_of(Spectrum(1.0));
    for (std::size_t c = 0; c < 3; ++c) CHECK(sum[c] == Approx(white[c]).epsilon(1e-4));
    CHECK(range == Approx(longest_nm - shortest_nm).epsilon(uniform ? 1e-10 : 1e-2));
    CHECK(wavelengths.draw(0).wavelength_nm == shortest_nm);
    CHECK(wavelengths.draw(std::nextafter(1.0, 0.0)).wavelength_nm <= longest_nm);
}
