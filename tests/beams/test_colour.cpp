// Coloured stones by beams: Beer and Lambert's law along paths, and the pictures that rays make.
#include <catch2/catch.hpp>

#include "beams/footprint.hpp"
#include "beams/tracer.hpp"
#include "math/decay.hpp"
#include "render/path_colour.hpp"
#include "support/compare_engines.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr double thickness = 2;
const std::vector<double> wavelengths{400, 450, 520, 600, 700};

/// Follows every beam to a depth; what goes down is seen, colour by colour.
struct Below {
    PathColour colour;
    std::vector<double> seen = std::vector<double>(wavelengths.size());
    double all = 0, absorbed = 0, lost = 0;

    double gain(double weight, int) const { return weight > 1e-18 ? 1 : 0; }
    int stand_in(double, double, int) const { return -1; }
    bool may_meet(int hits) const { return hits < 60; }
    void lose(double weight) { lost += weight; }
    void open() {}
    void close(int) {}
    double transmit(std::span<const Affine> lengths) { return colour.transmit(lengths); }
    void absorb(double weight) { absorbed += weight; }
    void see(const Leaf<IntensityResponse>& leaf) {
        const double weight = leaf.area * leaf.response.power();
        all += weight;
        if (!(leaf.k.value.z < 0)) return;
        for (std::size_t i = 0; i < seen.size(); ++i) seen[i] += weight * colour.tint()[i];
    }
};

/// A pixel of a plate so wide that no path reaches its rim, seen straight from above.
template <bool birefringent>
Below through_plate(const Crystal& c) {
    const Stone plate = box_stone({-1e4, -1e4, -thickness / 2}, {1e4, 1e4, thickness / 2});
    Camera camera = towards_origin(1);
    camera.kind = Camera::Kind::orthographic;
    const FacetSearch facets(plate);
    const RayField field = pixel_field(camera, 1, 1, 0, 0, facets.centre());
    std::vector<Footprint::Part> parts;
    std::size_t count = 0;
    Footprint(plate, camera, 1, 1).divide({0, 0, 1, 1}, parts, count);
    REQUIRE(count == 1);
    BeamTracer<IntensityResponse, birefringent, false, true> tracer(facets);
    tracer.set_medium(birefringent
                          ? Medium::uniaxial(c.indices.front()(0), c.indices.back()(0), c.axis)
                          : Medium::isotropic(c.indices.front()(0)));
    Below sink;
    sink.colour.set(c, wavelengths);
    tracer.trace(field, camera.right, parts[0].polygon, parts[0].facet, sink);
    CHECK(sink.all + sink.absorbed + sink.lost == Approx(1).epsilon(1e-13));
    return sink;
}

/// At normal incidence, with all reflections within the plate.
double through(double n, double internal) {
    const double r = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    return (1 - r) * (1 - r) * internal / (1 - r * r * internal * internal);
}

const Spectrum ruddy({380, 480, 560, 620, 780}, {1.2, 0.5, 2.2, 0.1, 0.05});
const Spectrum bluish({380, 500, 650, 780}, {0.1, 0.2, 1.6, 1.1});

/// The reds of ruby and spinel, two colours of a tourmaline whose axis lies across the view, and
/// crystals of both kinds that disperse light besides.
Crystal coloured(int kind) {
    Crystal c = kind == 0   ? glass(1.76)
                : kind == 1 ? uniaxial(1.644, 1.624, {1, 0, 0})
                            : zircon(normalised({2, 1, 1}));
    if (kind == 2) c.indices = {IndexFunction::cauchy(2.3784, 0.0134)};
    if (kind == 3)
        c.indices = {IndexFunction::cauchy(1.88, 0.013), IndexFunction::cauchy(1.93, 0.019)};
    c.absorption = {ruddy};
    if (c.birefringent()) c.absorption.push_back(bluish);
    return c;
}

}  // namespace

TEST_CASE("a decay is the exponential function", "[colour]") {
    CHECK(decay(0) == 1);
    for (double x = -30; x < 690; x += 0.37) {
        CAPTURE(x);
        CHECK(decay(x) == Approx(std::exp(-x)).epsilon(4e-16 * std::max(4.0, std::abs(x))));
    }
    CHECK(decay(1e9) == Approx(std::exp(-700.0)).epsilon(1e-12));
}

TEST_CASE("beams bring each colour through a plate as Beer and Lambert say", "[colour][slab]") {
    Crystal c = glass(1.5);
    c.absorption = {ruddy};
    c.fade = Fade{4, 1000, bluish};
    const Below below = through_plate<false>(c);
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const double nm = wavelengths[i];
        const double internal = std::exp(-(ruddy(nm) + (1 - bluish(nm)) / 4) * thickness);
        CHECK(below.seen[i] == Approx(through(1.5, internal)).epsilon(1e-13));
    }
}

TEST_CASE(
    "beams bring both colours of a pleochroic crystal, as of complex indices, through a plate",
    "[colour][slab]") {
    // As in test_absorption.cpp, for strong absorption on the scale of the plate, which is weak on
    // that of a wave.
    const double n_o = 1.6584, n_e = 1.4864;
    for (const double angle : {0.001, 10.0, 40.0, 65.0, 90.0}) {
        const double cosine = std::cos(angle * degree), sine = std::sin(angle * degree);
        Crystal crystal = uniaxial(n_o, n_e, {sine, 0, cosine});
        crystal.absorption = {ruddy, bluish};
        const Below below = through_plate<true>(crystal);
        for (std::size_t i = 0; i < wavelengths.size(); ++i) {
            const double nm = wavelengths[i], k0 = 2 * std::numbers::pi / (nm * 1e-6);
            const Complex o(n_o, ruddy(nm) / (2 * k0)), e(n_e, bluish(nm) / (2 * k0));
            const Complex n = 1.0 / std::sqrt(cosine * cosine / (o * o) + sine * sine / (e * e));
            const double x = through(n.real(), std::exp(-2 * k0 * n.imag() * thickness)),
                         y = through(n_o, std::exp(-ruddy(nm) * thickness));
            CAPTURE(angle, nm);
            CHECK(below.seen[i] == Approx((x + y) / 2).epsilon(1e-7));
        }
    }
}

TEST_CASE("beams and rays make the same picture of a coloured stone below a sky",
          "[colour][statistics]") {
    const int kind = GENERATE(0, 1, 2, 3);
    CAPTURE(kind);
    compare_engines(lit(picture_scene(coloured(kind), slope(normalised({1, 2, 4})))), 128, 64, 8);
}

TEST_CASE("beams of coloured stones that go on as rays find what rays find",
          "[colour][statistics]") {
    const int kind = GENERATE(0, 1, 3);
    CAPTURE(kind);
    Scene scene = lit(picture_scene(coloured(kind), slope({0, 1, 0})));
    scene.gems.push_back(
        {cube_stone().transformed(Transform::translation({2.2, 0, 0})), coloured(0), "cube"});
    compare_engines(scene, 64, 64, 6);
}

TEST_CASE("beams and rays agree on the polarisation of a grey crystal", "[colour][statistics]") {
    Crystal grey = uniaxial(1.644, 1.624, normalised({2, 1, 1}));
    grey.absorption = {Spectrum(0.9), Spectrum(0.2)};
    compare_engines(lit(picture_scene(grey, slope({1, 0, 0}))), 128, 32, 8, true);
}

TEST_CASE("no light grows on its way through a coloured stone, however it grazes the facets",
          "[colour][property]") {
    struct Least : Below {
        double least = 0;
        bool may_meet(int hits) const { return hits < 9; }
        double transmit(std::span<const Affine> lengths) {
            for (const Affine& length : lengths) least = std::min(least, length.value);
            return Below::transmit(lengths);
        }
    };
    const Scene scene = picture_scene(coloured(1), furnace());
    const FacetSearch facets(scene.gems[0].stone);
    const Footprint footprint(scene.gems[0].stone, scene.camera, 12, 12);
    BeamTracer<IntensityResponse, true, false, true> tracer(facets);
    tracer.set_medium(Medium::uniaxial(1.644, 1.624, {1, 0, 0}));
    Least sink;
    sink.colour.set(scene.gems[0].crystal, wavelengths);
    std::vector<Footprint::Part> parts;
    for (int pixel = 0; pixel < 144; ++pixel) {
        const int x = pixel % 12, y = pixel / 12;
        std::size_t count = 0;
        footprint.divide({x, y, x + 1, y + 1}, parts, count);
        const RayField field = pixel_field(scene.camera, 12, 12, x, y, facets.centre());
        for (std::size_t i = 0; i < count; ++i) {
            if (parts[i].facet < 0) continue;
            tracer.trace(field, scene.camera.right, parts[i].polygon, parts[i].facet, sink);
        }
    }
    CHECK(sink.least == 0);
}

TEST_CASE("a picture by beams of a coloured plate shows its spectrum's colour", "[colour]") {
    // Of index 1 and over white: nothing is reflected, so the picture is the spectrum's own.
    Crystal c = glass(1);
    c.absorption = {ruddy};
    Scene scene = scene_of(box_stone({-9, -9, -thickness / 2}, {9, 9, thickness / 2}), c);
    scene.camera = towards_origin(0.01);
    const bool as_rays = GENERATE(false, true);
    if (as_rays) scene.things.push_back(ball({0, 0, 99}, 1));
    std::vector<double> nodes, values;
    for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
        nodes.push_back(nm);
        values.push_back(std::exp(-ruddy(nm) * thickness) * white()(nm));
    }
    const Rgb expected = rgb_of(Spectrum(nodes, values));
    RenderOptions options = small(as_rays ? 32 : 2, 64);
    options.engine = Engine::beams;
    const Rendering picture = render(scene, options);
    for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(i, as_rays);
        CHECK(mean_of(picture.image.rgb, i, 3) ==
              Approx(expected[i]).margin((as_rays ? 2e-3 : 3e-4) * expected[0]));
    }
}

TEST_CASE("pixels by rays do not depend on pixels by beams before them", "[beams]") {
    Scene scene = lit(picture_scene(coloured(1), slope({0, 1, 0})));
    scene.camera = towards_origin(5);
    testing::Random random(1);
    Gem by_rays{brilliant_stone().transformed(Transform::translation({2.2, 0, 0})), topaz(random),
                "topaz"};
    scene.gems.push_back(by_rays);
    const auto picture = [&](int threads) {
        RenderOptions options = small(48, 2);
        options.engine = Engine::beams;
        options.threads = threads;
        return render(scene, options).image.rgb;
    };
    const auto one = picture(1);
    for (const int threads : {2, 7}) CHECK(picture(threads) == one);
}

TEST_CASE("in a furnace a coloured stone keeps what it does not show", "[colour][furnace]") {
    const int kind = GENERATE(0, 1, 2, 3);
    CAPTURE(kind);
    Scene scene = picture_scene(coloured(kind), furnace());
    scene.camera = towards_origin(1);
    RenderOptions options = small(8, 512);
    options.engine = Engine::beams;
    options.bands = 1;
    const Rendering beams = render(scene, options);
    REQUIRE(beams.report.absorbed > 0.2);
    options.engine = Engine::rays;
    const Rendering rays = render(scene, options);
    // Both in the mean over the eye's colours.
    CHECK(beams.report.absorbed == Approx(rays.report.absorbed).epsilon(0.01));
}
