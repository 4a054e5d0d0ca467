// Convex polygons: what is cut apart sums to the whole.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "beams/polygon.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

Polygon regular(int corners) {
    Polygon out;
    for (int i = 0; i < corners; ++i) {
        const double a = 2 * std::numbers::pi * i / corners;
        out.push_back({std::cos(a), std::sin(a)});
    }
    return out;
}

Affine line(Random& random) {
    const double a = random.uniform(0, 2 * std::numbers::pi);
    return {random.uniform(-1, 1), std::cos(a), std::sin(a)};
}

}  // namespace

TEST_CASE("a regular polygon has its known area, and its centroid in the middle", "[polygon]") {
    for (int n = 3; n < 20; ++n) {
        const Extent e = extent(regular(n));
        CHECK_THAT(e.area, WithinAbs(0.5 * n * std::sin(2 * std::numbers::pi / n), 1e-14));
        CHECK_THAT(e.centroid.x, WithinAbs(0, 1e-15));
        CHECK_THAT(e.centroid.y, WithinAbs(0, 1e-15));
    }
}

TEST_CASE("the parts on both sides of any line sum to the polygon, in area and in moment",
          "[polygon]") {
    Random random(3);
    Polygon whole, left, right, above, below;
    for (int i = 0; i < 20000; ++i) {
        whole = regular(3 + random.below(9));
        for (int cuts = 0; cuts < 4; ++cuts) {
            const Affine f = line(random);
            clip(whole, f, left);
            clip(whole, {-f.value, -f.dx, -f.dy}, right);
            split(whole, f, above, below);
            REQUIRE(above == left);
            REQUIRE(below == right);
            const Extent w = extent(whole), l = extent(left), r = extent(right);
            REQUIRE(std::abs(l.area + r.area - w.area) < 1e-14);
            REQUIRE(std::abs(l.area * l.centroid.x + r.area * r.centroid.x -
                             w.area * w.centroid.x) < 1e-14);
            for (const Point2& p : left) REQUIRE(f(p) > -1e-14);
            (l.area > r.area ? left : right).swap(whole);
        }
    }
}

TEST_CASE("a line through corners or along an edge loses nothing", "[polygon]") {
    const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    Polygon out;
    clip(square, {0, 1, -1}, out);
    CHECK(extent(out).area == 2);
    clip(square, {1, 1, 0}, out);
    CHECK(extent(out).area == 4);
    clip(square, {-1, 1, 0}, out);
    CHECK(extent(out).area == 0);
    clip(square, {-2, 1, 0}, out);
    CHECK(out.empty());
    Polygon rest;
    split(square, {0, 1, -1}, out, rest);
    CHECK(extent(out).area + extent(rest).area == 4);
}

TEST_CASE("uniform numbers give points spread evenly over a polygon", "[polygon]") {
    const Polygon p{{0, 0}, {3, 0}, {3, 1}, {0, 2}};
    Random random(5);
    constexpr int count = 100000;
    Point2 mean;
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform();
        const Point2 q = point_in(p, u, random.uniform());
        REQUIRE((q.x >= 0 && q.x <= 3 && q.y >= 0 && q.y <= 2 - q.x / 3 + 1e-12));
        mean = mean + (1.0 / count) * q;
    }
    // The standard error of either mean is below 0.003.
    const Extent e = extent(p);
    CHECK_THAT(mean.x, WithinAbs(e.centroid.x, 0.015));
    CHECK_THAT(mean.y, WithinAbs(e.centroid.y, 0.01));
}
