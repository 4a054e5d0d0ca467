// Media know what they are, and refuse what cannot be.
#include <catch2/catch.hpp>

#include "crystal/medium.hpp"
#include "math/error.hpp"

using namespace icespar;

namespace {

using Rows = std::array<std::array<Complex, 3>, 3>;

Rows rows(const ComplexTensor& t) {
    return {{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}};
}

ComplexTensor turned(const Complex& x, const Complex& y, const Complex& z) {
    const Vec3 a = normalised(Vec3{1, 2, -0.5}), b = any_perpendicular(a), c = cross(a, b);
    return x * complexified(dyad(a)) + y * complexified(dyad(b)) + z * complexified(dyad(c));
}

}  // namespace

TEST_CASE("a tensor is recognised as isotropic, uniaxial or biaxial", "[crystal][medium]") {
    CHECK(Medium::from_tensor(rows(turned(2.25, 2.25, 2.25))).symmetry == Symmetry::isotropic);
    const Medium calcite = Medium::from_tensor(rows(turned(2.21, 2.75, 2.75)));
    CHECK(calcite.symmetry == Symmetry::uniaxial);
    CHECK(calcite.n_o == Approx(std::sqrt(2.75)).epsilon(1e-14));
    CHECK(calcite.n_e == Approx(std::sqrt(2.21)).epsilon(1e-14));
    CHECK(length(cross(calcite.axis, normalised(Vec3{1, 2, -0.5}))) < 1e-14);
    const Medium topaz = Medium::from_tensor(rows(turned(2.61, 2.57, 2.59)));
    CHECK(topaz.symmetry == Symmetry::biaxial);
    CHECK(topaz.n_principal[1] == Approx(std::sqrt(2.59)).epsilon(1e-14));
    CHECK_FALSE(topaz.absorbing);
}

TEST_CASE("a dichroic tensor keeps its indices and absorptions", "[crystal][medium]") {
    const Complex o(1.62, 0.02), e(1.64, 0.3);
    const Medium tourmaline = Medium::from_tensor(rows(turned(e * e, o * o, o * o)));
    CHECK(tourmaline.symmetry == Symmetry::uniaxial);
    CHECK(tourmaline.absorbing);
    CHECK(tourmaline.kappa_o == Approx(0.02).epsilon(1e-12));
    CHECK(tourmaline.kappa_e == Approx(0.3).epsilon(1e-12));
    // A round real part whose loss is round about another axis has no axis left.
    const ComplexTensor mixed =
        turned(2.2, 2.7, 2.7) + Complex(0, 0.1) * complexified(dyad(Vec3{0, 0, 1}));
    CHECK(Medium::from_tensor(rows(mixed)).symmetry == Symmetry::biaxial);
}

TEST_CASE("metals and wire grids are media; gain and negative permittivity are not",
          "[crystal][medium]") {
    CHECK_NOTHROW(Medium::from_tensor(rows(turned({-13, 1}, {-13, 1}, {-13, 1}))));
    CHECK_NOTHROW(Medium::from_tensor(rows(turned({-13, 1}, 2, 2))));
    CHECK_THROWS_AS(Medium::from_tensor(rows(turned({2, -0.1}, 2, 2))), Error);
    CHECK_THROWS_AS(Medium::from_tensor(rows(turned(-2, 2, 2))), Error);
    Rows lopsided = rows(turned(2, 2.1, 2.2));
    lopsided[0][1] += 0.1;
    CHECK_THROWS_AS(Medium::from_tensor(lopsided), Error);
    lopsided[0][1] = std::nan("");
    CHECK_THROWS_AS(Medium::from_tensor(lopsided), Error);
}

TEST_CASE("a biaxial medium holds its principal indices however they are ordered",
          "[crystal][medium]") {
    const Medium m = Medium::biaxial({1.7, 1.5, 1.6}, {0, 0, 2}, {0, 3, 0});
    CHECK(m.n_principal == std::array{1.5, 1.6, 1.7});
    CHECK(m.principal[2] == Vec3{0, 0, 1});
    CHECK(m.permittivity().zz.real() == Approx(1.7 * 1.7).epsilon(1e-15));
    CHECK(m.permittivity().yy.real() == Approx(1.5 * 1.5).epsilon(1e-15));
    CHECK_THROWS_AS(Medium::biaxial({1.7, 1.5, 1.6}, {0, 0, 1}, {0, 1, 1}), Error);
    CHECK_THROWS_AS(Medium::biaxial({1.7, -1.5, 1.6}, {0, 0, 1}, {0, 1, 0}), Error);
    CHECK_THROWS_AS(Medium::biaxial({1.7, Complex(1.5, -0.1), 1.6}, {0, 0, 1}, {0, 1, 0}), Error);
    CHECK_THROWS_AS(optic_axes(Medium::isotropic(1.5)), Error);
}
