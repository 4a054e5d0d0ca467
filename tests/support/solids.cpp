// Stones to test with, and the laws of closed convex polyhedra.
#include "support/solids.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace icespar::testing {
namespace {

/// All signs of (a, b, c) and of its cyclic shifts.
std::vector<Vec3> cyclic(double a, double b, double c) {
    std::vector<Vec3> points;
    for (const double i : {-1.0, 1.0}) {
        for (const double j : {-1.0, 1.0}) {
            const Vec3 p{a, i * b, j * c};
            points.insert(points.end(), {p, {p.z, p.x, p.y}, {p.y, p.z, p.x}});
        }
    }
    return points;
}

}  // namespace

std::string fault_of(const Stone& stone) {
    Vec3 centre;
    for (const Vec3& v : stone.vertices) centre += v / static_cast<double>(stone.vertices.size());
    double size = 0;
    for (const Vec3& v : stone.vertices) size = std::max(size, length(v - centre));
    const double rounding = 1e-15 * (10 * size + 4 * length(centre));

    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    Vec3 sum_of_areas;
    double total_area = 0, volume = 0;
    for (std::size_t i = 0; i < stone.facets.size(); ++i) {
        const Facet& facet = stone.facets[i];
        const std::string where = " at facet " + std::to_string(i);
        if (std::abs(length(facet.normal) - 1) > 1e-15)
            return "normal is not a unit vector" + where;
        const auto& c = facet.corners;
        if (c.size() < 3) return "fewer than three corners" + where;
        Vec3 twice_area;
        for (std::size_t k = 0; k < c.size(); ++k) {
            const Vec3& p = stone.vertices.at(c[k]);
            if (std::abs(dot(facet.normal, p) - facet.distance) > rounding) {
                return "corner off its plane" + where;
            }
            ++edges[{c[k], c[(k + 1) % c.size()]}];
            twice_area +=
                cross(p - stone.vertices[c[0]], stone.vertices[c[(k + 1) % c.size()]] - p);
        }
        if (std::abs(dot(facet.normal, twice_area) / 2 - facet.area) > 10 * size * rounding) {
            return "area or sense of the corners" + where;
        }
        for (const Vec3& v : stone.vertices) {
            if (dot(facet.normal, v) - facet.distance > rounding) return "vertex outside" + where;
        }
        sum_of_areas += facet.area * facet.normal;
        total_area += facet.area;
        volume += facet.area * (facet.distance - dot(facet.normal, centre)) / 3;
    }
    for (const auto& [edge, count] : edges) {
        if (count != 1 || !edges.contains({edge.second, edge.first})) {
            return "an edge does not join two facets";
        }
    }
    if (stone.vertices.size() + stone.facets.size() != edges.size() / 2 + 2)
        return "Euler's formula";
    if (length(sum_of_areas) > 1e-14 * total_area) return "vector areas do not cancel";
    if (std::abs(volume - stone.volume) > total_area * rounding) return "volume";
    return {};
}

std::vector<FacetPlane> box_planes(const Vec3& low, const Vec3& high) {
    return {{{-1, 0, 0}, -low.x, "-x"}, {{1, 0, 0}, high.x, "+x"},  {{0, -1, 0}, -low.y, "-y"},
            {{0, 1, 0}, high.y, "+y"},  {{0, 0, -1}, -low.z, "-z"}, {{0, 0, 1}, high.z, "+z"}};
}

std::vector<Vec3> tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

std::vector<Vec3> cube() {
    std::vector<Vec3> points;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) points.insert(points.end(), {{x, y, -1}, {x, y, 1}});
    }
    return points;
}

std::vector<Vec3> octahedron() {
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

std::vector<Vec3> dodecahedron() {
    // Cube of half edge phi plus three rectangles: edge 2.
    std::vector<Vec3> points = cyclic(0, 1, std::numbers::phi * std::numbers::phi);
    for (const Vec3& p : cube()) points.push_back(std::numbers::phi * p);
    return points;
}

std::vector<Vec3> icosahedron() { return cyclic(0, 1, std::numbers::phi); }

std::vector<FacetPlane> random_planes(Random& random, int count, double spread) {
    std::vector<FacetPlane> planes;
    for (int i = 0; i < count; ++i) {
        planes.push_back({random.direction(), random.uniform(1, 1 + spread), std::to_string(i)});
    }
    return planes;
}

}  // namespace icespar::testing
