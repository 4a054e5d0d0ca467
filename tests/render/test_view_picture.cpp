// Pictures by exact beams are those of the other engines, with less noise or none.
#include <catch2/catch.hpp>

#include "polarisation/mueller.hpp"
#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

Scene parallel(Crystal crystal, Environment environment) {
    Scene scene = picture_scene(std::move(crystal), std::move(environment));
    Camera& c = scene.camera;
    c.kind = Camera::Kind::orthographic;
    c.direction = normalised(Vec3{0.2, -0.3, -1});
    c.location = -5.0 * c.direction;
    c.right = 2.6 * normalised(cross(c.direction, Vec3{0, 1, 0}));
    c.up = cross(c.right, c.direction);
    return scene;
}

Rendering rendered(const Scene& scene, Engine engine, int samples, double error, bool stokes) {
    RenderOptions options = small(16, samples);
    options.engine = engine;
    options.error = error;
    options.stokes = stokes;
    return render(scene, options);
}

/// Root mean square of the differences of two pictures.
double apart(const std::vector<float>& a, const std::vector<float>& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

Environment lamps_and_slope() {
    Environment sky = slope(normalised(Vec3{0.1, 0.3, 1}));
    sky.discs.push_back({normalised(Vec3{0.5, 0.2, 1}), std::cos(0.2), Spectrum(5.0)});
    return sky;
}

}  // namespace

TEST_CASE("in a furnace a picture by exact beams is 1 but for what the stone keeps",
          "[views][furnace]") {
    Crystal grey = quartz({0, 0, 1});
    grey.absorption = {Spectrum(0.3), Spectrum(0.1)};
    Crystal faded = glass(1.7);
    faded.fade = Fade{2, 1000, Spectrum(0.2)};
    for (const Crystal& crystal : {glass(2.417), quartz({0, 0, 1}), grey, faded}) {
        const Rendering r = rendered(parallel(crystal, furnace()), Engine::exact, 0, 0.02, false);
        CHECK(r.report.engine == Engine::exact);
        const double mean = mean_of(r.image.rgb, 1, 3);
        CHECK(std::abs(mean + r.report.absorbed - 1) < 1e-4);
        CHECK((r.report.absorbed > 0.1) == crystal.absorbs());
        CHECK(r.report.dropped < 1e-5);  // the rest is sampled
        CHECK(r.report.error < 0.04);
        if (crystal.absorbs()) continue;
        double squares = 0;
        for (const float v : r.image.rgb) squares += (v - 1) * (v - 1);
        CHECK(std::sqrt(squares / static_cast<double>(r.image.rgb.size())) < 0.04);
    }
}

TEST_CASE("what a bound on the depth takes from an exact picture is told", "[views][furnace]") {
    for (const Crystal& crystal : {glass(2.417), quartz({0, 0, 1})}) {
        Scene scene = parallel(crystal, furnace());
        scene.max_trace_level = 4;
        const Rendering r = rendered(scene, Engine::exact, 0, 0.02, false);
        CHECK(r.report.dropped > 0.02);
        CHECK(std::abs(mean_of(r.image.rgb, 1, 3) + r.report.dropped - 1) < 1e-4);
    }
}

TEST_CASE("a coloured stone is by exact beams what its rays see", "[views]") {
    const Vec3 axis = normalised(Vec3{0.3, 0.2, 1});
    Crystal grey = calcite(axis), green = grey, pleochroic = grey;
    grey.absorption = {Spectrum(0.8), Spectrum(0.2)};
    green.absorption = {Spectrum({420, 500, 560, 640}, {1.6, 0.1, 0.1, 1.2}), Spectrum(0.3)};
    pleochroic.indices = {IndexFunction(1.6), IndexFunction(1.62), IndexFunction(1.75)};
    pleochroic.third_axis = any_perpendicular(axis);
    pleochroic.absorption = {green.absorption[0], Spectrum(0.1), Spectrum({450, 650}, {0.1, 2})};
    for (const Crystal& crystal : {grey, green, pleochroic}) {
        const Scene scene = parallel(crystal, lamps_and_slope());
        const Rendering exact = rendered(scene, Engine::automatic, 0, 0.01, true),
                        rays = rendered(scene, Engine::rays, 192, 0, true);
        CHECK(exact.report.engine == Engine::exact);
        if (crystal.dispersive()) CHECK(exact.report.samples == 4);
        const double noise = 4 * rays.report.error * mean_of(rays.image.rgb, 1, 3);
        CAPTURE(noise, exact.report.error, crystal.indices.size());
        CHECK(noise < 0.1);
        CHECK(apart(exact.image.rgb, rays.image.rgb) < noise);
        CHECK(apart(exact.image.rgb_stokes, rays.image.rgb_stokes) < noise);
        for (std::size_t c = 0; c < 3; ++c) {
            CHECK(std::abs(mean_of(exact.image.rgb, c, 3) - mean_of(rays.image.rgb, c, 3)) <
                  noise / 8);
        }
        CHECK(std::abs(exact.report.absorbed - rays.report.absorbed) < 0.01);
    }
}

TEST_CASE("exact beams and pixel beams make the same picture, polarisation included", "[views]") {
    for (const Crystal& crystal : {glass(2.417), calcite(normalised(Vec3{0.3, 0.2, 1}))}) {
        const Scene scene = parallel(crystal, lamps_and_slope());
        const Rendering exact = rendered(scene, Engine::exact, 0, 0.005, true),
                        beams = rendered(scene, Engine::beams, 512, 0, true);
        const double noise =
            std::max(0.003, 3 * beams.report.error * mean_of(beams.image.rgb, 1, 3));
        CHECK(apart(exact.image.rgb, beams.image.rgb) < noise);
        CHECK(apart(exact.image.rgb_stokes, beams.image.rgb_stokes) < noise);
        CHECK(std::abs(mean_of(exact.image.rgb, 1, 3) - mean_of(beams.image.rgb, 1, 3)) < 0.003);
    }
}

TEST_CASE("a polarised sky behind an analyser is by exact beams what rays see of it", "[views]") {
    Environment steady = lamps_and_slope();
    steady.state = {1, 0.5, -0.3, 0.6};
    for (const Crystal& crystal : {glass(1.8), calcite(normalised(Vec3{0.3, 0.2, 1}))}) {
        for (const bool stokes : {false, true}) {
            Scene scene = parallel(crystal, steady);
            if (!stokes) scene.camera.analyser = jones_polariser(0.4);
            CAPTURE(stokes, crystal.birefringent());
            const Rendering exact = rendered(scene, Engine::automatic, 0, 0.01, stokes),
                            rays = rendered(scene, Engine::rays, 128, 0, stokes);
            CHECK(exact.report.engine == Engine::exact);
            const double noise = 4 * rays.report.error * mean_of(rays.image.rgb, 1, 3);
            CAPTURE(noise);
            CHECK(noise < 0.15);
            CHECK(apart(exact.image.rgb, rays.image.rgb) < noise);
            if (stokes) CHECK(apart(exact.image.rgb_stokes, rays.image.rgb_stokes) < noise);
            for (std::size_t c = 0; c < 3; ++c) {
                CHECK(std::abs(mean_of(exact.image.rgb, c, 3) - mean_of(rays.image.rgb, c, 3)) <
                      noise / 8);
            }
        }
    }
}

TEST_CASE("between crossed polarisers nothing is seen beside a stone, by exact beams", "[views]") {
    Environment sky = furnace();
    sky.state = {1, 1, 0, 0};
    Scene scene = parallel(glass(1.5), sky);
    scene.camera.direction = {0, 0, -1};
    scene.camera.right = {2.6, 0, 0};
    scene.camera.up = {0, 2.6, 0};
    scene.camera.location = {0, 0, 5};
    const auto corner = [&](double angle) {
        scene.camera.analyser = jones_polariser(angle);
        return rendered(scene, Engine::exact, 0, 0.02, false).image.rgb[1];
    };
    CHECK(std::abs(corner(0) - 1) < 1e-6);
    CHECK(std::abs(corner(std::numbers::pi / 2)) < 1e-6);
    CHECK(std::abs(corner(std::numbers::pi / 6) - 0.75) < 1e-6);
}

TEST_CASE("an interrupted picture by exact beams has what was followed, and says what is missing",
          "[views][furnace]") {
    Crystal dispersive;
    dispersive.indices = {IndexFunction::cauchy(2.3784, 0.0134)};
    const auto stopped = [&](const Crystal& crystal, const ProgressCallback& progress) {
        RenderOptions options = small(16, 0);
        options.engine = Engine::exact;
        options.error = 1e-3;
        options.threads = 1;
        const Rendering r = render(parallel(crystal, furnace()), options, progress);
        CHECK(r.report.interrupted);
        return r;
    };
    const auto twice = [asked = 0](const Progress&) mutable { return asked++ < 2; };
    const Crystal plain = calcite(normalised(Vec3{0.3, 0.2, 1}));
    for (const Crystal& crystal : {plain, dispersive}) {
        CHECK(stopped(crystal, [](const Progress&) { return false; }).report.paths == 0);
    }
    const Rendering part = stopped(plain, twice);
    CAPTURE(part.report.dropped);
    CHECK(part.report.dropped > 0.01);
    CHECK(part.report.dropped < 0.5);
    CHECK(std::abs(mean_of(part.image.rgb, 1, 3) + part.report.dropped - 1) < 1e-4);
    const Rendering coarse = stopped(dispersive, twice);
    CHECK(coarse.report.samples == 8);
    CHECK(coarse.report.error > 0.01);
    CHECK(std::abs(mean_of(coarse.image.rgb, 1, 3) - 1) < 0.01);
    const Rendering r = stopped(dispersive, [](const Progress& p) { return p.done == 0; });
    CHECK(r.report.samples == 8);
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK(std::abs(mean_of(r.image.rgb, c, 3) + r.report.dropped - 1) < 1e-3);
    }
}

TEST_CASE("a dispersive stone has by exact beams the colours of sampled wavelengths", "[views]") {
    Crystal crystal;
    crystal.indices = {IndexFunction::cauchy(2.3784, 0.0134)};
    const Scene scene = parallel(crystal, lamps_and_slope());
    const Rendering exact = rendered(scene, Engine::exact, 24, 0.02, false),
                    beams = rendered(scene, Engine::beams, 256, 0, false);
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK(std::abs(mean_of(exact.image.rgb, c, 3) - mean_of(beams.image.rgb, c, 3)) < 0.006);
    }
    const Rendering again = rendered(scene, Engine::exact, 24, 0.02, false);
    CHECK(exact.image.rgb == again.image.rgb);
}

TEST_CASE("few wavelengths make the picture that many make, by what neighbours share", "[views]") {
    const bool coloured = GENERATE(false, true), birefringent = GENERATE(false, true);
    CAPTURE(coloured, birefringent);
    Crystal crystal = quartz(normalised(Vec3{0.3, 0.2, 1}));
    crystal.indices = {IndexFunction::cauchy(2.3784, 0.0134)};
    if (birefringent) crystal.indices.push_back(IndexFunction::cauchy(2.25, 0.02));
    if (coloured) crystal.absorption = {Spectrum({420, 500, 560, 640}, {1.6, 0.1, 0.2, 1.2})};
    if (coloured && birefringent) crystal.absorption.push_back(Spectrum({450, 650}, {0.1, 2}));
    Scene scene = parallel(crystal, lamps_and_slope());
    // All paths are followed, without noise; but in one case those of fewer facets.
    std::vector<FacetPlane> planes;
    for (int f = 0; f < 8; ++f) {
        const Vec3 n{f & 1 ? 1.0 : -0.8, f & 2 ? 0.9 : -1.1, f & 4 ? 1.2 : -0.9 + 0.1 * f};
        planes.push_back({normalised(n), 0.7});
    }
    if (birefringent || coloured) scene.gems[0].stone = Stone::from_planes(planes);
    scene.max_trace_level = birefringent ? 4 : 5;
    const auto picture = [&](int wavelengths) {
        const Rendering r = rendered(scene, Engine::exact, wavelengths, 1e-4, false);
        CHECK(r.report.error < 1.01e-4);
        if (wavelengths == 0) CHECK(r.report.samples == 16);
        return r.image.rgb;
    };
    // So many share nothing.
    const std::vector<float> many = picture(65);
    const double mean = mean_of(many, 1, 3);
    CHECK(apart(picture(0), many) < 0.003 * mean);
    if (!birefringent && !coloured) CHECK(apart(picture(4), many) < 0.005 * mean);
}

TEST_CASE("an exact picture reaches the error that is asked for, and tells it", "[views]") {
    bool behind = false, further = false;  // progress went back or ran ahead; passes were added
    Crystal dispersive = zircon(normalised(Vec3{0.3, 0.2, 1}));
    dispersive.indices = {IndexFunction::cauchy(1.89, 0.0134), IndexFunction::cauchy(1.95, 0.0134)};
    Environment polarised = slope(normalised(Vec3{0.1, 0.3, 1}));
    polarised.state = {1, 0.5, -0.3, 0.6};
    const Environment skies[] = {lamps_and_slope(), lamps_and_slope(), polarised};
    const Crystal crystals[] = {glass(2.417), dispersive, calcite({0, 0.6, 0.8})};
    for (std::size_t i = 0; i < 3; ++i) {
        const Scene scene = parallel(crystals[i], skies[i]);
        constexpr int runs = 4;
        constexpr double asked = 0.04;
        RenderOptions options = small(16, 0);
        options.engine = Engine::exact;
        options.error = asked;
        options.samples = 4;  // wavelengths, where they part
        options.stokes = i > 1;
        std::vector<double> sum, squares;
        double told = 0, light = 0, scatter = 0, done = 0;
        for (int run = 0; run < runs; ++run) {
            options.seed = static_cast<std::uint64_t>(run);
            const Rendering r = render(scene, options, [&](const Progress& p) {
                behind = behind || p.done < done || p.done >= 1;
                further = further || p.error > asked;
                done = p.done;
                return true;
            });
            CHECK(r.report.error <= asked);
            done = 0;
            told += r.report.error * r.report.error / runs;
            const auto& rgb = r.image.rgb;
            sum.resize(rgb.size() / 3);
            squares.resize(rgb.size() / 3);
            for (std::size_t p = 0; p < sum.size(); ++p) {
                const double y = xyz_from_rgb({rgb[3 * p], rgb[3 * p + 1], rgb[3 * p + 2]})[1];
                sum[p] += y;
                squares[p] += y * y;
            }
        }
        for (std::size_t p = 0; p < sum.size(); ++p) {
            light += sum[p] / runs;
            scatter += (squares[p] - sum[p] * sum[p] / runs) / (runs - 1);
        }
        const double pixels = static_cast<double>(sum.size());
        const double truth = std::sqrt(scatter * pixels) / light;
        CAPTURE(i, truth, std::sqrt(told));
        CHECK(truth < 1.2 * std::sqrt(told));
        CHECK(truth > 0.8 * std::sqrt(told));
    }
    CHECK(further);
    CHECK(!behind);
}

TEST_CASE("exact beams are chosen for a lone stone in a parallel view", "[views]") {
    Scene scene = parallel(glass(1.5), furnace());
    CHECK(needs_of(scene).engine == Engine::exact);
    CHECK(needs_of(scene, false, Engine::rays).engine == Engine::rays);
    CHECK(needs_of(scene, false, Engine::beams).engine == Engine::beams);
    scene.camera.kind = Camera::Kind::perspective;
    CHECK(needs_of(scene).engine == Engine::beams);
    CHECK_THROWS_WITH(rendered(scene, Engine::exact, 0, 0.1, false),
                      Catch::Matchers::Contains("not orthographic"));
    CHECK(needs_of(parallel(quartz({0, 0, 1}), furnace())).engine == Engine::exact);
    Crystal faded = glass(1.5);
    faded.fade = Fade{2, 1000, Spectrum(0.2)};
    CHECK(needs_of(parallel(faded, furnace())).engine == Engine::exact);
    faded.fade->power = 1;
    CHECK(needs_of(parallel(faded, furnace())).engine == Engine::rays);
}
