// Optical elements do to polarised light what they do on the bench.
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "polarisation/mueller.hpp"

using namespace icespar;

namespace {

constexpr double pi = std::numbers::pi;

void check_same(const Stokes& a, const Stokes& b) {
    CHECK(a.s0 == Approx(b.s0).margin(1e-14));
    CHECK(a.s1 == Approx(b.s1).margin(1e-14));
    CHECK(a.s2 == Approx(b.s2).margin(1e-14));
    CHECK(a.s3 == Approx(b.s3).margin(1e-14));
}

double distance(const Mueller& a, const Mueller& b) {
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j)
            worst = std::max(worst, std::abs(a.m[i][j] - b.m[i][j]));
    }
    return worst;
}

}  // namespace

TEST_CASE("a quarter-wave plate with its fast axis on x turns +45 light left-circular",
          "[polarisation][convention]") {
    // Ex leads Ey by a quarter period: the field points along x, then y: anticlockwise.
    check_same(linear_retarder(pi / 2) * Stokes{1, 0, 1, 0}, {1, 0, 0, -1});
    check_same(linear_retarder(pi / 2) * Stokes{1, 0, -1, 0}, {1, 0, 0, 1});
}

TEST_CASE("the field behind a quarter-wave plate goes round anticlockwise for left-circular light",
          "[polarisation][convention]") {
    const Jones plate = jones_linear_retarder(pi / 2);
    const double h = std::sqrt(0.5);
    const std::complex<double> x = plate.m[0][0] * h, y = plate.m[1][1] * h;
    const auto angle = [&](double t) {
        const std::complex<double> turn = std::exp(std::complex<double>(0, -t));
        return std::atan2((y * turn).real(), (x * turn).real());
    };
    CHECK(std::remainder(angle(0.1) - angle(0), 2 * pi) == Approx(0.1).epsilon(1e-12));
    CHECK(stokes_from_field(x, y).s3 == Approx(-1).epsilon(1e-14));
}

TEST_CASE("a circular retarder that delays left circular light turns clockwise",
          "[polarisation][convention]") {
    // From x towards -y for the receiver, by half the retardance.
    const Stokes out = circular_retarder(0.6) * Stokes{1, 1, 0, 0};
    CHECK(angle_of_polarisation(out) == Approx(-0.3).epsilon(1e-14));
}

TEST_CASE("Mueller matrices of elements follow from their Jones matrices", "[polarisation]") {
    for (const double axis : {0.0, 0.3, -1.1, 2.0}) {
        for (const double d : {0.2, 1.5, 3.0}) {
            CHECK(distance(mueller_from_jones(jones_linear_retarder(d, axis)),
                           linear_retarder(d, axis)) < 1e-15);
            CHECK(distance(mueller_from_jones(jones_circular_retarder(d)), circular_retarder(d)) <
                  1e-15);
        }
        CHECK(distance(mueller_from_jones(jones_rotator(axis)), rotator(axis)) < 1e-15);
        CHECK(distance(mueller_from_jones(jones_polariser(axis)), linear_polariser(axis)) < 1e-15);
        CHECK(distance(mueller_from_jones(jones_diattenuator(0.9, 0.4, axis)),
                       linear_diattenuator(0.81, 0.16, axis)) < 1e-15);
    }
}

TEST_CASE("a Mueller matrix does to a Stokes vector what its Jones matrix does to the field",
          "[polarisation]") {
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    const auto z = [&] { return std::complex<double>(normal(engine), normal(engine)); };
    for (int i = 0; i < 200; ++i) {
        const Jones j{{{{z(), z()}, {z(), z()}}}};
        const auto x = z(), y = z();
        const Stokes a = mueller_from_jones(j) * stokes_from_field(x, y);
        const Stokes b =
            stokes_from_field(j.m[0][0] * x + j.m[0][1] * y, j.m[1][0] * x + j.m[1][1] * y);
        CHECK(a.s0 == Approx(b.s0).margin(1e-12));
        CHECK(a.s1 == Approx(b.s1).margin(1e-12));
        CHECK(a.s2 == Approx(b.s2).margin(1e-12));
        CHECK(a.s3 == Approx(b.s3).margin(1e-12));
        CHECK(depolarisation_index(mueller_from_jones(j)) == Approx(1).epsilon(1e-12));
        CHECK(distance(mueller_from_jones(jones_from_mueller(mueller_from_jones(j))),
                       mueller_from_jones(j)) < 1e-11);
    }
}

TEST_CASE("polarisers follow the law of Malus", "[polarisation]") {
    for (const double angle : {0.0, 0.4, 1.0, pi / 2}) {
        const Stokes out = linear_polariser(angle) * Stokes{1, 1, 0, 0};
        CHECK(out.s0 == Approx(std::pow(std::cos(angle), 2)).margin(1e-15));
    }
    check_same(linear_polariser(0.7) * Stokes{1, 0, 0, 0},
               {0.5, 0.5 * std::cos(1.4), 0.5 * std::sin(1.4), 0});
    check_same(circular_polariser(true) * Stokes{1, 0, 0, 1}, {1, 0, 0, 1});
    check_same(circular_polariser(true) * Stokes{1, 0, 0, -1}, {0, 0, 0, 0});
}

TEST_CASE("a plate between crossed polarisers transmits sin^2(2 angle) sin^2(retardance / 2)",
          "[polarisation]") {
    for (const double angle : {0.1, 0.5, pi / 4}) {
        const double d = retardance(1.5442, 1.5533, 0.03, 589.3);
        const Stokes out = linear_polariser(pi / 2) *
                           (linear_retarder(d, angle) * (linear_polariser(0) * Stokes{2, 0, 0, 0}));
        CHECK(out.s0 == Approx(std::pow(std::sin(2 * angle) * std::sin(d / 2), 2)).epsilon(1e-12));
    }
}

TEST_CASE("degree, angle and ellipticity describe the ellipse", "[polarisation]") {
    const double angle = 0.4, chi = 0.2, p = 0.7;
    const Stokes s{2, 2 * p * std::cos(2 * chi) * std::cos(2 * angle),
                   2 * p * std::cos(2 * chi) * std::sin(2 * angle), 2 * p * std::sin(2 * chi)};
    CHECK(degree_of_polarisation(s) == Approx(p));
    CHECK(degree_of_linear_polarisation(s) == Approx(p * std::cos(2 * chi)));
    CHECK(angle_of_polarisation(s) == Approx(angle));
    CHECK(ellipticity(s) == Approx(std::tan(chi)));
    CHECK(degree_of_polarisation(Stokes{}) == 0);
}

TEST_CASE("the matrix of one ray takes what its analyser accepts and sends one polarisation",
          "[polarisation]") {
    const std::complex<double> a(0.6, 0.1), b(-0.3, 0.5);
    const Stokes out = stokes_from_field({0.2, 0.4}, {0.7, -0.1});
    const Mueller m = mueller_of_wave(a, b, out);
    const std::complex<double> x(0.3, -0.8), y(0.9, 0.2);
    const Stokes seen = m * stokes_from_field(x, y);
    CHECK(seen.s0 == Approx(std::norm(a * x + b * y)).epsilon(1e-14));
    CHECK(degree_of_polarisation(m * Stokes{1, 0, 0, 0}) == Approx(1).epsilon(1e-14));
    CHECK(depolarisation_index(m) == Approx(1).epsilon(1e-14));
    for (std::size_t i = 1; i < 4; ++i) {
        for (std::size_t j = 1; j < 4; ++j) {
            CHECK(m.m[0][0] * m.m[i][j] == Approx(m.m[i][0] * m.m[0][j]).margin(1e-15));
        }
    }
}

TEST_CASE("depolarisers and diattenuators have the indices of their definitions",
          "[polarisation]") {
    CHECK(depolarisation_index(depolariser(0, 0, 0)) == 0);
    CHECK(depolarisation_index(depolariser(0.5, 0.5, 0.5)) == Approx(0.5));
    CHECK(diattenuation(linear_polariser(0.2)) == Approx(1));
    CHECK(diattenuation(linear_diattenuator(0.8, 0.2, 1)) == Approx(0.6));
    CHECK(diattenuation(linear_retarder(1, 1)) == Approx(0).margin(1e-15));
}
