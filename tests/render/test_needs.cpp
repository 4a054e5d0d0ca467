// What a scene does not need changes nothing: lesser kernels make the full one's picture.
#include <catch2/catch.hpp>
#include <filesystem>

#include "parser/load.hpp"
#include "render/pixel_worker.hpp"
#include "support/gem_scenes.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;

namespace {

/// The sums of a small picture with one band: pixel by pixel R, G, B and the band, S0 alone.
std::vector<double> sums_of(const Scene& scene, Engine engine, const Forced& forced, int samples) {
    constexpr int width = 3, height = 2, bands = 1;
    const Needs needs = needs_of(scene, false, engine, forced);
    const PreparedScene prepared(scene, needs, width, height, bands);
    Film film(width, height, bands, needs.stokes);
    PixelWorker worker(prepared, film);
    PixelWorker::Account account;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) worker.add(film, {x, y, x + 1, y + 1}, 7, 0, samples, true, account);
    }
    REQUIRE(worker.bad() == 0);
    std::vector<double> out;
    const auto stride = static_cast<std::size_t>(film.components());
    for (std::size_t i = 0; i < film.sums().size(); i += stride) out.push_back(film.sums()[i]);
    return out;
}

constexpr std::size_t channels = 4, band = 3;

/// The greatest difference of two pictures relative to the pixel, over the channels from `first`.
double difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t first) {
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t p = 0; p < a.size(); p += channels) {
        for (std::size_t c = first; c < channels; ++c) {
            const double d = std::abs(a[p + c] - b[p + c]);
            if (d > 0) worst = std::max(worst, d / std::abs(a[p + band]));
        }
    }
    return worst;
}

/// Kernels that take the same samples as lesser ones.
std::vector<std::pair<const char*, Forced>> same_samples() {
    Forced stokes, absorption, tree;
    stokes.stokes = absorption.absorption = tree.tree = true;
    return {{"stokes", stokes}, {"absorption", absorption}, {"tree", tree}};
}

void check_kernels(const Scene& scene, int samples) {
    for (const Engine engine : {Engine::rays, Engine::automatic}) {
        const auto lesser = sums_of(scene, engine, {}, samples);
        for (const auto& [what, forced] : same_samples()) {
            CAPTURE(what, engine == Engine::rays);
            CHECK(difference(lesser, sums_of(scene, engine, forced, samples), 0) < 1e-12);
        }
    }
}

/// All Stokes components that a few rays see, by the whole tree, to the n-th facet.
void check_general_solver(const Scene& scene, testing::Random& random, int rays) {
    TraceOptions options;
    options.max_hits = 6;
    options.threads = 1;
    const auto camera = scene.camera;
    std::vector<SensorRay> all;
    for (int i = 0; i < rays; ++i) {
        const double u = random.uniform() - 0.5, v = random.uniform() - 0.5;
        all.push_back({camera.location,
                       camera.direction + 0.5 * u * camera.right + 0.5 * v * camera.up,
                       camera.right});
    }
    const Traced closed = trace(scene, all, options);
    options.forced.general = true;
    const Traced general = trace(scene, all, options);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double scale = closed.stokes[i].s0 + closed.dropped[i].s0 + closed.absorbed[i].s0;
        CAPTURE(i, text(closed.stokes[i]), text(general.stokes[i]));
        CHECK(testing::difference(closed.stokes[i], general.stokes[i]) <= 1e-12 * scale);
    }
}

Crystal random_crystal(testing::Random& random, int kind) {
    const double n = random.uniform(1.3, 2.6);
    Crystal c = glass(n);
    if (kind % 4 == 1) c = uniaxial(n, n + random.uniform(-0.2, 0.2), random.direction());
    if (kind % 4 == 2) c = active_quartz(random.direction(), random.uniform(-50, 50));
    if (kind % 4 == 3) c = biaxial(n, n + 0.05, n + 0.2, random);
    if (random.uniform() < 0.3) c.absorption.assign(c.indices.size(), Spectrum(0.3));
    return c;
}

/// One or two stones of any kind below a grey sky, perhaps with lamps, a ball and a lit floor.
Scene random_scene(std::uint64_t seed) {
    testing::Random random(seed);
    Scene scene;
    scene.camera = towards_origin(1.8);
    Environment& sky = scene.environment;
    sky.illuminant = Spectrum(1.0);
    sky.below = Spectrum(0.3);
    sky.above = Spectrum(1.0);
    sky.up = random.direction();
    if (random.uniform() < 0.5) sky.discs.push_back({random.direction(), 0.9, Spectrum(3.0)});
    if (random.uniform() < 0.3) sky.state = {1, 0.3, -0.2, 0.5};
    const int stones = random.uniform() < 0.3 ? 2 : 1;
    for (int i = 0; i < stones; ++i) {
        std::vector<Vec3> corners;
        while (corners.size() < 10) corners.push_back(random.direction());
        Stone stone = Stone::from_points(corners);
        const double size = stones == 1 ? 0.8 : 0.45;
        stone = stone.transformed(
            Transform::scaling({size, size, size})
                .then(Transform::translation({stones == 1 ? 0 : 1.6 * i - 0.8, 0, 0})));
        const int kind = static_cast<int>(random.uniform(0, 8));
        scene.gems.push_back({std::move(stone), random_crystal(random, kind), "stone"});
    }
    if (random.uniform() < 0.4) {
        scene.things.push_back(ball({0, 0, -2}, 0.5));
        scene.things.push_back(floor_of(0.5, 0.6));
        scene.things.back().to_world = Transform::translation({0, -3, 0});
        scene.lights.push_back(lamp_at({3, 5, 2}));
        scene.lights[0].light = Spectrum(0.8);
    }
    scene.max_trace_level = 12;
    return scene;
}

}  // namespace

TEST_CASE("a lesser kernel makes the full kernel's picture of any small scene, to rounding",
          "[needs][property]") {
    const auto seed = static_cast<std::uint64_t>(GENERATE(range(0, 200)));
    CAPTURE(seed);
    const Scene scene = random_scene(seed);
    check_kernels(scene, 2);
    // Every light is grey: at whatever wavelengths it is sampled, the band sees the same.
    Forced spectral;
    spectral.wavelengths = true;
    CHECK(difference(sums_of(scene, Engine::rays, {}, 2), sums_of(scene, Engine::rays, spectral, 2),
                     band) < 1e-12);
    testing::Random random(seed);
    check_general_solver(scene, random, 2);
}

TEST_CASE("a lesser kernel makes the full kernel's picture of every example, to rounding",
          "[needs]") {
    for (const auto& entry : std::filesystem::directory_iterator(ICESPAR_SCENES_DIR)) {
        if (entry.path().extension() != ".spar") continue;
        CAPTURE(entry.path().filename());
        LoadOptions options;
        options.width = 3;
        options.height = 2;
        const LoadResult loaded = load_scene_file(entry.path(), options);
        REQUIRE(loaded.scene);
        check_kernels(*loaded.scene, 1);
    }
}

TEST_CASE("a scene needs what its stones, its sky and the user ask for", "[needs]") {
    const Needs plain = needs_of(scene_of(cube_stone(), glass(1.5)));
    CHECK_FALSE(plain.wavelengths);
    CHECK_FALSE(plain.stokes);
    CHECK_FALSE(plain.birefringent);
    CHECK_FALSE(plain.absorption);
    CHECK_FALSE(plain.tree);
    CHECK_FALSE(plain.surroundings);
    CHECK(plain.engine == Engine::beams);

    Crystal diamond{{IndexFunction::cauchy(2.3784, 0.0134)}, {0, 0, 1}};
    CHECK(needs_of(scene_of(cube_stone(), diamond)).wavelengths);
    CHECK(needs_of(scene_of(cube_stone(), calcite({0, 0, 1}))).birefringent);
    CHECK(needs_of(scene_of(cube_stone(), active_quartz({0, 0, 1}))).general);
    CHECK(needs_of(scene_of(cube_stone(), active_quartz({0, 0, 1}))).engine == Engine::rays);
    CHECK(needs_of(scene_of(cube_stone(), glass(1.5)), true).stokes);

    Scene furnished = scene_of(cube_stone(), glass(1.5));
    for (int i = 0; i < 8; ++i) furnished.things.push_back(ball({0, 3.0 * i, 9}, 1));
    CHECK(needs_of(furnished).tree);
    CHECK(needs_of(furnished).surroundings);
    Scene polarised = scene_of(cube_stone(), glass(1.5));
    polarised.environment.state = {1, 1, 0, 0};
    CHECK(needs_of(polarised).surroundings);

    Scene through_a_lens = scene_of(cube_stone(), glass(1.5));
    through_a_lens.camera.lens_radius = 0.1;
    CHECK(needs_of(through_a_lens).obstacle == "the camera has a lens");
    CHECK(needs_of(through_a_lens).engine == Engine::rays);
}

TEST_CASE("a plan gives the reason of each choice and says what converges slowly", "[needs]") {
    Scene scene = lit_floor(lamp_at({0, 5, 0}));
    scene.gems.push_back({cube_stone(), calcite({0, 0, 1}), "ring.spar:12"});
    CHECK_THAT(plan_text(scene, needs_of(scene)), Contains("o and e part in the stone") &&
                                                      Contains("1 light source") &&
                                                      Contains("warning") && Contains("caustics"));
    scene.lights.clear();
    CHECK_THAT(plan_text(scene, needs_of(scene)), !Contains("warning"));
    scene.gems.push_back(
        {cube_stone().transformed(Transform::translation({5, 0, 0})), glass(1.5), "ring.spar:15"});
    CHECK_THAT(plan_text(scene, needs_of(scene)), Contains("the stone at ring.spar:12"));
    CHECK(plan_summary(needs_of(scene)) ==
          "beams, one path for all wavelengths, intensity, "
          "uniaxial");
}
