// Stones that absorb, in parallel views.
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"
#include "views/transmission.hpp"
#include "views/view.hpp"

using namespace icespar;
using namespace icespar::testing;

TEST_CASE("what passes through a wedge is the mean over its thickness", "[views]") {
    // Over the unit square exp(-a - b x - c y) is a product of two means.
    const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto mean = [](double slope) { return slope == 0 ? 1 : -std::expm1(-slope) / slope; };
    for (const double b : {0.0, 1e-9, 1e-3, 0.02, 0.049, 0.06, 1.0, 7.0}) {
        for (const double c : {0.0, 1e-6, 0.03, 0.2, 3.0, -2.0}) {
            const double exact = std::exp(-0.4) * mean(b) * mean(c);
            CAPTURE(b, c);
            CHECK(std::abs(mean_transmission(square, {0.4, b, c}) / exact - 1) < 1e-12);
        }
    }
}

TEST_CASE("the mean over a sliver lies between those of its corners", "[views]") {
    Random random(5);
    for (int i = 0; i < 20'000; ++i) {
        const Point2 a{random.uniform(-1, 1), random.uniform(-1, 1)},
            along{random.uniform(-1, 1), random.uniform(-1, 1)},
            across = std::pow(10, random.uniform(-17, -14)) * Point2{-along.y, along.x};
        const Polygon sliver{a, a + along, a + 0.7 * along + across, a + 0.3 * along + across};
        if (!(extent(sliver).area > 0)) continue;
        const Affine depth{3, random.uniform(-1, 1), random.uniform(-1, 1)};
        const auto [low, high] = range_of(sliver, depth);
        const double mean = mean_transmission(sliver, depth);
        REQUIRE(mean <= std::exp(-low));
        REQUIRE(mean >= std::exp(-high));
    }
}

TEST_CASE("light that runs along two faces of a coloured cube does not grow", "[views]") {
    const Medium ruby = Medium::uniaxial(1.768, 1.76, {0, 0, 1});
    const double strengths[] = {0.1, 0.2};
    const Absorption colour = absorption_of(ruby, strengths);
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        ViewOptions options;
        options.bound = {};
        options.error = 2e-3;
        options.sample_effort = 4;
        options.outlines = i % 2 == 0;  // by beams; else by paths
        options.seed = static_cast<std::uint64_t>(i);
        // Nothing may make it last.
        int looks = 0;
        options.go_on = [&] { return ++looks < 1000; };
        // But for rounding, across one axis.
        const double lean = random.uniform(0.1, 1.4);
        const Vec3 direction{1e-17 * random.uniform(-9, 9), std::sin(lean), -std::cos(lean)};
        const Exits e =
            trace_view(cube_stone(), ruby, {direction, random.direction()}, options, {&colour, 1});
        double sum = e.absorbed + e.residue;
        for (std::size_t k = 0; k < e.size(); ++k) {
            const double light = e.weight[k].s0 * e.area[k];
            REQUIRE(light <= e.area_total);
            sum += light * static_cast<double>(e.images.size());
        }
        CAPTURE(i);
        CHECK(std::abs(sum / e.area_total - 1) < 1e-3);
    }
}

TEST_CASE("light that a crystal cube keeps for thousands of faces stays as much as it is",
          "[views]") {
    ViewOptions options;
    options.bound = {};
    options.error = 1e-4;
    options.max_beams = 50'000;
    options.outlines = GENERATE(false, true);
    int looks = 0;
    options.go_on = [&] { return ++looks < 2000; };
    const Exits e = trace_view(cube_stone(), Medium::uniaxial(1.925, 1.984, {1, 0, 0}),
                               {{-0.65382861, -0.12961363, 0.78397547}, {0.3, 0.2, 0.9}}, options);
    double sum = e.residue;
    for (std::size_t i = 0; i < e.size(); ++i) {
        sum += e.weight[i].s0 * e.area[i] * static_cast<double>(e.images.size());
    }
    CHECK(std::abs(sum / e.area_total - 1) < 1e-6);
    CHECK(e.residue < 1e-4 * e.area_total);
}

TEST_CASE("strips of a wedge follow the exponential and share its mean", "[views]") {
    const Polygon wedge{{0, 0}, {2, 0.3}, {1.7, 1.2}, {0.1, 0.8}};
    for (const Affine& depth :
         {Affine{0.2, 0, 0}, Affine{0.2, 1e-3, 0}, Affine{0.1, 0.4, -0.1}, Affine{0.5, -0.2, 3}}) {
        double sum = 0, area = 0, worst = 0;
        each_strip(wedge, depth, [&](PolygonView strip, const Affine& passed) {
            const Extent e = extent(strip);
            sum += e.area * passed(e.centroid);
            area += e.area;
            for (const Point2& p : strip) {
                worst = std::max(worst, std::abs(passed(p) * std::exp(depth(p)) - 1));
            }
        });
        const double whole = extent(wedge).area;
        CHECK(std::abs(area - whole) < 1e-12);
        CHECK(std::abs(sum / whole - mean_transmission(wedge, depth)) < 1e-12);
        CHECK(worst < (depth.dx == 1e-3 ? 0.01 : 4e-3));
    }
}

TEST_CASE("a plate that absorbs transmits and reflects as the sum over its echoes", "[views]") {
    // Along the axis of a uniaxial plate both waves see the ordinary index and absorption.
    constexpr double n = 1.6, alpha = 0.3, thickness = 2;
    constexpr double r = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    const double t = std::exp(-alpha * thickness);
    const double echoes = (1 - r) * (1 - r) * t / (1 - r * r * t * t);
    Absorption ordinary;
    ordinary.tensor = RealTensor::diagonal(n * alpha, n * alpha, 5);
    Absorption grey;
    grey.per_length = alpha;
    struct Case {
        Medium medium;
        Absorption absorption;
    };
    const Case cases[] = {
        {Medium::uniaxial(n, 1.5, {0, 0, 1}), ordinary},
        {Medium::uniaxial(n, 1.5, {0, 0, 1}), grey},
        {Medium::isotropic(n), {RealTensor::diagonal(n * alpha, n * alpha, n * alpha)}},
        {Medium::isotropic(n), grey}};
    for (const Case& c : cases) {
        ViewOptions options;
        options.bound = 0;
        options.max_beams = 200;
        const Exits e = trace_view(cube_stone(), c.medium, {}, options, {&c.absorption, 1});
        double back = 0, through = 0;
        for (std::size_t i = 0; i < e.size(); ++i) {
            (e.direction[i].z > 0 ? back : through) += e.weight[i].s0 * e.area[i];
        }
        const double part = static_cast<double>(e.images.size()) / e.area_total;
        CHECK(std::abs(part * through - echoes) < 1e-14);
        CHECK(std::abs(part * back - (r + r * t * echoes)) < 1e-14);
        CHECK(std::abs(e.absorbed / e.area_total - (1 - r - echoes - r * t * echoes)) < 1e-14);
    }
}

TEST_CASE("what coloured stones return, keep and leave untraced is all light", "[views][furnace]") {
    icespar::testing::Random random(21);
    for (int i = 0; i < 12; ++i) {
        const Vec3 axis = random.direction();
        const Medium medium =
            i % 2 == 0 ? Medium::isotropic(1.76) : Medium::uniaxial(1.77, 1.76, axis);
        Absorption colour;
        colour.tensor = RealTensor::diagonal(0.4, 0.4, 0.4);
        if (i % 2 == 1) colour.tensor = colour.tensor + 1.5 * dyad(axis);
        colour.per_length = 0.05 * i;
        ViewOptions options;
        options.max_beams = 2000;
        const Exits e = trace_view(brilliant_stone(), medium, {random.direction(), axis}, options,
                                   {&colour, 1});
        double traced = 0;
        for (std::size_t x = 0; x < e.size(); ++x) traced += e.weight[x].s0 * e.area[x];
        traced *= static_cast<double>(e.images.size());
        CHECK(std::abs(traced + e.untraced + e.absorbed - e.area_total) < 1e-11 * e.area_total);
        CHECK(e.absorbed > 0.1 * e.area_total);
    }
}

TEST_CASE("colours that share their beams pass as each would alone", "[views]") {
    const Vec3 axis = normalised(Vec3{0.3, 1, 0.5});
    const Medium media[] = {Medium::isotropic(1.76), Medium::uniaxial(1.62, 1.66, axis),
                            Medium::biaxial({1.6, 1.64, 1.7}, axis, any_perpendicular(axis))};
    for (const Medium& medium : media) {
        std::vector<Absorption> colours;
        for (const double strength : {0.0, 0.002, 0.6, 4.0}) {
            std::vector<double> along{strength};
            if (medium.birefringent) along.push_back(0.3);
            if (medium.symmetry == Symmetry::biaxial) along.push_back(2 * strength);
            colours.push_back(absorption_of(medium, along));
            colours.back().per_length = 0.1 * strength;
        }
        ViewOptions options;
        options.bound = 0;
        options.max_beams = 0;
        options.max_hits = 4;
        options.outlines = true;
        const ParallelView view{{0.2, 0.1, -1}};
        const Exits together = trace_view(brilliant_stone(), medium, view, options, colours);
        const double count = static_cast<double>(colours.size());
        double absorbed = 0, cut = 0;
        for (std::size_t c = 0; c < colours.size(); ++c) {
            const Exits alone =
                trace_view(brilliant_stone(), medium, view, options, {&colours[c], 1});
            absorbed += alone.absorbed / count;
            cut += alone.cut / count;
            std::array<double, 2> light{}, truth{};
            for (std::size_t i = 0; i < alone.size(); ++i) {
                const double seen = alone.weight[i].s0 * alone.area[i];
                truth[0] += seen;
                truth[1] += seen * alone.direction[i].x;
            }
            double worst = 0;
            for (std::size_t i = 0; i < together.size(); ++i) {
                const double seen =
                    together.weight[i].s0 * together.tint_of(i)[c] * together.area[i];
                light[0] += seen;
                light[1] += seen * together.direction[i].x;
                // The picture's depth has the same mean.
                if (together.hits[i] == 1) continue;
                const PolygonView polygon(together.corners.data() + together.outline[i],
                                          together.outline[i + 1] - together.outline[i]);
                double mean = 0;
                for (std::size_t d = 0; d < colours.size(); ++d) {
                    mean += mean_transmission(polygon, together.depth(i, d)) / count;
                }
                const double left = mean_transmission(polygon, together.depth(i, c));
                worst = std::max(worst, std::abs(left / mean - together.tint_of(i)[c]));
            }
            CAPTURE(static_cast<int>(medium.symmetry), c);
            CHECK(std::abs(light[0] - truth[0]) < 1e-9 * truth[0]);
            CHECK(std::abs(light[1] - truth[1]) < 1e-9 * truth[0]);
            CHECK(worst < 1e-7);
        }
        CHECK(std::abs(together.absorbed - absorbed) < 1e-8);
        CHECK(std::abs(together.cut - cut) < 1e-8);
    }
}

TEST_CASE("an absorption that has other axes than its medium is refused", "[views]") {
    Absorption odd;
    odd.tensor = dyad(normalised(Vec3{1, 1, 0}));
    for (const Medium& medium : {Medium::isotropic(1.5), Medium::uniaxial(1.5, 1.6, {0, 0, 1})}) {
        CHECK_THROWS_WITH(trace_view(cube_stone(), medium, {}, {}, {&odd, 1}),
                          Catch::Matchers::Contains("the axes of the medium"));
    }
}

TEST_CASE("a coloured stone returns what its rays return, on average", "[views]") {
    const Vec3 axis = normalised(Vec3{1, 0.4, 0.3});
    Crystal crystal = uniaxial(1.642, 1.622, axis);
    crystal.absorption = {Spectrum(1.2), Spectrum(0.2)};
    Scene scene = scene_of(brilliant_stone(), crystal, slope(axis));
    scene.environment.illuminant = Spectrum(1.0);
    Absorption colour;
    const double across = 1.642 * 1.2, along = 1.622 * 0.2;
    colour.tensor = RealTensor::diagonal(across, across, across) + (along - across) * dyad(axis);
    ViewOptions options;
    options.bound = 2e-3;
    options.outlines = true;
    const Exits e = trace_view(scene.gems[0].stone, Medium::uniaxial(1.642, 1.622, axis), {},
                               options, {&colour, 1});
    double seen = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
        for (const PictureImage& image : e.images) {
            seen += e.weight[i].s0 * e.area[i] * 0.5 *
                    (1 + dot(image.of(e.direction[i], e.frame), axis));
        }
    }
    // Rays on a grid over the table, beside which the stone is not counted.
    std::vector<SensorRay> rays;
    constexpr int grid = 70;
    for (int y = 0; y < grid; ++y) {
        for (int x = 0; x < grid; ++x) {
            rays.push_back({{2.2 * ((x + 0.5) / grid - 0.5), 2.2 * ((y + 0.5) / grid - 0.5), 5},
                            {0, 0, -1},
                            {1, 0, 0}});
        }
    }
    TraceOptions how;
    how.wavelength_nm = 550;
    how.threshold = 1e-3;
    const double beside = 0.5 * (1 - axis.z);
    double sum = 0;
    for (const Stokes& s : trace(scene, rays, how).stokes) {
        if (std::abs(s.s0 - beside) > 1e-12) sum += s.s0;
    }
    const double mean = sum * 2.2 * 2.2 / (grid * grid);
    CHECK(std::abs(mean - seen) < 0.01 * mean);
}
