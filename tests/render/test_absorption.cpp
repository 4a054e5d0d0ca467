// What stones keep: Beer and Lambert's law for each wave, by its own polarisation.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/gem_scenes.hpp"
#include "support/recorder.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr double thickness = 2;

/// So wide that no path reaches its rim.
Stone plate() { return box_stone({-1e4, -1e4, -thickness / 2}, {1e4, 1e4, thickness / 2}); }

/// From above along -z; the picture's right is x.
const SensorRay down{{0, 0, 5}, {0, 0, -1}, {1, 0, 0}};

/// Light through a plate at normal incidence, all reflections within it added up, not as fields.
double through(double n, double internal) {
    const double r = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    return (1 - r) * (1 - r) * internal / (1 - r * r * internal * internal);
}

double reflected(double n, double internal) {
    const double r = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    return r + (1 - r) * (1 - r) * r * internal * internal / (1 - r * r * internal * internal);
}

/// What is seen from above a plate under a sky that is 1 below and 0 above.
Stokes from_below(const Crystal& crystal, double nm = 589.3) {
    Scene scene = scene_of(plate(), crystal, slope({0, 0, -1}));
    TraceOptions options;
    options.wavelength_nm = nm;
    return trace_one(scene, down, options);
}

Crystal trichroic(const std::array<Vec3, 3>& axes) {
    Crystal c;
    c.indices = {IndexFunction(1.542), IndexFunction(1.547), IndexFunction(1.551)};
    c.axis = axes[0];
    c.third_axis = axes[2];
    c.absorption = {Spectrum({400, 700}, {0.1, 0.4}), Spectrum({400, 700}, {0.9, 0.2}),
                    Spectrum({400, 700}, {0.3, 1.5})};
    return c;
}

}  // namespace

TEST_CASE("a grey glass plate lets through what Beer and Lambert say", "[absorption][slab]") {
    Crystal c = glass(1.5);
    c.absorption = {Spectrum({400, 600}, {0.2, 0.6})};
    for (const double nm : {400.0, 450.0, 550.0, 700.0}) {
        const double alpha = nm >= 600 ? 0.6 : 0.2 + 0.4 * (nm - 400) / 200;
        CHECK(difference(from_below(c, nm),
                         {through(1.5, std::exp(-alpha * thickness)), 0, 0, 0}) <= 1e-14);
    }
}

TEST_CASE("tourmaline has two colours: across its axis, and for light polarised along it",
          "[absorption][slab]") {
    const double n_o = 1.644, n_e = 1.624, alpha_o = 1.3, alpha_e = 0.2;
    Crystal c = uniaxial(n_o, n_e, {1, 0, 0});
    c.absorption = {Spectrum(alpha_o), Spectrum(alpha_e)};
    const double o = through(n_o, std::exp(-alpha_o * thickness)),
                 e = through(n_e, std::exp(-alpha_e * thickness));
    // The axis along the picture's x: that polarisation is the extraordinary wave.
    CHECK(difference(from_below(c), {(e + o) / 2, (e - o) / 2, 0, 0}) <= 1e-14);
    // Along the axis there is only the ordinary colour.
    c.axis = {0, 0, 1};
    CHECK(difference(from_below(c), {o, 0, 0, 0}) <= 1e-14);
}

TEST_CASE("iolite has three colours, two to be seen along each of its axes", "[absorption][slab]") {
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const double n[] = {1.542, 1.547, 1.551};
    for (const double nm : {400.0, 520.0, 700.0}) {
        const auto alpha = [&](double a, double b) { return a + (b - a) * (nm - 400) / 300; };
        const double part[] = {through(n[0], std::exp(-thickness * alpha(0.1, 0.4))),
                               through(n[1], std::exp(-thickness * alpha(0.9, 0.2))),
                               through(n[2], std::exp(-thickness * alpha(0.3, 1.5)))};
        const auto expected = [&](int along_x, int along_y) {
            return Stokes{(part[along_x] + part[along_y]) / 2, (part[along_x] - part[along_y]) / 2,
                          0, 0};
        };
        CAPTURE(nm);
        CHECK(difference(from_below(trichroic({x, y, z}), nm), expected(0, 1)) <= 1e-13);
        CHECK(difference(from_below(trichroic({y, z, x}), nm), expected(2, 0)) <= 1e-13);
        CHECK(difference(from_below(trichroic({z, x, y}), nm), expected(1, 2)) <= 1e-13);
    }
}

TEST_CASE("the extraordinary wave decays as in a crystal of complex indices",
          "[absorption][slab]") {
    // Wave normal at an angle to the axis: n(angle) with complex n_o, n_e; its imaginary part acts
    // along the wave normal.
    const double n_o = 1.6584, n_e = 1.4864, nm = 589.3, k0 = 2 * std::numbers::pi / (nm * 1e-6);
    const double alpha_o = 0.02, alpha_e = 0.5;
    for (const double angle : {10.0, 40.0, 65.0, 85.0}) {
        const double c = std::cos(angle * degree), s = std::sin(angle * degree);
        Crystal crystal = uniaxial(n_o, n_e, {s, 0, c});
        crystal.absorption = {Spectrum(alpha_o), Spectrum(alpha_e)};
        const Complex o(n_o, alpha_o / (2 * k0)), e(n_e, alpha_e / (2 * k0));
        const Complex n = 1.0 / std::sqrt(c * c / (o * o) + s * s / (e * e));
        const double x = through(n.real(), std::exp(-2 * k0 * n.imag() * thickness)),
                     y = through(n_o, std::exp(-alpha_o * thickness));
        CAPTURE(angle);
        CHECK(difference(from_below(crystal), {(x + y) / 2, (x - y) / 2, 0, 0}) <= 1e-9);
    }
}

TEST_CASE("a plate sends back what it neither keeps nor lets through", "[absorption][slab]") {
    Crystal c = glass(1.7);
    c.absorption = {Spectrum(0.4)};
    const double internal = std::exp(-0.4 * thickness);
    const Scene scene = scene_of(plate(), c);
    const Traced seen = trace(scene, std::span(&down, 1), {});
    const double left = through(1.7, internal) + reflected(1.7, internal);
    CHECK(std::abs(seen.stokes[0].s0 - left) <= 1e-14);
    CHECK(std::abs(seen.absorbed[0].s0 - (1 - left)) <= 1e-14);
}

TEST_CASE("POV-Ray's attenuation is Beer's law from a power of 1000, else a fraction",
          "[absorption][slab]") {
    Crystal c = glass(1);
    for (const double colour : {0.0, 0.25, 0.9}) {
        for (const double power : {0.0, 1.0, 2.0, 3.5}) {
            c.fade = Fade{4, power, Spectrum(colour)};
            const double part = colour + (1 - colour) / (1 + std::pow(thickness / 4, power));
            CHECK(difference(from_below(c), {part, 0, 0, 0}) <= 1e-14);
        }
        c.fade = Fade{4, 1001, Spectrum(colour)};
        const double part = std::exp(-(1 - colour) * thickness / 4);
        CHECK(difference(from_below(c), {part, 0, 0, 0}) <= 1e-14);
    }
}

TEST_CASE("a picture of a coloured stone shows its spectrum's colour", "[absorption]") {
    // A plate of index 1 over white: nothing is reflected, so the picture is the spectrum's own.
    const Spectrum alpha({400, 500, 600, 700}, {0.9, 0.1, 0.5, 0.05});
    Crystal c = glass(1);
    c.absorption = {alpha};
    Scene scene = scene_of(plate(), c);
    scene.camera = towards_origin(1);
    scene.camera.kind = Camera::Kind::orthographic;
    std::vector<double> nodes, values;
    for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
        nodes.push_back(nm);
        values.push_back(std::exp(-alpha(nm) * thickness) * white()(nm));
    }
    const Rgb expected = rgb_of(Spectrum(nodes, values));
    const Rendering picture = render(scene, small(16, 256));
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(mean_of(picture.image.rgb, i, 3) == Approx(expected[i]).margin(2e-3));
    }
    CHECK(picture.report.absorbed > 0.1);
}
