// Round lamps at infinity: seen where they stand, and as large as they are.
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;
using Draws = icespar::testing::Random;

TEST_CASE("a disc in the sky shines from within its edge and not from beyond", "[render][disc]") {
    Scene scene;
    scene.environment = furnace();
    scene.environment.discs.push_back({{0, 1, 0}, std::cos(9 * degree), Spectrum(12.0)});
    const auto seen = [&](double angle) {
        return trace_one(scene, {{}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}).s0;
    };
    CHECK_THAT(seen(8.999 * degree), WithinAbs(13, 1e-12));
    CHECK_THAT(seen(9.001 * degree), WithinAbs(1, 1e-12));
}

TEST_CASE("a disc as wide as the sphere of directions is a uniform sky", "[render][disc]") {
    Draws random(7);
    Scene discs = scene_of(brilliant_stone(), calcite({0, 0, 1}), night());
    discs.environment.discs.push_back({{1, 0, 0}, -1, Spectrum(1.0)});
    Scene uniform = discs;
    uniform.environment = furnace();
    for (const SensorRay& ray : random_rays(random, 10, 5, 0.8)) {
        CHECK(difference(trace_one(discs, ray), trace_one(uniform, ray)) < 1e-9);
    }
}

TEST_CASE("a disc whose direction is no unit vector is refused", "[render][disc]") {
    Scene scene;
    scene.environment.discs.push_back({{0, 2, 0}, 0.9, Spectrum(1.0)});
    CHECK(faults(scene).size() == 1);
}
