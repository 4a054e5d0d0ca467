// Pigments of every kind, coloured glow, and primitives in their places.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "image/image.hpp"
#include "parser/scene_text.hpp"
#include "render/surface.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

Thing thing_of(const std::string& text) {
    const Scene scene = scene_of(text);
    REQUIRE(scene.things.size() == 1);
    return scene.things[0];
}

/// Linear RGB of a thing's pigment at a point of the scene.
Rgb colour_at(const Thing& thing, const Vec3& p) {
    const Mix mix = mix_at(thing.pigment, {p.x, p.y, -p.z}, {0, 1, 0});
    Rgb out{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(mix.count); ++i) {
        const Rgb part = rgb_of(thing.pigment.colours[mix.colour[i]] * white());
        for (std::size_t c = 0; c < 3; ++c) out[c] += mix.share[i] * part[c];
    }
    return out;
}

void check(const Rgb& found, const Rgb& expected, double tolerance = 1e-9) {
    for (std::size_t i = 0; i < 3; ++i) CHECK_THAT(found[i], WithinAbs(expected[i], tolerance));
}

}  // namespace

TEST_CASE("a gradient runs through its colour map, and moves with its pigment",
          "[parser][surface]") {
    const Thing t = thing_of(
        "plane { y, 0 pigment { gradient x color_map { [0 rgb 0] [0.5 rgb <1, 0, 0>] [1 rgb <0, 0, "
        "1>] } scale 2 translate x } }");
    check(colour_at(t, {1, 0, 0}), {0, 0, 0});
    check(colour_at(t, {1.5, 0, 0}), {0.5, 0, 0});
    check(colour_at(t, {2, 0, 3}), {1, 0, 0});
    check(colour_at(t, {2.5, 0, 0}), {0.5, 0, 0.5});
    check(colour_at(t, {3.5, 0, 0}), {0.5, 0, 0});
    check(colour_at(t, {-0.5, 0, 0}), {0.5, 0, 0});
    // Maps may be declared, and be written as of old.
    const Thing old = thing_of(
        "#declare M = color_map { [0 0.5 color rgb 0 color rgb 1] [0.5 1 rgb 1 rgb <0, 1, 0>] }"
        "plane { y, 0 pigment { gradient z color_map { M } } }");
    check(colour_at(old, {0, 0, 0.25}), {0.5, 0.5, 0.5});
    check(colour_at(old, {0, 0, 0.75}), {0.5, 1, 0.5});
}

TEST_CASE("a picture lies on the unit square, upright, and comes again", "[parser][surface]") {
    const ScratchFolder folder;
    Image image;
    image.width = image.height = 2;
    image.rgb = {1, 0, 0, 0, 1, 0,  //
                 0, 0, 1, 1, 1, 1};
    write_exr(image, folder / "four.exr");
    write_png(image, folder / "four.png");
    for (const std::string file : {"four.exr", "four.png"}) {
        const LoadResult result = load_scene_text("plane { z, 0 pigment { image_map { \"" + file +
                                                      "\" } } }"
                                                      "plane { z, 1 pigment { image_map { \"" +
                                                      file +
                                                      "\" once interpolate 2 } } }"
                                                      "sphere { 0, 1 pigment { image_map { \"" +
                                                      file + "\" map_type 1 } } }",
                                                  "test.spar", folder / "");
        INFO(messages(result));
        REQUIRE(result.scene);
        const Thing& flat = result.scene->things[0];
        check(colour_at(flat, {0.2, 0.8, 0}), {1, 0, 0}, 1e-6);
        check(colour_at(flat, {0.8, 0.8, 0}), {0, 1, 0}, 1e-6);
        check(colour_at(flat, {0.2, 0.2, 0}), {0, 0, 1}, 1e-6);
        check(colour_at(flat, {-0.8, 5.8, 7}), {1, 0, 0}, 1e-6);
        const Thing& once = result.scene->things[1];
        check(colour_at(once, {1.5, 0.5, 0}), {0, 0, 0}, 1e-6);
        check(colour_at(once, {0.5, 0.75, 0}), {0.5, 0.5, 0}, 1e-6);
        // Round from +x by +z: the front half, towards -z, is the right half of the picture.
        const Thing& ball = result.scene->things[2];
        check(colour_at(ball, {0.1, 0.5, -1}), {0, 1, 0}, 1e-6);
        check(colour_at(ball, {0.1, -0.5, 1}), {0, 0, 1}, 1e-6);
    }
    const auto fault = [&](const std::string& text) {
        return messages(load_scene_text(text, "test.spar", folder / ""));
    };
    std::ofstream(folder / "bad.png") << "no picture";
    std::ofstream(folder / "bad.exr") << "no picture";
    CHECK_THAT(fault("plane { y, 0 pigment { image_map { \"bad.png\" } } }"),
               Contains("cannot be read as PNG"));
    CHECK_THAT(fault("plane { y, 0 pigment { image_map { \"bad.exr\" } } }"),
               Contains("cannot be read as OpenEXR"));
    CHECK_THAT(fault("plane { y, 0 pigment { image_map { \"none.png\" } } }"),
               Contains("there is no file 'none.png'"));
    CHECK_THAT(fault("plane { y, 0 pigment { image_map { \"four.jpg\" } } }"),
               Contains("there is no file"));
}

TEST_CASE("a spectrum stands wherever a colour may", "[parser][spectrum]") {
    const std::string spectrum = "spectrum { 400, 0.1, 500, 0.3, 600, 0.9 }";
    const Thing plain = thing_of("#declare S = " + spectrum + " sphere { 0, 1 pigment { S } }");
    CHECK_THAT(plain.pigment.colours[0](450), WithinAbs(0.2, 1e-15));
    CHECK_THAT(plain.pigment.colours[0](700), WithinAbs(0.9, 1e-15));
    const Thing peak =
        thing_of("sphere { 0, 1 pigment { checker gaussian { 550, 40, 0.8 } rgb 0 } }");
    CHECK_THAT(peak.pigment.colours[0](550), WithinAbs(0.8, 1e-15));
    CHECK_THAT(peak.pigment.colours[0](570), WithinAbs(0.4, 1e-15));
    const ScratchFolder folder;
    std::ofstream(folder / "s.csv")
        << "wavelength,value\n# made up\n400, 0.1\n500;0.3\r\n600 0.9\n";
    const LoadResult result = load_scene_text(
        "sphere { 0, 1 pigment { spectrum \"s.csv\" } } light_source { 5, spectrum \"s.csv\" }"
        "environment { uniform 1 illuminant spectrum \"s.csv\" }",
        "test.spar", folder / "");
    INFO(messages(result));
    REQUIRE(result.scene);
    CHECK_THAT(result.scene->things[0].pigment.colours[0](450), WithinAbs(0.2, 1e-15));
    CHECK_THAT(result.scene->lights[0].light(450) / white()(450), WithinAbs(0.2, 1e-12));
    const Spectrum& lamp = result.scene->environment.illuminant;
    CHECK_THAT(lamp(600) / lamp(400), WithinAbs(9, 1e-12));
    CHECK_THAT(xyz_from_rgb(rgb_of(lamp))[1], WithinAbs(1, 1e-12));
    std::ofstream(folder / "bad.csv") << "400, 0.1\n500, lots\n";
    CHECK_THAT(messages(load_scene_text("sphere { 0, 1 pigment { spectrum \"bad.csv\" } }",
                                        "test.spar", folder / "")),
               Contains("line 2 of 'bad.csv'"));
    CHECK(faulty("sphere { 0, 1 pigment { spectrum { 500, 1, 400, 2 } } }", "do not rise"));
    CHECK(
        faulty("sphere { 0, 1 pigment { spectrum { 500 } } }", "needs the value at a wavelength"));
}

TEST_CASE("coloured ambient light tints the pigment", "[parser][surface]") {
    const Thing t = thing_of(
        "global_settings { ambient_light rgb <1, 0.5, 0.25> } sphere { 0, 1 pigment { rgb 1 } "
        "finish { ambient 0.8 diffuse 0 } }");
    CHECK(t.finish.emission == 0.8);
    const Rgb c = rgb_of(t.finish.emission * t.finish.tint * t.pigment.colours[0] * white());
    check(c, {0.8, 0.4, 0.2});
}

TEST_CASE("cylinders, cones and discs stand where their ends are", "[parser][objects]") {
    const Thing cone =
        thing_of("cone { <1, 2, 3>, 0.5, <1, 5, 7>, 2 pigment { rgb 1 } translate x }");
    const auto* shape = std::get_if<ConeShape>(&cone.shape);
    REQUIRE(shape);
    CHECK(shape->top == 0.25);
    const auto near = [](const Vec3& a, const Vec3& b) { return length(a - b) < 1e-12; };
    // The wider end is the foot; z is negated in the core.
    CHECK(near(cone.to_world.point({0, 0, 0}), {2, 5, -7}));
    CHECK(near(cone.to_world.point({0, 1, 0}), {2, 2, -3}));
    CHECK_THAT(length(cone.to_world.vector({1, 0, 0})), WithinAbs(2, 1e-12));
    const Thing tube = thing_of("cylinder { 0, y*4, 3 open pigment { rgb 1 } }");
    CHECK(std::get<ConeShape>(tube.shape).open);
    CHECK(std::get<ConeShape>(tube.shape).top == 1);
    const Thing disc = thing_of("disc { <1, 1, 1>, x, 4, 1 pigment { rgb 1 } }");
    CHECK(std::get<DiscShape>(disc.shape).hole == 0.25);
    CHECK(
        near(disc.to_world.normal({0, 1, 0}) / length(disc.to_world.normal({0, 1, 0})), {1, 0, 0}));
    CHECK(faulty("cylinder { y, y, 1 pigment { rgb 1 } }", "its two ends are in one place"));
    CHECK(faulty("disc { 0, y, 1, 2 pigment { rgb 1 } }", "the hole of a disc is smaller"));
    CHECK(faulty("triangle { 0, x, x*2 pigment { rgb 1 } }", "this triangle has no area"));
    CHECK(faulty("cylinder { 0, y, 1 pigment { rgbt 1 } interior { ior 1.5 } }",
                 "a stone has flat facets"));
}
