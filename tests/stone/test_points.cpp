// Stones as the convex hull of points.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/error.hpp"
#include "support/solids.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

double total_area(const Stone& stone) {
    double area = 0;
    for (const Facet& facet : stone.facets) area += facet.area;
    return area;
}

std::string message_of(const std::vector<Vec3>& points) {
    try {
        (void)Stone::from_points(points);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// As a file with six decimals has it.
Vec3 six_decimals(const Vec3& p) {
    const auto digits = [](double x) { return std::round(x * 1e6) / 1e6; };
    return {digits(p.x), digits(p.y), digits(p.z)};
}

Transform turned(Random& random) {
    const Vec3 x = random.direction();
    const Vec3 y = random.perpendicular_to(x);
    return {{x, y, cross(x, y)}, {}};
}

}  // namespace

TEST_CASE("the regular solids have the volumes and areas of Euclid", "[stone]") {
    using std::numbers::sqrt3;
    const double sqrt5 = std::sqrt(5.0);
    struct Solid {
        std::vector<Vec3> points;
        std::size_t facets, corners;
        double volume, area;
    };
    const Solid solid = GENERATE_COPY(
        Solid{tetrahedron(), 4, 3, 8.0 / 3, 8 * sqrt3}, Solid{cube(), 6, 4, 8, 24},
        Solid{octahedron(), 8, 3, 4.0 / 3, 4 * sqrt3},
        Solid{dodecahedron(), 12, 5, 2 * (15 + 7 * sqrt5), 12 * std::sqrt(25 + 10 * sqrt5)},
        Solid{icosahedron(), 20, 3, 10.0 / 3 * (3 + sqrt5), 20 * sqrt3});
    CAPTURE(solid.facets);
    const bool as_given = GENERATE(true, false);
    Random random(3);
    const Transform turn = as_given ? Transform() : turned(random);
    std::vector<Vec3> points = solid.points;
    for (Vec3& p : points) p = turn.point(p);
    points.push_back({0.1, 0.2, 0.1});  // inside: of no account
    points.push_back(points.front());   // twice: likewise
    const Stone stone = Stone::from_points(points);
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() == solid.facets);
    CHECK_THAT(stone.volume, WithinRel(solid.volume, 2e-15));
    CHECK_THAT(total_area(stone), WithinRel(solid.area, 2e-15));
    CHECK(stone.vertices.size() == solid.points.size());
    for (const Facet& facet : stone.facets) CHECK(facet.corners.size() == solid.corners);
    CHECK(stone.unreached.empty());
}

TEST_CASE("points with six decimals give the facets that were meant", "[stone]") {
    const int seed = GENERATE(range(0, 20));
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const Transform turn = turned(random);
    std::vector<Vec3> points;
    for (const Vec3& p : dodecahedron()) points.push_back(six_decimals(turn.point(p)));
    const Stone stone = Stone::from_points(points);
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() == 12);
    CHECK_THAT(stone.volume, WithinRel(2 * (15 + 7 * std::sqrt(5.0)), 3e-6));
    for (const Facet& facet : stone.facets) {
        for (const Vec3& p : points) CHECK(dot(facet.normal, p) <= facet.distance + 1e-14);
    }
}

TEST_CASE("the hull of a stone's corners is that stone", "[stone][property]") {
    const int seed = GENERATE(range(0, 30));
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const Stone cut = Stone::from_planes(random_planes(random, 40, 0.1));
    const bool rounded = GENERATE(false, true);
    std::vector<Vec3> points = cut.vertices;
    if (rounded) std::transform(points.begin(), points.end(), points.begin(), six_decimals);
    const Stone stone = Stone::from_points(points);
    CHECK(fault_of(stone) == "");
    CHECK_THAT(stone.volume, WithinRel(cut.volume, rounded ? 1e-5 : 1e-13));
    // Rounding may merge a tiny facet with its neighbour, but makes no new ones.
    CHECK(stone.facets.size() <= cut.facets.size());
    CHECK(stone.facets.size() + 2 >= cut.facets.size());
    if (!rounded) CHECK(stone.facets.size() == cut.facets.size());
}

TEST_CASE("points on a sphere are all corners, and facets are ordered by them", "[stone]") {
    Random random(8);
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) points.push_back(random.direction());
    const Stone stone = Stone::from_points(points);
    CHECK(fault_of(stone) == "");
    CHECK(stone.vertices.size() == 300);
    CHECK(stone.facets.size() == 2 * 300 - 4);
    const auto lowest = [&](const Facet& facet) {
        std::size_t least = points.size();
        for (const std::uint32_t corner : facet.corners) {
            for (std::size_t i = 0; i < least; ++i) {
                if (length(points[i] - stone.vertices[corner]) < 1e-12) least = i;
            }
        }
        return least;
    };
    CHECK(std::is_sorted(stone.facets.begin(), stone.facets.end(),
                         [&](const Facet& a, const Facet& b) { return lowest(a) < lowest(b); }));
    const Stone again = Stone::from_points(points);
    CHECK(again.vertices == stone.vertices);
    CHECK(again.volume == stone.volume);
}

TEST_CASE("a hull far from the origin, or tiny, keeps its facets", "[stone]") {
    const double scale = GENERATE(1e-3, 1.0);
    const double away = GENERATE(0.0, 1e6);
    CAPTURE(scale, away);
    std::vector<Vec3> points;
    for (const Vec3& p : dodecahedron()) points.push_back(scale * p + Vec3{away, away / 3, -away});
    const Stone stone = Stone::from_points(points);
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() == 12);
}

TEST_CASE("points without a volume are refused", "[stone][error]") {
    CHECK_THAT(message_of({}), Contains("lie in one plane"));
    CHECK_THAT(message_of({{1, 2, 3}, {1, 2, 3}}), Contains("lie in one plane"));
    CHECK_THAT(message_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), Contains("one plane"));
    CHECK_THAT(message_of({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}), Contains("one plane"));
    CHECK_THAT(message_of({{0, 0, 1}, {1, 0, 1}, {1, 1, 1 + 1e-9}, {0, 1, 1}}),
               Contains("one plane"));
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(message_of({{0, 0, 0}, {nan, 0, 0}}), Contains("point 2") && Contains("not finite"));
}
