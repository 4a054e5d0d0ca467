// What interior and crystal say of a stone: absorption, axes, rotation, POV-Ray's words.
#include <catch2/catch.hpp>
#include <cmath>

#include "crystal/mineral_colour.hpp"
#include "scene_text.hpp"

using namespace icespar;
using Catch::Matchers::WithinAbs;

namespace {

Crystal interior(const std::string& words) {
    const LoadResult result =
        load_scene_text("gem { box { 0, 1 } interior { " + words + " } }", "test.spar", ".");
    for (const Diagnostic& d : result.diagnostics) UNSCOPED_INFO(to_string(d));
    REQUIRE(result.scene);
    REQUIRE(result.scene->gems.size() == 1);
    return result.scene->gems[0].crystal;
}

Crystal crystal(const std::string& words) { return interior("crystal { " + words + " }"); }

}  // namespace

TEST_CASE("absorption is said by wave, by index, or once for all", "[crystal][absorption]") {
    const Crystal named = crystal(
        "mineral \"tourmaline\" absorption { extraordinary 0.1 ordinary spectrum { 400, 1, 600, 2 "
        "} }");
    REQUIRE(named.absorption.size() == 2);
    CHECK(named.absorption[0](500) == 1.5);
    CHECK(named.absorption[1](500) == 0.1);
    const Crystal listed = crystal("mineral \"topaz\" absorption { 0.1, 0.2, 0.3 }");
    REQUIRE(listed.absorption.size() == 3);
    CHECK(listed.absorption[2](500) == 0.3);
    CHECK(crystal("mineral \"topaz\" absorption { 0.4 }").absorption[2](500) == 0.4);
    const Crystal bands = crystal(
        "indices 1.7 absorption { first gaussian { 500, 40, 1 } gaussian { 600, 40, 1 } 0.1 }");
    CHECK_THAT(bands.absorption[0](500), WithinAbs(1.1, 1e-6));
    CHECK_THAT(bands.absorption[0](520), WithinAbs(0.6, 2e-5));
}

TEST_CASE("a mineral is clear until its colour is said", "[crystal][absorption]") {
    CHECK(crystal("mineral \"corundum\"").absorption.empty());
    const Crystal ruby = crystal("mineral \"corundum\" colour \"ruby\"");
    const MineralColour* table = find_colour(*find_mineral("corundum"), "ruby");
    REQUIRE(ruby.absorption.size() == 2);
    for (const double nm : {420.0, 550.0, 690.0}) {
        CHECK(ruby.absorption[1](nm) == table->absorption[1](nm));
    }
}

TEST_CASE("fade and dispersion mean what they mean in POV-Ray", "[crystal]") {
    const Crystal c =
        interior("ior 1.77 dispersion 1.02 fade_distance 4 fade_power 1000 fade_color rgb 0.25");
    CHECK_THAT(c.indices[0](589.3), WithinAbs(1.77, 1e-12));
    CHECK_THAT(c.indices[0](430.8) / c.indices[0](686.7), WithinAbs(1.02, 1e-12));
    REQUIRE(c.fade);
    CHECK_THAT(c.fade->transmittance(8, 550), WithinAbs(std::exp(-0.75 * 2), 1e-9));
    const Crystal inverse = interior("ior 1.5 fade_distance 4 fade_power 2 fade_colour rgb 0.5");
    CHECK_THAT(inverse.fade->transmittance(8, 550), WithinAbs(0.5 + 0.5 / (1 + 4), 1e-9));
    CHECK_FALSE(interior("ior 1.5 fade_power 2").fade);
}

TEST_CASE("an Abbe number spreads the lines F and C as it says", "[crystal]") {
    const Crystal c = crystal("indices 1.6, 1.7 dispersion { abbe 40, 50 }");
    for (const std::size_t i : {0u, 1u}) {
        const IndexFunction& n = c.indices[i];
        CHECK_THAT((n(587.5618) - 1) / (n(486.1327) - n(656.2725)),
                   WithinAbs(i == 0 ? 40 : 50, 1e-9));
        CHECK_THAT(n(589.3), WithinAbs(i == 0 ? 1.6 : 1.7, 1e-12));
    }
    const Crystal bg = crystal("mineral \"topaz\" dispersion { bg 0.01, 0.02, 0.03 }");
    CHECK_THAT(bg.indices[2](430.8) - bg.indices[2](686.7), WithinAbs(0.03, 1e-12));
}

TEST_CASE("the axes of a biaxial stone turn with it", "[crystal]") {
    const LoadResult result = load_scene_text(
        "gem { box { 0, 1 } interior { crystal { mineral \"topaz\" axes x, z*3 } } rotate y*90 }",
        "test.spar", ".");
    REQUIRE(result.scene);
    const Crystal& c = result.scene->gems[0].crystal;
    // Left-handed about y: x goes to -z and z to x; the core's z is the other way round.
    CHECK(length(c.axis - Vec3{0, 0, 1}) < 1e-15);
    CHECK(length(c.third_axis - Vec3{1, 0, 0}) < 1e-15);
}

TEST_CASE("rotation falls with the square of the wavelength unless a spectrum says else",
          "[crystal]") {
    const Crystal c = crystal("mineral \"quartz\" rotation -21.7");
    CHECK_THAT(c.rotation(589.3), WithinAbs(-21.7, 1e-12));
    CHECK_THAT(c.rotation(400), WithinAbs(-21.7 * std::pow(589.3 / 400, 2), 2e-4));
    CHECK(c.dispersive());
    CHECK(crystal("mineral \"quartz\" rotation spectrum { 400, 50, 700, 14 }").rotation(550) == 32);
}
