// Stones from meshes: closed and convex ones, and where others are open or dented.
#include <catch2/catch.hpp>
#include <cmath>

#include "math/error.hpp"
#include "support/solids.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Facets as fans; every third triangle goes round the other way.
Triangles fans(const Stone& stone) {
    Triangles out;
    for (const Facet& f : stone.facets) {
        for (std::size_t i = 2; i < f.corners.size(); ++i) {
            out.push_back({f.corners[0], f.corners[i - 1], f.corners[i]});
            if (out.size() % 3 == 0) std::swap(out.back()[0], out.back()[1]);
        }
    }
    return out;
}

std::string fault(const std::vector<Vec3>& points, const Triangles& triangles) {
    try {
        (void)Stone::from_mesh(points, triangles);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("a convex mesh with six decimals is the stone it was made from", "[stone][mesh]") {
    Random random(31);
    for (int i = 0; i < 12; ++i) {
        const Stone stone = Stone::from_planes(random_planes(random, 12 + 5 * i, 0.1));
        std::vector<Vec3> points = stone.vertices;
        for (Vec3& p : points) {
            const auto digits = [](double v) { return std::round(v * 1e6) / 1e6; };
            p = {digits(p.x), digits(p.y), digits(p.z)};
        }
        const Stone mesh = Stone::from_mesh(points, fans(stone));
        CAPTURE(i);
        CHECK(fault_of(mesh) == "");
        CHECK(mesh.facets.size() == stone.facets.size());
        CHECK_THAT(mesh.volume, WithinRel(stone.volume, 1e-5));
    }
}

TEST_CASE("a mesh with a hole, a dent or two parts is no stone, and the message says where",
          "[stone][mesh]") {
    const Stone solid = Stone::from_points(cube());
    const std::vector<Vec3>& corners = solid.vertices;
    Triangles triangles = fans(solid);
    CHECK(fault(corners, triangles).empty());

    Triangles open = triangles;
    open.pop_back();
    CHECK_THAT(fault(corners, open), Contains("not a closed surface: the edge from <") &&
                                         Contains("belongs to 1 triangle"));

    // A face's middle, pushed inwards.
    const Facet& face = solid.facets[0];
    std::vector<Vec3> dented = corners;
    dented.push_back(0.9 * face.normal * face.distance);
    Triangles roof;
    for (const auto& t : triangles) {
        const bool on_face = [&] {
            for (const auto corner : t) {
                if (std::abs(dot(face.normal, corners[corner]) - face.distance) > 1e-9)
                    return false;
            }
            return true;
        }();
        if (!on_face) roof.push_back(t);
    }
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        roof.push_back({face.corners[i], face.corners[(i + 1) % face.corners.size()],
                        static_cast<std::uint32_t>(corners.size())});
    }
    CHECK_THAT(fault(dented, roof), Contains("not convex: at <"));
    // Pushed outwards it is a stone of nine facets.
    dented.back() = 1.1 * face.normal * face.distance;
    CHECK(Stone::from_mesh(dented, roof).facets.size() == 9);

    std::vector<Vec3> two = corners;
    Triangles both = triangles;
    for (const Vec3& c : corners) two.push_back(c + Vec3{5, 0, 0});
    for (const auto& [a, b, c] : triangles) both.push_back({a + 8, b + 8, c + 8});
    CHECK_THAT(fault(two, both), Contains("parts that are not joined"));
}

TEST_CASE("corners that a loop computes twice are one, though rounding parts them",
          "[stone][mesh]") {
    std::vector<Vec3> points;
    Triangles triangles;
    const auto corner = [&](const Vec3& p) {
        points.push_back(p);
        return static_cast<std::uint32_t>(points.size() - 1);
    };
    const double turn = 2 * std::acos(-1.0);
    for (int i = 0; i < 16; ++i) {
        const double a = turn * i / 16, b = turn * (i + 1) / 16;
        for (const double y : {-0.9, 0.7}) {
            triangles.push_back({corner({0, y, 0}), corner({std::cos(a), 0, std::sin(a)}),
                                 corner({std::cos(b), 0, std::sin(b)})});
        }
    }
    const Stone stone = Stone::from_mesh(points, triangles);
    CHECK(stone.facets.size() == 32);
    CHECK_THAT(stone.volume, WithinRel(1.6 * 8 * std::sin(turn / 16) / 3, 1e-12));
}
