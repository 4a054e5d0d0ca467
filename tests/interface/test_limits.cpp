// What a face of a general medium does changes smoothly: across the limits in which one kind of
// medium becomes another, and from one way of computing to the next.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "support/general_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

using Answer = std::vector<double>;

/// Totals and summed fields.
Answer answer(const Medium& from, const Medium& to, const Vec3& normal, const Wave& in) {
    const Interface face(from, to, normal, in);
    const Coefficients a = face.solve(in);
    const SummedFields f = face.summed_fields(in);
    Answer out{a.reflected_total, a.transmitted_total};
    for (const CVec3& v : {f.reflected_E, f.reflected_H, f.transmitted_E, f.transmitted_H}) {
        for (const Complex& z : {v.x, v.y, v.z}) {
            out.push_back(z.real());
            out.push_back(z.imag());
        }
    }
    return out;
}

double distance(const Answer& a, const Answer& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

/// Largest |answer(t) - answer(0)| / (t + 1e-12) for t from `largest` to 1e-16.
template <class Family>
double steepest(const Family& family, double largest) {
    const Answer limit = family(0.0);
    double worst = 0;
    for (double t = largest; t > 1e-16; t /= 2.7) {
        worst = std::max(worst, distance(family(t), limit) / (t + 1e-12));
    }
    return worst;
}

/// A face with moderate angles, so that no critical angle is near.
struct Setting {
    Vec3 normal, x, y;
    Wave in;
    Medium air = Medium::isotropic(1);

    explicit Setting(Random& random) {
        normal = random.direction();
        x = random.direction();
        y = random.perpendicular_to(x);
        const double angle = random.uniform(0.05, 1.3);
        const Vec3 d = std::cos(angle) * normal + std::sin(angle) * random.perpendicular_to(normal);
        in =
            plane_wave(air, random.uniform() < 0.5 ? Mode::s : Mode::p, d, By::wave_normal, normal);
    }
    [[nodiscard]] Answer into(const Medium& m) const { return answer(air, m, normal, in); }
};

}  // namespace

TEST_CASE("a biaxial crystal becomes uniaxial and isotropic without a jump",
          "[interface][general][limits]") {
    Random random(71);
    for (int i = 0; i < 100; ++i) {
        const Setting s(random);
        const double n = random.uniform(1.4, 2.2);
        const auto biaxial = [&](double a, double b, double c) {
            return s.into(Medium::biaxial({a, b, c}, s.x, s.y));
        };
        CHECK(steepest([&](double t) { return biaxial(n, n + t, n + 0.2); }, 0.05) < 60);
        CHECK(steepest([&](double t) { return biaxial(n, n + 0.2 - t, n + 0.2); }, 0.05) < 60);
        CHECK(steepest([&](double t) { return biaxial(n, n + 0.4 * t, n + t); }, 0.05) < 60);
        const Answer round = s.into(Medium::uniaxial(n, n + 0.2, cross(s.x, s.y))),
                     plain = s.into(Medium::isotropic(n));
        CHECK(distance(biaxial(n, n, n + 0.2), round) < 1e-12);
        CHECK(distance(biaxial(n, n, n), plain) < 1e-12);
    }
}

TEST_CASE("absorption and activity begin without a jump", "[interface][general][limits]") {
    Random random(72);
    for (int i = 0; i < 100; ++i) {
        const Setting s(random);
        const double n = random.uniform(1.4, 2.2);
        const auto dark = [&](double kappa) {
            return s.into(Medium::biaxial(
                {Complex(n, kappa), Complex(n + 0.1, 0.5 * kappa), Complex(n + 0.15, 0)}, s.x,
                s.y));
        };
        CHECK(steepest(dark, 0.1) < 60);
        const auto active = [&](double g) {
            Medium m = Medium::uniaxial(n, n + 0.01, s.x);
            m.gyration = g;
            m.gyration_along = -0.5 * g;
            return s.into(m);
        };
        CHECK(steepest(active, 0.1) < 2000);
    }
}

TEST_CASE("an absorbing first medium becomes transparent without a jump",
          "[interface][general][limits]") {
    Random random(73);
    for (int i = 0; i < 60; ++i) {
        const Setting s(random);
        const Vec3 d = normalised(real(s.in.k));
        const auto from = [&](double kappa) {
            const Medium m = Medium::biaxial(
                {Complex(1.5, kappa), Complex(1.6, 0.3 * kappa), Complex(1.65, 0)}, s.x, s.y);
            Wave in = plane_wave(m, Mode::slow, d, By::wave_normal, s.normal);
            // In one phase for all.
            const auto& E = in.E;
            const Complex most = std::max({E.x, E.y, E.z}, [](const Complex& a, const Complex& b) {
                return std::norm(a) < std::norm(b);
            });
            const Complex turn = std::conj(most) / std::abs(most);
            in.E = turn * in.E;
            in.H = turn * in.H;
            return answer(m, Medium::isotropic(2), s.normal, in);
        };
        const Wave in = plane_wave(Medium::biaxial({1.5, 1.6, 1.65}, s.x, s.y), Mode::slow, d,
                                   By::wave_normal, s.normal);
        if (dot(in.ray, s.normal) < 0.3) continue;
        CHECK(steepest(from, 1e-3) < 1000);
    }
}

TEST_CASE("no way of computing meets the next with a step", "[interface][general][limits]") {
    Random random(74);
    const GeneralStress kinds[] = {
        GeneralStress::into_biaxial,       GeneralStress::out_of_biaxial,
        GeneralStress::biaxial_to_biaxial, GeneralStress::active_second,
        GeneralStress::active_first,       GeneralStress::absorbing_biaxial,
        GeneralStress::absorbing_incident};
    double worst = 0;
    std::string where;
    for (int i = 0; i < 7000; ++i) {
        GeneralCase c = random_case(random, kinds[i % 7]);
        if (c.cos_ray < 0.05) continue;
        const auto at = [&](const Vec3& direction) {
            GeneralCase d = c;
            d.direction = normalised(direction);
            const Wave in = d.incident();
            return std::pair{in.E, answer(c.from.medium(), c.to.medium(), c.normal, in)};
        };
        // From one direction to another far enough for every switch, in steps as small as rounding.
        const Vec3 aside = random.perpendicular_to(c.direction);
        const auto [E0, here] = at(c.direction);
        const auto [E1, there] = at(c.direction + 1e-13 * aside);
        if (length(E0 - E1) > 1e-9) continue;
        const double step = distance(here, there);
        if (!(step <= worst)) worst = step, where = c.text();
    }
    INFO(where);
    CHECK(worst < 1e-9);
}
