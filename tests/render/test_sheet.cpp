// Polarisers, wave plates and grey filters between the camera and the light.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;
using std::numbers::pi;

namespace {

/// A sheet across the z axis at this height, its axis turned from x towards y.
Thing sheet_at(double z, Filter::Kind kind, double degrees = 0) {
    Thing thing;
    thing.shape = SquareShape{};
    thing.finish = {0, 0};
    thing.to_world = Transform({Vec3{20, 0, 0}, Vec3{0, 0, 20}, Vec3{0, -1, 0}}, {-10, -10, z});
    Filter filter;
    filter.kind = kind;
    filter.axis = {std::cos(degrees * degree), std::sin(degrees * degree), 0};
    thing.filter = filter;
    return thing;
}

Thing plate_at(double z, double degrees, double retardance_nm) {
    Thing thing = sheet_at(z, Filter::Kind::waveplate, degrees);
    thing.filter->retardance_nm = retardance_nm;
    return thing;
}

Scene behind(std::vector<Thing> sheets, const Stokes& light = {1, 0, 0, 0}) {
    Scene scene;
    scene.environment = furnace();
    scene.environment.state = light;
    scene.things = std::move(sheets);
    return scene;
}

/// Seen from +z along -z: x of the picture is x.
Stokes seen(const Scene& scene, const TraceOptions& options = {}) {
    return trace_one(scene, {{0.3, -0.2, 9}, {0, 0, -1}, {1, 0, 0}}, options);
}

constexpr auto polariser = Filter::Kind::polariser;

}  // namespace

TEST_CASE("a polariser passes half of natural light, all of it polarised along its axis",
          "[sheet]") {
    for (const double angle : {0.0, 20.0, 45.0, 90.0, 130.0}) {
        const Stokes s = seen(behind({sheet_at(0, polariser, angle)}));
        const double two = 2 * angle * degree;
        CHECK(difference(s, {0.5, 0.5 * std::cos(two), 0.5 * std::sin(two), 0}) < 1e-15);
    }
}

TEST_CASE("two polarisers pass the squared cosine of the angle between them (Malus)", "[sheet]") {
    for (double angle = 0; angle <= 180; angle += 7.5) {
        const Scene scene =
            behind({sheet_at(0, polariser, 12), sheet_at(1, polariser, 12 + angle)});
        const double c = std::cos(angle * degree);
        CAPTURE(angle);
        CHECK_THAT(seen(scene).s0, WithinAbs(0.5 * c * c, 1e-15));
    }
    CHECK(seen(behind({sheet_at(0, polariser, 30), sheet_at(1, polariser, 120)})).s0 < 1e-31);
    // A third one between crossed ones lets light through again, at 45 degrees an eighth.
    CHECK_THAT(seen(behind({sheet_at(0, polariser, 0), sheet_at(1, polariser, 45),
                            sheet_at(2, polariser, 90)}))
                   .s0,
               WithinAbs(0.125, 1e-15));
}

TEST_CASE(
    "a quarter-wave plate with its fast axis on x turns +45 light left-circular, as its "
    "Mueller matrix does",
    "[sheet][convention]") {
    const TraceOptions at{.wavelength_nm = 560};
    const Stokes left = seen(behind({plate_at(0, 0, 140)}, {1, 0, 1, 0}), at);
    CHECK(difference(left, {1, 0, 0, -1}) < 1e-14);
    Random random(3);
    for (int i = 0; i < 50; ++i) {
        const Vec3 p = random.uniform() * random.direction();
        const double angle = 360 * random.uniform(), path = 900 * random.uniform();
        const Stokes light{1, p.x, p.y, p.z};
        const Stokes expected = linear_retarder(2 * pi * path / 560, angle * degree) * light;
        CHECK(difference(seen(behind({plate_at(0, angle, path)}, light), at), expected) < 1e-13);
    }
}

TEST_CASE("a full-wave plate between crossed polarisers is dark at its own wavelength alone",
          "[sheet]") {
    const Scene scene =
        behind({sheet_at(0, polariser, 0), plate_at(1, 45, 550), sheet_at(2, polariser, 90)});
    CHECK(seen(scene, {.wavelength_nm = 550}).s0 < 1e-28);
    for (const double nm : {400.0, 480.0, 650.0, 760.0}) {
        const double s = std::sin(pi * 550 / nm);
        CHECK_THAT(seen(scene, {.wavelength_nm = nm}).s0, WithinAbs(0.5 * s * s, 1e-14));
    }
    // Its picture is magenta, the sensitive tint: red and blue, and little green.
    Scene picture = scene;
    picture.camera = towards_origin(2);
    const Image image = render(picture, small(4, 512)).image;
    const double red = mean_of(image.rgb, 0, 3), green = mean_of(image.rgb, 1, 3),
                 blue = mean_of(image.rgb, 2, 3);
    CHECK(red > 3 * std::max(green, 0.0));
    CHECK(blue > 3 * std::max(green, 0.0));
}

TEST_CASE("at a slant a polariser stops the field along its fibres, and nothing else", "[sheet]") {
    Random random(17);
    for (int i = 0; i < 100; ++i) {
        const double angle = 180 * random.uniform();
        const Scene scene = behind({sheet_at(0, polariser, angle)});
        const Vec3 d = normalised(Vec3{0.5 * random.direction().x, 0.5 * random.direction().y, -1});
        const Vec3 x = random.perpendicular_to(d);
        const Stokes s = trace_one(scene, {-3.0 * d, d, x});
        CHECK_THAT(s.s0, WithinAbs(0.5, 1e-14));
        CHECK_THAT(polarised_part(s), WithinAbs(0.5, 1e-14));
        // The direction of its field, across the fibres and the ray.
        const Vec3 fibres{-std::sin(angle * degree), std::cos(angle * degree), 0};
        const Vec3 e = normalised(cross(d, fibres)), y = cross(-d, x);
        const double ex = dot(e, x), ey = dot(e, y);
        CHECK(difference(s, {0.5, 0.5 * (ex * ex - ey * ey), ex * ey, 0}) < 1e-14);
    }
}

TEST_CASE("a grey filter takes its share, polarised or not", "[sheet]") {
    Thing grey = sheet_at(0, Filter::Kind::neutral);
    grey.filter->transmission = 0.3;
    CHECK(difference(seen(behind({grey}, {1, 0.2, -0.3, 0.4})), {0.3, 0.06, -0.09, 0.12}) < 1e-15);
    grey.filter->transmission = 0;
    CHECK(seen(behind({grey})).s0 == 0);
}

TEST_CASE("a lamp lights the floor through a polariser by half, and not through crossed ones",
          "[sheet][surface]") {
    Scene scene = lit_floor(lamp_at({0, 0, 10}));
    scene.things[0].to_world = Transform({Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}, {});
    const SensorRay ray{{0, 0, 2}, {0, 0, -1}, {1, 0, 0}};
    const double bare = trace_one(scene, ray).s0;
    scene.things.push_back(sheet_at(5, polariser, 10));
    CHECK_THAT(trace_one(scene, ray).s0, WithinAbs(0.5 * bare, 1e-12));
    scene.things.push_back(sheet_at(6, polariser, 70));
    CHECK_THAT(trace_one(scene, ray).s0, WithinAbs(0.125 * bare, 1e-12));
    scene.things.push_back(sheet_at(7, polariser, 160));
    CHECK(trace_one(scene, ray).s0 < 1e-30);
}

TEST_CASE(
    "a stone between crossed polarisers is dark where it does not turn the light, and a sheet "
    "may not run through it",
    "[sheet]") {
    Scene scene = scene_of(cube_stone(), glass(1.5));
    scene.things = {sheet_at(-3, polariser, 0), sheet_at(3, polariser, 90)};
    // From the front the stone's face mirrors what the analyser has passed.
    CHECK(seen(scene).s0 > 0.01);
    Formula from_behind;
    from_behind.variable(2);
    from_behind.apply([](double z, double) { return z < 0 ? 1.0 : 0.0; }, 1);
    scene.environment.formulas = {from_behind};
    CHECK(seen(scene).s0 < 1e-28);
    scene.gems[0].crystal = calcite({1, 0, 0});
    CHECK(seen(scene).s0 < 1e-28);
    scene.gems[0].crystal = calcite(normalised(Vec3{1, 1, 0}));
    CHECK(seen(scene).s0 > 0.1);
    scene.things[0] = sheet_at(0.5, polariser, 0);
    const auto problems = faults(scene);
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Matchers::Contains("a sheet runs through this stone"));
    scene.things[0] = sheet_at(-1, polariser, 0);
    CHECK(faults(scene).empty());
}
