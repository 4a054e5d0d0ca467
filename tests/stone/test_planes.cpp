// Stones from facet planes: what is closed, what is reached, and what is said when there is no
// stone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/error.hpp"
#include "stone/cut.hpp"
#include "support/solids.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

std::string message_of(const std::vector<FacetPlane>& planes) {
    try {
        (void)Stone::from_planes(planes);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// A prism of n sides around z with the given apothem, open at both ends.
std::vector<FacetPlane> prism(int sides, double apothem) {
    std::vector<FacetPlane> planes;
    for (int i = 0; i < sides; ++i) {
        planes.push_back(cut_plane(90, apothem, i, sides, 0, false, "G" + std::to_string(i)));
    }
    return planes;
}

}  // namespace

TEST_CASE("a box has six facets in the order of its planes, and its volume", "[stone]") {
    const Stone stone = Stone::from_planes(box_planes({-1, -2, -3}, {2, 3, 4}));
    CHECK(fault_of(stone) == "");
    REQUIRE(stone.facets.size() == 6);
    CHECK(stone.vertices.size() == 8);
    CHECK(stone.volume == 3.0 * 5 * 7);
    const auto planes = box_planes({-1, -2, -3}, {2, 3, 4});
    const std::vector<double> areas{35, 35, 21, 21, 15, 15};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(stone.facets[i].name == planes[i].name);
        CHECK(stone.facets[i].normal == planes[i].normal);
        CHECK(stone.facets[i].distance == planes[i].distance);
        CHECK(stone.facets[i].area == areas[i]);
        CHECK(stone.facets[i].corners.size() == 4);
    }
    CHECK(stone.unreached.empty());
}

TEST_CASE("normals need not be unit vectors", "[stone]") {
    auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
    double factor = 1e-150;
    for (FacetPlane& plane : planes) {
        plane.normal = plane.normal * factor;
        plane.distance *= factor;
        factor *= 1e50;
    }
    const Stone stone = Stone::from_planes(planes);
    CHECK(fault_of(stone) == "");
    CHECK_THAT(stone.volume, WithinRel(8.0, 1e-14));
}

TEST_CASE("random planes close to polyhedra that obey Euler and Gauss", "[stone][property]") {
    const int seed = GENERATE(range(0, 60));
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    auto planes = random_planes(random, 12 + random.below(60), seed % 2 ? 0.3 : 0.0);
    for (const FacetPlane& plane : box_planes({-2, -2, -2}, {2, 2, 2})) planes.push_back(plane);
    const Stone stone = Stone::from_planes(planes);
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() + stone.unreached.size() == planes.size());

    // Facets keep the order of the planes.
    auto plane = planes.begin();
    for (const Facet& facet : stone.facets) {
        plane = std::find_if(plane, planes.end(),
                             [&](const FacetPlane& p) { return p.name == facet.name; });
        REQUIRE(plane != planes.end());
    }
}

TEST_CASE("building a stone twice gives the same bits", "[stone]") {
    Random random(5);
    const auto planes = random_planes(random, 60, 0.1);
    const Stone a = Stone::from_planes(planes), b = Stone::from_planes(planes);
    CHECK(a.vertices == b.vertices);
    CHECK(a.volume == b.volume);
    REQUIRE(a.facets.size() == b.facets.size());
    for (std::size_t i = 0; i < a.facets.size(); ++i) {
        CHECK(a.facets[i].corners == b.facets[i].corners);
        CHECK(a.facets[i].area == b.facets[i].area);
        CHECK(a.facets[i].distance == b.facets[i].distance);
    }
}

TEST_CASE("a stone far from the origin, or tiny, is as exact as its numbers", "[stone]") {
    const double scale = GENERATE(1e-3, 1.0, 1e3);
    const double away = GENERATE(0.0, 1e3, 1e6);
    CAPTURE(scale, away);
    const Vec3 centre{away, -0.7 * away, 0.4 * away};
    Random random(9);
    auto planes = random_planes(random, 40, 0.05);
    const Stone near_by = Stone::from_planes(planes);
    for (FacetPlane& plane : planes) {
        plane.distance = plane.distance * scale + dot(plane.normal, centre);
    }
    const Stone stone = Stone::from_planes(planes);
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() == near_by.facets.size());
    CHECK_THAT(stone.volume / (scale * scale * scale),
               WithinRel(near_by.volume, 1e-14 + 1e-15 * away / scale));
}

TEST_CASE("planes that coincide are one facet with the first one's name", "[stone]") {
    auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
    planes.push_back({{0, 0, 2}, 2, "again"});
    planes.push_back({{3e-10, 0, 1}, 1 - 4e-10, "nearly"});
    const Stone stone = Stone::from_planes(planes);
    CHECK(stone.facets.size() == 6);
    CHECK(stone.facets[5].name == "+z");
    CHECK(stone.unreached.empty());
    CHECK(stone.volume == 8);
}

TEST_CASE("nearly parallel planes that differ by more than rounding are facets of their own",
          "[stone]") {
    // The tilted top meets the flat one in the line x = 0.
    const double slope = GENERATE(1e-6, 1e-5, 1e-3);
    CAPTURE(slope);
    auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
    planes.push_back({{slope, 0, 1}, 1, "tilted"});
    const Stone stone = Stone::from_planes(planes);
    CHECK(fault_of(stone) == "");
    REQUIRE(stone.facets.size() == 7);
    CHECK_THAT(stone.volume, WithinRel(8 - slope, 1e-15));
}

TEST_CASE("planes that miss the stone, touch it, or graze it by rounding are unreached",
          "[stone]") {
    auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
    planes.push_back({{1, 1, 0}, 3, "misses"});
    planes.push_back({{1, 0, 1}, 2, "touches an edge"});
    planes.push_back({{-1, -1, -1}, 3, ""});  // touches a corner
    planes.push_back({{0, 1, 1}, 2 - 1e-8, "grazes an edge"});
    const Stone stone = Stone::from_planes(planes);
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() == 6);
    CHECK(stone.unreached ==
          std::vector<std::string>{"misses", "touches an edge", "facet 9", "grazes an edge"});
    CHECK(stone.volume == 8);
}

TEST_CASE("the blunt end of a needle stays, however small", "[stone]") {
    // Four sides that would meet 1e4 above the base, cut at a width of 2e-4.
    std::vector<FacetPlane> planes{{{0, 0, -1}, 0, "base"}, {{0, 0, 1}, 5000, "tip"}};
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        planes.push_back({{x * 1e4, y * 1e4, 1}, 1e4, "side"});
    }
    const Stone whole = Stone::from_planes(planes);
    CHECK(whole.facets.size() == 6);
    CHECK(fault_of(whole) == "");
}

TEST_CASE("an open stone names the directions in which it is open", "[stone][error]") {
    auto both_ends = prism(16, 1);
    CHECK_THAT(message_of(both_ends),
               Contains("not closed") && Contains("<0, 0, 1>") && Contains("<0, 0, -1>"));
    auto up = both_ends;
    up.push_back({{0, 0, -1}, 1, "bottom"});
    CHECK_THAT(message_of(up), Contains("towards <0, 0, 1>;"));
    auto sideways = box_planes({-1, -1, -1}, {1, 1, 1});
    sideways.erase(sideways.begin());
    CHECK_THAT(message_of(sideways), Contains("towards <-1, 0, 0>;"));

    CHECK_THAT(message_of({{{0, 0, 1}, 1}}), Contains("not closed"));
    CHECK_THAT(message_of({{{0, 0, 1}, 1}, {{0, 0, -1}, 1}}), Contains("not closed"));
    CHECK_THAT(message_of({{{0, 0, 1}, 1}, {{0, 1, -1}, 1}, {{1, 0, -1}, 1}}),
               Contains("not closed"));
    CHECK_THAT(message_of({}), Contains("at least four planes"));

    // Sides that lean together by an ulp do close, a quadrillion away: that is open to a cutter.
    auto almost = up;
    for (FacetPlane& plane : almost) plane.normal.z += plane.normal.z == 0 ? 1e-16 : 0;
    CHECK_THAT(message_of(almost), Contains("not closed"));
}

TEST_CASE("facets that leave no room between them are named", "[stone][error]") {
    auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
    planes.push_back({{0, 0, 1}, -1.5, "T"});
    CHECK_THAT(message_of(planes), Contains("nothing is left of the stone") &&
                                       Contains("facet 5 ('-z') and facet 7 ('T')"));
    planes.back().distance = -1;  // flat: no volume
    CHECK_THAT(message_of(planes), Contains("nothing is left") && Contains("'T'"));
    planes.back().distance = std::nextafter(-1, 0);
    CHECK_THAT(message_of(planes), Contains("thinner than numbers can tell"));
    planes.back().distance = -1 + 1e-9;  // a plate, however thin, is a stone
    CHECK(Stone::from_planes(planes).facets.size() == 6);
}

TEST_CASE("numbers that are not finite, and normals of length 0, are refused", "[stone][error]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const FacetPlane& bad :
         {FacetPlane{{nan, 0, 1}, 1, "P"}, FacetPlane{{0, infinity, 1}, 1, "P"},
          FacetPlane{{0, 0, 1}, nan, "P"}, FacetPlane{{0, 0, 1}, -infinity, "P"},
          FacetPlane{{1e308, 1.7e308, 1.7e308}, 1, "P"}}) {
        auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
        planes.push_back(bad);
        CHECK_THAT(message_of(planes), Contains("facet 7 ('P')") && Contains("not finite"));
    }
    auto planes = box_planes({-1, -1, -1}, {1, 1, 1});
    planes[2].normal = {};
    CHECK_THAT(message_of(planes), Contains("facet 3 ('-y')") && Contains("<0, 0, 0>"));
}
