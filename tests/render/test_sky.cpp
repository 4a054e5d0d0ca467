// Surroundings that differ from direction to direction: panoramas, colour maps and functions.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;
using std::numbers::pi;

namespace {

/// Looks from the origin; `d` in the scene's own left-handed coordinates.
Stokes towards(const Scene& scene, const Vec3& d, const Vec3& right) {
    return trace_one(scene, {{}, {d.x, d.y, -d.z}, {right.x, right.y, -right.z}});
}

Vec3 at(double longitude, double latitude) {
    const double a = longitude * degree, b = latitude * degree;
    return {std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a)};
}

}  // namespace

TEST_CASE("a panorama has +z in its middle, +x to the right of it, +y at its top", "[sky]") {
    Scene scene;
    scene.environment.pattern = panorama(8, 4, {0,  1,  2,  3,  4,  5,  6,  7,   //
                                                10, 11, 12, 13, 14, 15, 16, 17,  //
                                                20, 21, 22, 23, 24, 25, 26, 27,  //
                                                30, 31, 32, 33, 34, 35, 36, 37});
    const auto value = [&](double longitude, double latitude) {
        const Vec3 d = at(longitude, latitude);
        return towards(scene, d, normalised(cross(Vec3{0.1, 1, 0.2}, d))).s0;
    };
    // Centres of pixels.
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            CHECK_THAT(value(45 * column - 180 + 22.5, 90 - 45 * row - 22.5),
                       WithinAbs(10 * row + column, 1e-9));
        }
    }
    // Linear between them, round the back too; constant above the topmost centre.
    CHECK_THAT(value(0, 0), WithinAbs(18.5, 1e-9));
    CHECK_THAT(value(9, 22.5), WithinAbs(13.5 + 0.2, 1e-9));
    CHECK_THAT(value(180, 22.5), WithinAbs(13.5, 1e-9));
    CHECK_THAT(value(-22.5, 80), WithinAbs(3, 1e-9));
}

TEST_CASE("a colour map over the sky blends between its stops", "[sky]") {
    Scene scene;
    Pigment p;
    p.kind = Pigment::Kind::gradient;
    p.colours = {Spectrum(0.2), Spectrum(1.0), Spectrum(3.0), Spectrum(5.0)};
    p.stops = {0.1, 0.5, 0.5, 0.9};
    scene.environment.pattern = p;
    const auto value = [&](double y) {
        return towards(scene, {std::sqrt(1 - y * y), y, 0}, {0, 0, 1}).s0;
    };
    CHECK_THAT(value(0.05), WithinAbs(0.2, 1e-12));
    CHECK_THAT(value(0.3), WithinAbs(0.6, 1e-12));
    CHECK_THAT(value(0.4999999), WithinAbs(1, 1e-5));
    CHECK_THAT(value(0.5000001), WithinAbs(3, 1e-5));
    CHECK_THAT(value(0.6), WithinAbs(3.5, 1e-12));
    CHECK_THAT(value(0.95), WithinAbs(5, 1e-12));
    // Below the horizon the map starts over, as POV-Ray's does.
    CHECK_THAT(value(-0.4), WithinAbs(3.5, 1e-12));
}

TEST_CASE("a function of four expressions is the Stokes vector of one who looks at the sky",
          "[sky][convention]") {
    Scene scene;
    Formula one, x, y, zero;
    one.constant(2);
    x.variable(0);
    y.variable(1);
    zero.variable(2);
    scene.environment.formulas = {one, x, y, zero};
    scene.environment.to_own = Transform::scaling({1, 1, -1});
    for (const Vec3& d :
         {Vec3{0, 0, 1}, normalised(Vec3{1, 0.3, 0.5}), normalised(Vec3{-1, -2, 0.1})}) {
        // Picture-right with y up, in left-handed coordinates: y x d.
        const Vec3 right = normalised(cross(Vec3{0, 1, 0}, d));
        CHECK(difference(towards(scene, d, right), {2, d.x, d.y, d.z}) < 1e-13);
    }
    // A picture turned by 90 degrees sees the linear part with the other sign.
    const Vec3 d = normalised(Vec3{0.4, 0, 1});
    CHECK(difference(towards(scene, d, {0, 1, 0}), {2, -d.x, 0, d.z}) < 1e-13);
}

TEST_CASE("a function's light is cut to what light can be", "[sky]") {
    Scene scene;
    Formula height;
    height.variable(1);
    scene.environment.formulas = {height};
    CHECK(towards(scene, normalised(Vec3{1, -0.5, 0}), {0, 0, 1}).s0 == 0);
    Formula root = height, q, none;
    root.apply([](double a, double) { return std::sqrt(a); }, 1);
    scene.environment.formulas = {root};
    CHECK(towards(scene, normalised(Vec3{1, -0.5, 0}), {0, 0, 1}).s0 == 0);
    q.constant(3);
    none.constant(0);
    scene.environment.formulas = {height, q, none, none};
    const Stokes s = towards(scene, {0.6, 0.8, 0}, {0, 0, 1});
    CHECK_THAT(s.s0, WithinAbs(0.8, 1e-14));
    CHECK_THAT(polarised_part(s), WithinAbs(0.8, 1e-14));
}

TEST_CASE("a picture of a pattern in the sky has the colours of the pattern", "[sky]") {
    Scene scene;
    Pigment p;
    p.kind = Pigment::Kind::gradient;
    p.axis = {0, 0, -1};
    p.colours = {reflectance_from_rgb({0.9, 0.1, 0.2}), reflectance_from_rgb({0.9, 0.1, 0.2})};
    p.stops = {0, 1};
    scene.environment.pattern = p;
    const Image image = render(scene, small(2, 8)).image;
    CHECK_THAT(image.rgb[0], WithinAbs(0.9, 1e-6));
    CHECK_THAT(image.rgb[1], WithinAbs(0.1, 1e-6));
    CHECK_THAT(image.rgb[2], WithinAbs(0.2, 1e-6));
}
