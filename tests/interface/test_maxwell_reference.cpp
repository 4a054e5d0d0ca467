// The sixty-digit reference solves Maxwell's equations, keeps energy, and gives Fresnel's formulas.
#include <algorithm>
#include <catch2/catch.hpp>

#include "support/general_cases.hpp"
#include "support/maxwell_reference.hpp"

using namespace reference;
using icespar::testing::InterfaceCase;
using icespar::testing::Random;
using icespar::testing::random_case;
using icespar::testing::Stress;

namespace {

Double3 array(const icespar::Vec3& v) { return {v.x, v.y, v.z}; }

Material material(const icespar::Medium& m) {
    return m.birefringent ? Material::uniaxial(m.n_o, m.n_e, array(m.axis))
                          : Material::isotropic(m.n_o);
}

Real total_power(const Solution& s) {
    return s.reflected[0].power + s.reflected[1].power + s.transmitted[0].power +
           s.transmitted[1].power;
}

}  // namespace

TEST_CASE("the reference satisfies Maxwell and the boundary conditions to 45 digits",
          "[interface][maxwell]") {
    Random random(21);
    Real worst = 0, worst_energy = 0;
    for (int i = 0; i < 480; ++i) {
        const auto stress = static_cast<Stress>(i % static_cast<int>(Stress::count));
        // There the matching itself is singular, and digits are lost in proportion.
        if (stress == Stress::merging_evanescent) continue;
        const InterfaceCase c = random_case(random, stress);
        const Material from = material(c.from), to = material(c.to);
        const Solution s = solve(from, to, array(c.normal), array(c.direction), c.mode_index());
        worst = std::max(worst, residual(s, from, to, array(c.normal)));
        worst_energy = std::max<Real>(worst_energy, abs(total_power(s) - 1) * s.normal_flux);
    }
    CHECK(worst < Real("1e-45"));
    CHECK(worst_energy < Real("1e-45"));
}

TEST_CASE("the reference gives Fresnel's formulas between isotropic media",
          "[interface][maxwell]") {
    Random random(22);
    Real worst = 0;
    for (int i = 0; i < 60; ++i) {
        const double n1 = random.uniform(1, 3), n2 = random.uniform(1, 3);
        const icespar::Vec3 d = random.direction();
        const Double3 normal{0, 0, 1}, direction{d.x, d.y, std::abs(d.z)};
        const RealVector u = unit(direction);
        const Real sin2 = (Real(1) - u[2] * u[2]) * Real(n1) * Real(n1);
        const Cplx cos_i(u[2]), cos_t = square_root(Cplx(Real(1) - sin2 / (Real(n2) * Real(n2))));
        const Cplx a(n1), b(n2);
        const Cplx r_s = (a * cos_i - b * cos_t) / (a * cos_i + b * cos_t);
        const Cplx r_p = (b * cos_i - a * cos_t) / (b * cos_i + a * cos_t);
        const Material from = Material::isotropic(n1), to = Material::isotropic(n2);
        const Solution s = solve(from, to, normal, direction, 0);
        const Solution p = solve(from, to, normal, direction, 1);
        worst = std::max(
            {worst, magnitude(s.reflected[0].amplitude - r_s), magnitude(s.reflected[1].amplitude),
             magnitude(p.reflected[1].amplitude - r_p), magnitude(p.reflected[0].amplitude)});
        if (sin2 < Real(n2) * Real(n2))
            worst = std::max({worst, magnitude(s.transmitted[0].amplitude - (Cplx(1) + r_s)),
                              magnitude(p.transmitted[1].amplitude -
                                        (Cplx(1) + r_p) * Cplx(Real(n1) / Real(n2)))});
    }
    CHECK(worst < Real("1e-50"));
}

TEST_CASE("the reference follows waves to grazing incidence behind an absorbing medium",
          "[interface][maxwell]") {
    icespar::testing::MediumRecipe dark, air;
    dark.n[0] = {1.85, 0.28};
    const Double3 normal{0, 0, 1}, direction{0.6, -0.8, 1e-6};
    const Solution s = solve(dark.material(), air.material(), normal, direction, 0);
    const RealVector u = unit(direction);
    const Cplx n(Real(1.85), Real(0.28)), q_i = n * Cplx(u[2]);
    Cplx q_t = square_root(Cplx(1) - n * n * Cplx(Real(1) - u[2] * u[2]));
    if (q_t.imag() < 0) q_t = -q_t;
    CHECK(magnitude(s.reflected[0].amplitude - (q_i - q_t) / (q_i + q_t)) < Real("1e-40"));
}

TEST_CASE("the reference handles any symmetric tensor, biaxial or absorbing",
          "[interface][maxwell]") {
    using T = std::array<std::array<std::complex<double>, 3>, 3>;
    const std::complex<double> i(0, 1);
    const T topaz{{{2.6, 0.02, 0.01}, {0.02, 2.58, -0.03}, {0.01, -0.03, 2.61}}};
    const T dichroic{{{2.6 + 0.1 * i, 0.02 + 0.01 * i, 0.01},
                      {0.02 + 0.01 * i, 2.58 + 0.3 * i, -0.03},
                      {0.01, -0.03, 2.61 + 0.02 * i}}};
    const Double3 normal{0.1, 0.2, 0.9}, direction{0.5, -0.3, 0.7};
    const Material air = Material::isotropic(1);
    for (const int mode : {0, 1}) {
        const Solution clear = solve(air, Material::general(topaz), normal, direction, mode);
        CHECK(residual(clear, air, Material::general(topaz), normal) < Real("1e-45"));
        CHECK(abs(total_power(clear) - 1) < Real("1e-45"));
        const Solution dark = solve(air, Material::general(dichroic), normal, direction, mode);
        CHECK(residual(dark, air, Material::general(dichroic), normal) < Real("1e-45"));
        CHECK(dark.transmitted[0].k[2].imag() > 0);
        const Solution inside = solve(Material::general(topaz), air, normal, direction, mode);
        CHECK(residual(inside, Material::general(topaz), air, normal) < Real("1e-45"));
        CHECK(abs(total_power(inside) - 1) < Real("1e-45"));
    }
}
