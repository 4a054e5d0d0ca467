// One pass over the planes for the exit, one over its neighbours for edges, several at a time.
#include "beams/facet_search.hpp"

#include <algorithm>
#include <experimental/simd>
#include <limits>
#include <map>

namespace icespar {
namespace {

namespace simd = std::experimental;
using Lanes = simd::native_simd<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

Lanes lanes(const std::vector<double>& v, std::size_t i) {
    return Lanes(v.data() + i, simd::element_aligned);
}

}  // namespace

std::vector<std::vector<int>> neighbours(const Stone& stone) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<int>> edges;
    for (std::size_t i = 0; i < stone.facets.size(); ++i) {
        const auto& corners = stone.facets[i].corners;
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const std::uint32_t a = corners[c], b = corners[(c + 1) % corners.size()];
            edges[{std::min(a, b), std::max(a, b)}].push_back(static_cast<int>(i));
        }
    }
    std::vector<std::vector<int>> out(stone.facets.size());
    for (const auto& [ends, facets] : edges) {
        for (const int i : facets) {
            for (const int j : facets) {
                if (j != i) out[static_cast<std::size_t>(i)].push_back(j);
            }
        }
    }
    return out;
}

void FacetSearch::Planes::add(const Vec3& normal, double d) {
    x.push_back(normal.x);
    y.push_back(normal.y);
    z.push_back(normal.z);
    distance.push_back(d);
}

void FacetSearch::Planes::pad(std::size_t multiple) {
    while (x.size() % multiple != 0) add({}, infinity);
}

FacetSearch::FacetSearch(const Stone& stone) : facets_(static_cast<int>(stone.facets.size())) {
    for (const Vec3& v : stone.vertices) centre_ += v;
    centre_ = centre_ / static_cast<double>(stone.vertices.size());
    for (const Facet& f : stone.facets) {
        // From a corner, whose difference to the centre is exact enough wherever the stone stands.
        const Vec3& corner = stone.vertices[f.corners[0]];
        planes_.add(f.normal, dot(f.normal, corner - centre_));
    }
    for (const std::vector<int>& around : neighbours(stone)) {
        first_around_.push_back(around_.x.size());
        for (const int facet : around) around_.add(normal(facet), distance(facet));
        neighbours_.insert(neighbours_.end(), around.begin(), around.end());
        around_.pad(Lanes::size());
        neighbours_.resize(around_.x.size(), -1);
    }
    first_around_.push_back(around_.x.size());
    planes_.pad(2 * Lanes::size());
}

int FacetSearch::exit(const Vec3& o, const Vec3& d, int left, double& t) const {
    const Lanes ox = o.x, oy = o.y, oz = o.z, dx = d.x, dy = d.y, dz = d.z;
    const Lanes own = static_cast<double>(left);
    Lanes number([](auto i) { return static_cast<double>(i); });
    const auto look = [&](std::size_t i, Lanes& best, Lanes& place) {
        const Lanes nx = lanes(planes_.x, i), ny = lanes(planes_.y, i), nz = lanes(planes_.z, i);
        const Lanes ahead = nx * dx + ny * dy + nz * dz;
        const Lanes there = (lanes(planes_.distance, i) - (nx * ox + ny * oy + nz * oz)) / ahead;
        const auto nearer = there < best && (ahead > 0 && number != own);
        simd::where(nearer, best) = there;
        simd::where(nearer, place) = number;
        number += static_cast<double>(Lanes::size());
    };
    // Two runs side by side, so that no comparison waits for the one before.
    Lanes best = infinity, place = -1.0, best_odd = infinity, place_odd = -1.0;
    for (std::size_t i = 0; i < planes_.x.size(); i += 2 * Lanes::size()) {
        look(i, best, place);
        look(i + Lanes::size(), best_odd, place_odd);
    }
    simd::where(best_odd < best, place) = place_odd;
    best = simd::min(best, best_odd);
    t = simd::hmin(best);
    if (!(t < infinity)) return -1;
    const auto lane = static_cast<std::size_t>(simd::find_first_set(best == Lanes(t)));
    return static_cast<int>(place[lane]);
}

void FacetSearch::crossed(int facet, const Expansion& point, PolygonView polygon,
                          std::vector<Edge>& edges) const {
    edges.clear();
    const auto f = static_cast<std::size_t>(facet);
    for (std::size_t i = first_around_[f]; i < first_around_[f + 1]; i += Lanes::size()) {
        const Lanes nx = lanes(around_.x, i), ny = lanes(around_.y, i), nz = lanes(around_.z, i);
        const auto rise = [&](const Vec3& v) { return nx * v.x + ny * v.y + nz * v.z; };
        const Lanes value = lanes(around_.distance, i) - rise(point.value);
        const Lanes dx = -rise(point.dx), dy = -rise(point.dy);
        Lanes least = 0;
        for (const Point2& p : polygon) least = simd::min(least, value + dx * p.x + dy * p.y);
        if (simd::all_of(least == 0)) continue;
        for (std::size_t lane = 0; lane < Lanes::size(); ++lane) {
            if (least[lane] < 0) {
                edges.push_back({neighbours_[i + lane], {value[lane], dx[lane], dy[lane]}});
            }
        }
    }
}

}  // namespace icespar
