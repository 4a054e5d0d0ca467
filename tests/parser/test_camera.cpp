// The camera is POV-Ray 3.7's: closed forms, and views that were measured in its pictures.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::WithinAbs;

namespace {

Camera camera_of(const std::string& items) { return scene_of("camera { " + items + " }").camera; }

void check(const Vec3& v, const Vec3& expected, double tolerance = 1e-12) {
    CHECK_THAT(v.x, WithinAbs(expected.x, tolerance));
    CHECK_THAT(v.y, WithinAbs(expected.y, tolerance));
    CHECK_THAT(v.z, WithinAbs(expected.z, tolerance));
}

}  // namespace

TEST_CASE("a camera of which nothing is said looks along z, 1.33 wide", "[camera]") {
    for (const Camera& camera : {camera_of(""), scene_of("").camera}) {
        check(camera.location, {0, 0, 0});
        check(camera.direction, {0, 0, -1});
        check(camera.right, {1.33, 0, 0});
        check(camera.up, {0, 1, 0});
    }
}

TEST_CASE("look_at turns the camera and keeps its vectors' lengths", "[camera]") {
    const Camera camera =
        camera_of("location <3, 0, 0> direction z*2 right x*1.5 up y*0.5 look_at 0");
    check(camera.location, {3, 0, 0});
    check(camera.direction, {-2, 0, 0});
    // Looking along -x with y up, z (towards +z of the language, -z of the core) is to the right.
    check(camera.right, {0, 0, -1.5});
    check(camera.up, {0, 0.5, 0});
}

TEST_CASE("angle is the horizontal angle of view, in whatever order the items stand", "[camera]") {
    for (const auto* items : {"angle 90 right x*2 location -z*5 look_at 0",
                              "look_at 0 location -z*5 right x*2 angle 90"}) {
        const Camera camera = camera_of(items);
        CHECK_THAT(length(camera.direction), WithinAbs(1, 1e-12));
        check(camera.location, {0, 0, 5});
    }
}

TEST_CASE("sky says where up is, and a negative right mirrors the view", "[camera]") {
    const Camera tilted = camera_of("location -z look_at 0 sky x");
    check(tilted.up, {1, 0, 0});
    check(tilted.right, {0, -1.33, 0});
    const Camera left_handed = camera_of("right -x*1.33 location -z look_at 0");
    check(left_handed.right, {-1.33, 0, 0});
    check(left_handed.up, {0, 1, 0});
}

TEST_CASE("straight down, the picture's top is towards z", "[camera]") {
    const Camera camera = camera_of("location y*5 look_at 0");
    check(camera.direction, {0, -1, 0});
    check(camera.right, {1.33, 0, 0});
    check(camera.up, {0, 0, -1});
}

TEST_CASE("transforms move the camera after look_at wherever they stand", "[camera]") {
    const Camera after =
        camera_of("location <1, 2, -5> look_at y angle 30 rotate <10, 20, 30> translate x");
    const Camera before =
        camera_of("rotate <10, 20, 30> translate x look_at y angle 30 location <1, 2, -5>");
    check(after.location, before.location);
    check(after.direction, before.direction);
    check(after.right, before.right);
    check(camera_of("location -z*5 look_at 0 rotate y*90").location, {-5, 0, 0});
}

TEST_CASE("a parallel view shows at the point looked at what a perspective one would",
          "[camera][orthographic]") {
    const std::string place = "location <1, 3, -5> look_at <0.3, 0.4, 0.2> ";
    const double distance = std::sqrt(0.7 * 0.7 + 2.6 * 2.6 + 5.2 * 5.2);
    const Camera wide = camera_of("orthographic " + place + "angle 24");
    const double width = 2 * distance * std::tan(12 * std::numbers::pi / 180);
    CHECK_THAT(length(wide.right), WithinAbs(width, 1e-12));
    CHECK_THAT(length(wide.up), WithinAbs(width / 1.33, 1e-12));
    // Measured in POV-Ray 3.7's picture of this camera: 2.490 by 1.875.
    CHECK_THAT(length(wide.right), WithinAbs(2.490, 2e-3));
    CHECK_THAT(length(wide.up), WithinAbs(1.875, 4e-3));

    const Camera plain = camera_of("orthographic " + place);
    CHECK_THAT(length(plain.right), WithinAbs(1.33 * distance, 1e-12));
    const Camera zoomed = camera_of("orthographic " + place + "direction z*3");
    CHECK_THAT(length(zoomed.up), WithinAbs(distance / 3, 1e-12));
    const Camera sized = camera_of("orthographic " + place + "right x*3 up y*2");
    CHECK_THAT(length(sized.right), WithinAbs(3, 1e-12));
    CHECK_THAT(length(sized.up), WithinAbs(2, 1e-12));
}
