// Spectra as functions: between nodes, beyond them, multiplied, summed.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "math/error.hpp"
#include "spectrum/spectrum.hpp"

using namespace icespar;

TEST_CASE("a spectrum is linear between nodes and constant beyond them", "[spectrum]") {
    const Spectrum s({400, 500, 700}, {1, 3, 2});
    CHECK(s(300) == 1);
    CHECK(s(400) == 1);
    CHECK(s(450) == Approx(2).epsilon(1e-15));
    CHECK(s(500) == Approx(3).epsilon(1e-15));
    CHECK(s(600) == Approx(2.5).epsilon(1e-15));
    CHECK(s(700) == 2);
    CHECK(s(900) == 2);
    CHECK(Spectrum()(550) == 0);
    CHECK(Spectrum(0.7)(550) == 0.7);
}

TEST_CASE("equal spacing changes how a spectrum is looked up, not what it is", "[spectrum]") {
    std::vector<double> even, values;
    for (int i = 0; i <= 40; ++i) {
        even.push_back(380 + 10.0 * i);
        values.push_back(std::sin(0.3 * i));
    }
    const Spectrum fast(even, values);
    // One more node on the last straight piece makes the spacing uneven and changes nothing else.
    even.insert(even.end() - 1, 775);
    values.insert(values.end() - 1, 0.5 * (values[39] + values[40]));
    const Spectrum slow(even, values);
    for (double nm = 379; nm <= 781; nm += 0.37)
        CHECK_THAT(fast(nm), Catch::WithinAbs(slow(nm), 1e-14));
}

TEST_CASE("light through a filter is the product at every node of either", "[spectrum]") {
    const Spectrum light({400, 500, 600}, {1, 2, 4}), filter({450, 500, 700}, {1, 0.5, 0});
    const Spectrum seen = light * filter;
    for (const double nm : {390.0, 400.0, 450.0, 500.0, 600.0, 700.0, 720.0})
        CHECK_THAT(seen(nm), Catch::WithinAbs(light(nm) * filter(nm), 1e-15));
    CHECK((Spectrum(2.0) * light)(500) == 4);
    CHECK((light * Spectrum(2.0))(500) == 4);
    CHECK((light * Spectrum())(500) == 0);
    CHECK((0.25 * light)(600) == 1);
}

TEST_CASE("the sum over the rendered range is exact for straight lines", "[spectrum]") {
    CHECK(Spectrum::integrate([](double) { return 1.0; }) == 400);
    CHECK(Spectrum::integrate([](double nm) { return nm; }) ==
          Approx(0.5 * (780.0 * 780 - 380.0 * 380)).epsilon(1e-14));
}

TEST_CASE("a spectrum that makes no sense is refused", "[spectrum]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(Spectrum({500, 400}, {1, 1}), Error);
    CHECK_THROWS_AS(Spectrum({500, 500}, {1, 1}), Error);
    CHECK_THROWS_AS(Spectrum({400, 500}, {1}), Error);
    CHECK_THROWS_AS(Spectrum(std::vector<double>{}, std::vector<double>{}), Error);
    CHECK_THROWS_AS(Spectrum({400, 500}, {1, nan}), Error);
    CHECK_THROWS_AS(Spectrum({400, nan}, {1, 1}), Error);
    CHECK_THROWS_AS(Spectrum(nan), Error);
}
