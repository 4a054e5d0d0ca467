// The observer, the lights and the reflectances, against the figures the CIE and physics give.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "math/error.hpp"
#include "spectrum/spectrum.hpp"

using namespace icespar;

namespace {

std::array<double, 2> chromaticity(const Spectrum& light) {
    const Xyz xyz = xyz_from_rgb(rgb_of(light));
    const double sum = xyz[0] + xyz[1] + xyz[2];
    return {xyz[0] / sum, xyz[1] / sum};
}

Rgb random_colour(std::mt19937& random) {
    std::uniform_real_distribution<double> part(0, 1);
    return {part(random), part(random), part(random)};
}

struct Published {
    const char* name;
    double x, y;
};

/// The light of that name has luminance 1, and this chromaticity is the published one.
void check(const Published& published, double x, double y) {
    CAPTURE(published.name);
    CHECK_THAT(xyz_from_rgb(rgb_of(illuminant(published.name)))[1], Catch::WithinAbs(1, 1e-13));
    CHECK_THAT(x, Catch::WithinAbs(published.x, 6e-5));
    CHECK_THAT(y, Catch::WithinAbs(published.y, 6e-5));
}

}  // namespace

TEST_CASE("daylight D65 at value 1 is RGB 1, 1, 1", "[colour][convention]") {
    for (const double channel : rgb_of(white())) CHECK_THAT(channel, Catch::WithinAbs(1, 1e-14));
    CHECK(white()(560) > 0.9);
    CHECK(white()(560) < 1.1);
}

TEST_CASE("the equal-energy light of luminance 1 has radiance 1", "[colour][convention]") {
    CHECK_THAT(Spectrum::integrate([](double nm) { return observer(nm)[1]; }),
               Catch::WithinAbs(1, 1e-14));
    CHECK(illuminant("E")(400) == 1);
    CHECK(illuminant("e")(700) == 1);
}

TEST_CASE("every illuminant has luminance 1 and the chromaticity the CIE publishes", "[colour]") {
    // CIE 015:2018, table 3, for 380 .. 780 nm at 5 nm; E follows from the observer's equal areas.
    const Published published =
        GENERATE(Published{"D65", 0.31272, 0.32903}, Published{"D50", 0.34567, 0.35851},
                 Published{"A", 0.44758, 0.40745}, Published{"E", 0.33333, 0.33333},
                 Published{"D55", 0.33243, 0.34744}, Published{"D75", 0.29903, 0.31488});
    // The CIE sums at 5 nm; a line between the nodes moves a chromaticity by half of the fourth
    // digit.
    const auto [x, y] = chromaticity(illuminant(published.name));
    check(published, x, y);
}

TEST_CASE("fluorescent lamps and LEDs have the chromaticities the CIE publishes", "[colour]") {
    // CIE 015:2018, tables 10.1 and 12.1.
    const Published published =
        GENERATE(Published{"F1", 0.3131, 0.3371}, Published{"F2", 0.3721, 0.3751},
                 Published{"F3", 0.4091, 0.3941}, Published{"F4", 0.4402, 0.4031},
                 Published{"F5", 0.3138, 0.3452}, Published{"F6", 0.3779, 0.3882},
                 Published{"F7", 0.3129, 0.3292}, Published{"F8", 0.3458, 0.3586},
                 Published{"F9", 0.3741, 0.3727}, Published{"F10", 0.3458, 0.3588},
                 Published{"FL11", 0.3805, 0.3769}, Published{"f12", 0.4370, 0.4042},
                 Published{"LED-B1", 0.4560, 0.4078}, Published{"LED-B2", 0.4357, 0.4012},
                 Published{"LED-B3", 0.3756, 0.3723}, Published{"LED-B4", 0.3422, 0.3502},
                 Published{"LED-B5", 0.3118, 0.3236}, Published{"LED-BH1", 0.4474, 0.4066},
                 Published{"LED-RGB1", 0.4557, 0.4211}, Published{"LED-V1", 0.4548, 0.4044},
                 Published{"led-v2", 0.3781, 0.3775}, Published{"C", 0.31006, 0.31616});
    const Spectrum light = illuminant(published.name);
    // Summed as the CIE sums: at the nodes.
    double sum[3] = {};
    for (double nm = 380; nm <= 780; nm += 5)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += light(nm) * observer(nm)[i];
    const double all = sum[0] + sum[1] + sum[2];
    check(published, sum[0] / all, sum[1] / all);
}

TEST_CASE("red, green and blue have the luminances of Rec. 709", "[colour]") {
    CHECK_THAT(xyz_from_rgb({1, 0, 0})[1], Catch::WithinAbs(0.2126, 1e-4));
    CHECK_THAT(xyz_from_rgb({0, 1, 0})[1], Catch::WithinAbs(0.7152, 1e-4));
    CHECK_THAT(xyz_from_rgb({0, 0, 1})[1], Catch::WithinAbs(0.0722, 1e-4));
}

TEST_CASE("to XYZ and back is the same colour", "[colour]") {
    const Rgb back = rgb_from_xyz(xyz_from_rgb({0.2, 0.7, 1.3}));
    CHECK_THAT(back[0], Catch::WithinAbs(0.2, 1e-14));
    CHECK_THAT(back[1], Catch::WithinAbs(0.7, 1e-14));
    CHECK_THAT(back[2], Catch::WithinAbs(1.3, 1e-14));
}

TEST_CASE("the eye sees nothing outside the rendered range", "[colour]") {
    CHECK(observer(379.9) == Xyz{0, 0, 0});
    CHECK(observer(780.1) == Xyz{0, 0, 0});
    CHECK(observer(std::nan("")) == Xyz{0, 0, 0});
    CHECK(observer(780)[0] > 0);
    CHECK(observer(555)[1] > observer(550)[1]);
    CHECK(observer(555)[1] > observer(560)[1]);
}

TEST_CASE("a blackbody peaks where Wien says", "[colour][blackbody]") {
    const double wien_nm_kelvin = 2.897771955e6;
    const double kelvin = GENERATE(4500.0, 5000.0, 6000.0, 7000.0);
    const Spectrum light = blackbody(kelvin);
    double best = 0, peak_nm = 0;
    for (double nm = 380; nm <= 780; nm += 1)
        if (light(nm) > best) best = light(nm), peak_nm = nm;
    CHECK_THAT(peak_nm, Catch::WithinAbs(wien_nm_kelvin / kelvin, 1));
    CHECK_THAT(xyz_from_rgb(rgb_of(light))[1], Catch::WithinAbs(1, 1e-13));
}

TEST_CASE("illuminant A is a blackbody", "[colour][blackbody]") {
    // The CIE defines A by Planck's law at 2848 K with c2 = 1.435e-2 m K, an older value.
    const double c2 = 6.62607015e-34 * 299792458 / 1.380649e-23;
    const Spectrum lamp = illuminant("A"), planck = blackbody(2848 * c2 / 1.435e-2);
    for (double nm = 380; nm <= 780; nm += 5) {
        CAPTURE(nm);
        // The table has six figures, and is taken to be linear in between.
        CHECK_THAT(planck(nm) / lamp(nm), Catch::WithinAbs(1, 1.5e-4));
    }
}

TEST_CASE("a lamp outside what can be rendered is refused with the remedy", "[colour]") {
    CHECK_THROWS_AS(blackbody(499), Error);
    CHECK_THROWS_AS(blackbody(50001), Error);
    CHECK_THROWS_AS(blackbody(std::nan("")), Error);
    CHECK_NOTHROW(blackbody(500));
    CHECK_THROWS_WITH(illuminant("D66"), Catch::Contains("D66") && Catch::Contains("F1 to F12"));
}

TEST_CASE("a reflectance looks like its colour under D65, exactly", "[colour][reflectance]") {
    std::mt19937 random(7);
    for (int i = 0; i < 100; ++i) {
        const Rgb wanted = random_colour(random);
        const Spectrum reflectance = reflectance_from_rgb(wanted);
        const Rgb seen = rgb_of(reflectance * white());
        // The same light as a tracer meets it: wavelength by wavelength.
        Xyz xyz{};
        for (std::size_t j = 0; j < 3; ++j)
            xyz[j] = Spectrum::integrate(
                [&](double nm) { return reflectance(nm) * white()(nm) * observer(nm)[j]; });
        const Rgb traced = rgb_from_xyz(xyz);
        CAPTURE(i);
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK_THAT(seen[j], Catch::WithinAbs(wanted[j], 1e-12 * wanted[j]));
            CHECK_THAT(traced[j], Catch::WithinAbs(wanted[j], 1e-12 * wanted[j]));
        }
    }
}

TEST_CASE("no reflectance gives back more than it got, or less than nothing",
          "[colour][reflectance]") {
    for (int corner = 0; corner < 8; ++corner) {
        const Spectrum s = reflectance_from_rgb(
            {1.0 * (corner & 1), 1.0 * (corner >> 1 & 1), 1.0 * (corner >> 2 & 1)});
        double least = 1, most = 0;
        for (double nm = 380; nm <= 780; nm += 0.5) {
            least = std::min(least, s(nm));
            most = std::max(most, s(nm));
        }
        CAPTURE(corner);
        CHECK(least >= -1e-14);
        CHECK(most <= 1 + 1e-14);
    }
}

TEST_CASE("a white surface reflects all, and colours mix linearly", "[colour][reflectance]") {
    const Spectrum all = reflectance_from_rgb({1, 1, 1}),
                   nearly = reflectance_from_rgb({1, 1, 1 - 1e-15});
    const Rgb a{0.1, 0.9, 0.3}, b{2.5, 0, 0.4};
    const Spectrum sum = reflectance_from_rgb({a[0] + 2 * b[0], a[1] + 2 * b[1], a[2] + 2 * b[2]});
    for (double nm = 380; nm <= 780; nm += 2.5) {
        CHECK(all(nm) == 1);
        CHECK_THAT(nearly(nm), Catch::WithinAbs(1, 1e-14));
        CHECK_THAT(
            sum(nm),
            Catch::WithinAbs(reflectance_from_rgb(a)(nm) + 2 * reflectance_from_rgb(b)(nm), 1e-14));
    }
    CHECK_THROWS_AS(reflectance_from_rgb({0, std::nan(""), 0}), Error);
}
