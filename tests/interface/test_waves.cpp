// Every wave the interface names is a solution of Maxwell's equations in its medium and leaves the
// face.
#include <algorithm>
#include <catch2/catch.hpp>

#include "interface/interface.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

CVec3 times_epsilon(const Medium& m, const CVec3& v) {
    const double eo = m.n_o * m.n_o, ee = m.n_e * m.n_e;
    return eo * v + (ee - eo) * dot(v, m.axis) * m.axis;
}

/// Largest violation of k x E = H, k x H = -epsilon E and of what struct Wave promises.
double violation(const Wave& w, const Medium& m) {
    const Vec3 flow = real(cross(w.E, conj(w.H)));
    return std::max({length(cross(w.k, w.E) - w.H), length(cross(w.k, w.H) + times_epsilon(m, w.E)),
                     std::abs(length(w.E) - 1), std::abs(length(w.ray) - 1),
                     length(cross(w.ray, flow)), std::abs(w.n_phase - length(real(w.k))),
                     std::abs(w.n_ray - dot(real(w.k), w.ray))}) /
           (m.n_o * m.n_o);
}

}  // namespace

TEST_CASE("each of the five waves at a face satisfies Maxwell's equations in its medium",
          "[interface][waves]") {
    Random random(41);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 100000; ++i) {
        const auto stress = static_cast<Stress>(random.below(static_cast<int>(Stress::count)));
        const InterfaceCase c = random_case(random, stress);
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const OutgoingWaves out = Interface(c.from, c.to, c.normal, in).waves();
        double error = violation(in, c.from);
        for (int m = 0; m < 2; ++m)
            error = std::max(
                {error, violation(out.reflected[m], c.from), violation(out.transmitted[m], c.to)});
        error /= field_slack(stress);
        if (!(error <= worst)) worst = error, where = std::string(name(stress)) + ": " + c.text();
    }
    INFO(in_digits(worst) << " at " << where);
    CHECK(worst < 3e-14);
}

TEST_CASE("waves keep the tangential wave vector, and leave the face or decay from it",
          "[interface][waves]") {
    Random random(42);
    double drift = 0;
    int wrong_way = 0;
    std::string where;
    for (int i = 0; i < 100000; ++i) {
        const auto stress = static_cast<Stress>(random.below(static_cast<int>(Stress::count)));
        const InterfaceCase c = random_case(random, stress);
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const Interface face(c.from, c.to, c.normal, in);
        const OutgoingWaves out = face.waves();
        const CVec3 n = complexified(c.normal);
        for (int m = 0; m < 2; ++m)
            for (const double sign : {-1.0, 1.0}) {
                const Wave& w = sign < 0 ? out.reflected[m] : out.transmitted[m];
                drift = std::max(drift, length(cross(n, w.k - in.k)));
                const double away =
                    w.propagating ? sign * w.flux(c.normal) : sign * std::imag(dot(w.k, n));
                // Energy along the face itself, exactly critical, is neither.
                if (away < -1e-15 || face.propagating(sign > 0, m) != w.propagating) {
                    ++wrong_way;
                    where = std::string(name(stress)) + ": " + c.text();
                }
            }
    }
    INFO(in_digits(drift) << ", wrong way at " << where);
    CHECK(drift < 5e-15);
    CHECK(wrong_way == 0);
}

TEST_CASE("the ray tracer's short answers are those of the full waves", "[interface][waves]") {
    Random random(45);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 50000; ++i) {
        const auto stress = static_cast<Stress>(random.below(static_cast<int>(Stress::count)));
        const InterfaceCase c = random_case(random, stress);
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const Interface face(c.from, c.to, c.normal, in);
        const Coefficients a = face.solve(in);
        const OutgoingWaves out = face.waves();
        const Vec3 s = face.s_direction();
        double error = std::max(std::abs(length(s) - 1), std::abs(dot(s, c.normal)));
        error = std::max(error, std::abs(dot(s, real(in.k))));
        const auto m = static_cast<std::size_t>(c.mode_index());
        for (std::size_t b = 0; b < 2; ++b)
            error = std::max(
                {error, length(face.reflected(b).E - out.reflected[b].E),
                 length(face.transmitted(b).ray - out.transmitted[b].ray),
                 std::abs(std::norm(face.flux_amplitude(m, false, b)) - a.reflected_power[b]),
                 std::abs(std::norm(face.flux_amplitude(m, true, b)) - a.transmitted_power[b])});
        if (!(error <= worst)) worst = error, where = std::string(name(stress)) + ": " + c.text();
    }
    INFO(in_digits(worst) << " at " << where);
    CHECK(worst < 1e-14);
}

TEST_CASE("the phase of the incident wave changes no power", "[interface][waves]") {
    Random random(46);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 50000; ++i) {
        const auto stress = static_cast<Stress>(random.below(static_cast<int>(Stress::count)));
        const InterfaceCase c = random_case(random, stress);
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const Coefficients a = Interface(c.from, c.to, c.normal, in).solve(in);
        for (const Complex phase : {Complex(-1, 0), Complex(0, 1), Complex(0.6, -0.8)}) {
            Wave turned = in;
            turned.E = phase * in.E;
            turned.H = phase * in.H;
            const Coefficients b = Interface(c.from, c.to, c.normal, turned).solve(turned);
            double error = 0;
            for (std::size_t m = 0; m < 2; ++m)
                error = std::max({error, std::abs(a.reflected_power[m] - b.reflected_power[m]),
                                  std::abs(a.transmitted_power[m] - b.transmitted_power[m])});
            if (!(error <= worst))
                worst = error, where = std::string(name(stress)) + ": " + c.text();
        }
    }
    INFO(in_digits(worst) << " at " << where);
    CHECK(worst < 1e-13);
}

TEST_CASE("s and p of one wave vector may share a face", "[interface][waves]") {
    Random random(47);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        InterfaceCase c = random_case(random, Stress::ordinary);
        if (c.from.birefringent) continue;
        const Wave s = plane_wave(c.from, Mode::s, c.direction, By::wave_normal, c.normal);
        const Wave p = plane_wave(c.from, Mode::p, c.direction, By::wave_normal, c.normal);
        const Interface face(c.from, c.to, c.normal, s), other(c.from, c.to, c.normal, p);
        const Coefficients a = face.solve(p), b = other.solve(p);
        for (std::size_t m = 0; m < 2; ++m)
            worst = std::max({worst, std::abs(a.reflected[m] - b.reflected[m]),
                              std::abs(a.transmitted[m] - b.transmitted[m])});
    }
    CHECK(worst < 1e-13);
}

TEST_CASE("modes bear the polarisations of their names", "[interface][waves]") {
    Random random(43);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 normal = random.direction(), direction = random.direction();
        const Vec3 axis = random.direction();
        const double n_o = random.uniform(1.3, 2.7), n_e = random.uniform(1.3, 2.7);
        if (length(cross(axis, direction)) < 0.01 || length(cross(normal, direction)) < 0.01)
            continue;
        const Medium glass = Medium::isotropic(n_o), crystal = Medium::uniaxial(n_o, n_e, axis);
        const auto check = [&](const Medium& m, Mode mode, const Vec3& expected) {
            const Wave w = plane_wave(m, mode, direction, By::wave_normal, normal);
            worst = std::max(worst, length(w.E - complexified(normalised(expected))));
            CHECK(w.mode == mode);
        };
        const Vec3 s = cross(normal, direction);
        check(glass, Mode::s, s);
        check(glass, Mode::p, cross(direction, s));
        check(crystal, Mode::ordinary, cross(direction, axis));
        const double n = n_o * n_e /
                         std::sqrt(n_e * n_e * std::pow(dot(direction, axis), 2) +
                                   n_o * n_o * (1 - std::pow(dot(direction, axis), 2)));
        check(crystal, Mode::extraordinary,
              axis - (n * n / (n_o * n_o)) * dot(direction, axis) * direction);
    }
    CHECK(worst < 1e-13);
}

TEST_CASE("rays are what is asked for by ray", "[interface][waves]") {
    Random random(44);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 ray = random.direction(), normal = random.direction();
        const Medium m = Medium::uniaxial(random.uniform(1.3, 2.7), random.uniform(1.3, 2.7),
                                          i % 10 == 0 ? ray : random.direction());
        for (const Mode mode : {Mode::ordinary, Mode::extraordinary}) {
            const Wave w = plane_wave(m, mode, ray, By::ray, normal);
            worst = std::max({worst, length(w.ray - ray), violation(w, m)});
        }
    }
    CHECK(worst < 1e-14);
}
