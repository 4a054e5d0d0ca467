// Stones that touch each other, the floor, or the plane of the camera.
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;

namespace {

/// In a random attitude: a box, and above it, `gap` away, another or (things) a glowing plane.
Scene neighbours(std::uint64_t seed, double gap, int kind) {
    testing::Random random(seed);
    const Vec3 x = random.direction(), y = random.perpendicular_to(x), z = cross(x, y);
    const Transform turned{{x, y, z}, 3 * random.direction()};
    Scene scene = scene_of(box_stone({-1, -1, -1}, {0, 1, 1}).transformed(turned), glass(1.5),
                           slope(random.direction()));
    if (kind == 0) {
        scene.gems.push_back(
            {box_stone({gap, -1, -1}, {1, 1, 1}).transformed(turned), glass(1.7), "other"});
        return scene;
    }
    Thing thing;
    thing.finish = {0, 1};
    // The plane y = 0 or the box from 0 to 1, turned so that it faces the stone's side x = 0.
    const Transform quarter{{Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}}, {gap, 0, 0}};
    const Transform centred = Transform::translation({0, -0.5, -0.5})
                                  .then(Transform::scaling({2, 4, 4}))
                                  .then(Transform::translation({gap, 0, 0}));
    if (kind == 1) thing.shape = PlaneShape{};
    if (kind == 2) thing.shape = BoxShape{};
    thing.to_world = (kind == 1 ? quarter : centred).then(turned);
    scene.things.push_back(thing);
    return scene;
}

}  // namespace

TEST_CASE("what touches a stone is seen as if it stood a hair's breadth away", "[world][contact]") {
    const auto seed = static_cast<std::uint64_t>(GENERATE(range(0, 30)));
    const int kind = GENERATE(0, 1, 2);
    CAPTURE(seed, kind);
    const Scene apart = neighbours(seed, 1e-7, kind), touching = neighbours(seed, 0, kind);
    testing::Random random(seed + 1000);
    Vec3 centre;
    for (const Vec3& v : apart.gems[0].stone.vertices) centre += v / 8.0;
    TraceOptions options;
    options.max_hits = 8;
    for (int i = 0; i < 8; ++i) {
        const SensorRay ray = random_ray(random, 5, 1, centre);
        CAPTURE(i);
        CHECK(difference(trace_one(apart, ray, options), trace_one(touching, ray, options)) < 1e-4);
    }
}

TEST_CASE("a parallel view does not start inside a stone, and shows none behind it",
          "[camera][contact]") {
    Scene scene = scene_of(cube_stone(), glass(1.5), slope({1, 0, 0}));
    scene.camera.kind = Camera::Kind::orthographic;
    scene.camera.location = {0, 0, 0.5};
    scene.camera.right = {3, 0, 0};
    scene.camera.up = {0, 3, 0};
    CHECK_THROWS_WITH(render(scene, small(4, 1)), Contains("start inside the stone"));
    scene.camera.location = {4, 0, 0.5};
    CHECK_NOTHROW(render(scene, small(4, 1)));
    scene.camera.location = {0, 0, -2};
    for (const Engine engine : {Engine::rays, Engine::automatic}) {
        RenderOptions options = small(4, 4);
        options.engine = engine;
        const Image image = render(scene, options).image;
        // The sky straight ahead, which is level.
        for (const float v : image.rgb) CHECK(v == Approx(0.5).epsilon(1e-6));
    }
}
