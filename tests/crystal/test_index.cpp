// Dispersion formulas against the figures of the makers and the handbooks.
#include <catch2/catch.hpp>
#include <cmath>

#include "crystal/index.hpp"
#include "math/error.hpp"

using namespace icespar;
using Catch::WithinAbs;

TEST_CASE("N-BK7 has the indices its maker prints", "[index]") {
    // Schott's data sheet: F, d and C lines.
    const IndexFunction n = IndexFunction::sellmeier2(
        {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653});
    CHECK_THAT(n(486.1327), WithinAbs(1.52238, 5e-6));
    CHECK_THAT(n(587.5618), WithinAbs(1.51680, 5e-6));
    CHECK_THAT(n(656.2725), WithinAbs(1.51432, 5e-6));
    CHECK(n.dispersive());
    CHECK(n.valid());
}

TEST_CASE("formula 1 is formula 2 with the resonances not yet squared", "[index]") {
    const IndexFunction one = IndexFunction::sellmeier1({0.1, 0.9, 0.2, 1.5, 9});
    const IndexFunction two = IndexFunction::sellmeier2({0.1, 0.9, 0.04, 1.5, 81});
    CHECK_THAT(one(450), WithinAbs(two(450), 1e-15));
}

TEST_CASE("rutile follows Devore", "[index]") {
    // Devore (1951): n^2 = 5.913 + 0.2441 / (l^2 - 0.0803) for the ordinary ray.
    const IndexFunction n = IndexFunction::formula4({5.913, 0.2441, 0, 0.0803, 1, 0, 0, 0, 1});
    CHECK_THAT(n(589.3), WithinAbs(std::sqrt(5.913 + 0.2441 / (0.5893 * 0.5893 - 0.0803)), 1e-14));
}

TEST_CASE("formula 4 has powers of the wavelength in numerator, resonance and tail", "[index]") {
    const IndexFunction n = IndexFunction::formula4({2, 0.5, 2, 0.1, 2, 0.2, 1, 0.3, 3, -0.01, 2});
    const double l = 0.5;
    CHECK_THAT(n(500), WithinAbs(std::sqrt(2 + 0.5 * l * l / (l * l - 0.1 * 0.1) +
                                           0.2 * l / (l * l - 0.027) - 0.01 * l * l),
                                 1e-14));
}

TEST_CASE("Cauchy's formula and a constant", "[index]") {
    CHECK_THAT(IndexFunction::cauchy(1.6, 0.01)(500), WithinAbs(1.64, 1e-15));
    CHECK(IndexFunction(1.5)(500) == 1.5);
    CHECK_FALSE(IndexFunction(1.5).dispersive());
    CHECK(IndexFunction()(500) == 1);
}

TEST_CASE("an index that light cannot have never passes for valid", "[index]") {
    CHECK(IndexFunction(1.0).valid());
    CHECK_FALSE(IndexFunction(0.99).valid());
    CHECK_FALSE(IndexFunction(std::nan("")).valid());
    CHECK_FALSE(IndexFunction(HUGE_VAL).valid());
    CHECK_FALSE(IndexFunction::cauchy(1.05, -0.02).valid());
    CHECK_FALSE(IndexFunction::sellmeier2({0, -2, 0.01}).valid());
    // A weak, narrow resonance at 550.5 nm, between whole wavelengths.
    CHECK_FALSE(IndexFunction::sellmeier1({0, 1.3, 0.1, 1e-9, 0.5505}).valid());
}

TEST_CASE("a formula with the wrong number of coefficients is refused", "[index]") {
    CHECK_THROWS_AS(IndexFunction::sellmeier1({}), Error);
    CHECK_THROWS_AS(IndexFunction::sellmeier1({0}), Error);
    CHECK_THROWS_AS(IndexFunction::sellmeier2({0, 1}), Error);
    CHECK_THROWS_AS(IndexFunction::sellmeier2({0, 1, std::nan("")}), Error);
    CHECK_THROWS_AS(IndexFunction::formula4({2, 0.5, 2, 0.1, 2}), Error);
}
