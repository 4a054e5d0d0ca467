// Which of a pigment's colours lies where: cells and lines, below zero, in walls, moved and turned.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/surface.hpp"

using namespace icespar;

namespace {

bool shows(const Pigment& pigment, double x, double y, double z, const Vec3& normal = {0, 1, 0}) {
    return mix_at(pigment, {x, y, z}, normal).colour[0] == 0;
}

}  // namespace

TEST_CASE("a checker's cells alternate, through zero and below", "[surface][pattern]") {
    Pigment p;
    p.kind = Pigment::Kind::checker;
    CHECK(shows(p, 0.5, 0, 0.5));
    CHECK_FALSE(shows(p, 1.5, 0, 0.5));
    CHECK_FALSE(shows(p, -0.5, 0, 0.5));
    CHECK(shows(p, -0.5, 0, -0.5));
    CHECK_FALSE(shows(p, -1.5, 0, -0.5));
    CHECK_FALSE(shows(p, 0.5, 1.5, 0.5));
    CHECK_FALSE(shows(p, -1.5, 1.5, 0.5));
    CHECK(shows(p, -2.5, 1.5, -0.5) == shows(p, -0.5, 1.5, -2.5));
    for (int x = -3; x < 3; ++x) {
        for (int z = -3; z < 3; ++z) {
            CHECK(shows(p, x + 0.3, 0.2, z + 0.8) == ((x + z) % 2 == 0));
        }
    }
}

TEST_CASE("a wall that lies in the face of cells shows one row of them, not noise",
          "[surface][pattern]") {
    Pigment p;
    p.kind = Pigment::Kind::checker;
    for (const double wall : {0.0, 3.0, -2.0}) {
        for (const double rounding : {-1e-15, 0.0, 1e-15}) {
            CHECK(shows(p, 0.5, wall + rounding, 0.5) == shows(p, 0.5, wall + 0.5, 0.5));
            CHECK(shows(p, wall + rounding, 0.5, 0.5, {1, 0, 0}) == shows(p, wall + 0.5, 0.5, 0.5));
            CHECK(shows(p, 0.5, 0.5, wall + rounding, {0, 0, 1}) == shows(p, 0.5, 0.5, wall + 0.5));
        }
    }
}

TEST_CASE("a grid's lines run along the integer planes, half their width to either side",
          "[surface][pattern]") {
    Pigment p;
    p.kind = Pigment::Kind::grid;
    p.line_width = 0.1;
    for (const double line : {0.0, 1.0, -3.0}) {
        CHECK(shows(p, line + 0.049, 0, 0.5));
        CHECK(shows(p, line - 0.049, 0, 0.5));
        CHECK_FALSE(shows(p, line + 0.051, 0, 0.5));
        CHECK_FALSE(shows(p, line - 0.051, 0, 0.5));
        CHECK(shows(p, 0.5, 0, line + 0.049));
        CHECK_FALSE(shows(p, 0.5, 0, line + 0.051));
    }
    // The floor y = 0 lies in a line's plane itself and yet is not all line; a wall shows heights.
    CHECK_FALSE(shows(p, 0.5, 0, 0.5));
    CHECK(shows(p, 0, 0.02, 0.5, {1, 0, 0}));
    CHECK_FALSE(shows(p, 0, 0.2, 0.5, {1, 0, 0}));
    CHECK(shows(p, 0.5, 1.96, 0, {0, 0, -1}));
    // On a slanted face all three families are drawn.
    const Vec3 slant = normalised(Vec3{1, 1, 1});
    CHECK(shows(p, 0.5, 0.0, 0.4, slant));
    CHECK(shows(p, 0.0, 0.5, 0.4, slant));
    CHECK_FALSE(shows(p, 0.5, 0.4, 0.4, slant));
}

TEST_CASE("patterns are moved, turned and stretched with their pigment", "[surface][pattern]") {
    Pigment p;
    p.kind = Pigment::Kind::checker;
    p.to_pattern =
        Transform::scaling({0.25, 0.25, 0.25}).then(Transform::translation({0.5, 0, 0})).inverse();
    // Cells of a quarter, one of them from 0.5 to 0.75.
    CHECK(shows(p, 0.6, 0, 0.1));
    CHECK_FALSE(shows(p, 0.8, 0, 0.1));
    CHECK_FALSE(shows(p, 0.6, 0, 0.3));
    CHECK_FALSE(shows(p, 0.4, 0, 0.1));
    CHECK(shows(p, 0.4, 0, -0.1));

    // Turned by 45 degrees about y: lines run along x = z and x = -z.
    Pigment grid;
    grid.kind = Pigment::Kind::grid;
    grid.line_width = 0.1;
    const double h = std::sqrt(0.5);
    grid.to_pattern = Transform({Vec3{h, 0, h}, {0, 1, 0}, {-h, 0, h}}, {}).inverse();
    CHECK(shows(grid, 3.3, 0, 3.3));
    CHECK(shows(grid, -0.7, 0, 0.7));
    CHECK_FALSE(shows(grid, 0.5 * h * 2, 0, 0));
    CHECK_FALSE(shows(grid, 0, 0, 0.5 / h));

    // Stretched along x alone, a slanted wall keeps its normal by the inverse transpose: a wall of
    // the pattern's x = 0 draws heights and z, but is not all line.
    Pigment wide = grid;
    wide.to_pattern = Transform::scaling({4, 1, 1}).inverse();
    CHECK_FALSE(shows(wide, 0, 0.5, 0.5, {1, 0, 0}));
    CHECK(shows(wide, 0.15, 0.5, 0.5, {0, 0, 1}));
    CHECK_FALSE(shows(wide, 0.25, 0.5, 0.5, {0, 0, 1}));
}
