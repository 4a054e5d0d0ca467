// Beams through a stone: nothing is lost or doubled, and every leaf is where a ray would be.
#include <catch2/catch.hpp>

#include "beams/footprint.hpp"
#include "beams/tracer.hpp"
#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;
using Draws = icespar::testing::Random;

namespace {

/// Follows every beam to a depth and keeps the sums.
template <class Response>
struct Recorder {
    int depth = 12;
    Environment sky = furnace();
    Stokes seen;
    double lost = 0, entered = 0, negative = 0;
    int leaves = 0, not_finite = 0;
    double worst_area = 0, worst_centroid = 0;

    double gain(double, int) const { return 1; }
    int stand_in(double, double, int) const { return -1; }
    bool may_meet(int hits) const { return hits < depth; }
    void lose(double weight) { lost += weight; }
    void open() {}
    void close(int) {}
    void see(const Leaf<Response>& leaf) {
        ++leaves;
        const Stokes s = leaf.area * leaf.response.unpolarised();
        if (!std::isfinite(s.s0) || !is_finite(leaf.k.value)) ++not_finite;
        negative = std::min(negative, s.s0);
        const double height = 0.5 * (1 + dot(leaf.k.value, sky.up));
        seen += (sky.below(550) * (1 - height) + sky.above(550) * height) * s;
        const Extent e = extent(leaf.polygon);
        worst_area = std::max(worst_area, std::abs(e.area - leaf.area) / leaf.area);
        worst_centroid = std::max({worst_centroid, std::abs(e.centroid.x), std::abs(e.centroid.y)});
    }
};

Medium medium_of(const Crystal& c) {
    return c.birefringent() ? Medium::uniaxial(c.indices[0](550), c.indices[1](550), c.axis)
                            : Medium::isotropic(c.indices[0](550));
}

/// All of one pixel's beams; what the background sees is not counted.
template <class Response>
Recorder<Response> followed(const Scene& scene, int width, int x, int y, int depth) {
    Recorder<Response> out;
    out.depth = depth;
    out.sky = scene.environment;
    const Gem& gem = scene.gems[0];
    const FacetSearch facets(gem.stone);
    const Footprint footprint(gem.stone, scene.camera, width, width);
    const RayField field = pixel_field(scene.camera, width, width, x, y, facets.centre());
    std::vector<Footprint::Part> parts;
    std::size_t count = 0;
    footprint.divide({x, y, x + 1, y + 1}, parts, count);
    const auto run = [&](auto tracer) {
        tracer.set_medium(medium_of(gem.crystal));
        for (std::size_t i = 0; i < count; ++i) {
            if (parts[i].facet < 0) continue;
            out.entered += extent(parts[i].polygon).area;
            tracer.trace(field, scene.camera.right, parts[i].polygon, parts[i].facet, out);
        }
    };
    if (gem.crystal.birefringent()) {
        run(BeamTracer<Response, true>(facets));
    } else {
        run(BeamTracer<Response, false>(facets));
    }
    return out;
}

Camera random_camera(Draws& random, double distance, double width) {
    Camera c;
    const Vec3 from = random.direction();
    c.location = distance * from;
    c.direction = -from;
    c.right = width * random.perpendicular_to(from);
    c.up = cross(c.right, c.direction);
    c.kind = random.below(2) == 0 ? Camera::Kind::perspective : Camera::Kind::orthographic;
    return c;
}

}  // namespace

TEST_CASE("the facets of a stone and the background share a pixel without gap or overlap",
          "[beams]") {
    Draws random(11);
    double worst = 0;
    for (int i = 0; i < 60; ++i) {
        const Stone stone = Stone::from_planes(random_planes(random, 12 + random.below(60), 0.3));
        Scene scene = scene_of(stone, glass(1.5));
        scene.camera = random_camera(random, 5, 0.7);
        if (scene.camera.kind == Camera::Kind::orthographic) {
            scene.camera.right = 5 * scene.camera.right;
            scene.camera.up = 5 * scene.camera.up;
        }
        constexpr int size = 8;
        const Footprint footprint(stone, scene.camera, size, size);
        std::vector<Footprint::Part> parts;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                std::size_t count = 0;
                footprint.divide({x, y, x + 1, y + 1}, parts, count);
                double sum = 0;
                for (std::size_t p = 0; p < count; ++p) sum += extent(parts[p].polygon).area;
                worst = std::max(worst, std::abs(sum - 1));
            }
        }
    }
    CHECK(worst < 1e-12);
}

TEST_CASE("in a furnace the leaves of a pixel and what a depth bound ended make up its light",
          "[beams][furnace]") {
    Draws random(13);
    for (int i = 0; i < 24; ++i) {
        const Stone stone =
            i % 3 == 0 ? brilliant_stone() : Stone::from_planes(random_planes(random, 40, 0.2));
        const Vec3 axis = random.direction();
        Scene scene = scene_of(stone, i % 2 == 0 ? glass(2.417) : calcite(axis));
        scene.camera = random_camera(random, 6, 0.2);
        const auto r = followed<IntensityResponse>(scene, 4, 1, 2, i % 2 == 0 ? 20 : 7);
        CAPTURE(i, r.leaves, r.entered);
        CHECK(r.not_finite == 0);
        CHECK(r.negative >= 0);
        CHECK(std::abs(r.seen.s0 + r.lost - r.entered) < 1e-12);
        CHECK(r.worst_area < 1e-9);
        CHECK(r.worst_centroid < 1e-9);
    }
}

TEST_CASE("a pixel as small as a point sees what its ray sees, in all four components", "[beams]") {
    Draws random(17);
    for (int i = 0; i < 24; ++i) {
        const Vec3 axis = random.direction();
        const Crystal crystal = i % 3 == 0   ? glass(2.417)
                                : i % 3 == 1 ? calcite(axis)
                                             : quartz(axis);
        Scene scene = scene_of(brilliant_stone(), crystal, slope(random.direction()));
        scene.environment.illuminant = Spectrum(1.0);
        scene.camera = random_camera(random, 6, 1e-9);
        const auto full = followed<FullResponse>(scene, 1, 0, 0, 9);
        const auto intensity = followed<IntensityResponse>(scene, 1, 0, 0, 9);
        if (full.entered < 1) continue;
        TraceOptions options;
        options.wavelength_nm = 550;
        options.max_hits = 9;
        const Vec3 d = normalised(scene.camera.direction);
        const Stokes ray =
            trace_one(scene, {scene.camera.location, d, scene.camera.right}, options);
        CAPTURE(i, text(ray), text(full.seen));
        CHECK(difference(full.seen, ray) < 1e-7);
        CHECK_THAT(intensity.seen.s0, WithinAbs(full.seen.s0, 1e-12));
    }
}

TEST_CASE("light leaves a stone of a slightly different colour where its fan points", "[beams]") {
    struct Leaves : Recorder<IntensityResponse> {
        std::vector<Vec3> k, fan;
        void see(const Leaf<IntensityResponse>& leaf) {
            k.push_back(leaf.k.value);
            fan.push_back(leaf.fan);
        }
    };
    Draws random(19);
    constexpr double dn_o = 0.7, dn_e = 1.3, step = 1e-7;
    const FacetSearch facets(brilliant_stone());
    int compared = 0;
    for (int i = 0; i < 40; ++i) {
        Camera camera = random_camera(random, 6, 1e-12);
        camera.kind = Camera::Kind::perspective;
        const Footprint footprint(brilliant_stone(), camera, 1, 1);
        const RayField field = pixel_field(camera, 1, 1, 0, 0, facets.centre());
        std::vector<Footprint::Part> parts;
        std::size_t count = 0;
        footprint.divide({0, 0, 1, 1}, parts, count);
        if (count != 1 || parts[0].facet < 0) continue;
        const Vec3 axis = random.direction();
        const auto followed_at = [&](double c) {
            Leaves leaves;
            leaves.depth = 6;
            const auto run = [&](auto tracer, const Medium& medium) {
                tracer.set_medium(medium, dn_o, dn_e);
                tracer.trace(field, camera.right, parts[0].polygon, parts[0].facet, leaves);
            };
            const double n_o = 1.7 + dn_o * c, n_e = 1.5 + dn_e * c;
            if (i % 2 == 0) {
                run(BeamTracer<IntensityResponse, false, true>(facets), Medium::isotropic(n_o));
            } else {
                run(BeamTracer<IntensityResponse, true, true>(facets),
                    Medium::uniaxial(n_o, n_e, axis));
            }
            return leaves;
        };
        const Leaves below = followed_at(-step), middle = followed_at(0), above = followed_at(step);
        if (below.k.size() != middle.k.size() || above.k.size() != middle.k.size()) continue;
        for (std::size_t leaf = 0; leaf < middle.k.size(); ++leaf) {
            const Vec3 turn = (above.k[leaf] - below.k[leaf]) / (2 * step);
            // Near grazing k turns ever faster.
            const double size = 1 + length(turn);
            CAPTURE(i, leaf, length(turn), length(middle.fan[leaf]));
            CHECK(length(turn - middle.fan[leaf]) < 1e-6 * size * size * size);
            ++compared;
        }
    }
    CHECK(compared > 300);
}

TEST_CASE("a plate of glass reflects and transmits as the sum over all its echoes",
          "[beams][slab]") {
    // Unpolarised light at 40 degrees on a plate so wide that no beam meets its rim: of each
    // polarisation 2R / (1 + R) comes back.
    constexpr double n = 1.7, angle = 40 * degree;
    Scene scene = scene_of(box_stone({-500, -500, 0}, {500, 500, 1}), glass(n));
    scene.camera.kind = Camera::Kind::orthographic;
    scene.camera.direction = {std::sin(angle), 0, -std::cos(angle)};
    scene.camera.location = Vec3{0, 0, 1} - 5.0 * scene.camera.direction;
    scene.camera.right = {0, 0.01, 0};
    scene.camera.up = cross(scene.camera.right, scene.camera.direction);
    scene.environment = slope({0, 0, 1});
    const auto r = followed<IntensityResponse>(scene, 1, 0, 0, 60);
    const double q1 = std::cos(angle), q2 = std::sqrt(n * n - std::sin(angle) * std::sin(angle));
    const double rs = std::pow((q1 - q2) / (q1 + q2), 2),
                 rp = std::pow((n * n * q1 - q2) / (n * n * q1 + q2), 2);
    const double back = rs / (1 + rs) + rp / (1 + rp);
    const double up = 0.5 * (1 + std::cos(angle)), down = 0.5 * (1 - std::cos(angle));
    CHECK_THAT(r.entered, WithinAbs(1, 1e-14));
    CHECK_THAT(r.seen.s0, WithinAbs(back * up + (1 - back) * down, 1e-13));
}

TEST_CASE("views along an edge, a facet, a facet's normal or the optic axis lose no light",
          "[beams][furnace]") {
    struct View {
        Vec3 direction, right;
    };
    const View views[] = {{{0, 0, -1}, {1, 0, 0}},     {{-1, 0, 0}, {0, 1, 0}},
                          {{-1, -1, 0}, {0, 0, 1}},    {{-1, -1, -1}, {1, -1, 0}},
                          {{0, -1, 1e-15}, {1, 0, 0}}, {{1e-9, 0, -1}, {0, 1, 0}}};
    for (const Crystal& crystal : {glass(1.5), calcite({0, 0, 1})}) {
        for (const View& view : views) {
            for (const auto kind : {Camera::Kind::perspective, Camera::Kind::orthographic}) {
                Scene scene = scene_of(cube_stone(), crystal);
                scene.camera.kind = kind;
                scene.camera.direction = normalised(view.direction);
                scene.camera.location = -6 * scene.camera.direction;
                const double width = kind == Camera::Kind::perspective ? 1.0 : 5.0;
                scene.camera.right = width * normalised(view.right);
                scene.camera.up = cross(scene.camera.right, scene.camera.direction);
                for (int y = 0; y < 5; ++y) {
                    for (int x = 0; x < 5; ++x) {
                        const auto r = followed<IntensityResponse>(scene, 5, x, y,
                                                                   crystal.birefringent() ? 6 : 12);
                        REQUIRE(r.not_finite == 0);
                        REQUIRE(std::abs(r.seen.s0 + r.lost - r.entered) < 1e-12);
                        REQUIRE(r.entered < 1 + 1e-12);
                    }
                }
            }
        }
    }
}
