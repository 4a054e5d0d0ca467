// A plane-parallel plate changes no direction, however often light is reflected within it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/gem_scenes.hpp"
#include "support/recorder.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

/// So wide that no path reaches its rim.
Stone plate() { return box_stone({-1e4, -1e4, -0.5}, {1e4, 1e4, 0.5}); }

std::vector<Branch> outward(const Scene& scene, const SensorRay& ray, int most_hits,
                            double least_weight) {
    const World world(scene);
    const Palette palette(scene, 0);
    return recorded(world, palette, ray.origin, ray.direction, most_hits, least_weight).out;
}

/// Index of the extraordinary wave with this wave normal.
double extraordinary_index(double n_o, double n_e, const Vec3& axis, const Vec3& normal) {
    const double c = dot(axis, normal);
    return 1 / std::sqrt(c * c / (n_o * n_o) + (1 - c * c) / (n_e * n_e));
}

}  // namespace

TEST_CASE("light leaves a calcite plate parallel to how it came, or mirrored", "[slab]") {
    double worst = 0;
    std::size_t seen = 0;
    int longest = 0;
    for (int seed = 0; seed < 60; ++seed) {
        testing::Random random(static_cast<std::uint64_t>(seed));
        const Scene scene = scene_of(plate(), calcite(random.direction()));
        Vec3 d = random.direction();
        d.z = -std::copysign(std::max(0.02, std::abs(d.z)), d.z);
        d = normalised(d);
        const SensorRay ray{-5 / std::abs(d.z) * d, d, random.perpendicular_to(d)};
        const Vec3 mirrored{d.x, d.y, -d.z};
        for (const Branch& b : outward(scene, ray, 60, 1e-7)) {
            const double off = std::min(length(b.ray - d), length(b.ray - mirrored));
            if (off > 1e-12) {
                CAPTURE(seed, b.hits, in_digits(off), in_digits(b.weight));
                CHECK(off <= 1e-12);
            }
            worst = std::max(worst, off);
            longest = std::max(longest, b.hits);
            ++seen;
        }
    }
    INFO("worst " << in_digits(worst) << " of " << seen << " branches, up to " << longest
                  << " reflections");
    CHECK(worst <= 1e-12);
    CHECK(seen > 10000);
    CHECK(longest > 8);
}

TEST_CASE("mirroring the extraordinary wave inside instead would miss by degrees", "[slab]") {
    // Incidence 45 degrees in the plane of the normal and the axis, which lies 45 degrees between.
    const double n_o = 1.6584, n_e = 1.4864;
    const Vec3 axis = normalised(Vec3{1, 0, 1});
    const Vec3 d = normalised(Vec3{1, 0, -1});
    const SensorRay ray{-5.0 * d, d, {0, 1, 0}};
    const Scene scene = scene_of(plate(), calcite(axis));
    const auto exits = outward(scene, ray, 6, 0);
    for (const Branch& b : exits) {
        const Vec3 mirrored{d.x, d.y, -d.z};
        CHECK(std::min(length(b.ray - d), length(b.ray - mirrored)) <= 1e-13);
    }

    // The entering wave: n(k) k has the tangential part of d; found here by bisection.
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double s = 0.5 * (low + high);
        const Vec3 k{s, 0, -std::sqrt(1 - s * s)};
        (extraordinary_index(n_o, n_e, axis, k) * s < d.x ? low : high) = s;
    }
    const Vec3 k{low, 0, -std::sqrt(1 - low * low)};
    // Shortcut 1: the wave normal mirrored. Its index is another, and so is its way out.
    const Vec3 mirrored_k{k.x, 0, -k.z};
    const double out_1 = extraordinary_index(n_o, n_e, axis, mirrored_k) * mirrored_k.x;
    const double miss_1 = std::abs(std::asin(out_1) - std::asin(d.x)) / degree;
    // Shortcut 2: the ray (along eps k) mirrored, and its wave normal (along eps^-1 ray) taken.
    const auto scaled = [&](const Vec3& v, double along, double across) {
        return across * v + (along - across) * dot(axis, v) * axis;
    };
    const Vec3 energy = scaled(k, n_e * n_e, n_o * n_o);
    const Vec3 wave =
        normalised(scaled({energy.x, 0, -energy.z}, 1 / (n_e * n_e), 1 / (n_o * n_o)));
    const double out_2 = extraordinary_index(n_o, n_e, axis, wave) * wave.x;
    const double miss_2 = std::abs(std::asin(std::min(1.0, out_2)) - std::asin(d.x)) / degree;
    CAPTURE(miss_1, miss_2);
    CHECK(miss_1 > 3);
    CHECK(miss_2 > 3);
}

TEST_CASE("a glass plate reflects 2R / (1 + R) of each polarisation", "[slab]") {
    for (const double n : {1.3, 1.5, 2.417}) {
        const Scene scene = scene_of(plate(), glass(n), slope({0, 0, 1}));
        for (const double angle : {0.0, 20.0, 45.0, 60.0, 75.0}) {
            const double c = std::cos(angle * degree), s = std::sin(angle * degree);
            const double c_t = std::sqrt(1 - s * s / (n * n));
            const auto whole = [](double r) { return 2 * r * r / (1 + r * r); };
            const double R_s = whole((c - n * c_t) / (c + n * c_t));
            const double R_p = whole((n * c - c_t) / (n * c + c_t));
            // Above the plate the surroundings are (1 + c) / 2 bright, below (1 - c) / 2.
            const auto seen = [&](double R) { return R * (1 + c) / 2 + (1 - R) * (1 - c) / 2; };
            const Vec3 d{s, 0, -c};
            const SensorRay across{-5.0 * d, d, {0, 1, 0}}, along{-5.0 * d, d, {c, 0, s}};
            const double sum = (seen(R_s) + seen(R_p)) / 2, half = (seen(R_s) - seen(R_p)) / 2;
            CAPTURE(n, angle);
            CHECK(difference(trace_one(scene, across), {sum, half, 0, 0}) <= 1e-13);
            CHECK(difference(trace_one(scene, along), {sum, -half, 0, 0}) <= 1e-13);
        }
    }
}

TEST_CASE("normal to a calcite plate each polarisation sees the plate of its own index", "[slab]") {
    // The axis in the face, along x: what is polarised along x meets n_e, along y n_o.
    const Scene scene = scene_of(plate(), calcite({1, 0, 0}), slope({0, 0, 1}));
    const auto reflected = [](double n) {
        const double r = (n - 1) / (n + 1);
        return 2 * r * r / (1 + r * r);
    };
    const double R_x = reflected(1.4864), R_y = reflected(1.6584);
    const SensorRay down{{0, 0, 5}, {0, 0, -1}, {1, 0, 0}};
    CHECK(difference(trace_one(scene, down), {(R_x + R_y) / 2, (R_x - R_y) / 2, 0, 0}) <= 1e-13);
}
