// The signs of the Stokes parameters, pinned to what the electric vector does in time.
#include <catch2/catch.hpp>
#include <numbers>

#include "polarisation/stokes.hpp"

using icespar::Stokes;
using icespar::stokes_from_field;
using Complex = std::complex<double>;

namespace {

/// The electric vector that a receiver sees at a phase w t of the cycle: x to the right, y up.
struct Seen {
    double x, y;
};

Seen at_phase(Complex ex, Complex ey, double phase) {
    const Complex clock = std::polar(1.0, -phase);
    return {(ex * clock).real(), (ey * clock).real()};
}

/// Mean over a cycle of the squared component along a direction at `degrees` from right towards up,
/// times 2: what a polariser at that angle lets through.
double through_polariser(Complex ex, Complex ey, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    double sum = 0;
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const Seen e = at_phase(ex, ey, 2 * std::numbers::pi * i / steps);
        const double along = e.x * std::cos(angle) + e.y * std::sin(angle);
        sum += 2 * along * along / steps;
    }
    return sum;
}

/// Twice the area that the electric vector sweeps in a cycle over pi; positive anticlockwise as
/// seen.
double anticlockwise(Complex ex, Complex ey) {
    double area = 0;
    constexpr int steps = 4096;
    for (int i = 0; i < steps; ++i) {
        const Seen a = at_phase(ex, ey, 2 * std::numbers::pi * i / steps);
        const Seen b = at_phase(ex, ey, 2 * std::numbers::pi * (i + 1) / steps);
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    return 2 * area / std::numbers::pi;
}

constexpr double exact = 1e-15;

}  // namespace

TEST_CASE("light along x has S1 > 0, along y S1 < 0", "[stokes][convention]") {
    CHECK(stokes_from_field(1, 0) == Stokes{1, 1, 0, 0});
    CHECK(stokes_from_field(0, 1) == Stokes{1, -1, 0, 0});
}

TEST_CASE("light along +45 degrees, right and up, has S2 > 0", "[stokes][convention]") {
    CHECK(stokes_from_field(1, 1) == Stokes{2, 0, 2, 0});
    CHECK(stokes_from_field(1, -1) == Stokes{2, 0, -2, 0});
    const Seen e = at_phase(1, 1, 0.3);
    CHECK(e.x == e.y);
}

TEST_CASE("light that turns clockwise for the receiver has S3 > 0", "[stokes][convention]") {
    // x = sin(w t), y = cos(w t): the vector is up, and a quarter period later right.
    const Complex ex(0, 1), ey(1, 0);
    const Seen start = at_phase(ex, ey, 0), later = at_phase(ex, ey, std::numbers::pi / 2);
    CHECK(start.y == Approx(1));
    CHECK(later.x == Approx(1));
    CHECK(stokes_from_field(ex, ey) == Stokes{2, 0, 0, 2});
    CHECK(stokes_from_field(ex, -ey) == Stokes{2, 0, 0, -2});
}

TEST_CASE("Stokes parameters are what polarisers and the sense of rotation measure",
          "[stokes][convention]") {
    for (int i = 0; i < 200; ++i) {
        const Complex ex = std::polar(0.1 + 0.01 * i, 1.3 * i), ey = std::polar(1.0, 0.7 * i + 0.2);
        const Stokes s = stokes_from_field(ex, ey);
        CHECK(s.s0 == Approx(through_polariser(ex, ey, 0) + through_polariser(ex, ey, 90)));
        CHECK(s.s1 ==
              Approx(through_polariser(ex, ey, 0) - through_polariser(ex, ey, 90)).margin(1e-12));
        CHECK(s.s2 ==
              Approx(through_polariser(ex, ey, 45) - through_polariser(ex, ey, -45)).margin(1e-12));
        CHECK(s.s3 == Approx(-anticlockwise(ex, ey)).epsilon(1e-5).margin(1e-5));
        CHECK(s.s1 * s.s1 + s.s2 * s.s2 + s.s3 * s.s3 == Approx(s.s0 * s.s0).epsilon(10 * exact));
    }
}

TEST_CASE("Stokes vectors add as light that does not interfere", "[stokes]") {
    Stokes sum = stokes_from_field(1, 0) + stokes_from_field(0, 1);
    CHECK(sum == Stokes{2, 0, 0, 0});
    sum += 0.5 * stokes_from_field(1, 1);
    CHECK(sum == Stokes{3, 0, 1, 0});
}
