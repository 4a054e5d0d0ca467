// Optically active crystals: rotary power, handedness, and the boundary problem.
#include <catch2/catch.hpp>
#include <numbers>

#include "interface/interface.hpp"
#include "polarisation/stokes.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr double n_o = 1.5442, n_e = 1.5533, rho = 21.75, wavelength = 589.3;  // quartz, D line

Stokes seen_along_z(const CVec3& E) { return stokes_from_field(E.x, E.y); }

/// Angle by which linear light along x turns over a length along z, towards y.
double turned(const Medium& crystal, double length_mm) {
    const auto waves = waves_along(crystal, {0, 0, 1}, By::wave_normal, {0, 0, 1});
    const double k0 = 2 * std::numbers::pi / (wavelength * 1e-6);
    CVec3 out{};
    for (const Wave& w : waves) {
        const Complex amplitude = std::conj(w.E.x) / (std::norm(w.E.x) + std::norm(w.E.y));
        out += amplitude * std::exp(Complex(0, k0 * length_mm * w.k.z.real())) * w.E;
    }
    const Stokes s = seen_along_z(out);
    CHECK(std::abs(s.s3) < 1e-9);
    return 0.5 * std::atan2(s.s2, s.s1);
}

Medium quartz(double rotation, const Vec3& axis = {0, 0, 1}, double ratio = -0.5) {
    return Medium::active(n_o, n_e, axis, rotation, wavelength, ratio);
}

}  // namespace

TEST_CASE("a dextrorotatory crystal turns light clockwise for the receiver",
          "[interface][activity][convention]") {
    // Clockwise for one who sees x to the right and y up: from x towards -y.
    const double degree = std::numbers::pi / 180;
    CHECK(turned(quartz(rho), 1) == Approx(-rho * degree).epsilon(1e-9));
    CHECK(turned(quartz(-rho), 1) == Approx(rho * degree).epsilon(1e-9));
    CHECK(turned(quartz(rho), 3) == Approx(-3 * rho * degree).epsilon(1e-9));
}

TEST_CASE("right circular light is the faster one in dextrorotatory quartz",
          "[interface][activity][convention]") {
    const auto waves = waves_along(quartz(rho), {0, 0, 1}, By::wave_normal, {0, 0, 1});
    CHECK(waves[0].mode == Mode::fast);
    CHECK(seen_along_z(waves[0].E).s3 == Approx(1).epsilon(1e-12));
    CHECK(seen_along_z(waves[1].E).s3 == Approx(-1).epsilon(1e-12));
    const double difference = waves[1].n_phase - waves[0].n_phase;
    CHECK(difference == Approx(rho * wavelength * 1e-6 / 180).epsilon(1e-10));
    CHECK(difference == Approx(7.12e-5).epsilon(1e-3));
}

TEST_CASE("the waves of quartz are almost linear a few degrees from its axis",
          "[interface][activity]") {
    // Ellipticity b/a = tan(chi), tan(2 chi) = 2 n G / (difference of the linear indices).
    const auto chi = [](double angle) {
        const double t = angle * std::numbers::pi / 180;
        const Vec3 u{std::sin(t), 0, std::cos(t)};
        const auto w = waves_along(quartz(rho, {0, 0, 1}, 0), u, By::wave_normal, {0, 0, 1});
        const Vec3 x{std::cos(t), 0, -std::sin(t)};
        const Stokes s = stokes_from_field(dot(w[0].E, x), w[0].E.y);
        return 0.5 * std::asin(s.s3 / s.s0);
    };
    for (const double angle : {1.0, 3.0, 5.0, 10.0}) {
        const double t = angle * std::numbers::pi / 180;
        const double ne =
            1 / std::sqrt(std::pow(std::cos(t) / n_o, 2) + std::pow(std::sin(t) / n_e, 2));
        const double circular = rho * wavelength * 1e-6 / 180 * std::pow(std::cos(t), 2);
        CHECK(std::tan(2 * chi(angle)) == Approx(circular / (ne - n_o)).epsilon(2e-3));
    }
    CHECK(std::tan(chi(90)) == Approx(0).margin(1e-12));
}

TEST_CASE("waves in an active crystal obey Maxwell's equations", "[interface][activity]") {
    Random random(31);
    for (int i = 0; i < 200; ++i) {
        const Medium m =
            Medium::active(1.5 + random.uniform(), 1.5 + random.uniform(), random.direction(),
                           random.uniform(-1e4, 1e4), wavelength, random.uniform(-1, 1));
        for (const Wave& w : waves_along(m, random.direction(), By::wave_normal, {0, 0, 1})) {
            const auto alpha = [&](const CVec3& v) {
                return m.gyration * v +
                       ((m.gyration_along - m.gyration) * dot(m.axis, v)) * complexified(m.axis);
            };
            const Complex i1(0, 1);
            const CVec3 D = m.permittivity() * w.E + i1 * alpha(w.H), B = w.H - i1 * alpha(w.E);
            CHECK(length(cross(w.k, w.E) - B) < 1e-13);
            CHECK(length(cross(w.k, w.H) + D) < 1e-13);
        }
    }
}

TEST_CASE("active crystals conserve energy and are reciprocal", "[interface][activity][energy]") {
    Random random(33);
    double energy = 0, reciprocity = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto draw = [&]() -> Medium {
            const double kind = random.uniform();
            if (kind < 0.25) return Medium::isotropic(random.uniform(1, 2.5));
            if (kind < 0.4)
                return Medium::uniaxial(random.uniform(1.3, 2), random.uniform(1.3, 2),
                                        random.direction());
            return Medium::active(random.uniform(1.3, 2), random.uniform(1.3, 2),
                                  random.direction(), random.sign() * random.power_of_ten(0, 4),
                                  wavelength, random.uniform(-1, 1));
        };
        const Medium from = draw(), to = draw();
        const Vec3 normal = random.direction();
        const std::size_t mode = random.uniform() < 0.5 ? 0 : 1;
        Vec3 direction = random.direction();
        Wave in = plane_wave(from, modes_of(from)[mode], direction, By::wave_normal, normal);
        if (dot(in.ray, normal) < 0) {
            direction = -direction;
            in = plane_wave(from, modes_of(from)[mode], direction, By::wave_normal, normal);
        }
        if (dot(in.ray, normal) < 0.02) continue;
        const Interface face(from, to, normal, in);
        const Coefficients a = face.solve(in);
        energy = std::max(energy, std::abs(a.reflected_total + a.transmitted_total - 1));
        for (std::size_t j = 0; j < 2; ++j) {
            const Wave t = face.transmitted(j);
            if (!t.propagating || dot(t.ray, normal) < 0.02) continue;
            if (modes_of(to)[0] == Mode::s || modes_of(from)[0] == Mode::s) {
                if (length(cross(direction, normal)) < 1e-3) continue;
            }
            const Wave back =
                plane_wave(to, modes_of(to)[j], normalised(-real(t.k)), By::wave_normal, -normal);
            const Coefficients b = Interface(to, from, -normal, back).solve(back);
            reciprocity =
                std::max(reciprocity, std::abs(b.transmitted_power[mode] - a.transmitted_power[j]));
        }
    }
    CHECK(energy < 1e-12);
    CHECK(reciprocity < 1e-9);
}

TEST_CASE("a crystal whose activity fades reflects as the crystal without it",
          "[interface][activity]") {
    const Vec3 axis = normalised(Vec3{1, 2, 3}), direction = normalised(Vec3{0.5, 0.1, 0.7});
    const Medium air = Medium::isotropic(1);
    const Wave in = plane_wave(air, Mode::p, direction, By::wave_normal, {0, 0, 1});
    const auto total = [&](const Medium& m) {
        return Interface(air, m, {0, 0, 1}, in).solve(in).reflected_total;
    };
    const double still = total(Medium::uniaxial(n_o, n_e, axis));
    CHECK(total(quartz(1e-9, axis)) == Approx(still).epsilon(1e-13));
    CHECK(total(quartz(1e4, axis)) != Approx(still).epsilon(1e-6));
}
