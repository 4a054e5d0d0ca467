// Things beside stones and things through stones: the second would be passed over by the light
// inside.
#include <catch2/catch.hpp>
#include <string>

#include "parser/scene_text.hpp"

using namespace icespar;

namespace {

/// The messages about a thing in the company of a cube from -1 to 1.
std::string beside_cube(const std::string& thing) {
    return messages(
        load_scene_text("camera { location -9*z look_at 0 }\n"
                        "gem { box { -1, 1 } interior { ior 1.5 } }\n" +
                            thing + " pigment { rgb 1 } }",
                        "test.spar", ICESPAR_TESTS_DIR));
}

}  // namespace

TEST_CASE("a stone may touch what surrounds it", "[parser][contact]") {
    for (const char* thing :
         {"plane { y, -1", "plane { y, -0.9999", "plane { <1, 1, 1>, -sqrt(3)", "disc { y, y, 5",
          "disc { 0, y, 5, sqrt(2)", "cylinder { -y, y, sqrt(2) open",
          "cylinder { -2*y, 2*y, sqrt(2)", "cone { y, 1, y*3, 0", "sphere { x*4, 3",
          "sphere { 0, sqrt(3)", "sphere { y*2001, 2000", "box { -9, 9",
          "box { <1, -1, -1>, <2, 1, 1>", "mesh { triangle { x, <9, 1, 1>, <9, 1, -1> }",
          "sphere { 0, 1 scale <2, 1, 2> translate y*2"}) {
        INFO(thing);
        CHECK(beside_cube(thing).empty());
    }
}

TEST_CASE("what runs through a stone is a fault", "[parser][contact]") {
    for (const char* thing :
         {"plane { y, -0.99", "plane { -x, 0", "disc { 0, y, 5, 1.3", "disc { 0, y, 0.1",
          "cylinder { -y, y, 1.3 open", "cylinder { -3*x, 3*x, 0.1", "cylinder { -y*5, -y*0.9, 3",
          "cone { y*0.5, 1, y*3, 0", "sphere { x*3.9, 3", "sphere { 0, 1.7", "sphere { 0, 0.1",
          "sphere { <1.5, 1.5, 0>, 0.8", "sphere { y*2000.9, 2000",
          "box { <-3, -0.1, -0.1>, <3, 0.1, 0.1>", "box { 0, 0.5",
          "mesh { triangle { x*0.9, <9, 1, 1>, <9, 1, -1> }",
          "mesh { triangle { <-9, 0, 0>, <9, 0, 1>, <9, 0, 9> }",
          "sphere { 0, 1 scale <2, 1, 2> translate y*1.9"}) {
        INFO(thing);
        CHECK_THAT(beside_cube(thing), Catch::Matchers::Contains("runs through it; move it out"));
    }
}
