// What POV-Ray's scenes are full of, and what must not stop them here.
#include <catch2/catch.hpp>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

const std::string glass = " interior { ior 1.5 } ";

std::string messages_of(const std::string& text) {
    return messages(load_scene_text(text, "test.spar", ICESPAR_TESTS_DIR));
}

}  // namespace

TEST_CASE("a plane turned inside out keeps the side its normal points to", "[habits]") {
    const std::string five =
        "plane { y, 1 } plane { x, 1 } plane { -x, 1 } plane { z, 1 } plane { -z, 1 }";
    const Scene scene = scene_of(
        "intersection { " + five + " plane { y, -0.5 inverse } " + glass + "} intersection { " +
        five + " object { plane { y, 0.25 } inverse } " + glass + " translate x*5 }");
    CHECK_THAT(scene.gems.at(0).stone.volume, WithinRel(6.0, 1e-12));
    CHECK_THAT(scene.gems.at(1).stone.volume, WithinRel(3.0, 1e-12));
    CHECK(
        messages_of("plane { y, 0 inverse pigment { rgb 1 } } box { 0, 1 inverse pigment { rgb 1 } "
                    "translate y }")
            .empty());
    CHECK(faulty("object { box { 0, 1 " + glass + " } inverse }", "cannot be turned inside out"));
}

TEST_CASE("#default takes a whole texture as well as its parts", "[habits]") {
    const Scene scene = scene_of(
        "#default { texture { pigment { rgb 0.5 } finish { ambient 0 diffuse 0.25 } } } sphere { "
        "0, "
        "1 }");
    CHECK(scene.things.at(0).finish.diffuse == 0.25);
    CHECK_THAT(scene.things.at(0).pigment.colours[0](550), WithinRel(0.5, 1e-9));
    CHECK_THAT(messages_of("#default { interior { ior 1.5 } }"),
               Contains("'interior' does not belong in '#default'"));
}

TEST_CASE("what belongs to a word that is left out is left out with it", "[habits]") {
    const std::string said = messages_of("global_settings { charset utf8 assumed_gamma 1 }");
    CHECK_THAT(said, Contains("'charset' is left out"));
    CHECK_THAT(said, !Contains("utf8' does not"));
}

TEST_CASE("idle planes of a stone are told in one message", "[habits]") {
    std::string planes;
    for (int i = 0; i < 9; ++i) planes += "plane { x, 9 rotate y*" + std::to_string(i * 40) + " } ";
    const std::string said = messages_of("intersection { box { -1, 1 } " + planes + glass + "}");
    CHECK_THAT(said, Contains("facet 7, facet 8, facet 9, facet 10, facet 11, facet 12 and 3 more "
                              "do not reach the stone"));
}

TEST_CASE("POV-Ray's own includes that are not here are left out with a warning", "[habits]") {
    CHECK_THAT(messages_of("#include \"textures.inc\"\n"),
               Contains("warning: POV-Ray's textures.inc is left out"));
    CHECK(faulty("#include \"texture.inc\"", "there is no file 'texture.inc'"));
}

TEST_CASE("normals of triangles are left out with a warning", "[habits]") {
    for (const std::string triangle :
         {"mesh { smooth_triangle { 0, y, x, y, z, y } ", "smooth_triangle { 0, y, x, y, z, y ",
          "mesh2 { vertex_vectors { 3, <0, 0, 0>, x, z } normal_vectors { 3, y, y, y } "
          "face_indices { 1, <0, 1, 2> } "}) {
        INFO(triangle);
        CHECK_THAT(messages_of(triangle + "pigment { rgb 1 } }"),
                   Contains("warning: triangles are seen flat"));
    }
}

TEST_CASE("a function of floats is declared and called as in POV-Ray", "[habits]") {
    const std::string head =
        "#declare Cauchy = function(L) { 1.5 + 0.01/pow(L, 2) } "
        "#declare Sum = function(x, y) { x + 2*y }; #declare One = function(T) { 1 - T }";
    CHECK_THAT(number_of("Cauchy(0.5)", head), WithinRel(1.54, 1e-12));
    CHECK_THAT(number_of("10/Sum(1, 2) + Sum(One(0.25), 1).x", head), WithinRel(4.75, 1e-12));
    CHECK_THAT(number_of("vlength(x*Sum(3, 0))", head), WithinRel(3.0, 1e-12));
    CHECK(faulty("#declare F = function(x) { x + } #declare A = F(1);", "expected a value"));
    CHECK(faulty("#declare F = function(x) { x", "expected an expression and '}'"));
    CHECK(faulty("#declare F = function(x) { x } #declare A = F(1, 2);", "it is F(x)"));
    CHECK(faulty("#declare F = function(x) { F(x) } #declare A = F(1);", "the bound"));
}

TEST_CASE("ambient and emission add up", "[habits]") {
    const auto emission = [](const std::string& finish) {
        return scene_of(
                   "global_settings { ambient_light rgb 0.5 } sphere { 0, 1 pigment { rgb 1 } "
                   "finish { " +
                   finish + " } }")
            .things.at(0)
            .finish.emission;
    };
    CHECK_THAT(emission("emission 0.5 ambient 0"), WithinRel(0.5, 1e-12));
    CHECK_THAT(emission("ambient 0.4 emission 0.5"), WithinRel(0.7, 1e-12));
    CHECK_THAT(emission("ambient 0.4 emission 0.5 ambient 0.2"), WithinRel(0.6, 1e-12));
}

TEST_CASE("a thing of a union keeps its own pigment, a thing by itself takes the object's",
          "[habits]") {
    const std::string head =
        "#declare Ball = sphere { 0, 1 pigment { rgb 0.2 } } "
        "#declare Pair = union { object { Ball } sphere { x*5, 1 } } ";
    const Scene scene = scene_of(head +
                                 "object { Ball pigment { rgb 0.6 } } "
                                 "object { object { Pair } pigment { rgb 0.6 } }");
    CHECK_THAT(scene.things.at(0).pigment.colours[0](550), WithinRel(0.6, 1e-9));
    CHECK_THAT(scene.things.at(1).pigment.colours[0](550), WithinRel(0.2, 1e-9));
    CHECK_THAT(scene.things.at(2).pigment.colours[0](550), WithinRel(0.6, 1e-9));
}
