// Greedy joining of neighbouring triangles into flat faces.
#include "stone/coplanar.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace icespar {
namespace {

struct Face {
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> corners;  // sorted, each once
    std::set<std::uint32_t> neighbours;
    Vec3 area;  // vector area: the area-weighted normal
    double sum_of_areas = 0;
    int version = 0;  // grows at each joining, so that older offers are known to be stale
};

/// An offer to join two faces; the flattest comes first, ties by number.
struct Offer {
    double deviation;
    std::uint32_t a, b;
    int version_a, version_b;
    friend bool operator<(const Offer& l, const Offer& r) {
        return std::tie(l.deviation, l.a, l.b) > std::tie(r.deviation, r.a, r.b);
    }
};

std::vector<std::uint32_t> merged(const std::vector<std::uint32_t>& a,
                                  const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> out;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
    return out;
}

/// Half the thickness of the joined face along its area-weighted normal; negative when the two
/// faces look apart so far that they are no face together.
double deviation_of(std::span<const Vec3> points, const Face& a, const Face& b) {
    const Vec3 sum = a.area + b.area;
    const double size = length(sum);
    if (!(size >= 0.9 * (a.sum_of_areas + b.sum_of_areas))) return -1;
    const Vec3 n = size > 0 ? sum / size : Vec3{};
    double low = 0, high = 0;
    const Vec3& origin = points[a.corners.front()];
    for (const Face* face : {&a, &b}) {
        for (const std::uint32_t corner : face->corners) {
            const double height = dot(n, points[corner] - origin);
            low = std::min(low, height);
            high = std::max(high, height);
        }
    }
    return (high - low) / 2;
}

std::vector<Face> single_triangles(std::span<const Vec3> points,
                                   std::span<const Triangle> triangles) {
    std::vector<Face> faces(triangles.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owner_of_edge;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        faces[i].triangles = {i};
        faces[i].corners.assign(t.begin(), t.end());
        std::sort(faces[i].corners.begin(), faces[i].corners.end());
        faces[i].area = vector_area(points, t);
        faces[i].sum_of_areas = length(faces[i].area);
        for (std::size_t k = 0; k < 3; ++k) owner_of_edge[{t[k], t[(k + 1) % 3]}] = i;
    }
    for (const auto& [edge, face] : owner_of_edge) {
        const auto other = owner_of_edge.find({edge.second, edge.first});
        if (other != owner_of_edge.end()) faces[face].neighbours.insert(other->second);
    }
    return faces;
}

}  // namespace

Vec3 vector_area(std::span<const Vec3> points, const Triangle& t) {
    const Vec3& a = points[t[0]];
    return 0.5 * cross(points[t[1]] - a, points[t[2]] - a);
}

std::vector<std::vector<std::uint32_t>> coplanar_faces(std::span<const Vec3> points,
                                                       std::span<const Triangle> triangles,
                                                       double tolerance) {
    std::vector<Face> faces = single_triangles(points, triangles);
    std::priority_queue<Offer> offers;
    const auto offer = [&](std::uint32_t a, std::uint32_t b) {
        const double deviation = deviation_of(points, faces[a], faces[b]);
        if (deviation >= 0 && deviation <= tolerance) {
            offers.push({deviation, a, b, faces[a].version, faces[b].version});
        }
    };
    for (std::uint32_t a = 0; a < faces.size(); ++a) {
        for (const std::uint32_t b : faces[a].neighbours) {
            if (a < b) offer(a, b);
        }
    }

    while (!offers.empty()) {
        const Offer best = offers.top();
        offers.pop();
        Face& a = faces[best.a];
        Face& b = faces[best.b];
        if (a.version != best.version_a || b.version != best.version_b) continue;

        a.triangles = merged(a.triangles, b.triangles);
        a.corners = merged(a.corners, b.corners);
        a.area += b.area;
        a.sum_of_areas += b.sum_of_areas;
        ++a.version;
        for (const std::uint32_t other : b.neighbours) {
            faces[other].neighbours.erase(best.b);
            if (other == best.a) continue;
            faces[other].neighbours.insert(best.a);
            a.neighbours.insert(other);
        }
        b = Face{};
        b.version = -1;
        for (const std::uint32_t other : a.neighbours) {
            offer(std::min(best.a, other), std::max(best.a, other));
        }
    }

    std::vector<std::vector<std::uint32_t>> out;
    for (Face& face : faces) {
        if (!face.triangles.empty()) out.push_back(std::move(face.triangles));
    }
    return out;
}

}  // namespace icespar
