// Stones that are moved, measured, and put beside one another.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/solids.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Stone box(const Vec3& low, const Vec3& high) { return Stone::from_planes(box_planes(low, high)); }

bool contains(const Stone& stone, const Vec3& p) {
    for (const Facet& facet : stone.facets) {
        if (dot(facet.normal, p) > facet.distance) return false;
    }
    return true;
}

Transform random_transform(Random& random) {
    const auto vector = [&] { return random.uniform(0.5, 2) * random.direction(); };
    for (;;) {
        const std::array rows{vector(), vector(), vector()};
        if (std::abs(dot(rows[0], cross(rows[1], rows[2]))) < 0.2) continue;
        return {rows, 5 * random.direction()};
    }
}

}  // namespace

TEST_CASE("a moved, stretched or mirrored stone is still a stone", "[stone][property]") {
    const int seed = GENERATE(range(0, 40));
    CAPTURE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    const Stone stone = Stone::from_planes(random_planes(random, 40, 0.1));
    const Transform t = random_transform(random);
    const Stone moved = stone.transformed(t);
    CHECK(fault_of(moved) == "");
    CHECK_THAT(moved.volume, WithinRel(stone.volume * std::abs(t.determinant()), 1e-15));
    for (std::size_t i = 0; i < stone.facets.size(); ++i) {
        CHECK(moved.facets[i].name == stone.facets[i].name);
        CHECK(moved.facets[i].corners[0] == stone.facets[i].corners[0]);
    }
}

TEST_CASE("a mirror turns the corners round, not the facets inside out", "[stone]") {
    const Stone stone = box({0, 0, 0}, {1, 2, 3});
    const Stone mirrored = stone.transformed(Transform::scaling({1, 1, -1}));
    CHECK(fault_of(mirrored) == "");
    CHECK(mirrored.facets[5].normal.z == -1);
    CHECK(mirrored.facets[5].distance == 3);
}

TEST_CASE("length and width are the greater and the lesser extent across z", "[stone]") {
    const GirdleSize size = girdle_size(box({-1, -3, 0}, {1, 4, 0.5}));
    CHECK(size.length == 7);
    CHECK(size.width == 2);
    CHECK(size.height == 0.5);
    CHECK(girdle_size(box({-3, -1, 0}, {4, 1, 0.5})).length == 7);
    CHECK(girdle_size(Stone{}).width == 0);
}

TEST_CASE("stones that touch do not overlap", "[stone][overlap]") {
    const Stone unit = box({0, 0, 0}, {1, 1, 1});
    Vec3 where{7, 7, 7};
    CHECK_FALSE(overlap(unit, box({1, 0, 0}, {2, 1, 1}), where));  // face on face
    CHECK_FALSE(overlap(unit, box({1, 1, 0}, {2, 2, 1}), where));  // edge on edge
    CHECK_FALSE(overlap(unit, box({1, 1, 1}, {2, 2, 2}), where));  // corner on corner
    CHECK_FALSE(overlap(unit, box({5, 0, 0}, {6, 1, 1}), where));
    CHECK_FALSE(overlap(unit, box({1 - 1e-12, 0, 0}, {2, 1, 1}), where));  // by rounding
    CHECK(where == Vec3{7, 7, 7});

    CHECK(overlap(unit, box({1 - 1e-6, 0, 0}, {2, 1, 1}), where));
    CHECK(contains(unit, where));
    CHECK(overlap(unit, box({-1, -1, -1}, {3, 3, 3}), where));  // one within the other
    CHECK(contains(unit, where));
    CHECK(overlap(unit, unit, where));
    CHECK(contains(unit, where));
}

TEST_CASE("stones apart by less than their boxes show are told apart", "[stone][overlap]") {
    // Two octahedra beside each other along (1, 1, 1): their boxes overlap, only a facet parts
    // them.
    const Stone a = Stone::from_points(octahedron());
    const double touching = 2.0 / 3;
    const auto at = [&](double d) { return a.transformed(Transform::translation({d, d, d})); };
    Vec3 where;
    CHECK_FALSE(overlap(a, at(touching + 1e-6), where));
    CHECK_FALSE(overlap(a, at(touching), where));
    CHECK(overlap(a, at(touching - 1e-6), where));
    CHECK(contains(a, where));
    CHECK(contains(at(touching - 1e-6), where));
}

TEST_CASE("crossed edges are told apart", "[stone][overlap]") {
    // Two roofs, ridge on ridge at right angles: neither has a facet that parts them.
    const auto roof = [](double up, const Vec3& along, double ridge) {
        const Vec3 z{0, 0, 1};
        const Vec3 across = cross(along, z);
        return Stone::from_planes(std::vector<FacetPlane>{{up * z + across, up * ridge},
                                                          {up * z - across, up * ridge},
                                                          {-up * z, up * (up - ridge)},
                                                          {along, 2},
                                                          {-along, 2}});
    };
    Vec3 where;
    CHECK_FALSE(overlap(roof(1, {1, 0, 0}, 0), roof(-1, {0, 1, 0}, 1e-6), where));
    CHECK_FALSE(overlap(roof(1, {1, 0, 0}, 0), roof(-1, {0, 1, 0}, 0), where));
    CHECK(overlap(roof(1, {1, 0, 0}, 0), roof(-1, {0, 1, 0}, -1e-6), where));
}

TEST_CASE("overlap far from the origin allows for the rounding of places", "[stone][overlap]") {
    const Transform away = Transform::translation({1e6, 3e5, -2e6});
    const Stone a = box({0, 0, 0}, {1, 1, 1}).transformed(away);
    const Stone b = box({1, 0, 0}, {2, 1, 1}).transformed(away);
    const Stone c = box({0.999, 0, 0}, {2, 1, 1}).transformed(away);
    Vec3 where;
    CHECK_FALSE(overlap(a, b, where));
    CHECK(overlap(a, c, where));
}
