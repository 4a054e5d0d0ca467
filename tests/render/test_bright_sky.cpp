// Directions drawn towards lamps and bright parts of the sky, and what they do for a diffuse floor.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/bright_sky.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::WithinAbs;
using Catch::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

Disc lamp(const Vec3& direction, double radius_degrees, double radiance) {
    return {normalised(direction), std::cos(radius_degrees * degree), Spectrum(radiance)};
}

/// A dark panorama with one bright pixel.
Environment one_bright_pixel(int width, int height, int x, int y, float value) {
    std::vector<float> grey(static_cast<std::size_t>(width * height), 0.01f);
    grey[static_cast<std::size_t>(y * width + x)] = value;
    Environment sky;
    sky.pattern = panorama(width, height, grey);
    return sky;
}

Scene floor_below(Environment sky, double reflectance) {
    Scene scene;
    scene.things.push_back(floor_of(1, reflectance));
    scene.environment = std::move(sky);
    return scene;
}

}  // namespace

TEST_CASE("densities of bright directions integrate to 1, and are those of what is drawn",
          "[sky]") {
    Environment sky = one_bright_pixel(64, 32, 20, 9, 500);
    sky.discs = {lamp({0.2, 1, 0.1}, 12, 3), lamp({1, 0.3, -2}, 40, 0.5)};
    const BrightSky bright(sky);
    REQUIRE(!bright.empty());

    // Sums over the sphere of the density (half a million places tell the area of lamps to a
    // hundredth), and of it times x, y and z; then means of draws.
    constexpr int n = 512;
    double whole = 0;
    Vec3 expected, mean;
    int impossible = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            const double y = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - y * y),
                         phi = pi * (j + 0.5) / n;
            const Vec3 d{r * std::cos(phi), y, r * std::sin(phi)};
            const double share = bright.density(d) * 2 * pi / (n * n);
            whole += share;
            expected += share * d;
        }
    }
    CHECK_THAT(whole, WithinAbs(1, 1e-2));
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 d = bright.direction((i + 0.5) / n, (j + 0.5) / n);
            if (!(bright.density(d) > 0) || !(std::abs(length(d) - 1) < 1e-12)) ++impossible;
            mean += d / (1.0 * n * n);
        }
    }
    CHECK(impossible == 0);
    CHECK(length(mean - expected) < 1e-2);
}

TEST_CASE("a floor under a small round lamp of the sky has Lambert's radiance", "[sky]") {
    // Irradiance of a disc wholly above the horizon: pi L sin^2(radius) cos(zenith angle).
    const double zenith = GENERATE(0.0, 30.0, 70.0);
    const double radius = GENERATE(0.01, 0.27, 15.0);
    Environment sky = night();
    sky.discs = {lamp({std::sin(zenith * degree), std::cos(zenith * degree), 0}, radius, 1000)};
    const double sine = std::sin(radius * degree);
    const double expected = 0.6 * 1000 * sine * sine * std::cos(zenith * degree);
    // 32 of the 64 rays fall on the lamp: one of the others may, or not, and weighs as much.
    CHECK_THAT(seen_at(floor_below(sky, 0.6), 0, 0), WithinRel(expected, 4e-2));
}

TEST_CASE("a lamp of the size of the sun makes no noise on a floor", "[sky]") {
    Environment sky;
    sky.above = Spectrum(0.5);
    sky.discs = {lamp({0.3, 1, 0.2}, 0.27, 20000)};
    const double sine = std::sin(0.27 * degree);
    const double height = normalised(Vec3{0.3, 1, 0.2}).y;
    // The gradient (1 + y) / 4 over the hemisphere, by cosine: 1/4 + 1/6.
    const double expected = 0.5 * (20000 * sine * sine * height + 5.0 / 12);
    // 16 x 16 pixels of 8 rays: a floor that found the sun by luck would miss it in each of them.
    CHECK_THAT(pictured(floor_below(sky, 0.5), 0, 0, 8), WithinRel(expected, 0.05));
}

TEST_CASE("a bright pixel of a panorama is found however small it is", "[sky]") {
    const int width = GENERATE(64, 1024);
    const int height = width / 2, x = width / 3, y = height / 4;
    constexpr double value = 1e5;
    const Environment sky = one_bright_pixel(width, height, x, y, static_cast<float>(value));
    // The tent of a pixel integrates to its own solid angle.
    const double up = std::cos(pi * (y + 0.5) / height);
    const double solid_angle = 2 * pi * pi / (1.0 * width * height) * std::sqrt(1 - up * up);
    const double expected = value * solid_angle * up / pi + 0.01;
    CHECK_THAT(pictured(floor_below(sky, 1), 0, 0, 16), WithinRel(expected, 0.05));
}

TEST_CASE("a sky without bright parts, or one of nothing, offers no directions", "[sky]") {
    CHECK(BrightSky(furnace()).empty());
    Environment dark = night();
    dark.discs = {lamp({0, 1, 0}, 5, 0), lamp({0, 1, 0}, 0, 5)};
    CHECK(BrightSky(dark).empty());
    CHECK(BrightSky(one_bright_pixel(8, 4, 0, 0, 0.01f)).empty() == false);
}
