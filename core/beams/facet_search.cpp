// One pass over the planes for the exit, one for what else is near it, several planes at a time.
#include "beams/facet_search.hpp"

#include <experimental/simd>
#include <limits>

namespace icespar {
namespace {

namespace simd = std::experimental;
using Lanes = simd::native_simd<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

Lanes lanes(const std::vector<double>& v, std::size_t i) {
    return Lanes(v.data() + i, simd::element_aligned);
}

}  // namespace

FacetSearch::FacetSearch(const Stone& stone) : facets_(static_cast<int>(stone.facets.size())) {
    for (const Vec3& v : stone.vertices) centre_ += v;
    centre_ = centre_ / static_cast<double>(stone.vertices.size());
    for (const Facet& f : stone.facets) {
        nx_.push_back(f.normal.x);
        ny_.push_back(f.normal.y);
        nz_.push_back(f.normal.z);
        // From a corner, whose difference to the centre is exact enough wherever the stone stands.
        const Vec3& corner = stone.vertices[f.corners[0]];
        distance_.push_back(dot(f.normal, corner - centre_));
    }
    while (nx_.size() % Lanes::size() != 0) {
        for (auto* v : {&nx_, &ny_, &nz_}) v->push_back(0);
        distance_.push_back(infinity);
    }
}

FacetSearch::Scratch FacetSearch::scratch() const {
    return {std::vector<double>(nx_.size()), std::vector<double>(nx_.size()), {}};
}

int FacetSearch::exit(const Vec3& o, const Vec3& d, int left, double& t, Scratch& scratch) const {
    const Lanes ox = o.x, oy = o.y, oz = o.z, dx = d.x, dy = d.y, dz = d.z;
    Lanes best = infinity, place = -1.0;
    Lanes number([](auto i) { return static_cast<double>(i); });
    for (std::size_t i = 0; i < nx_.size(); i += Lanes::size()) {
        const Lanes nx = lanes(nx_, i), ny = lanes(ny_, i), nz = lanes(nz_, i);
        const Lanes ahead = nx * dx + ny * dy + nz * dz;
        const Lanes gap = lanes(distance_, i) - (nx * ox + ny * oy + nz * oz);
        ahead.copy_to(scratch.ahead.data() + i, simd::element_aligned);
        gap.copy_to(scratch.gap.data() + i, simd::element_aligned);
        const Lanes there = gap / ahead;
        const auto nearer = ahead > 0 && there < best && number != static_cast<double>(left);
        simd::where(nearer, best) = there;
        simd::where(nearer, place) = number;
        number += static_cast<double>(Lanes::size());
    }
    t = simd::hmin(best);
    if (!(t < infinity)) return -1;
    const auto lane = static_cast<std::size_t>(simd::find_first_set(best == Lanes(t)));
    return static_cast<int>(place[lane]);
}

void FacetSearch::near(int exit, int left, double t, double reach, Scratch& scratch) const {
    scratch.near.clear();
    const Lanes far = t, bound = reach;
    for (std::size_t i = 0; i < nx_.size(); i += Lanes::size()) {
        const auto within = lanes(scratch.gap, i) - far * lanes(scratch.ahead, i) < bound;
        if (simd::none_of(within)) continue;
        for (std::size_t lane = 0; lane < Lanes::size(); ++lane) {
            const int facet = static_cast<int>(i + lane);
            if (within[lane] && facet != exit && facet != left) scratch.near.push_back(facet);
        }
    }
}

}  // namespace icespar
