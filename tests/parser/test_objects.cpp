// Things, lamps and surroundings: where they stand in the core scene, with z negated once.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::WithinAbs;

namespace {

void check(const Vec3& v, const Vec3& expected, double tolerance = 1e-12) {
    CHECK_THAT(v.x, WithinAbs(expected.x, tolerance));
    CHECK_THAT(v.y, WithinAbs(expected.y, tolerance));
    CHECK_THAT(v.z, WithinAbs(expected.z, tolerance));
}

Thing thing_of(const std::string& text) {
    const Scene scene = scene_of(text);
    REQUIRE(scene.things.size() == 1);
    return scene.things[0];
}

}  // namespace

TEST_CASE("transforms act in the order they are written, rotations left-handed", "[objects]") {
    const std::string ball = "sphere { <1, 0, 0>, 1 pigment { rgb 1 } ";
    // With the left thumb along y, z turns to x and x to -z.
    check(thing_of(ball + "rotate y*90 }").to_world.point({0, 0, 0}), {0, 0, 1});
    check(thing_of(ball + "rotate z*90 translate x }").to_world.point({0, 0, 0}), {1, 1, 0});
    check(thing_of(ball + "translate x rotate z*90 }").to_world.point({0, 0, 0}), {0, 2, 0});
    check(thing_of(ball + "scale <3, 1, 1> rotate x*90 }").to_world.point({0, 1, 0}), {3, 0, -1});
    check(thing_of(ball + "rotate <90, 90, 0> }").to_world.vector({0, 1, 0}), {1, 0, 0});
    check(thing_of(ball + "matrix <1,0,0, 0,1,0, 1,0,1, 0,5,0> }").to_world.point({0, 0, 1}),
          {2, 5, -1});
    check(thing_of(ball + "transform { translate x*4 inverse } }").to_world.point({0, 0, 0}),
          {-3, 0, 0});
}

TEST_CASE("a plane stands at its distance along its normal, however long that is", "[objects]") {
    const Thing plane = thing_of("plane { <0, 0, 2>, 3 pigment { rgb 1 } }");
    check(plane.to_world.point({0, 0, 0}), {0, 0, -3});
    check(normalised(plane.to_world.normal({0, 1, 0})), {0, 0, -1});
}

TEST_CASE("a box spans its corners in either order", "[objects]") {
    const Thing box = thing_of("box { <2, 3, 4>, <-1, 0, 1> pigment { rgb 1 } }");
    check(box.to_world.point({0, 0, 0}), {-1, 0, -1});
    check(box.to_world.point({1, 1, 1}), {2, 3, -4});
}

TEST_CASE("a texture moves with the transforms after it and not with those before", "[objects]") {
    const Thing before = thing_of("sphere { 0, 1 translate x*5 pigment { checker rgb 1 rgb 0 } }");
    check(before.pigment.to_pattern.point({5, 1, 2}), {5, 1, -2});
    const Thing after =
        thing_of("sphere { 0, 1 pigment { checker rgb 1 rgb 0 scale 2 } translate x*5 }");
    check(after.pigment.to_pattern.point({5, 2, -4}), {0, 1, 2});
}

TEST_CASE("what has no pigment of its own takes the union's", "[objects]") {
    const Scene scene = scene_of(
        "union { sphere { 0, 1 } sphere { 0, 1 pigment { rgb <1, 0, 0> } finish { emission 2 } } "
        "pigment { rgb <0, 0, 1> } finish { diffuse 0.3 } translate z*2 }");
    REQUIRE(scene.things.size() == 2);
    check(scene.things[0].to_world.point({0, 0, 0}), {0, 0, -2});
    const auto blue = reflectance_from_rgb({0, 0, 1}), red = reflectance_from_rgb({1, 0, 0});
    CHECK(scene.things[0].pigment.colours[0](450) == blue(450));
    CHECK(scene.things[1].pigment.colours[0](650) == red(650));
    CHECK(scene.things[0].finish.diffuse == 0.3);
    CHECK(scene.things[1].finish.diffuse == 0.6);
    CHECK(scene.things[1].finish.emission == 2);
}

TEST_CASE("ambient is emission times ambient_light, and none where nothing is said", "[objects]") {
    const std::string sphere = "sphere { 0, 1 pigment { rgb 1 } ";
    CHECK(thing_of(sphere + "}").finish.emission == 0);
    CHECK(thing_of("global_settings { ambient_light rgb 2 }" + sphere + "finish { ambient 0.3 } }")
              .finish.emission == 0.6);
    CHECK(
        thing_of("#default { finish { ambient 0.1 diffuse 0.5 } }" + sphere + "}").finish.diffuse ==
        0.5);
}

TEST_CASE("a grid has lines of the width given, in cells", "[objects]") {
    const Thing plane =
        thing_of("plane { y, 0 pigment { grid rgb 0.2 rgb 1 line 0.06 scale 0.25 } }");
    CHECK(plane.pigment.kind == Pigment::Kind::grid);
    CHECK(plane.pigment.line_width == 0.06);
    CHECK_THAT(plane.pigment.colours[0](550), WithinAbs(0.2, 1e-12));
    check(plane.pigment.to_pattern.point({0.25, 0, -0.5}), {1, 0, 2});
}

TEST_CASE("lamps have their place, their colour and their edges", "[objects][light]") {
    const Scene scene = scene_of(
        "light_source { <1, 2, 3> rgb 2 } light_source { <0, 5, 0>, rgb 1 area_light x*2, z*4, 3, "
        "3 fade_distance 5 "
        "fade_power 2 translate y rotate y*90 } light_source { y rgb 1 illuminant \"A\" }");
    REQUIRE(scene.lights.size() == 3);
    check(scene.lights[0].position, {1, 2, -3});
    CHECK_THAT(scene.lights[0].light(550), WithinAbs(2 * white()(550), 1e-12));
    check(scene.lights[1].position, {0, 6, 0});
    check(scene.lights[1].edge_u, {0, 0, 2});
    check(scene.lights[1].edge_v, {4, 0, 0});
    CHECK(scene.lights[1].fade_distance == 5);
    CHECK(scene.lights[1].fade_power == 2);
    CHECK_THAT(scene.lights[2].light(650), WithinAbs(illuminant("A")(650), 1e-12));
}

TEST_CASE("an environment is uniform, graded or polarised", "[environment]") {
    const Environment uniform =
        scene_of("environment { uniform illuminant \"A\" 0.4 }").environment;
    CHECK(uniform.below(500) == 0.4);
    CHECK(uniform.above(700) == 0.4);
    CHECK(uniform.illuminant(560) == illuminant("A")(560));
    CHECK(uniform.state == Stokes{1, 0, 0, 0});
    const Environment hot = scene_of("environment { uniform blackbody 5600 1 }").environment;
    CHECK(hot.illuminant(560) == blackbody(5600)(560));
    const Environment graded =
        scene_of("environment { gradient rgb 0.1 rgb <1, 0.5, 0> rotate z*90 }").environment;
    CHECK(graded.below(500) == 0.1);
    CHECK_THAT(graded.above(500), WithinAbs(reflectance_from_rgb({1, 0.5, 0})(500), 1e-15));
    check(graded.up, {-1, 0, 0});
    const Stokes s =
        scene_of("environment { uniform 1 polarised { linear 30 0.8 } }").environment.state;
    CHECK_THAT(s.s1, WithinAbs(0.4, 1e-15));
    CHECK_THAT(s.s2, WithinAbs(0.8 * std::sqrt(0.75), 1e-15));
    CHECK(
        scene_of("environment { uniform 1 polarised { circular right 0.5 } }").environment.state ==
        Stokes{1, 0, 0, 0.5});
    CHECK(scene_of("environment { uniform 1 polarised { circular left } }").environment.state ==
          Stokes{1, 0, 0, -1});
}

TEST_CASE("a background is an environment too", "[environment]") {
    CHECK(scene_of("background { rgb 0.3 }").environment.above(600) == 0.3);
}
