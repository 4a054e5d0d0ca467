// Facet planes from a faceting diagram.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/error.hpp"
#include "stone/cut.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

Vec3 normal_of(double angle, double index, double gear = 96, double offset = 0) {
    return cut_plane(angle, 1, index, gear, offset, false, "").normal;
}

}  // namespace

TEST_CASE("the table faces up, the girdle sideways, the pavilion down", "[cut]") {
    CHECK(normal_of(0, 96) == Vec3{0, 0, 1});
    CHECK(normal_of(90, 96) == Vec3{0, 1, 0});
    CHECK(normal_of(-90, 96) == Vec3{0, 1, 0});
    CHECK(normal_of(-45, 96).z < 0);
    CHECK(cut_plane(45, 1, 0, 96, 0, true, "").normal.z < 0);
}

TEST_CASE("indices run from y towards x", "[cut]") {
    CHECK(normal_of(90, 24) == Vec3{1, 0, 0});
    CHECK(normal_of(90, 48) == Vec3{0, -1, 0});
    CHECK(normal_of(90, 72) == Vec3{-1, 0, 0});
    const Vec3 n = normal_of(30, 16);  // azimuth 60 degrees
    CHECK_THAT(n.x, WithinAbs(std::sqrt(3.0) / 4, 1e-16));
    CHECK_THAT(n.y, WithinAbs(0.25, 1e-16));
    CHECK_THAT(n.z, WithinAbs(std::sqrt(3.0) / 2, 2e-16));
}

TEST_CASE("a negative gear turns the other way, and an offset moves index 0", "[cut]") {
    CHECK(normal_of(90, 24, -96) == Vec3{-1, 0, 0});
    CHECK(normal_of(90, 48, 96, 48) == Vec3{0, 1, 0});
    CHECK(normal_of(90, -96, -96, 48) == normal_of(90, 96, -96, 48));
    CHECK(normal_of(90, 5, 96, 96) == normal_of(90, 5));
    CHECK(normal_of(40, 101) == normal_of(40, 5));
}

TEST_CASE("facets that mirror one another do so to the last bit", "[cut]") {
    for (int index = 0; index < 48; ++index) {
        const Vec3 right = normal_of(41.3, index), left = normal_of(41.3, 96 - index);
        CHECK(right == Vec3{-left.x, left.y, left.z});
        const Vec3 across = normal_of(41.3, index + 48);
        CHECK(across == Vec3{-right.x, -right.y, right.z});
    }
}

TEST_CASE("a culet is a table at a negative distance", "[cut]") {
    const FacetPlane culet = cut_plane(0, -0.6, 96, 96, 0, false, "CU");
    CHECK(culet.normal == Vec3{0, 0, -1});
    CHECK(culet.distance == 0.6);
    CHECK(culet.name == "CU");
    CHECK(cut_plane(0, 0.6, 96, 96, 0, true, "").normal == Vec3{0, 0, -1});
    // Elsewhere the sign is meant: the facet passes beyond the centre.
    CHECK(cut_plane(45, -0.1, 96, 96, 0, false, "").distance == -0.1);
}

TEST_CASE("a cut that cannot be made says why", "[cut][error]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(cut_plane(91, 1, 0, 96, 0, false, "P1"), Contains("'P1'") && Contains("90"));
    CHECK_THROWS_WITH(cut_plane(40, 1, 0, 0, 0, false, "P1"), Contains("gear"));
    CHECK_THROWS_WITH(cut_plane(nan, 1, 0, 96, 0, false, ""), Contains("not finite"));
    CHECK_THROWS_WITH(cut_plane(40, nan, 0, 96, 0, false, ""), Contains("not finite"));
    CHECK_THROWS_WITH(cut_plane(40, 1, 1.7e308, 96, -1.7e308, false, ""), Contains("not finite"));
    CHECK_THROWS_AS(cut_plane(40, 1, 0, nan, 0, false, ""), Error);
}
