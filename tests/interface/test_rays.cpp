// Waves by the direction of their energy in absorbing and active media, and the order of fast and
// slow.
#include <catch2/catch.hpp>

#include "interface/interface.hpp"
#include "math/error.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

/// A crystal that absorbs by up to `kappa`, or turns light by up to `gyration`.
Medium draw(Random& random, double kappa, double gyration) {
    const Vec3 x = random.direction();
    const auto index = [&] {
        return Complex(random.uniform(1.4, 2), kappa * random.uniform(0.1, 1));
    };
    if (gyration == 0 && random.uniform() < 0.5) {
        return Medium::biaxial({index(), index(), index()}, x, random.perpendicular_to(x));
    }
    Medium m = Medium::uniaxial(index(), index(), x);
    m.gyration = gyration * random.uniform(-1, 1);
    m.gyration_along = gyration * random.uniform(-1, 1);
    return m;
}

double violation(const Medium& m, const Wave& w) {
    const Complex i(0, 1);
    const auto turned = [&](const CVec3& v) {
        return m.gyration * v +
               ((m.gyration_along - m.gyration) * dot(m.axis, v)) * complexified(m.axis);
    };
    return length(cross(w.k, w.H) + m.permittivity() * w.E + i * turned(w.H)) +
           length(cross(w.k, w.E) - w.H + i * turned(w.E)) +
           length(normalised(real(cross(w.E, conj(w.H)))) - w.ray);
}

}  // namespace

TEST_CASE("in absorbing and active crystals the energy of a wave flows along the ray asked for",
          "[interface][rays]") {
    Random random(61);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
        const bool active = i % 2 == 0;
        const Medium m = draw(random, active ? 0 : random.power_of_ten(-8, -1),
                              active ? random.power_of_ten(-6, -1.5) : 0);
        const Vec3 ray = random.direction();
        const WavesOfRay found = waves_of_ray(m, ray);
        refused += found.count < 2;
        for (std::size_t j = 0; j < found.count; ++j) {
            const Wave& w = found.waves[j];
            CHECK(length(w.ray - ray) < 1e-12);
            CHECK(violation(m, w) < 1e-12);
            CHECK(w.n_ray == Approx(dot(real(w.k), ray)).epsilon(1e-11));
            for (std::size_t other = 0; other < j; ++other) {
                const double same = std::norm(dot(conj(w.E), found.waves[other].E));
                CHECK(length(w.k - found.waves[other].k) + 1 - same > 1e-7);
            }
        }
    }
    CHECK(refused == 0);
}

TEST_CASE("a wave in an absorbing or active crystal is found again by its ray",
          "[interface][rays]") {
    Random random(62);
    int lost = 0, all = 0;
    for (int i = 0; i < 150; ++i) {
        const bool active = i % 2 == 0;
        const Medium m = draw(random, active ? 0 : random.power_of_ten(-6, -1),
                              active ? random.power_of_ten(-6, -2) : 0);
        for (const Wave& w : waves_along(m, random.direction(), By::wave_normal, {0, 0, 1})) {
            const WavesOfRay found = waves_of_ray(m, w.ray);
            double nearest = 1;
            for (std::size_t j = 0; j < found.count; ++j) {
                nearest = std::min(nearest, length(found.waves[j].k - w.k));
            }
            ++all;
            lost += !(nearest < 1e-8);
        }
    }
    INFO(lost << " of " << all);
    CHECK(lost == 0);
}

TEST_CASE("rays of a crystal whose loss and activity fade are those of the transparent crystal",
          "[interface][rays]") {
    Random random(63);
    for (int i = 0; i < 60; ++i) {
        const Vec3 x = random.direction(), y = random.perpendicular_to(x), ray = random.direction();
        const std::array<Complex, 3> clear{1.5, 1.6, 1.75};
        auto dark = clear;
        for (auto& n : dark) n += Complex(0, 1e-10);
        const auto a = waves_along(Medium::biaxial(clear, x, y), ray, By::ray, {0, 0, 1}),
                   b = waves_along(Medium::biaxial(dark, x, y), ray, By::ray, {0, 0, 1});
        const double straight = length(a[0].k - b[0].k) + length(a[1].k - b[1].k),
                     crossed = length(a[0].k - b[1].k) + length(a[1].k - b[0].k);
        CHECK(std::min(straight, crossed) < 1e-8);
    }
}

TEST_CASE("beside an optic axis an active biaxial crystal has four waves for some rays",
          "[interface][rays]") {
    // Activity rounds off the point where the sheets touch; the outer one keeps a dimple there.
    Medium m = Medium::biaxial({1.5, 1.6, 1.75}, {1, 0, 0}, {0, 1, 0});
    m.gyration = m.gyration_along = 1e-3;
    const Vec3 axis = optic_axes(m).first;
    std::size_t most = 0;
    for (int i = -30; i < 30; i += 3) {
        for (int j = -30; j < 30; j += 3) {
            const Vec3 ray = normalised(axis + Vec3{0.003 * i, 0.003 * j, 0});
            most = std::max(most, waves_of_ray(m, ray).count);
        }
    }
    CHECK(most == 4);
}

TEST_CASE("the fast wave never has the larger index, and its wave vector never jumps",
          "[interface][biaxial]") {
    Random random(64);
    for (int i = 0; i < 30; ++i) {
        const Vec3 x = random.direction(), a = random.direction(), b = random.perpendicular_to(a);
        const Medium m = Medium::biaxial({1.5, 1.58, 1.75}, x, random.perpendicular_to(x));
        std::array<Vec3, 2> before{};
        constexpr int steps = 400;
        for (int s = 0; s <= steps; ++s) {
            const double angle = 6.283185307179586 * s / steps;
            const Vec3 d = std::cos(angle) * a + std::sin(angle) * b;
            const auto w = waves_along(m, d, By::wave_normal, d);
            CHECK(w[0].mode == Mode::fast);
            CHECK(w[1].mode == Mode::slow);
            CHECK(w[0].n_phase <= w[1].n_phase);
            for (std::size_t j = 0; j < 2; ++j) {
                const Vec3 k = real(w[j].k);
                if (s > 0) CHECK(length(k - before[j]) < 1.3 * 1.75 * 6.3 / steps);
                before[j] = k;
            }
        }
    }
}

TEST_CASE("fast and slow keep their names as a crystal turns behind its face",
          "[interface][biaxial]") {
    Random random(65);
    const Medium air = Medium::isotropic(1);
    const Vec3 n{0, 0, 1};
    const Wave in = plane_wave(air, Mode::p, normalised(Vec3{0.6, 0, 0.7}), By::wave_normal, n);
    for (int i = 0; i < 30; ++i) {
        const Vec3 x = random.direction(), y = random.perpendicular_to(x),
                   about = random.direction();
        std::array<double, 2> before{};
        constexpr int steps = 400;
        for (int s = 0; s <= steps; ++s) {
            const double angle = 6.283185307179586 * s / steps;
            const auto turned = [&](const Vec3& v) {
                return std::cos(angle) * v + std::sin(angle) * cross(about, v) +
                       (1 - std::cos(angle)) * dot(about, v) * about;
            };
            const Medium m = Medium::biaxial({1.5, 1.58, 1.75}, turned(x), turned(y));
            const Interface face(air, m, n, in);
            for (std::size_t j = 0; j < 2; ++j) {
                const double q = face.transmitted(j).k.z.real();
                if (s > 0) CHECK(std::abs(q - before[j]) < 0.01);
                before[j] = q;
            }
            CHECK(before[0] <= before[1]);
        }
    }
}
