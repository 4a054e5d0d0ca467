// Rays side by side: what goes in comes out, each does what it would do alone, and colours part as
// indices say.
#include <catch2/catch.hpp>
#include <cmath>

#include "beams/faint_rays.hpp"
#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

const Vec3 leaning = normalised({1, 2, 4});

Medium medium_of(double n_o, double n_e) { return Medium::uniaxial(n_o, n_e, leaning); }

/// A mode of either kind that goes from within a facet into the stone.
FaintRays::Ray ray_from(const Stone& stone, const FacetSearch& facets, const Medium& medium,
                        int facet, testing::Random& random) {
    const auto& corners = stone.facets[static_cast<std::size_t>(facet)].corners;
    FaintRays::Ray ray;
    double sum = 0;
    for (const std::uint32_t c : corners) {
        const double share = random.uniform(0.1, 1);
        ray.position += share * (stone.vertices[c] - facets.centre());
        sum += share;
    }
    ray.position = ray.position / sum;
    Vec3 along = random.direction();
    if (dot(along, facets.normal(facet)) > 0) along = -along;
    ray.extraordinary = random.uniform() < 0.5;
    const IndexSurface surface(medium);
    ray.k = surface.onto(along, ray.extraordinary);
    const Vec3 across = cross(ray.k, medium.axis);
    ray.field = normalised(ray.extraordinary
                               ? medium.axis - (dot(ray.k, medium.axis) / surface.eps_o) * ray.k
                               : across);
    ray.weight = random.uniform(0.5, 1);
    ray.left = facet;
    // What grazes a face may flow out where its wave vector points in.
    if (dot(surface.energy(ray.k, ray.extraordinary), facets.normal(facet)) > -0.01) {
        return ray_from(stone, facets, medium, facet, random);
    }
    return ray;
}

std::vector<FaintRays::Ray> rays_from(const Stone& stone, const FacetSearch& facets,
                                      const Medium& medium, int count, std::uint64_t seed = 3) {
    testing::Random random(seed);
    std::vector<FaintRays::Ray> rays;
    for (int i = 0; i < count; ++i) {
        rays.push_back(ray_from(stone, facets, medium,
                                random.below(static_cast<int>(stone.facets.size())), random));
        rays.back().owner = i;
        rays.back().random = icespar::Random(mixed(static_cast<std::uint64_t>(i)));
    }
    return rays;
}

std::vector<Lanes> widths() {
    std::vector<Lanes> all{Lanes::scalar, Lanes::baseline};
    if (widest_lanes() != Lanes::baseline) all.push_back(widest_lanes());
    return all;
}

std::vector<FaintRays::Exit> exits_of(FaintRays& rays, double threshold, int most_hits,
                                      Lanes width = widest_lanes()) {
    std::vector<FaintRays::Exit> exits;
    rays.follow(
        threshold, most_hits, [&](const FaintRays::Exit& e) { exits.push_back(e); }, width);
    return exits;
}

}  // namespace

TEST_CASE("each ray's exits and what is given up sum to its weight, in crystals weak and strong",
          "[beams][faint]") {
    const auto [n_o, n_e] =
        GENERATE(std::pair(1.5443, 1.5534), std::pair(1.925, 1.984), std::pair(1.6584, 1.4864),
                 std::pair(2.616, 2.903), std::pair(1.97, 2.66), std::pair(1.7, 1.7));
    const Stone stone = brilliant_stone();
    const FacetSearch facets(stone);
    const Medium medium = medium_of(n_o, n_e);
    constexpr int count = 400, most_hits = 40;
    for (const Lanes width : widths()) {
        CAPTURE(n_o, n_e, width);
        FaintRays rays(facets);
        rays.set_medium(medium);
        double given = 0;
        for (const FaintRays::Ray& ray : rays_from(stone, facets, medium, count)) {
            given += ray.weight;
            rays.add(ray);
        }
        double out = 0;
        int exits = 0;
        bool finite = true, unit = true, whole = true;
        const double lost = rays.follow(
            1e-300, most_hits,
            [&](const FaintRays::Exit& e) {
                ++exits;
                out += e.weight;
                finite = finite && std::isfinite(e.weight) && e.weight > 0;
                unit = unit && std::abs(length(e.k) - 1) < 1e-12;
                whole = whole && std::isfinite(e.out_s) && std::isfinite(e.out_p) &&
                        std::hypot(e.out_s, e.out_p) > 0;
            },
            width);
        CHECK(finite);
        CHECK(unit);
        CHECK(whole);
        CHECK(exits > count);
        CHECK_THAT((out + lost) / given, WithinAbs(1, 1e-11));
        CHECK(out > 0.5 * given);
    }
}

TEST_CASE("roulette gives back on average what it takes", "[beams][faint]") {
    const Stone stone = brilliant_stone();
    const FacetSearch facets(stone);
    const Medium medium = medium_of(1.925, 1.984);
    FaintRays rays(facets);
    rays.set_medium(medium);
    // Each time the same rays with other luck: their mean and its standard error.
    const auto starts = rays_from(stone, facets, medium, 200);
    double given = 0;
    for (const auto& ray : starts) given += ray.weight;
    constexpr int times = 100;
    double sum = 0, square = 0;
    for (int i = 0; i < times; ++i) {
        for (FaintRays::Ray ray : starts) {
            ray.random = icespar::Random(mixed(static_cast<std::uint64_t>(1000 * i + ray.owner)));
            rays.add(ray);
        }
        double out = 0;
        const double lost = rays.follow(2, 0, [&](const FaintRays::Exit& e) { out += e.weight; });
        out += lost;
        sum += out / given;
        square += out / given * out / given;
    }
    const double mean = sum / times, error = std::sqrt((square / times - mean * mean) / times);
    CAPTURE(mean, error);
    CHECK(error < 0.02);
    CHECK(std::abs(mean - 1) < 5 * error);
}

TEST_CASE("rays side by side go where each goes alone by InnerFace", "[beams][faint]") {
    const auto [n_o, n_e] =
        GENERATE(std::pair(1.925, 1.984), std::pair(1.6584, 1.4864), std::pair(1.97, 2.66));
    const Stone stone = brilliant_stone();
    const FacetSearch facets(stone);
    const Medium medium = medium_of(n_o, n_e);
    const bool spectral = GENERATE(false, true);
    std::vector<std::vector<FaintRays::Exit>> exits;
    for (const Lanes width : widths()) {
        FaintRays rays(facets);
        rays.set_medium(medium, spectral, 0.02, 0.03);
        for (const auto& ray : rays_from(stone, facets, medium, 300)) rays.add(ray);
        exits.push_back(exits_of(rays, 0.5, 0, width));
    }
    for (std::size_t w = 1; w < exits.size(); ++w) {
        CAPTURE(n_o, n_e, w);
        REQUIRE(exits[w].size() == exits[0].size());
        double k = 0, fan = 0, weight = 0, polarised = 0;
        bool owners = true;
        for (std::size_t i = 0; i < exits[0].size(); ++i) {
            const FaintRays::Exit &a = exits[0][i], &b = exits[w][i];
            k = std::max(k, length(a.k - b.k));
            if (spectral) fan = std::max(fan, length(a.fan - b.fan) / (1 + length(a.fan)));
            weight = std::max(weight, std::abs(a.weight - b.weight));
            owners = owners && a.owner == b.owner && a.hits == b.hits;
            // But for the sign of both: the field as a vector.
            const auto field = [](const FaintRays::Exit& e) {
                const Vec3 s = normalised(e.s);
                return (1 / std::hypot(e.out_s, e.out_p)) * (e.out_s * s + e.out_p * cross(e.k, s));
            };
            polarised = std::max(
                polarised, std::min(length(field(a) - field(b)), length(field(a) + field(b))));
        }
        CHECK(owners);
        CHECK(k < 1e-9);
        CHECK(fan < 1e-7);
        CHECK(weight < 1e-9);
        CHECK(polarised < 1e-7);
    }
}

TEST_CASE("a ray's fan is how its exits turn with colour", "[beams][faint]") {
    // Two stones a little to either side in colour, one path through both.
    constexpr double n_o = 1.925, n_e = 1.984, dn_o = 0.02, dn_e = 0.03, step = 1e-6;
    const Stone stone = brilliant_stone();
    const FacetSearch facets(stone);
    const Medium medium = medium_of(n_o, n_e);
    const auto exits_at = [&](double colour) {
        const Medium there = medium_of(n_o + colour * dn_o, n_e + colour * dn_e);
        FaintRays rays(facets);
        rays.set_medium(there, true, dn_o, dn_e);
        for (FaintRays::Ray ray : rays_from(stone, facets, medium, 300)) {
            // Straight on, whatever the colour.
            const auto k_at = [&](double c) {
                return IndexSurface(medium_of(n_o + c * dn_o, n_e + c * dn_e))
                    .onto(ray.k, ray.extraordinary);
            };
            ray.fan = (k_at(step) - k_at(-step)) / (2 * step);
            ray.k = k_at(colour);
            if (ray.extraordinary) {
                const Vec3& a = there.axis;
                ray.field = normalised(a - (dot(ray.k, a) / (there.n_o * there.n_o)) * ray.k);
            }
            rays.add(ray);
        }
        return exits_of(rays, 1e-300, 3);
    };
    const auto middle = exits_at(0), red = exits_at(-step), blue = exits_at(step);
    REQUIRE(red.size() == middle.size());
    REQUIRE(blue.size() == middle.size());
    // Beside a critical angle directions change without bound, and with them the second order.
    int compared = 0;
    double worst = 0;
    for (std::size_t i = 0; i < middle.size(); ++i) {
        const double size = length(middle[i].fan);
        if (size > 3) continue;
        ++compared;
        worst = std::max(worst,
                         length(middle[i].fan - (blue[i].k - red[i].k) / (2 * step)) / (1 + size));
    }
    CAPTURE(compared, worst);
    CHECK(compared > 100);
    CHECK(worst < 1e-6);
}
