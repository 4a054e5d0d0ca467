// No face creates or destroys energy, every passage can be reversed, and the fields join across the
// face.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "interface/interface.hpp"
#include "support/interface_cases.hpp"
#include "support/interface_energy.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// Fractions of power of one incident wave: reflected 0, 1, transmitted 0, 1.
std::array<double, 4> powers(const InterfaceCase& c) {
    const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
    const Coefficients a = Interface(c.from, c.to, c.normal, in).solve(in);
    return {a.reflected_power[0], a.reflected_power[1], a.transmitted_power[0],
            a.transmitted_power[1]};
}

}  // namespace

TEST_CASE("no face creates or destroys energy", "[interface][energy]") {
    Random random(11);
    EnergyTally tally;
    for (int i = 0; i < 1000000; ++i) {
        // Half ordinary, half hard.
        const int kind = std::max(
            0, random.below(2 * static_cast<int>(Stress::count)) - static_cast<int>(Stress::count));
        tally.add(random_case(random, static_cast<Stress>(kind)));
    }
    INFO(tally.report());
    CHECK(tally.worst_excess() <= 1);
}

TEST_CASE("every passage of a face has the same power backwards", "[interface][energy]") {
    Random random(12);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 100000; ++i) {
        const auto stress = static_cast<Stress>(random.below(static_cast<int>(Stress::count)));
        const InterfaceCase c = random_case(random, stress);
        const double excess = reciprocity_error(c) / 1e-13;
        if (!(excess <= worst)) worst = excess, where = std::string(name(stress)) + ": " + c.text();
    }
    INFO(in_digits(worst) << " at " << where);
    CHECK(worst <= 1);
}

TEST_CASE("tangential E and H are continuous across a face", "[interface][energy]") {
    Random random(13);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 100000; ++i) {
        const auto stress = static_cast<Stress>(random.below(static_cast<int>(Stress::count)));
        const InterfaceCase c = random_case(random, stress);
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const Interface face(c.from, c.to, c.normal, in);
        const Coefficients a = face.solve(in);
        const OutgoingWaves out = face.waves();
        CVec3 E = in.E, H = in.H;
        double size = 1;
        for (int m = 0; m < 2; ++m) {
            E += a.reflected[m] * out.reflected[m].E - a.transmitted[m] * out.transmitted[m].E;
            H += a.reflected[m] * out.reflected[m].H - a.transmitted[m] * out.transmitted[m].H;
            size = std::max({size, std::abs(a.reflected[m]), std::abs(a.transmitted[m])});
        }
        const CVec3 n = complexified(c.normal);
        const double jump =
            std::max(length(cross(n, E)), length(cross(n, H))) / size / field_slack(stress);
        // A wave that grazes the face turns by rounding / cos when its k is found anew.
        const double limit = 2e-13 + 4 * std::numeric_limits<double>::epsilon() / c.cos_ray;
        if (!(jump / limit <= worst))
            worst = jump / limit, where = std::string(name(stress)) + ": " + c.text();
    }
    INFO(in_digits(worst) << " of what is allowed at " << where);
    CHECK(worst < 1);
}

TEST_CASE("a crystal whose indices are equal refracts and reflects as glass does",
          "[interface][energy]") {
    Random random(14);
    double power = 0, geometry = 0;
    for (int i = 0; i < 20000; ++i) {
        InterfaceCase glass = random_case(random, Stress::ordinary);
        glass.from = Medium::isotropic(random.uniform(1, 2.5));
        glass.to = Medium::isotropic(random.uniform(1, 2.5));
        glass.mode = random.uniform() < 0.5 ? Mode::s : Mode::p;
        if (dot(glass.direction, glass.normal) < 0) glass.direction = -glass.direction;
        if (dot(glass.direction, glass.normal) < 1e-3) continue;
        InterfaceCase crystal = glass;
        crystal.to = Medium::uniaxial(glass.to.n_o, glass.to.n_o, random.direction());
        const auto a = powers(glass), b = powers(crystal);
        power = std::max(
            {power, std::abs(a[0] + a[1] - b[0] - b[1]), std::abs(a[2] + a[3] - b[2] - b[3])});
        const Wave in =
            plane_wave(glass.from, glass.mode, glass.direction, By::wave_normal, glass.normal);
        const OutgoingWaves x = Interface(glass.from, glass.to, glass.normal, in).waves();
        const OutgoingWaves y = Interface(glass.from, crystal.to, glass.normal, in).waves();
        for (int m = 0; m < 2; ++m) {
            geometry = std::max(geometry, length(x.transmitted[m].k - y.transmitted[m].k));
            if (x.transmitted[m].propagating)
                geometry = std::max(geometry, length(x.transmitted[m].ray - y.transmitted[m].ray));
        }
    }
    CHECK(power < 1e-12);
    CHECK(geometry < 1e-12);
}

TEST_CASE("the rays of calcite part by 6.26 degrees at most", "[interface][walk-off]") {
    const double n_o = 1.6584, n_e = 1.4864;
    const Medium calcite = Medium::uniaxial(n_o, n_e, {0, 0, 1});
    double largest = 0, at = 0;
    for (double angle = 0; angle <= 90; angle += 0.001) {
        const double t = angle * std::numbers::pi / 180;
        const Vec3 k{std::sin(t), 0, std::cos(t)};
        const Wave w = plane_wave(calcite, Mode::extraordinary, k, By::wave_normal, {0, 0, 1});
        const double walk_off = std::atan2(length(cross(k, w.ray)), dot(k, w.ray));
        if (walk_off > largest) largest = walk_off, at = angle;
        CHECK(w.n_ray == Approx(w.n_phase * std::cos(walk_off)).epsilon(1e-14));
    }
    // tan(walk-off) is largest where tan(angle) = n_e / n_o and is then (n_o^2 - n_e^2)/(2 n_o
    // n_e).
    CHECK(degrees(largest) == Approx(6.26).margin(0.005));
    CHECK(std::tan(largest) == Approx((n_o * n_o - n_e * n_e) / (2 * n_o * n_e)).epsilon(1e-9));
    CHECK(at == Approx(degrees(std::atan(n_e / n_o))).margin(0.1));
}

TEST_CASE("internal reflection in quartz turns all of an o-wave into an e-wave",
          "[interface][conversion]") {
    const double n_o = 1.5442, n_e = 1.5533;
    Random random(15);
    double most = 0;
    for (int i = 0; i < 300000; ++i) {
        InterfaceCase c;
        c.from = Medium::uniaxial(n_o, n_e, random.direction());
        c.mode = Mode::ordinary;
        c.normal = {0, 0, 1};
        c.direction = random.direction();
        if (c.direction.z < 0.02) continue;
        most = std::max(most, powers(c)[1]);
    }
    CHECK(most > 0.995);
    CHECK(most <= 1 + 1e-12);
}
