// Pixels whose beams are followed together, against each by itself.
#include <catch2/catch.hpp>
#include <cmath>

#include "beams/block.hpp"
#include "math/random.hpp"
#include "render/pixel_worker.hpp"
#include "support/compare_engines.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

constexpr int size = 16;

/// Luminances of a picture that goes in blocks of so many pixels a side.
std::vector<double> luminances(const Scene& scene, int side, int samples, std::uint64_t seed = 1) {
    const PreparedScene prepared(scene, needs_of(scene, false, Engine::beams), size, size, 0);
    Film film(size, size, 0, false);
    PixelWorker worker(prepared, film);
    PixelWorker::Account account;
    for (int y = 0; y < size; y += side) {
        for (int x = 0; x < size; x += side) {
            worker.add(film, {x, y, x + side, y + side}, seed, 0, samples, true, account);
        }
    }
    REQUIRE(worker.bad() == 0);
    std::vector<double> out;
    for (std::size_t i = 0; i < film.sums().size(); i += 3) {
        const auto& s = film.sums();
        out.push_back(xyz_from_rgb({s[i], s[i + 1], s[i + 2]})[1] / samples);
    }
    return out;
}

/// The root of the mean square difference over the mean.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double square = 0, mean = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        square += (a[i] - b[i]) * (a[i] - b[i]) / double(a.size());
        mean += b[i] / double(a.size());
    }
    return std::sqrt(square) / mean;
}

/// A part of the brilliant, 16 pixels wide, near enough that a pixel is small beside a facet.
Scene close_up(const Crystal& crystal, bool parallel) {
    Scene scene = lit(picture_scene(crystal, slope(normalised({1, 2, 4}))));
    scene.camera = towards_origin(0.15);
    scene.camera.location = {0.4, 0.3, 6};
    if (parallel) scene.camera.kind = Camera::Kind::orthographic;
    return scene;
}

Crystal coloured(Crystal crystal) {
    crystal.absorption = {Spectrum(0.9)};
    if (crystal.birefringent()) crystal.absorption.push_back(Spectrum(0.2));
    return crystal;
}

}  // namespace

TEST_CASE("what of a polygon lies in each pixel of a block sums to the polygon", "[beams][block]") {
    const Block block{4, 3};
    PixelCutter cutter;
    icespar::Random random(5);
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(i);
        Polygon polygon;
        const int corners = 3 + static_cast<int>(4 * random.uniform());
        const double turn = random.uniform();
        const double reach = (i % 3 == 0 ? 0.6 : 1.2) * std::pow(10, -4 * random.uniform());
        for (int c = 0; c < corners; ++c) {
            const double angle = 2 * std::numbers::pi * (c + turn) / corners;
            polygon.push_back({reach * std::cos(angle), reach * std::sin(angle)});
        }
        const Extent whole = extent(polygon);
        for (Point2& p : polygon) p = p - whole.centroid;
        // Some have a corner or an edge on a line between pixels.
        const double x = 0.6 * (2 * random.uniform() - 1), y = 0.1 * (2 * random.uniform() - 1);
        const Point2 centre = i % 3 == 0 ? Point2{0, 0.5} - polygon[0] : Point2{x, y};
        double area = 0;
        Point2 moment;
        cutter.cut(block, polygon, centre, whole.area,
                   [&](std::size_t pixel, PolygonView part, double own, const Point2& at) {
                       area += own;
                       moment = moment + own * at;
                       const double left = double(pixel % 4) - 2, top = 1.5 - double(pixel / 4);
                       for (const Point2& p : part) {
                           const Point2 there = p + at + centre;
                           CHECK(there.x >= left - 1e-8);
                           CHECK(there.x <= left + 1 + 1e-8);
                           CHECK(there.y <= top + 1e-8);
                           CHECK(there.y >= top - 1 - 1e-8);
                       }
                   });
        CHECK_THAT(area / whole.area, WithinAbs(1, 1e-12));
        CHECK_THAT(std::hypot(moment.x, moment.y) / (whole.area * reach), WithinAbs(0, 1e-12));
    }
}

TEST_CASE("a polygon that fills its block gives each pixel a square about its middle",
          "[beams][block]") {
    const Block block{4, 3};
    const Polygon polygon{{-2, -1.5}, {2, -1.5}, {2, 1.5}, {-2, 1.5}};
    std::vector<Point2> middles;
    PixelCutter().cut(
        block, polygon, {}, extent(polygon).area,
        [&](std::size_t pixel, PolygonView part, double area, const Point2& at) {
            CHECK(pixel == middles.size());
            const Extent own = extent(part);
            CHECK_THAT(area, WithinAbs(own.area, 1e-15));
            CHECK_THAT(own.area, WithinAbs(1, 1e-15));
            CHECK_THAT(std::hypot(own.centroid.x, own.centroid.y), WithinAbs(0, 1e-15));
            for (const Point2& p : part) {
                CHECK_THAT(std::max(std::abs(p.x), std::abs(p.y)), WithinAbs(0.5, 1e-15));
            }
            middles.push_back(at);
        });
    REQUIRE(middles.size() == 12);
    for (std::size_t i = 0; i < middles.size(); ++i) {
        CHECK_THAT(middles[i].x, WithinAbs(double(i % 4) - 1.5, 1e-15));
        CHECK_THAT(middles[i].y, WithinAbs(1 - double(i / 4), 1e-15));
    }
}

TEST_CASE("pixels followed together see what each sees by itself", "[beams][block]") {
    const bool parallel = GENERATE(false, true);
    const int kind = GENERATE(range(0, 6));
    const Vec3 axis = normalised({2, 1, 1});
    const Crystal crystal = kind == 0   ? glass(1.945)
                            : kind == 1 ? zircon(axis)
                            : kind == 2 ? calcite(axis)
                            : kind == 3 ? Crystal{{IndexFunction::cauchy(2.3784, 0.0134)}, axis}
                            : kind == 4 ? coloured(glass(1.76))
                                        : coloured(zircon(axis));
    CAPTURE(parallel, kind);
    const Scene scene = close_up(crystal, parallel);
    // The pictures of other seeds tell what chance does to either.
    const int samples = kind == 3 ? 512 : 2048;
    const auto alone = luminances(scene, 1, samples), together = luminances(scene, 4, samples);
    const double chance = std::hypot(difference(luminances(scene, 1, samples, 2), alone),
                                     difference(luminances(scene, 4, samples, 2), together)) /
                          std::sqrt(2);
    // Directions are linear over a block: exact in a parallel view.
    const double bend = parallel ? 1e-4 : 1e-3;
    CHECK(difference(together, alone) < 2 * chance + bend);
}

TEST_CASE("pixels followed together err no more than chance makes them, by few samples too",
          "[beams][block]") {
    const int kind = GENERATE(0, 1, 2);
    const Crystal crystal = kind == 0   ? glass(1.945)
                            : kind == 1 ? quartz(normalised({2, 1, 1}))
                                        : coloured(glass(1.76));
    CAPTURE(kind);
    const Scene scene = close_up(crystal, false);
    const auto truth = luminances(scene, 1, 8192);
    constexpr int samples = 16, runs = 64;
    std::vector<double> mean(truth.size());
    double noise = 0;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        const auto found = luminances(scene, 4, samples, 100 + seed);
        noise += std::pow(difference(found, truth), 2) / runs;
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += found[i] / runs;
    }
    CAPTURE(noise);
    CHECK(difference(mean, truth) < (0.25 + 1.2 / std::sqrt(runs)) * std::sqrt(noise));
}

TEST_CASE("in a furnace each of the pixels followed together sees all the light",
          "[beams][block]") {
    const bool split = GENERATE(false, true);
    Scene scene = close_up(split ? zircon(normalised({2, 1, 1})) : glass(1.945), false);
    scene.environment = furnace();
    for (const double v : luminances(scene, 4, 1 << 14)) CHECK_THAT(v, WithinAbs(1, 5e-3));
}
