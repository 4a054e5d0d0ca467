// Stones as the language describes them: their shape, their handedness, what they are made of.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "crystal/mineral.hpp"
#include "parser/scene_text.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Gem gem_of(const std::string& text) {
    const Scene scene = scene_of(text);
    REQUIRE(scene.gems.size() == 1);
    return scene.gems[0];
}

const std::string glass = " interior { ior 1.5 } ";

void check(const Vec3& v, const Vec3& expected, double tolerance = 1e-12) {
    CHECK_THAT(v.x, WithinAbs(expected.x, tolerance));
    CHECK_THAT(v.y, WithinAbs(expected.y, tolerance));
    CHECK_THAT(v.z, WithinAbs(expected.z, tolerance));
}

bool has_facet(const Stone& stone, const Vec3& normal, double distance) {
    return std::any_of(stone.facets.begin(), stone.facets.end(), [&](const Facet& f) {
        return length(f.normal - normal) < 1e-12 && std::abs(f.distance - distance) < 1e-12;
    });
}

}  // namespace

TEST_CASE("the rhomb of the language's example is a cleavage rhomb of calcite", "[stones]") {
    const Gem gem = gem_of(
        "#include \"shapes.inc\" gem { hull { Rhomb_Points(2, 101.92) } interior { crystal { "
        "mineral \"calcite\" axis <1, 1, 1> } } }");
    REQUIRE(gem.stone.facets.size() == 6);
    REQUIRE(gem.stone.vertices.size() == 8);
    const double c = std::cos(101.92 * std::numbers::pi / 180);
    // Volume of a rhombohedron, a^3 sqrt(1 - 3 c^2 + 2 c^3); all edges 2; the axis through blunt
    // corners.
    CHECK_THAT(gem.stone.volume, WithinRel(8 * std::sqrt(1 - 3 * c * c + 2 * c * c * c), 1e-12));
    for (const Facet& f : gem.stone.facets) {
        REQUIRE(f.corners.size() == 4);
        double blunt = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 p = gem.stone.vertices[f.corners[i]];
            const Vec3 a = gem.stone.vertices[f.corners[(i + 1) % 4]] - p;
            const Vec3 b = gem.stone.vertices[f.corners[(i + 3) % 4]] - p;
            CHECK_THAT(length(a), WithinAbs(2, 1e-12));
            blunt = std::max(blunt, std::acos(dot(a, b) / (length(a) * length(b))));
        }
        CHECK_THAT(blunt * 180 / std::numbers::pi, WithinAbs(101.92, 1e-9));
        // Calcite's axis makes 44.6 degrees with every cleavage normal (tables say 44 degrees 37').
        CHECK_THAT(std::acos(std::abs(dot(f.normal, gem.crystal.axis))) * 180 / std::numbers::pi,
                   WithinAbs(44.61, 0.02));
    }
    check(gem.crystal.axis, {1 / std::sqrt(3), 1 / std::sqrt(3), -1 / std::sqrt(3)});
    CHECK(gem.crystal.indices.size() == 2);
}

TEST_CASE("planes keep the side that their normals point away from", "[stones]") {
    const Gem gem = gem_of(
        "intersection { plane { x, 1 } plane { -x, 2 } plane { y, 3 } plane { -y, 0 } plane { z, 1 "
        "} "
        "plane { <0, 0, -5>, 4 } " +
        glass + " translate z*10 }");
    CHECK_THAT(gem.stone.volume, WithinRel(3 * 3 * 5.0, 1e-14));
    CHECK(has_facet(gem.stone, {0, 0, -1}, 11));
    CHECK(has_facet(gem.stone, {0, 0, 1}, -6));
    CHECK(has_facet(gem.stone, {-1, 0, 0}, 2));
}

TEST_CASE("boxes, planes and hulls intersect, transformed, turned inside out and through names",
          "[stones]") {
    CHECK_THAT(
        gem_of("gem { intersection { box { -1, 1 } plane { y, 0 rotate z*45 } }" + glass + "}")
            .stone.volume,
        WithinRel(4, 1e-12));
    CHECK_THAT(gem_of("#declare Half = plane { x, 0 } gem { intersection { box { -1, 1 } object { "
                      "Half inverse } }" +
                      glass + "}")
                   .stone.volume,
               WithinRel(4, 1e-12));
    CHECK_THAT(gem_of("#declare Cube = box { 0, 1 } gem { object { Cube scale 2 }" + glass + "}")
                   .stone.volume,
               WithinRel(8, 1e-12));
    CHECK_THAT(
        gem_of("gem { intersection { hull { <0, 0, 0>, x, y, z } box { 0, 0.5 } }" + glass + "}")
            .stone.volume,
        WithinRel(5.0 / 48, 1e-12));
}

TEST_CASE("a box of glass is a gem, as in POV-Ray, and an opaque one is not", "[stones]") {
    const Scene scene = scene_of("box { 0, 1 pigment { rgbt 1 }" + glass +
                                 "} box { 2, 3 pigment { rgb 1 } } "
                                 "union { box { 4, 5 } interior { ior 1.7 } }");
    REQUIRE(scene.gems.size() == 2);
    CHECK(scene.things.size() == 1);
    CHECK(scene.gems[1].crystal.indices[0](550) == 1.7);
    CHECK(scene.gems[0].name == "test.spar:1");
}

TEST_CASE("cut and design agree about one and the same stone", "[stones][cut]") {
    const ScratchFolder folder;
    std::ofstream(folder / "stone.asc")
        << "GemCad 5.0\ng 96 0.0\ny 4 n\nI 1.54\n"
           "a -43.0 0.65 5 n P1 29 53 77\na 90.0 1.0 5 n G 29 53 77\n"
           "a 35.0 0.75 9 n C1 33 57 81\na 0.0 0.5 0 n T\n";
    const std::string text = "gem { design \"stone.asc\" interior { ior 1.54 } }";
    const LoadResult design = load_scene_text(text, "d.spar", folder / "");
    INFO(messages(design));
    REQUIRE(design.scene);
    const Gem cut = gem_of(
        "gem { cut { gear 96 facet { \"P1\" angle -43 distance 0.65 every 24 from 5 } "
        "facet { \"G\" angle 90 distance 1 every 24 from 5 } "
        "facet { \"C1\" angle 35 distance 0.75 every 24 from 9 } "
        "facet { \"T\" angle 0 distance 0.5 } } interior { ior 1.54 } }");
    const Stone& stone = design.scene->gems[0].stone;
    REQUIRE(stone.facets.size() == cut.stone.facets.size());
    for (const Facet& f : stone.facets) CHECK(has_facet(cut.stone, f.normal, f.distance));
    CHECK_THAT(stone.volume, WithinRel(cut.stone.volume, 1e-12));
}

TEST_CASE("a cut keeps its handedness from GemCad's frame to the picture", "[stones][cut]") {
    // Tooth 24 of 96 is azimuth 90: GemCad's x, the language's x. Tooth 0 is GemCad's y, the
    // language's z.
    const Gem gem = gem_of(
        "gem { cut { gear 96 facet { \"T\" angle 0 distance 0.3 } facet { \"A\" angle 60 distance "
        "0.9 index 24 } "
        "facet { \"B\" angle 50 distance 0.8 index 0 } facet { \"G\" angle 90 distance 1 every 12 "
        "from 0 } "
        "facet { \"P\" angle -45 distance 0.7 every 12 from 6 } }" +
        glass + "}");
    const double s60 = std::sin(std::numbers::pi / 3), c50 = std::cos(50 * std::numbers::pi / 180);
    CHECK(has_facet(gem.stone, {s60, 0.5, 0}, 0.9));
    CHECK(has_facet(gem.stone, {0, c50, -std::sqrt(1 - c50 * c50)}, 0.8));
    CHECK(has_facet(gem.stone, {0, 1, 0}, 0.3));
}

TEST_CASE("scale_to sizes the girdle", "[stones]") {
    const Gem gem = gem_of("gem { box { <-1, 0, -2>, <1, 9, 2> } scale_to width 6" + glass + "}");
    CHECK_THAT(gem.stone.volume, WithinRel(2 * 9 * 4 * 27.0, 1e-12));
}

TEST_CASE("a stone of glass may be scaled: nothing in it has a direction", "[stones][crystal]") {
    for (const std::string stone :
         {"gem { box { -1, 1 } interior { ior 1.5 } scale <0.9, 2, 0.5> }",
          "gem { box { -1, 1 } interior { crystal { mineral \"spinel\" } } "
          "rotate x*30 scale 0.9 }"}) {
        const Gem gem = gem_of(stone);
        CHECK_THAT(length(gem.crystal.axis), WithinAbs(1, 1e-12));
        CHECK(gem.stone.volume > 0);
    }
}

TEST_CASE("the optic axis turns with the stone, wherever the interior stands",
          "[stones][crystal]") {
    for (const auto* text :
         {"gem { box { 0, 1 } interior { crystal { indices 1.6, 1.7 axis x } } rotate z*90 }",
          "gem { box { 0, 1 } rotate z*90 interior { crystal { indices 1.6, 1.7 axis x*3 } } }",
          "union { gem { box { 0, 1 } interior { crystal { indices 1.6, 1.7 axis x } } } rotate "
          "z*90 }",
          "#declare G = gem { box { 0, 1 } interior { crystal { indices 1.6, 1.7 axis x } } } "
          "object { G rotate z*90 }"}) {
        check(gem_of(text).crystal.axis, {0, 1, 0});
    }
    check(gem_of("gem { box { 0, 1 } interior { crystal { indices 1.6, 1.7 axis z } } }")
              .crystal.axis,
          {0, 0, -1});
}

TEST_CASE("what a crystal is made of can be said in several ways", "[stones][crystal]") {
    const auto crystal = [](const std::string& items) {
        return gem_of("gem { box { 0, 1 } interior { crystal { " + items + " axis y } } }").crystal;
    };
    const Mineral& quartz = *find_mineral("quartz");
    CHECK(crystal("mineral \"quartz\"").indices[1](500) == quartz.indices[1](500));
    CHECK(crystal("mineral \"quartz\" indices 1.5, 1.5").indices.size() == 2);
    CHECK(crystal("indices 1.5, 1.5").birefringent());
    const Crystal bg = crystal("indices 1.6, 1.7 dispersion { bg 0.02 }");
    for (const std::size_t i : {0U, 1U}) {
        CHECK_THAT(bg.indices[i](589.3), WithinAbs(1.6 + 0.1 * static_cast<double>(i), 1e-12));
        CHECK_THAT(bg.indices[i](430.8) - bg.indices[i](686.7), WithinAbs(0.02, 1e-12));
    }
    const Crystal glass_bk7 = gem_of(
                                  "gem { box { 0, 1 } interior { crystal { dispersion { sellmeier "
                                  "{ 1.03961212, 0.00600069867, "
                                  "0.231792344, 0.0200179144, 1.01046945, 103.560653 } } } } }")
                                  .crystal;
    CHECK_THAT(glass_bk7.indices[0](587.5618), WithinAbs(1.51680, 5e-6));  // Schott's n_d of N-BK7
    const Crystal cauchy = crystal("dispersion { cauchy 1.5, 0.004 cauchy 1.6, 0.005 }");
    CHECK_THAT(cauchy.indices[1](500), WithinAbs(1.62, 1e-12));
}

TEST_CASE("instances of one gem are stones of their own", "[stones]") {
    const Scene scene = scene_of(
        "#declare G = gem { box { -1, 1 } interior { ior 1.5 } } #for (I, 0, 3) object { G rotate "
        "y*15*I "
        "translate x*4*I } #end");
    REQUIRE(scene.gems.size() == 4);
    for (const Gem& gem : scene.gems) CHECK_THAT(gem.stone.volume, WithinRel(8, 1e-12));
    CHECK(has_facet(scene.gems[2].stone, {0, 1, 0}, 1));
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    // Turned by 30 degrees, the left thumb up: x goes towards -z of the language, +z of the core.
    CHECK(has_facet(scene.gems[2].stone, {c, 0, s}, 1 + 8 * c));
}

TEST_CASE("a scene that is read twice has the same stones, bit for bit", "[stones]") {
    for (const char* name : {"calcite_on_grid", "cuts", "diamond_brilliant"}) {
        const std::string file = ICESPAR_SCENES_DIR "/" + std::string(name) + ".spar";
        const LoadResult one = load_scene_file(file), two = load_scene_file(file);
        INFO(file);
        INFO(messages(one));
        REQUIRE(one.scene.has_value());
        CHECK(one.diagnostics.empty());
        REQUIRE(one.scene->gems.size() == two.scene->gems.size());
        for (std::size_t i = 0; i < one.scene->gems.size(); ++i) {
            const Stone &a = one.scene->gems[i].stone, &b = two.scene->gems[i].stone;
            CHECK(a.vertices == b.vertices);
            REQUIRE(a.facets.size() == b.facets.size());
            for (std::size_t f = 0; f < a.facets.size(); ++f) {
                CHECK(a.facets[f].normal == b.facets[f].normal);
                CHECK(a.facets[f].distance == b.facets[f].distance);
            }
        }
    }
}
