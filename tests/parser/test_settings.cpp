// What holds for a whole scene: the unit of its lengths.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::WithinRel;

namespace {

const std::string scene =
    "camera { location <0, 2, -8> look_at 0 angle 20 aperture 0.4 focal_point 0 }\n"
    "gem { box { -1, 1 } interior { ior 1.5 fade_distance 3 fade_power 1000 fade_color rgb 0.5 } "
    "}\n"
    "sphere { <4, 0, 0>, 2 pigment { checker rgb 1, rgb 0 } }\n"
    "light_source { <0, 9, 0>, rgb 1 cylinder radius 1 falloff 2 point_at 0 fade_distance 5 "
    "fade_power 2 }\n"
    "light_source { <3, 9, 0>, rgb 1 area_light x, z, 2, 2 }\n";

}  // namespace

TEST_CASE("lengths in centimetres are ten times those in millimetres", "[parser][settings]") {
    const Scene mm = scene_of("global_settings { unit mm }\n" + scene);
    for (const char* unit : {"unit cm", "unit 10", "mm_per_unit 10"}) {
        INFO(unit);
        const Scene cm = scene_of("global_settings { " + std::string(unit) + " }\n" + scene);
        CHECK(length(cm.camera.location - 10 * mm.camera.location) < 1e-12);
        CHECK_THAT(cm.camera.lens_radius, WithinRel(10 * mm.camera.lens_radius, 1e-14));
        CHECK_THAT(cm.camera.focal_distance, WithinRel(10 * mm.camera.focal_distance, 1e-14));
        CHECK_THAT(cm.gems[0].stone.volume, WithinRel(1000 * mm.gems[0].stone.volume, 1e-12));
        // What a stretch of the same picture takes is the same.
        CHECK_THAT(cm.gems[0].crystal.fade->transmittance(20, 550),
                   WithinRel(mm.gems[0].crystal.fade->transmittance(2, 550), 1e-14));
        CHECK(length(cm.things[0].to_world.point({1, 0, 0}) -
                     10 * mm.things[0].to_world.point({1, 0, 0})) < 1e-12);
        CHECK(length(cm.things[0].pigment.to_pattern.point({25, 10, -5}) - Vec3{2.5, 1, 0.5}) <
              1e-14);
        CHECK(cm.lights[0].radius == 10);
        CHECK(cm.lights[0].falloff == 20);
        CHECK(cm.lights[0].fade_distance == 50);
        CHECK(length(cm.lights[1].edge_u) == 10);
    }
    CHECK_THAT(scene_of("global_settings { unit in }\n" + scene).camera.location.y,
               WithinRel(2 * 25.4, 1e-14));
    CHECK(faulty("global_settings { unit inch }", "'inch' is not declared"));
}
