// Spots, cylinders, parallel beams and lamps without shadow, as POV-Ray has them.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/lamp.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

Light spot(double radius, double falloff, double tightness) {
    Light light = lamp_at({0, 10, 0});
    light.kind = Light::Kind::spot;
    light.direction = {0, -1, 0};
    light.radius = radius * degree;
    light.falloff = falloff * degree;
    light.tightness = tightness;
    return light;
}

double strength(const Light& light, double x) {
    return lamp_ray(light, {x, 0, 0}, 0.5, 0.5).strength;
}

}  // namespace

TEST_CASE("a spot is full within its radius, dark beyond its falloff, and halfway half", "[lamp]") {
    const Light light = spot(10, 20, 0);
    CHECK(strength(light, 0) == 1);
    CHECK(strength(light, 10 * std::tan(9.9 * degree)) == 1);
    CHECK(strength(light, 10 * std::tan(20.1 * degree)) == 0);
    const double middle = std::acos(0.5 * (std::cos(10 * degree) + std::cos(20 * degree)));
    CHECK_THAT(strength(light, 10 * std::tan(middle)), WithinAbs(0.5, 1e-12));
    // Tightness is a power of the cosine.
    CHECK_THAT(strength(spot(40, 50, 7), 10 * std::tan(30 * degree)),
               WithinAbs(std::pow(std::cos(30 * degree), 7), 1e-12));
    // Nothing is lit behind it.
    CHECK(lamp_ray(light, {0, 20, 0}, 0.5, 0.5).strength == 0);
}

TEST_CASE("a cylinder of light keeps its width, whatever the distance", "[lamp]") {
    Light light = lamp_at({0, 10, 0});
    light.kind = Light::Kind::cylinder;
    light.radius = 1;
    light.falloff = 4;
    for (const double y : {0.0, 5.0, -100.0}) {
        const auto at = [&](double x) { return lamp_ray(light, {x, y, 0}, 0.5, 0.5).strength; };
        CHECK(at(0.9) == 1);
        CHECK(at(4.1) == 0);
        CHECK_THAT(at(2.5), WithinAbs(0.5, 1e-12));
    }
    CHECK(lamp_ray(light, {0, 11, 0}, 0.5, 0.5).strength == 0);
}

TEST_CASE("parallel light falls on every point from one direction", "[lamp][surface]") {
    Light light = lamp_at({3, 10, 0});
    light.parallel = true;
    light.direction = normalised(Vec3{1, -1, 0});
    Scene scene = lit_floor(light);
    for (const double x : {-50.0, 0.0, 80.0}) {
        CHECK_THAT(seen_at(scene, x, 1), WithinAbs(std::sqrt(0.5), 1e-12));
    }
    // A ball's shadow is as wide as the ball.
    scene.things.push_back(ball({0, 5, 0}, 1));
    CHECK(seen_at(scene, 5, 0.99) == 0);
    CHECK(seen_at(scene, 5, 1.01) > 0.7);
    CHECK(seen_at(scene, 5 + 1.40, 0) == 0);
    CHECK(seen_at(scene, 5 + 1.43, 0) > 0.7);
    scene.lights[0].shadowless = true;
    CHECK_THAT(seen_at(scene, 5, 0), WithinAbs(std::sqrt(0.5), 1e-12));
}

TEST_CASE("a round lamp spreads over its disc, and a turned one faces what it lights", "[lamp]") {
    Light light = lamp_at({0, 10, 0});
    light.edge_u = {4, 0, 0};
    light.edge_v = {0, 0, 2};
    light.circular = true;
    Random random(9);
    double mean = 0, mean_square = 0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const LampRay ray = lamp_ray(light, {0, 0, 0}, random.uniform(), random.uniform());
        const Vec3 p = ray.distance * ray.to_lamp;
        CHECK(p.x * p.x / 4 + p.z * p.z / 1 <= 1 + 1e-12);
        mean += p.x / count;
        mean_square += p.x * p.x / count;
    }
    // Uniform over an ellipse of half axis 2: variance 1.
    CHECK(std::abs(mean) < 0.03);
    CHECK(std::abs(mean_square - 1) < 0.04);
    light.orient = true;
    const Vec3 point{7, -3, 2};
    const Vec3 facing = normalised(light.position - point);
    for (int i = 0; i < 50; ++i) {
        const LampRay ray = lamp_ray(light, point, random.uniform(), random.uniform());
        const Vec3 p = point + ray.distance * ray.to_lamp;
        CHECK(std::abs(dot(p - light.position, facing)) < 1e-12);
    }
}
