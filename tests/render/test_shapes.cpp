// Cylinders, cones, discs, triangles and meshes: where rays meet them, with and without the tree.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "render/meet_shape.hpp"
#include "render/world.hpp"
#include "support/lit_floor.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

/// A ball of triangles: an icosahedron's faces, each cut into four, on the unit sphere.
std::shared_ptr<const TriangleMesh> ball_mesh(int cuts) {
    auto mesh = std::make_shared<TriangleMesh>();
    const Stone solid = Stone::from_points(icosahedron());
    for (const Vec3& v : solid.vertices) mesh->vertices.push_back(normalised(v));
    for (const Facet& f : solid.facets) {
        mesh->triangles.push_back({f.corners[0], f.corners[1], f.corners[2]});
    }
    for (; cuts > 0; --cuts) {
        const auto coarse = std::exchange(mesh->triangles, {});
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, is_new] = middles.try_emplace(
                std::minmax(a, b), static_cast<std::uint32_t>(mesh->vertices.size()));
            if (is_new) {
                mesh->vertices.push_back(normalised(mesh->vertices[a] + mesh->vertices[b]));
            }
            return at->second;
        };
        for (const auto& [a, b, c] : coarse) {
            const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const auto& t : {std::array{a, ab, ca}, std::array{b, bc, ab},
                                  std::array{c, ca, bc}, std::array{ab, bc, ca}}) {
                mesh->triangles.push_back(t);
            }
        }
    }
    return mesh;
}

Thing thing_of(Shape shape, const Transform& to_world = {}) {
    Thing thing;
    thing.shape = std::move(shape);
    thing.to_world = to_world;
    return thing;
}

}  // namespace

TEST_CASE("a ray meets a cone where it first passes from outside to inside", "[shapes]") {
    Random random(11);
    for (const double top : {1.0, 0.5, 0.0}) {
        const auto inside = [&](const Vec3& p) {
            return p.y > 0 && p.y < 1 && std::hypot(p.x, p.z) < 1 + (top - 1) * p.y;
        };
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const SensorRay ray = random_ray(random, i % 2 == 0 ? 5 : 5e6, 1.3, {0, 0.5, 0});
            // Crossings by small steps, far from which nothing is asked.
            const double near = length(ray.origin) - 3;
            double expected = -1;
            for (int step = 1; step <= 6000 && expected < 0; ++step) {
                if (inside(ray.origin + (near + 1e-3 * step) * ray.direction)) {
                    expected = near + 1e-3 * step;
                }
            }
            Meeting met;
            const bool found = meet_shape(ConeShape{top, false}, ray.origin, ray.direction, 0, met);
            CAPTURE(top, i);
            if (expected < 0) {
                // It may have grazed an edge between two steps.
                if (found) {
                    CHECK_FALSE(inside(ray.origin + (met.distance + 2e-3) * ray.direction));
                }
                continue;
            }
            ++hits;
            REQUIRE(found);
            CHECK(met.distance <= expected + 1e-9);
            CHECK(met.distance >= expected - 1.1e-3);
            const Vec3 p = ray.origin + met.distance * ray.direction;
            const double off = std::min({std::abs(p.y), std::abs(p.y - 1),
                                         std::abs(std::hypot(p.x, p.z) - 1 - (top - 1) * p.y)});
            CHECK(off <= 1e-15 * length(ray.origin) + 1e-13);
            // The normal leans against the ray: the surface faces it.
            const double sign = dot(met.normal, ray.direction);
            CHECK((sign < 0 || std::abs(met.normal.y) == 1));
        }
        CHECK(hits > 500);
    }
}

TEST_CASE("an open tube is seen into, and a disc has a hole", "[shapes]") {
    Meeting met;
    const Vec3 above{0.2, 5, 0.1}, down{0, -1, 0};
    CHECK(meet_shape(ConeShape{1, false}, above, down, 0, met));
    CHECK_THAT(met.distance, WithinAbs(4, 1e-15));
    CHECK_FALSE(meet_shape(ConeShape{1, true}, above, down, 0, met));
    const Vec3 slanted = normalised(Vec3{0.18, -1, 0});
    CHECK(meet_shape(ConeShape{1, true}, above, slanted, 0, met));
    CHECK(meet_shape(DiscShape{0.2}, above, down, 0, met));
    CHECK_FALSE(meet_shape(DiscShape{0.3}, above, down, 0, met));
    CHECK_FALSE(meet_shape(DiscShape{}, {1.01, 5, 0}, down, 0, met));
    CHECK(meet_shape(SquareShape{}, above, down, 0, met));
    CHECK_FALSE(meet_shape(SquareShape{}, {-0.01, 5, 0.5}, down, 0, met));
}

TEST_CASE("no ray slips through a mesh at an edge or a corner", "[shapes][leak]") {
    const auto mesh = ball_mesh(2);
    Scene scene;
    scene.things = {thing_of(MeshShape{mesh}, Transform::scaling({1, 2, 3}).then(
                                                  Transform::translation({0.1, 0.7, -0.3})))};
    Random random(5);
    for (const bool tree : {false, true}) {
        const World world(scene, tree);
        for (int i = 0; i < 3000; ++i) {
            const auto& t = mesh->triangles[static_cast<std::size_t>(
                random.uniform() * static_cast<double>(mesh->triangles.size()))];
            const Vec3& a = mesh->vertices[t[0]];
            const Vec3& b = mesh->vertices[t[1]];
            const double part = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 : random.uniform();
            const Vec3 aim = scene.things[0].to_world.point(a + part * (b - a));
            Hit hit;
            CAPTURE(tree, i);
            // From the middle every direction meets the mesh.
            const Vec3 middle = scene.things[0].to_world.point({});
            REQUIRE(world.nearest({middle, normalised(aim - middle)}, {}, hit));
            CHECK_THAT(hit.distance, WithinAbs(length(aim - middle), 1e-12));
        }
    }
}

TEST_CASE("a mesh is met alike with the tree and without", "[shapes][embree]") {
    Scene scene;
    scene.things = {thing_of(MeshShape{ball_mesh(2)}),
                    thing_of(ConeShape{0.3, true}, Transform::translation({1.5, 0, 0})),
                    thing_of(DiscShape{0.4}, Transform::translation({-1.5, 0.2, 0}))};
    const World asked(scene, false), sorted(scene, true);
    Random random(8);
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
        const SensorRay ray = random_ray(random, 6, 2);
        Hit a, b;
        const bool one = asked.nearest({ray.origin, ray.direction}, {}, a);
        const bool other = sorted.nearest({ray.origin, ray.direction}, {}, b);
        CAPTURE(i);
        REQUIRE(one == other);
        if (!one) continue;
        ++met;
        CHECK(a.distance == b.distance);
        CHECK(a.thing == b.thing);
        CHECK(dot(a.normal, ray.direction) < 0);
    }
    CHECK(met > 1000);
}

TEST_CASE("a ball of many triangles is lit like a ball, without specks of its own shadow",
          "[shapes][surface]") {
    Scene scene;
    scene.environment = night();
    scene.things = {thing_of(MeshShape{ball_mesh(4)})};
    scene.things[0].finish = {1, 0};
    scene.lights = {lamp_at({0, 1e6, 0})};
    Random random(21);
    for (int i = 0; i < 500; ++i) {
        const Vec3 n = random.direction();
        const double seen = trace_one(scene, {5.0 * n, -n, random.perpendicular_to(n)}).s0;
        CAPTURE(i);
        CHECK_THAT(seen, WithinAbs(std::max(0.0, n.y), 0.06));
    }
}
