// Stones from facet planes and from points: checks, facets that belong together, and what to say
// when there is no stone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "math/error.hpp"
#include "stone/polyhedron.hpp"

namespace icespar {
namespace {

/// Planes are the same when their unit normals, and their relative offsets, differ by no more.
constexpr double coincidence = 1e-9;
/// Thickness of a face of a hull, in units of the hull's size; points with six decimals have it.
constexpr double flatness = 1e-6;
/// A stone longer than this many of its inner radii is open, but for rounding.
constexpr double longest = 1e12;

std::string label(const std::string& name, std::size_t index) {
    return name.empty() ? "facet " + std::to_string(index + 1) : name;
}

/// "facet 7" or "facet 7 ('P1')".
std::string quoted(const FacetPlane& plane, std::size_t index) {
    std::string text = "facet " + std::to_string(index + 1);
    if (!plane.name.empty()) text += " ('" + plane.name + "')";
    return text;
}

/// "a, b and c".
std::string listed(const std::vector<std::string>& items) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
        text += items[i];
    }
    return text;
}

std::string written(const Vec3& v) {
    char text[80];
    // Adding 0 turns -0 into 0.
    const auto digits = [](double x) { return std::round(x * 1000) / 1000 + 0.0; };
    std::snprintf(text, sizeof text, "<%g, %g, %g>", digits(v.x), digits(v.y), digits(v.z));
    return text;
}

/// A few of the directions that differ.
std::string open_directions(const std::vector<Vec3>& open) {
    constexpr std::size_t most = 4;
    std::vector<std::string> names;
    for (const Vec3& direction : open) {
        const double largest =
            std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
        const std::string name = written(normalised(direction / largest));
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    if (names.size() > most) {
        const std::size_t more = names.size() - (most - 1);
        names.resize(most - 1);
        names.push_back(std::to_string(more) + " more directions");
    }
    return listed(names);
}

/// Beyond these, products of coordinates leave the range of double.
constexpr double largest_length = 1e30, largest_normal = 1e200;

void check_plane(const FacetPlane& plane, std::size_t index) {
    const bool finite = is_finite(plane.normal) && std::isfinite(plane.distance) &&
                        std::isfinite(std::hypot(plane.normal.x, plane.normal.y, plane.normal.z));
    if (!finite) {
        throw Error(quoted(plane, index) +
                    " has a number that is not finite: give its normal and distance as numbers");
    }
    if (plane.normal == Vec3{}) {
        throw Error(quoted(plane, index) +
                    " has the normal <0, 0, 0>: give the direction that it faces");
    }
    const double size = std::hypot(plane.normal.x, plane.normal.y, plane.normal.z);
    if (!(size > 1 / largest_normal && size < largest_normal) ||
        !(std::abs(plane.distance) < largest_length * size)) {
        throw Error(quoted(plane, index) + " is too large, too small or too far away (beyond " +
                    "1e30): scale the stone to ordinary sizes");
    }
}

/// The planes without later ones that coincide with earlier ones, by number. Offsets are compared
/// as seen from the centre, so that neither size nor place matters.
std::vector<std::size_t> distinct_planes(std::span<const FacetPlane> planes, const Vec3& centre) {
    struct Seen {
        Vec3 normal;
        double offset;
    };
    std::multimap<double, Seen> seen;  // by the normal's x
    std::vector<std::size_t> distinct;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Vec3& n = planes[i].normal;
        const double norm = std::hypot(n.x, n.y, n.z);
        const Seen plane{n / norm, planes[i].distance / norm - dot(n / norm, centre)};
        const auto first = seen.lower_bound(plane.normal.x - coincidence);
        const auto last = seen.upper_bound(plane.normal.x + coincidence);
        const bool known = std::any_of(first, last, [&](const auto& entry) {
            const Seen& other = entry.second;
            return length(other.normal - plane.normal) <= coincidence &&
                   std::abs(other.offset - plane.offset) <= coincidence * std::abs(other.offset);
        });
        if (known) continue;
        seen.emplace(plane.normal.x, plane);
        distinct.push_back(i);
    }
    return distinct;
}

/// The same as `inner_ball`, which takes long over many planes: the ball of a few of them, to which
/// those that cut into it are added until none does.
InnerBall inner_ball_of_many(std::span<const HalfSpace> planes) {
    constexpr std::size_t few = 256, more = 8;
    if (planes.size() <= few) return inner_ball(planes);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < few / 4; ++i) chosen.push_back(i * planes.size() / (few / 4));
    for (;;) {
        std::vector<HalfSpace> some;
        for (const std::size_t i : chosen) some.push_back(planes[i]);
        if (some.size() > planes.size() / 2) return inner_ball(planes);
        InnerBall ball = inner_ball(some);
        for (std::size_t& i : ball.touching) i = chosen[i];
        if (!(ball.radius > 0)) return ball;
        std::vector<double> depth(planes.size());
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const Vec3& n = planes[i].normal;
            depth[i] = ball.radius -
                       (planes[i].distance - dot(n, ball.centre)) / std::hypot(n.x, n.y, n.z);
        }
        std::vector<std::size_t> deepest(planes.size());
        std::iota(deepest.begin(), deepest.end(), std::size_t{0});
        std::partial_sort(deepest.begin(), deepest.begin() + more, deepest.end(),
                          [&](std::size_t a, std::size_t b) {
                              return std::tie(depth[b], a) < std::tie(depth[a], b);
                          });
        const double rounding = 1e-12 * (ball.radius + length(ball.centre));
        const std::size_t before = chosen.size();
        for (std::size_t k = 0; k < more; ++k) {
            const std::size_t i = deepest[k];
            const bool is_new = std::find(chosen.begin(), chosen.end(), i) == chosen.end();
            if (depth[i] > rounding && is_new) chosen.push_back(i);
        }
        if (chosen.size() == before) return ball;
    }
}

/// The mean of the hull's corners, each counted once.
Vec3 middle(std::span<const Vec3> points, std::span<const Triangle> triangles) {
    std::set<std::uint32_t> corners;
    for (const Triangle& t : triangles) corners.insert(t.begin(), t.end());
    const Vec3& origin = points[*corners.begin()];
    Vec3 sum;
    for (const std::uint32_t corner : corners) sum += points[corner] - origin;
    return origin + sum / static_cast<double>(corners.size());
}

std::vector<std::uint32_t> corners_of(std::span<const Triangle> triangles,
                                      const std::vector<std::uint32_t>& face) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t t : face) {
        corners.insert(corners.end(), triangles[t].begin(), triangles[t].end());
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// The area-weighted normal of a face, from its outer edges alone: how the hull cut a flat face
/// into triangles is of no account.
Vec3 face_normal(std::span<const Vec3> points, std::span<const Triangle> triangles,
                 const std::vector<std::uint32_t>& face) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> outer;
    for (const std::uint32_t t : face) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
            if (outer.erase({to, from}) == 0) outer.insert({from, to});
        }
    }
    const Vec3& origin = points[outer.begin()->first];
    Vec3 area;
    for (const auto& [from, to] : outer) area += cross(points[from] - origin, points[to] - origin);
    return area;
}

/// A lone triangle's plane is exact; a merged face touches the points from outside.
HalfSpace plane_of(std::span<const Vec3> points, std::span<const Triangle> triangles,
                   const std::vector<std::uint32_t>& face) {
    if (face.size() == 1) {
        const auto& [a, b, c] = triangles[face.front()];
        return {{}, 0, std::array{points[a], points[b], points[c]}};
    }
    const Vec3 normal = face_normal(points, triangles, face);
    double distance = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : points) distance = std::max(distance, dot(normal, p));
    return {normal, distance};
}

}  // namespace

Stone Stone::from_planes(std::span<const FacetPlane> planes) {
    if (planes.empty()) throw Error("a stone needs facets: give at least four planes");
    std::vector<HalfSpace> half_spaces;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        check_plane(planes[i], i);
        half_spaces.push_back({planes[i].normal, planes[i].distance});
    }

    const InnerBall ball = inner_ball_of_many(half_spaces);
    if (!(ball.radius > 0)) {
        std::vector<std::string> names;
        for (const std::size_t i : ball.touching) names.push_back(quoted(planes[i], i));
        throw Error("nothing is left of the stone: " + listed(names) +
                    " leave no room between them; check their distances and which way they face");
    }
    const std::vector<std::size_t> distinct = distinct_planes(planes, ball.centre);
    std::vector<HalfSpace> kept;
    for (const std::size_t i : distinct) kept.push_back(half_spaces[i]);
    Intersection found = intersection(kept, ball.centre);
    for (const Vec3& v : found.stone.vertices) {
        const Vec3 from_centre = v - ball.centre;
        if (length(from_centre) > longest * ball.radius) found.open.push_back(from_centre);
    }
    if (!found.open.empty()) {
        throw Error("the stone is not closed: it runs out towards " + open_directions(found.open) +
                    "; add facets that face that way");
    }

    Stone stone = std::move(found.stone);
    auto facet = stone.facets.begin();
    auto unreached = found.unreached.begin();
    for (std::size_t k = 0; k < distinct.size(); ++k) {
        const std::size_t i = distinct[k];
        if (unreached != found.unreached.end() && *unreached == k) {
            stone.unreached.push_back(label(planes[i].name, i));
            ++unreached;
        } else {
            (facet++)->name = planes[i].name;
        }
    }
    return stone;
}

Stone Stone::from_points(std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto in_range = [](double v) { return std::abs(v) < largest_length; };
        if (in_range(points[i].x) && in_range(points[i].y) && in_range(points[i].z)) continue;
        throw Error(
            "point " + std::to_string(i + 1) +
            " of the hull is not finite, or farther away than 1e30: give its coordinates as "
            "ordinary numbers");
    }
    const Error flat("the " + std::to_string(points.size()) +
                     " points lie in one plane: a hull needs at least four that do not");
    const std::vector<Triangle> triangles = hull_triangles(points);
    if (triangles.empty()) throw flat;

    const Vec3 centre = middle(points, triangles);
    double radius = 0;
    for (const Vec3& p : points) radius = std::max(radius, length(p - centre));
    const auto faces = coplanar_faces(points, triangles, flatness * 2 * radius);

    std::vector<std::pair<std::vector<std::uint32_t>, HalfSpace>> planes;
    for (const auto& face : faces) {
        planes.emplace_back(corners_of(triangles, face), plane_of(points, triangles, face));
    }
    // By the numbers of their corners: the order does not depend on how the hull was found.
    std::sort(planes.begin(), planes.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<HalfSpace> half_spaces;
    for (const auto& plane : planes) half_spaces.push_back(plane.second);
    Intersection found = intersection(half_spaces, centre);
    if (!found.open.empty()) throw flat;
    return std::move(found.stone);
}

}  // namespace icespar
