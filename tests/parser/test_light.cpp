// Surroundings, lamps, cameras and sheets as scenes write them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "image/image.hpp"
#include "parser/scene_text.hpp"
#include "render/render.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Light from a direction of the scene, by a ray from far away, with picture-right x.
Stokes from(const Scene& scene, const Vec3& d, const Vec3& right = {1, 0, 0}) {
    const SensorRay ray{1e4 * Vec3{d.x, d.y, -d.z}, {d.x, d.y, -d.z}, {right.x, right.y, -right.z}};
    return trace(scene, std::span(&ray, 1), {}).stokes[0];
}

double at_angle(const Scene& scene, double from_zenith) {
    return from(scene, {std::sin(from_zenith * degree), std::cos(from_zenith * degree), 0},
                {0, 0, 1})
        .s0;
}

}  // namespace

TEST_CASE("the domes of faceters have their definitions", "[parser][environment]") {
    const Scene iso = scene_of("environment { iso head 10 }");
    CHECK(at_angle(iso, 9.9) == 0);
    CHECK(at_angle(iso, 10.1) == 1);
    CHECK(at_angle(iso, 89) == 1);
    CHECK(at_angle(iso, 91) == 0);
    const Scene cosine = scene_of("environment { cosine head 20 0.5 }");
    CHECK(at_angle(cosine, 19) == 0);
    CHECK_THAT(at_angle(cosine, 60), WithinAbs(0.25, 1e-12));
    const Scene sc2 = scene_of("environment { sc2 }");
    CHECK_THAT(at_angle(sc2, 45), WithinAbs(1, 1e-12));
    CHECK_THAT(at_angle(sc2, 15), WithinAbs(0.5, 1e-12));
    CHECK(at_angle(sc2, 100) == 0);
    // Turned with the stone's table, here towards the viewer.
    const Scene turned = scene_of("environment { iso head 10 rotate -90*x }");
    CHECK(from(turned, {0, 0, -1}).s0 == 0);
    CHECK(from(turned, {0, 0.5, -std::sqrt(0.75)}).s0 == 1);
    CHECK(from(turned, {0, 0, 1}).s0 == 0);
}

TEST_CASE("the structured domes colour light by where it comes from", "[parser][environment]") {
    const auto colour = [](const Scene& scene, double angle) {
        Scene s = scene;
        s.camera.direction = {std::sin(angle * degree), std::cos(angle * degree), 0};
        s.camera.right = {0, 0, 1e-3};
        s.camera.up = 1e-3 * cross(normalised(s.camera.direction), Vec3{0, 0, 1});
        RenderOptions options;
        options.width = options.height = 1;
        options.samples = 8;
        const Image image = render(s, options).image;
        std::string name;
        for (std::size_t c = 0; c < 3; ++c) name += image.rgb[c] > 0.99 ? "RGB"[c] : '-';
        return name;
    };
    const Scene aset = scene_of("environment { aset }");
    CHECK(colour(aset, 5) == "--B");
    CHECK(colour(aset, 14) == "--B");
    CHECK(colour(aset, 16) == "R--");
    CHECK(colour(aset, 44) == "R--");
    CHECK(colour(aset, 46) == "-G-");
    CHECK(colour(aset, 89) == "-G-");
    CHECK(colour(aset, 91) == "---");
    const Scene scope = scene_of("environment { idealscope head 20 }");
    CHECK(colour(scope, 19) == "---");
    CHECK(colour(scope, 21) == "R--");
    CHECK(colour(scope, 120) == "RGB");
}

TEST_CASE("functions of x, y and z are light, of one expression or four", "[parser][environment]") {
    const Vec3 d{0.48, 0.6, 0.64};
    const auto value = [&](const std::string& f) {
        return from(scene_of("#declare A = 2; environment { function { " + f + " } }"), d).s0;
    };
    CHECK_THAT(value("A*y + 3"), WithinAbs(4.2, 1e-12));
    CHECK_THAT(value("max(0, x, y*1.1, z)"), WithinAbs(0.66, 1e-12));
    CHECK_THAT(value("x > 0.4 & !(y < z) ? 5 : 7"), WithinAbs(7, 1e-12));
    CHECK_THAT(value("-(-1) + pow(x, 2)/A - -abs(z - 1)"), WithinAbs(1 + 0.1152 + 0.36, 1e-12));
    const Scene four = scene_of("environment { function { 1, 0.3, 0.2, z*0.5 } illuminant \"A\" }");
    const Vec3 right = normalised(cross(Vec3{0, 1, 0}, d));
    const Stokes s = from(four, d, right);
    CHECK_THAT(s.s1, WithinAbs(0.3, 1e-12));
    CHECK_THAT(s.s2, WithinAbs(0.2, 1e-12));
    CHECK_THAT(s.s3, WithinAbs(0.32, 1e-12));
    CHECK(faulty("environment { function { 1, 2 } }", "the four of a Stokes vector, not 2"));
    CHECK(faulty("environment { function { x*q } }", "'q' is not declared"));
    CHECK(faulty("environment { function { atan2(y) } }", "takes 2 arguments"));
    const LoadResult dark = load_scene_text("environment { function { y } }", "t", ".");
    CHECK_THAT(messages(dark), Contains("negative or has no value towards <"));
    CHECK(dark.scene.has_value());
}

TEST_CASE("a sky's polarisation turns with it", "[parser][environment]") {
    const Scene turned = scene_of("environment { function { 1, 1, 0, 0 } rotate z*45 }");
    // Seen along z with y up: linear along x before, now at -45 or 45 degrees.
    const Stokes s = from(turned, {0, 0, 1});
    CHECK_THAT(std::abs(s.s2), WithinAbs(1, 1e-12));
    CHECK_THAT(s.s1, WithinAbs(0, 1e-12));
    // z*45 takes x towards y, whose field lies at +45 degrees.
    CHECK(s.s2 > 0);
    CHECK(faulty("environment { function { 1, x, 0, 0 } scale <1, 2, 1> }",
                 "can be turned, but not stretched"));
}

TEST_CASE("lamps of the sky are round, and add to it", "[parser][environment]") {
    const Scene scene = scene_of(
        "environment { uniform 0.5 lamps { disc y, 10, rgb 3  disc <1, 0, 1>, 5, 2 } rotate x*90 "
        "}");
    CHECK(scene.environment.discs.size() == 2);
    // y turned about x by the left hand goes towards z.
    CHECK_THAT(from(scene, {0, 0, 1}).s0, WithinAbs(scene.environment.below(589.3) + 3, 1e-9));
}

TEST_CASE("a sky_sphere's colour map is looked up as POV-Ray does", "[parser][environment]") {
    const Scene scene = scene_of(
        "sky_sphere { pigment { gradient y color_map { [0 rgb 0.2] [1 rgb 1] } scale 2 translate "
        "-1 } }");
    for (const double y : {-0.9, -0.2, 0.3, 0.99}) {
        CHECK_THAT(from(scene, {std::sqrt(1 - y * y), y, 0}, {0, 0, 1}).s0,
                   WithinAbs(0.2 + 0.8 * (y + 1) / 2, 1e-12));
    }
}

TEST_CASE("a panorama from a file surrounds the scene", "[parser][environment]") {
    const ScratchFolder folder;
    Image image;
    image.width = 4;
    image.height = 2;
    for (int i = 0; i < 8; ++i) image.rgb.insert(image.rgb.end(), 3, static_cast<float>(i));
    write_exr(image, folder / "sky.exr");
    const LoadResult result = load_scene_text(
        "environment { image \"sky.exr\" illuminant \"E\" 2 rotate y*90 }", "t", folder / "");
    INFO(messages(result));
    REQUIRE(result.scene);
    // y*90 takes +z to +x: the picture's middle, between 5 and 6 below the horizon.
    CHECK_THAT(from(*result.scene, normalised(Vec3{1, -1, 0}), {0, 0, 1}).s0,
               WithinAbs(2 * 5.5, 1e-9));
}

TEST_CASE("lamps of every kind have what POV-Ray gives them", "[parser][light]") {
    const auto light = [](const std::string& text) {
        const Scene scene = scene_of("light_source { <0, 5, 0>, rgb 1 " + text + " }");
        REQUIRE(scene.lights.size() == 1);
        return scene.lights[0];
    };
    const Light spot = light("spotlight radius 10 falloff 20 tightness 3 point_at <0, 0, 5>");
    CHECK(spot.kind == Light::Kind::spot);
    CHECK_THAT(spot.radius, WithinAbs(10 * degree, 1e-15));
    CHECK(spot.tightness == 3);
    CHECK(length(spot.direction - normalised(Vec3{0, -1, -1})) < 1e-15);
    const Light moved = light("spotlight point_at 0 rotate z*90");
    CHECK(length(moved.direction - Vec3{1, 0, 0}) < 1e-12);
    CHECK_THAT(moved.falloff, WithinAbs(45 * degree, 1e-15));
    const Light beam = light("cylinder radius 1 falloff 2 point_at 0 parallel shadowless");
    CHECK(beam.kind == Light::Kind::cylinder);
    CHECK(beam.parallel);
    CHECK(beam.shadowless);
    CHECK(beam.falloff == 2);
    CHECK(light("area_light x, z, 4, 4 circular orient").circular);
    CHECK(faulty("light_source { 0, rgb 1 spotlight point_at 0 }", "points at where it stands"));
}

TEST_CASE("cameras have lenses, analysers and fish eyes", "[parser][camera]") {
    const Camera lens =
        scene_of("camera { location -8*z look_at 0 aperture 0.4 focal_point -2*z blur_samples 50 }")
            .camera;
    CHECK_THAT(lens.lens_radius, WithinAbs(0.1, 1e-15));
    CHECK_THAT(lens.focal_distance, WithinAbs(6, 1e-12));
    CHECK(scene_of("camera { fisheye angle 220 look_at x }").camera.fisheye_angle == 220 * degree);
    const Scene right = scene_of(
        "camera { location -8*z look_at 0 analyser { circular right } }"
        "environment { uniform 1 polarised { circular right 1 } }");
    RenderOptions options;
    options.width = options.height = 1;
    options.samples = 8;
    CHECK_THAT(render(right, options).image.rgb[0], WithinAbs(1, 1e-6));
    const Scene linear = scene_of(
        "camera { location -8*z look_at 0 angle 0.1 analyser { linear 30 } }"
        "environment { uniform 1 polarised { linear 75 } }");
    CHECK_THAT(render(linear, options).image.rgb[0], WithinAbs(0.5, 1e-5));
    CHECK(faulty("camera { analyser { linear } }", "needs an angle in degrees"));
    CHECK(faulty("camera { location -8*z look_at 0 aperture 1 focal_point -9*z }",
                 "focal_point is not before it"));
}

TEST_CASE("sheets stand, turn and filter as they are written", "[parser][sheet]") {
    const Scene scene = scene_of(
        "sheet { <-5, -5, 0>, 10*x, 10*y polariser axis <1, 1, 0.5> rotate z*45 translate 2*z }"
        "sheet { <-5, -5, 0>, 10*x, 10*y waveplate 140 axis x }"
        "sheet { <-5, -5, 0>, 10*x, 10*y neutral 0.25 translate z }");
    REQUIRE(scene.things.size() == 3);
    const Filter& polariser = *scene.things[0].filter;
    // Laid into the sheet and turned by 45 degrees: along y.
    CHECK(std::abs(std::abs(polariser.axis.y) - 1) < 1e-12);
    CHECK(scene.things[1].filter->retardance_nm == 140);
    CHECK(scene.things[2].filter->transmission == 0.25);
    CHECK(std::abs(scene.things[0].to_world.point({0.5, 0, 0.5}).z + 2) < 1e-12);
    CHECK(faulty("sheet { 0, x, 2*x neutral 1 }", "its edges lie in a line"));
    CHECK(faulty("sheet { 0, x, y polariser axis z }", "the axis of a sheet lies in it"));
    CHECK(faulty("sheet { 0, x, y }", "this sheet is no filter"));
}

TEST_CASE("what is wrong between things is told at the stone, with a caret", "[parser][messages]") {
    const std::string gem = "gem { box { -1, 1 } interior { ior 1.5 } }\n";
    CHECK(faulty(gem + gem, "test.spar:1:1: error: this stone overlaps the one at test.spar:2"));
    CHECK(faulty("camera { location 0 look_at z }\n" + gem,
                 "test.spar:1:1: error: the camera is inside the stone at test.spar:2"));
    CHECK(faulty("sphere { 0, 1 pigment { Wheat } }", "it stands in #include \"colors.inc\""));
}
