// A stone from the triangles of a closed convex mesh, or where the mesh is open or dented.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

#include "math/error.hpp"
#include "stone/polyhedron.hpp"

namespace icespar {
namespace {

/// How far below the hull's surface a mesh may lie, in units of the stone's size: coordinates with
/// six decimals are off by half a millionth, and facets gathered from them by two.
constexpr double dent = 4e-6;
/// Corners no farther apart are one, in units of the stone's size: cos(2*pi) is not quite cos(0).
constexpr double apart = 1e-9;
/// By which part of itself the volume may differ from the hull's.
constexpr double bulge = 1e-4;

std::string written(const Vec3& v) {
    char text[100];
    const auto digits = [](double x) { return std::round(x * 1e6) / 1e6 + 0.0; };
    std::snprintf(text, sizeof text, "<%g, %g, %g>", digits(v.x), digits(v.y), digits(v.z));
    return text;
}

struct Surface {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
};

/// Corners at one place but for rounding become the first of them; triangles that lose their area
/// by that are left out.
Surface welded(std::span<const Vec3> points, std::span<const Triangle> triangles,
               double tolerance) {
    std::vector<std::uint32_t> by_x(points.size()), first(points.size()), number(points.size());
    std::iota(by_x.begin(), by_x.end(), 0U);
    std::iota(first.begin(), first.end(), 0U);
    std::sort(by_x.begin(), by_x.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(points[a].x, a) < std::tie(points[b].x, b);
    });
    for (auto i = by_x.begin(); i != by_x.end(); ++i) {
        for (auto j = i; j != by_x.begin();) {
            --j;
            if (!(points[*i].x - points[*j].x <= tolerance)) break;
            if (!(length(points[*i] - points[*j]) <= tolerance)) continue;
            const std::uint32_t least = std::min(first[*i], first[*j]);
            first[*i] = first[*j] = first[first[*j]] = least;
        }
    }
    Surface out;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        while (first[first[i]] != first[i]) first[i] = first[first[i]];
        number[i] =
            first[i] == i ? static_cast<std::uint32_t>(out.points.size()) : number[first[i]];
        if (first[i] == i) out.points.push_back(points[i]);
    }
    for (const auto& [a, b, c] : triangles) {
        const Triangle t{number[a], number[b], number[c]};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.triangles.push_back(t);
    }
    return out;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Every edge belongs to two triangles. Turns triangles so that neighbours go round alike.
std::vector<Triangle> oriented(std::span<const Vec3> points, std::span<const Triangle> triangles) {
    std::map<Edge, std::vector<std::uint32_t>> owners;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
            owners[std::minmax(a, b)].push_back(t);
        }
    }
    for (const auto& [edge, faces] : owners) {
        if (faces.size() == 2) continue;
        throw Error("the mesh is not a closed surface: the edge from " +
                    written(points[edge.first]) + " to " + written(points[edge.second]) +
                    " belongs to " + std::to_string(faces.size()) +
                    (faces.size() == 1 ? " triangle" : " triangles") +
                    ", and in a stone every edge joins two");
    }
    std::vector<Triangle> out(triangles.begin(), triangles.end());
    std::vector<bool> turned(out.size(), false);
    std::vector<std::uint32_t> waiting{0};
    turned[0] = true;
    std::size_t reached = 0;
    while (!waiting.empty()) {
        const std::uint32_t t = waiting.back();
        waiting.pop_back();
        ++reached;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = out[t][k], b = out[t][(k + 1) % 3];
            for (const std::uint32_t other : owners[std::minmax(a, b)]) {
                if (turned[other]) continue;
                turned[other] = true;
                Triangle& o = out[other];
                for (std::size_t m = 0; m < 3; ++m) {
                    if (o[m] == a && o[(m + 1) % 3] == b) {
                        std::swap(o[0], o[1]);
                        break;
                    }
                }
                waiting.push_back(other);
            }
        }
    }
    if (reached < out.size()) {
        throw Error("the mesh has parts that are not joined: " + std::to_string(reached) +
                    " of its " + std::to_string(out.size()) +
                    " triangles hang together; make a gem of each part");
    }
    return out;
}

}  // namespace

Stone Stone::from_mesh(std::span<const Vec3> given, std::span<const Triangle> triangles) {
    if (triangles.empty()) throw Error("a stone needs facets: the mesh has no triangles");
    Vec3 low = given[0], high = given[0];
    for (const Vec3& p : given) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double size = length(high - low);
    const Surface mesh = welded(given, triangles, apart * size);
    if (mesh.triangles.empty()) throw Error("a stone needs facets: the mesh is a single point");
    const std::vector<Vec3>& points = mesh.points;
    const std::vector<Triangle> surface = oriented(points, mesh.triangles);
    Stone stone = from_points(points);

    // A convex mesh is its own hull: no triangle lies below it, and it goes round once.
    double deepest = 0, volume = 0;
    Vec3 where;
    const auto look_at = [&](const Vec3& p) {
        double depth = size;
        for (const Facet& f : stone.facets) depth = std::min(depth, f.distance - dot(f.normal, p));
        if (depth <= deepest) return;
        deepest = depth;
        where = p;
    };
    for (const auto& [a, b, c] : surface) {
        look_at((points[a] + points[b] + points[c]) / 3);
        volume += dot(points[a] - low, cross(points[b] - low, points[c] - low)) / 6;
    }
    if (deepest > dent * size) {
        throw Error("the mesh is not convex: at " + written(where) + " it lies " +
                    std::to_string(deepest) +
                    " below the surface of a convex stone; cut it into convex parts");
    }
    if (!(std::abs(std::abs(volume) - stone.volume) <= bulge * stone.volume)) {
        throw Error("the mesh is not one convex surface: it encloses a volume of " +
                    std::to_string(std::abs(volume)) + ", and its hull " +
                    std::to_string(stone.volume));
    }
    return stone;
}

}  // namespace icespar
