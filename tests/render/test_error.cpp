// How sure pixels are: the errors that renders tell against those that they have, and what is done
// about them.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/effort.hpp"
#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

Scene lit_brilliant(const Crystal& crystal) {
    Environment sky = slope({0, 1, 0});
    sky.discs = {{normalised(Vec3{0.3, 0.4, 1}), std::cos(12 * degree), Spectrum(4.0)},
                 {normalised(Vec3{-0.8, 0.1, 0.5}), std::cos(9 * degree), Spectrum(6.0)}};
    return picture_scene(crystal, sky);
}

constexpr int size = 40;

RenderOptions by(Engine engine, int samples, std::uint64_t seed = 0) {
    RenderOptions options = small(size, samples);
    options.engine = engine;
    options.seed = seed;
    return options;
}

/// By beams, whose error is a fortieth of what the tests look at.
Image truth_of(const Scene& scene) { return render(scene, by(Engine::beams, 1024, 77)).image; }

double luminance_at(const Image& i, std::size_t pixel) {
    return xyz_from_rgb({i.rgb[3 * pixel], i.rgb[3 * pixel + 1], i.rgb[3 * pixel + 2]})[1];
}

}  // namespace

TEST_CASE("nine to ten of ten pixels lie within the interval they tell", "[error]") {
    const bool split = GENERATE(false, true);
    const Scene scene = lit_brilliant(split ? zircon(normalised(Vec3{0.2, 0.3, 1})) : glass(2.4));
    const Image truth = truth_of(scene);
    for (const Engine engine : {Engine::rays, Engine::beams}) {
        for (const int samples : {24, 64}) {
            const Image found = render(scene, by(engine, samples)).image;
            REQUIRE(found.standard_error.size() == size * size);
            int within = 0;
            for (std::size_t p = 0; p < found.standard_error.size(); ++p) {
                const double sigma = std::hypot(found.standard_error[p], truth.standard_error[p]);
                const double off = std::abs(luminance_at(found, p) - luminance_at(truth, p));
                if (off <= 1.96 * sigma + 1e-6) ++within;
            }
            const double share = within / (1.0 * size * size);
            CAPTURE(split, samples, engine == Engine::rays);
            CHECK(share >= 0.90);
            CHECK(share <= 0.99);
        }
    }
}

TEST_CASE("tiles get samples in proportion to their deviation, and none for nothing", "[error]") {
    // Four tiles; one sample has the variances 0, 1, 4 and 16, and each pixel has had 100.
    const Tiles tiles{64, 16};
    std::vector<double> variances;
    for (int i = 0; i < 64 * 16; ++i) {
        variances.push_back(std::array{0.0, 1.0, 4.0, 16.0}[static_cast<std::size_t>(i % 64 / 16)] /
                            100);
    }
    const std::vector<int> done(4, 100);
    const auto rest = [&](double error, ErrorMetric metric) {
        return unfinished(tiles, variances, 1, done, error, metric);
    };
    // Deviations 0.573 (a quarter of the root mean square), 1, 2 and 4, 7.573 in all: n = s * 7.573
    // / (4 * error^2), so that 100 samples are enough for them at these errors.
    const double root = std::sqrt(7.573 / 400);
    using Numbers = std::vector<int>;
    CHECK(rest(1.01 * root * std::sqrt(4.0), ErrorMetric::rms) == Numbers{});
    CHECK(rest(0.99 * root * std::sqrt(4.0), ErrorMetric::rms) == Numbers{3});
    CHECK(rest(0.99 * root * std::sqrt(2.0), ErrorMetric::rms) == Numbers{2, 3});
    CHECK(rest(0.99 * root, ErrorMetric::rms) == Numbers{1, 2, 3});
    CHECK(rest(0.99 * root * std::sqrt(0.573), ErrorMetric::rms) == Numbers{0, 1, 2, 3});
    CHECK(rest(0.41, ErrorMetric::largest) == Numbers{});
    CHECK(rest(0.21, ErrorMetric::largest) == Numbers{3});
    CHECK(rest(0.09, ErrorMetric::largest) == Numbers{1, 2, 3});
    CHECK(relative_error(variances, 2, ErrorMetric::rms) == Approx(std::sqrt(21.0 / 400) / 2));
    CHECK(relative_error(variances, 2, ErrorMetric::largest) == Approx(0.2));
}

TEST_CASE("a picture made to an error has it, whichever pixels it took", "[error]") {
    const Scene scene = lit_brilliant(glass(2.4));
    const auto metric = GENERATE(ErrorMetric::rms, ErrorMetric::largest);
    RenderOptions options = by(Engine::rays, 0);
    options.metric = metric;
    options.error = metric == ErrorMetric::rms ? 0.08 : 0.3;
    const Rendering found = render(scene, options);
    CHECK(found.report.error <= options.error);
    options.threads = 2;
    CHECK(render(scene, options).image.rgb == found.image.rgb);

    const Image truth = truth_of(scene);
    double squares = 0, sum = 0, largest = 0;
    for (std::size_t p = 0; p < size * size; ++p) {
        const double off = luminance_at(found.image, p) - luminance_at(truth, p);
        squares += off * off;
        largest = std::max(largest, std::abs(off));
        sum += luminance_at(truth, p);
    }
    const double mean = sum / (size * size), rms = std::sqrt(squares / (size * size));
    if (metric == ErrorMetric::rms) {
        CHECK(rms / mean < 1.15 * 0.08);
        CHECK(rms / mean > 0.04);
    } else {
        // The largest of 1600 deviates is nearly four standard errors.
        CHECK(largest / mean < 4.5 * 0.3);
    }
}

TEST_CASE("a pixel's variance is the mean of those around it, at the picture's edges of fewer",
          "[error]") {
    constexpr int width = 7, height = 4;
    Film film(width, height, 0, false);
    const auto own = [](int x, int y) { return 1 + 0.3 * x * x + std::cos(3.0 * x + 5.0 * y); };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            REQUIRE(film.add(x, y, {1, 1, 1}));
            film.end_pass(x, y, own(x, y));
        }
    }
    const std::vector<double> found = film.variances();
    REQUIRE(found.size() == width * height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double sum = 0, count = 0;
            for (int v = y - 2; v <= y + 2; ++v) {
                for (int u = x - 2; u <= x + 2; ++u) {
                    if (u < 0 || v < 0 || u >= width || v >= height) continue;
                    sum += own(u, v);
                    ++count;
                }
            }
            CAPTURE(x, y);
            CHECK(found[static_cast<std::size_t>(y * width + x)] == Approx(sum / count));
        }
    }
}
