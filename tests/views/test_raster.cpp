// Exact coverage of pixels by polygons.
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"
#include "views/raster.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr int width = 9, height = 7;

double covered(const Raster& r, int x, int y) { return r.pixel(x, y)[0]; }

/// The part of a pixel that lies in a convex polygon, by cutting it.
double part_of(Polygon polygon, int x, int y) {
    Polygon rest;
    for (const Affine& side : {Affine{-1.0 * x, 1, 0}, Affine{x + 1.0, -1, 0},
                               Affine{-1.0 * y, 0, 1}, Affine{y + 1.0, 0, -1}}) {
        clip(polygon, side, rest);
        polygon.swap(rest);
    }
    return std::abs(extent(polygon).area);
}

}  // namespace

TEST_CASE("a pixel counts by the part of it that a polygon covers", "[views][raster]") {
    icespar::testing::Random random(7);
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
        // Large and small ones, beside the picture too, and with edges along pixels' borders.
        const double size = i % 2 == 0 ? 12 : 1.5;
        const Point2 middle{14 * random.uniform() - 3, 12 * random.uniform() - 3};
        Polygon polygon;
        for (int corner = 0; corner < 3; ++corner) {
            Point2 p =
                middle + Point2{size * (random.uniform() - 0.5), size * (random.uniform() - 0.5)};
            if (i % 5 == 0) p.x = std::round(p.x);
            if (i % 7 == 0) p.y = std::round(p.y);
            polygon.push_back(p);
        }
        Raster raster(width, height, 2);
        const double values[] = {1, -2};
        raster.add(polygon, values);
        raster.finish();
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                worst = std::max(worst, std::abs(covered(raster, x, y) - part_of(polygon, x, y)));
                worst =
                    std::max(worst, std::abs(raster.pixel(x, y)[1] + 2 * raster.pixel(x, y)[0]));
            }
        }
    }
    CHECK(worst < 1e-12);
}

TEST_CASE("polygons that fill the picture cover every pixel once", "[views][raster]") {
    icespar::testing::Random random(9);
    std::vector<Polygon> pieces{
        {{-1, -1}, {width + 1, -1}, {width + 1, height + 1}, {-1, height + 1}}};
    for (int i = 0; i < 12; ++i) {
        const double angle = 6.3 * random.uniform();
        Affine line{0, std::cos(angle), std::sin(angle)};
        line.value = -line({width * random.uniform(), height * random.uniform()});
        std::vector<Polygon> next;
        for (const Polygon& p : pieces) {
            for (const double side : {1.0, -1.0}) {
                Polygon part;
                clip(p, {side * line.value, side * line.dx, side * line.dy}, part);
                if (part.size() > 2) next.push_back(std::move(part));
            }
        }
        pieces = std::move(next);
    }
    Raster raster(width, height, 1);
    const double one[] = {1};
    for (const Polygon& p : pieces) raster.add(p, one);
    raster.finish();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) CHECK(std::abs(covered(raster, x, y) - 1) < 1e-12);
    }
}

TEST_CASE("a factor that varies linearly is taken at each pixel's middle", "[views][raster]") {
    const Polygon polygon{{0.5, 0.3}, {8.2, 1.1}, {6.4, 6.6}, {2.3, 5.2}};
    const Affine factor{2, 0.3, -0.2};
    Raster raster(width, height, 1), other(width, height, 1);
    const double values[] = {3};
    other.add(polygon, values, factor);
    raster.add(other);
    raster.add({polygon.begin(), 3}, values);
    raster.finish();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double shaded = part_of(polygon, x, y) * factor({x + 0.5, y + 0.5});
            const double plain = part_of({polygon.begin(), polygon.begin() + 3}, x, y);
            CHECK(std::abs(covered(raster, x, y) - 3 * (shaded + plain)) < 1e-12);
        }
    }
}
