// Rays at edges and corners of a stone: none may be lost there.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/gem_scenes.hpp"
#include "support/recorder.hpp"

using namespace icespar;
using namespace icespar::testing;
using Draws = icespar::testing::Random;

namespace {

/// A point on an edge of the stone, or (now and then) at a corner; with the facets that meet there.
struct RimPoint {
    Vec3 point;
    std::vector<Vec3> normals;
};

RimPoint rim_point(const Stone& stone, Draws& random) {
    const auto below = [&](std::size_t n) {
        return static_cast<std::size_t>(random.below(static_cast<int>(n)));
    };
    const Facet& facet = stone.facets[below(stone.facets.size())];
    const std::size_t i = below(facet.corners.size());
    const Vec3& a = stone.vertices[facet.corners[i]];
    const Vec3& b = stone.vertices[facet.corners[(i + 1) % facet.corners.size()]];
    const double t = random.below(3) == 0 ? 0 : random.uniform();
    RimPoint rim{(1 - t) * a + t * b, {}};
    for (const Facet& f : stone.facets) {
        if (std::abs(dot(f.normal, rim.point) - f.distance) < 1e-9) rim.normals.push_back(f.normal);
    }
    return rim;
}

}  // namespace

TEST_CASE("rays aimed at edges and corners from outside meet the stone there", "[world][leak]") {
    Draws random(3);
    const Scene scene = scene_of(brilliant_stone(), glass(2.417));
    const World world(scene);
    const Stone& stone = scene.gems[0].stone;
    int aimed = 0, lost = 0;
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const RimPoint rim = rim_point(stone, random);
        const Vec3 origin = random.uniform(2, 9) * random.direction();
        const Vec3 d = normalised(rim.point - origin);
        // Where every facet of the edge looks at the ray's origin, nothing hides the edge.
        const bool open = std::all_of(rim.normals.begin(), rim.normals.end(),
                                      [&](const Vec3& n) { return dot(n, d) < -1e-6; });
        if (!open) continue;
        ++aimed;
        Hit hit;
        if (!world.nearest({origin, d}, {}, hit)) {
            ++lost;
            continue;
        }
        worst = std::max(worst, std::abs(hit.distance - length(rim.point - origin)));
    }
    INFO("worst " << in_digits(worst));
    CHECK(aimed > 20000);
    CHECK(lost == 0);
    CHECK(worst < 1e-8);  // glancing facets, cosines down to 1e-6
}

TEST_CASE("rays aimed at edges and corners from inside leave there", "[world][leak]") {
    Draws random(4);
    const Scene scene = scene_of(brilliant_stone(), glass(2.417));
    const World world(scene);
    const Stone& stone = scene.gems[0].stone;
    int lost = 0;
    double worst = 0, farthest_out = 0;
    for (int i = 0; i < 100000; ++i) {
        const RimPoint rim = rim_point(stone, random);
        const RimPoint other = rim_point(stone, random);
        const Vec3 origin = 0.3 * other.point + 0.1 * rim.point;
        const Vec3 d = normalised(rim.point - origin);
        double distance = -1;
        const int facet = world.planes(0).exit(origin, d, -1, distance);
        if (facet < 0 || !(distance >= 0)) {
            ++lost;
            continue;
        }
        worst = std::max(worst, std::abs(distance - length(rim.point - origin)));
        // Onward from that very edge, in any direction that leads back inside the facet it is on.
        const Vec3 start = origin + distance * d;
        Vec3 on = random.direction();
        const Vec3& n = stone.facets[static_cast<std::size_t>(facet)].normal;
        if (dot(on, n) > 0) on = on - 2 * dot(on, n) * n;
        const int next = world.planes(0).exit(start, on, facet, distance);
        if (next < 0 || next == facet || !(distance >= 0)) {
            ++lost;
            continue;
        }
        for (const Facet& f : stone.facets) {
            farthest_out =
                std::max(farthest_out, dot(f.normal, start + distance * on) - f.distance);
        }
    }
    INFO("worst " << in_digits(worst) << ", outside by " << in_digits(farthest_out));
    CHECK(lost == 0);
    CHECK(worst < 1e-13);
    CHECK(farthest_out < 1e-13);
}

TEST_CASE("no light is lost at edges and corners", "[world][leak][furnace]") {
    Draws random(5);
    for (const Crystal& crystal : {glass(2.417), zircon(random.direction())}) {
        const bool plain = !crystal.birefringent();
        const Scene scene = scene_of(brilliant_stone(), crystal);
        std::vector<SensorRay> rays;
        for (int i = 0; i < (plain ? 100000 : 10000); ++i) {
            const RimPoint rim = rim_point(scene.gems[0].stone, random);
            const Vec3 origin = random.uniform(2, 9) * random.direction();
            const Vec3 d = normalised(rim.point - origin);
            rays.push_back({origin, d, random.perpendicular_to(d)});
        }
        TraceOptions options;
        options.max_hits = plain ? 5 : 4;
        const Traced traced = trace(scene, rays, options);
        double worst = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            worst = std::max(worst, difference(traced.stokes[i] + traced.dropped[i], {1, 0, 0, 0}));
        }
        CAPTURE(in_digits(worst));
        CHECK(worst <= 1e-12);

        // What leaks out inside counts as dropped above: no branch may find no facet ahead.
        const World world(scene);
        const Palette palette(scene, 0);
        int stuck = 0;
        for (std::size_t i = 0; i < 10000; ++i) {
            stuck += recorded(world, palette, rays[i].origin, rays[i].direction, 6, 1e-3).stuck;
        }
        CHECK(stuck == 0);
    }
}
