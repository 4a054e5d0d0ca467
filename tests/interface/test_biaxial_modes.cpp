// Waves of biaxial crystals: optic axes, sheets, and the two waves of a ray.
#include <catch2/catch.hpp>
#include <numbers>

#include "interface/wave.hpp"
#include "math/error.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

Medium random_biaxial(Random& random) {
    const Vec3 x = random.direction();
    return Medium::biaxial(
        {random.uniform(1.4, 2.2), random.uniform(1.4, 2.2), random.uniform(1.4, 2.2)}, x,
        random.perpendicular_to(x));
}

}  // namespace

TEST_CASE("the optic axes of a biaxial crystal are the normals of equal indices",
          "[interface][biaxial]") {
    Random random(51);
    for (int i = 0; i < 200; ++i) {
        const Medium m = random_biaxial(random);
        const OpticAxes axes = optic_axes(m);
        CHECK(dot(axes.first, axes.second) == Approx(std::cos(axes.two_v_gamma)).margin(1e-12));
        for (const Vec3& axis : {axes.first, axes.second}) {
            const auto w = waves_along(m, axis, By::wave_normal, {0, 0, 1});
            CHECK(w[0].n_phase == Approx(m.n_principal[1]).epsilon(1e-14));
            CHECK(w[1].n_phase == Approx(m.n_principal[1]).epsilon(1e-14));
        }
    }
}

TEST_CASE("aragonite is negative with 2V of 18 degrees", "[interface][biaxial]") {
    // About n_alpha the angle is the small one.
    const Medium aragonite = Medium::biaxial({1.53013, 1.68157, 1.68589}, {1, 0, 0}, {0, 1, 0});
    const double about_alpha = 180 - optic_axes(aragonite).two_v_gamma * 180 / std::numbers::pi;
    CHECK(about_alpha == Approx(18).margin(0.5));
}

TEST_CASE("the indices of a wave normal follow its angles to the two optic axes",
          "[interface][biaxial]") {
    // 1/n^2 = mean + half difference cos(t1 +- t2) (Born & Wolf, 15.3.3).
    Random random(52);
    for (int i = 0; i < 500; ++i) {
        const Medium m = random_biaxial(random);
        const OpticAxes axes = optic_axes(m);
        const Vec3 u = random.direction();
        const double t1 = std::acos(dot(u, axes.first)), t2 = std::acos(dot(u, axes.second));
        const double a = std::pow(m.n_principal[0], -2), c = std::pow(m.n_principal[2], -2);
        const auto w = waves_along(m, u, By::wave_normal, {0, 0, 1});
        const double fast = (a + c) / 2 + (a - c) / 2 * std::cos(t1 + t2);
        const double slow = (a + c) / 2 + (a - c) / 2 * std::cos(t1 - t2);
        CHECK(w[0].mode == Mode::fast);
        CHECK(w[0].n_phase <= w[1].n_phase);
        CHECK(std::pow(w[0].n_phase, -2) == Approx(std::max(fast, slow)).epsilon(1e-12));
        CHECK(std::pow(w[1].n_phase, -2) == Approx(std::min(fast, slow)).epsilon(1e-12));
    }
}

TEST_CASE("waves in a biaxial crystal obey Maxwell's equations", "[interface][biaxial]") {
    Random random(53);
    for (int i = 0; i < 500; ++i) {
        const Medium m = random_biaxial(random);
        const Vec3 u = random.direction();
        for (const By by : {By::wave_normal, By::ray}) {
            const auto waves = waves_along(m, u, by, {0, 0, 1});
            for (const Wave& w : waves) {
                CHECK(length(w.E) == Approx(1).epsilon(1e-14));
                CHECK(length(cross(w.k, w.H) + m.permittivity() * w.E) < 1e-13);
                CHECK(length(w.ray - normalised(real(cross(w.E, conj(w.H))))) < 1e-13);
                CHECK(w.n_ray == Approx(dot(real(w.k), w.ray)).epsilon(1e-14));
            }
            CHECK(std::abs(dot(waves[0].E, m.permittivity() * waves[1].E)) < 1e-13);
        }
    }
}

TEST_CASE("every wave is found again by its ray", "[interface][biaxial]") {
    Random random(54);
    for (int i = 0; i < 1000; ++i) {
        const Medium m = random_biaxial(random);
        for (const Wave& w : waves_along(m, random.direction(), By::wave_normal, {0, 0, 1})) {
            double nearest = 1;
            for (const Wave& v : waves_along(m, w.ray, By::ray, {0, 0, 1})) {
                const double d = length(v.k - w.k);
                if (d < nearest) {
                    nearest = d;
                    if (d < 1e-12) CHECK(v.mode == w.mode);
                }
            }
            CHECK(nearest < 1e-9);
        }
    }
}

TEST_CASE("rays of an optic axis lie on the cone of internal conical refraction",
          "[interface][biaxial]") {
    // Opening angle: tan(A) = sqrt((nb^2 - na^2)(nc^2 - nb^2)) / (na nc) (Born & Wolf, 15.3.4).
    const double a = 1.53013, b = 1.68157, c = 1.68589;  // aragonite, D line
    const Medium m = Medium::biaxial({a, b, c}, {1, 0, 0}, {0, 1, 0});
    const double opening = std::atan(std::sqrt((b * b - a * a) * (c * c - b * b)) / (a * c));
    const Vec3 axis = optic_axes(m).first;
    // In the plane of the axes one wave has its ray along the axis, the other at the full angle.
    const auto w =
        waves_along(m, normalised(axis + 1e-7 * Vec3{0, 0, 1}), By::wave_normal, {0, 0, 1});
    const double first = std::acos(std::min(1.0, dot(w[0].ray, axis))),
                 second = std::acos(std::min(1.0, dot(w[1].ray, axis)));
    CHECK(std::min(first, second) < 1e-4);
    CHECK(std::max(first, second) == Approx(opening).epsilon(1e-4));
    CHECK(opening * 180 / std::numbers::pi == Approx(1.87).margin(0.02));
}

TEST_CASE("modes that a medium does not have are refused", "[interface][biaxial]") {
    const Medium m = Medium::biaxial({1.5, 1.6, 1.7}, {1, 0, 0}, {0, 1, 0});
    CHECK_THROWS_AS(plane_wave(m, Mode::ordinary, {0, 0, 1}, By::wave_normal, {0, 0, 1}), Error);
    CHECK_THROWS_AS(
        plane_wave(Medium::isotropic(1.5), Mode::fast, {0, 0, 1}, By::wave_normal, {0, 0, 1}),
        Error);
}
