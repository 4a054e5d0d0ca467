// Which object a ray meets: the tree against asking all, and stones of any size and place.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "render/world.hpp"
#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;
using Draws = icespar::testing::Random;

namespace {

/// A random turn, stretch and shift.
Transform random_placement(Draws& random, double reach, double least, double most) {
    const Vec3 a = random.direction(), b = random.perpendicular_to(a), c = cross(a, b);
    const double x = random.uniform(least, most), y = random.uniform(least, most),
                 z = random.uniform(least, most);
    const Vec3 offset{random.uniform(-reach, reach), random.uniform(-reach, reach),
                      random.uniform(-reach, reach)};
    return {{Vec3{a.x * x, b.x * y, c.x * z}, Vec3{a.y * x, b.y * y, c.y * z},
             Vec3{a.z * x, b.z * y, c.z * z}},
            offset};
}

Transform moved(double scale, const Vec3& by) {
    return Transform::scaling({scale, scale, scale}).then(Transform::translation(by));
}

/// Thirty gems, ten spheres, ten boxes and a floor.
Scene crowd(Draws& random) {
    Scene scene;
    const Stone shapes[] = {cube_stone(), rhomb_stone(), brilliant_stone()};
    for (std::size_t i = 0; i < 30; ++i) {
        scene.gems.push_back({shapes[i % 3].transformed(random_placement(random, 10, 0.3, 1.2)),
                              glass(1.5), std::to_string(i)});
    }
    for (int i = 0; i < 20; ++i) {
        Thing thing;
        if (i % 2 == 0) {
            thing.shape = SphereShape{};
        } else {
            thing.shape = BoxShape{};
        }
        thing.to_world = random_placement(random, 10, 0.3, 1.5);
        scene.things.push_back(thing);
    }
    Thing floor;
    floor.to_world = Transform::translation({0, -11, 0});
    scene.things.push_back(floor);
    return scene;
}

bool same(const Hit& a, const Hit& b) {
    return a.distance == b.distance && a.gem == b.gem && a.thing == b.thing && a.facet == b.facet &&
           a.normal == b.normal;
}

}  // namespace

TEST_CASE("the tree finds what asking every object finds, to the last bit", "[world]") {
    Draws random(1);
    std::size_t met = 0;
    for (int arrangement = 0; arrangement < 4; ++arrangement) {
        const Scene scene = crowd(random);
        const World tree(scene, true), all(scene, false);
        for (int i = 0; i < 25000; ++i) {
            const SensorRay r = random_ray(random, random.uniform(0, 30), 12);
            Departure from;
            if (i % 4 == 0) from.gem = random.below(30);
            if (i % 4 == 1) from.thing = random.below(21);
            Hit a, b;
            const bool found = all.nearest({r.origin, r.direction}, from, a);
            const bool in_tree = tree.nearest({r.origin, r.direction}, from, b);
            if (found != in_tree || (found && !same(a, b))) {
                CAPTURE(arrangement, i, found, in_tree, a.gem, b.gem, a.thing, b.thing);
                CHECK(in_digits(a.distance) == in_digits(b.distance));
                FAIL("the tree found something else");
            }
            met += found ? 1 : 0;
            const double reach = random.uniform(0, 20);
            REQUIRE(all.blocked({r.origin, r.direction}, from, reach) ==
                    tree.blocked({r.origin, r.direction}, from, reach));
            if (found) {
                REQUIRE(all.blocked({r.origin, r.direction}, from, a.distance * 1.001));
                REQUIRE_FALSE(all.blocked({r.origin, r.direction}, from, a.distance));
            }
        }
    }
    CHECK(met > 50000);
}

TEST_CASE("rays from very far away find what stands in the scene", "[world]") {
    Draws random(2);
    Scene scene = crowd(random);
    scene.things.pop_back();  // the floor
    const World tree(scene, true), all(scene, false);
    for (const double distance : {1e3, 1e5, 1e7}) {
        int lost = 0, met = 0;
        for (int i = 0; i < 20000; ++i) {
            const SensorRay r = random_ray(random, distance, 12);
            Hit a, b;
            const bool found = all.nearest({r.origin, r.direction}, {}, a);
            const bool in_tree = tree.nearest({r.origin, r.direction}, {}, b);
            met += found ? 1 : 0;
            lost += found != in_tree || (found && !same(a, b)) ? 1 : 0;
        }
        INFO(lost << " of " << met << " from " << distance);
        CHECK(met > 1000);
        CHECK(lost == 0);
    }
}

TEST_CASE("a stone's size and place do not change what is seen in it", "[world]") {
    Draws random(6);
    const Crystal crystal = GENERATE_COPY(values({glass(2.417), calcite({0.6, 0, 0.8})}));
    const bool crowded = GENERATE(false, true);  // more than four objects bring in the tree
    const auto build = [&](double scale, const Vec3& by) {
        Scene scene;
        scene.environment = slope(normalised(Vec3{1, 2, 3}));
        for (int i = 0; i < (crowded ? 6 : 1); ++i) {
            const Vec3 place = by + scale * Vec3{3.0 * i, 0, 0};
            scene.gems.push_back(
                {brilliant_stone().transformed(moved(scale, place)), crystal, std::to_string(i)});
        }
        return scene;
    };
    const auto rays = random_rays(random, 300, 4, 0.7);
    TraceOptions options;
    options.max_hits = 5;
    const Traced plain = trace(build(1, {}), rays, options);
    const auto differing = [&](double scale, const Vec3& by) {
        std::vector<SensorRay> there;
        for (const SensorRay& r : rays) {
            there.push_back({scale * r.origin + by, r.direction, r.x_axis});
        }
        const Traced traced = trace(build(scale, by), there, options);
        int count = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            count += difference(traced.stokes[i], plain.stokes[i]) > 1e-11 ? 1 : 0;
        }
        return count;
    };
    CAPTURE(crystal.birefringent(), crowded);
    CHECK(differing(1e-3, {}) == 0);
    CHECK(differing(1e6, {}) == 0);
    // Positions are good to 1e-10 there; a ray in 1e8 changes facets for it.
    CHECK(differing(1, {1e6, 0, 0}) == 0);
    CHECK(differing(1, {-6e5, 7e5, 4e5}) == 0);
    CHECK(differing(1e-3, {10, -20, 5}) == 0);
}

TEST_CASE("a ray inside a box or a sphere meets the wall, from the wall the opposite one",
          "[world]") {
    Scene scene;
    Thing box, sphere;
    box.shape = BoxShape{};
    sphere.shape = SphereShape{};
    sphere.to_world = Transform::translation({10, 0, 0});
    scene.things = {box, sphere};
    const World world(scene);
    Hit hit;
    REQUIRE(world.nearest({{0.5, 0.5, 0.5}, {1, 0, 0}}, {}, hit));
    CHECK(hit.thing == 0);
    CHECK(hit.distance == 0.5);
    CHECK(hit.normal == Vec3{-1, 0, 0});
    REQUIRE(world.nearest({{1, 0.5, 0.5}, {1, 0, 0}}, {-1, 0}, hit));
    CHECK(hit.thing == 1);
    CHECK(hit.normal.x < 0);
    REQUIRE(world.nearest({{10, 0, 0}, {0, 1, 0}}, {}, hit));
    CHECK(hit.distance == 1);
    CHECK(hit.normal == Vec3{0, -1, 0});
    REQUIRE(world.nearest({{9, 0, 0}, {1, 0, 0}}, {-1, 1}, hit));
    CHECK(hit.distance == Approx(2));
    CHECK_FALSE(world.nearest({{11, 0, 0}, {1, 0, 0}}, {-1, 1}, hit));
}
