// Cells are cut by the lines where two facets are equally far, which neighbours share exactly.
#include "views/facet_cells.hpp"

#include <algorithm>

namespace icespar {

FacetCells::FacetCells(const Stone& stone)
    : facets_(stone),
      neighbours_(neighbours(stone)),
      distances_(stone.facets.size()),
      known_(stone.facets.size()),
      asked_(stone.facets.size()) {}

const Affine& FacetCells::distance(int facet, const BeamPlace& place, const Vec3& flow) {
    const auto i = static_cast<std::size_t>(facet);
    if (known_[i] != call_) {
        known_[i] = call_;
        const Vec3 n = facets_.normal(facet);
        const double slowness = 1 / dot(n, flow);
        distances_[i] = {(facets_.distance(facet) - dot(n, place.origin)) * slowness,
                         -dot(n, place.along_x) * slowness, -dot(n, place.along_y) * slowness};
    }
    return distances_[i];
}

std::span<const FacetCells::Piece> FacetCells::divide(const BeamPlace& place, const Vec3& flow,
                                                      int left, PolygonView polygon,
                                                      const Point2& inside) {
    ++call_;
    count_ = 0;
    double t = 0;
    const int first = facets_.exit(place.at(inside), flow, left, t);
    if (first < 0) return {};
    waiting_.assign(1, first);
    asked_[static_cast<std::size_t>(first)] = call_;
    while (!waiting_.empty()) {
        const int facet = waiting_.back();
        waiting_.pop_back();
        if (count_ == pieces_.size()) pieces_.emplace_back();
        Piece& piece = pieces_[count_];
        piece.polygon.assign(polygon.begin(), polygon.end());
        beyond_.clear();
        const Affine here = distance(facet, place, flow);
        for (const int other : neighbours_[static_cast<std::size_t>(facet)]) {
            // Behind, or all but parallel: it is never the nearest.
            if (other == left || !(dot(facets_.normal(other), flow) > 0)) continue;
            const Affine nearer = distance(other, place, flow) - here;
            double least = 0;
            for (const Point2& p : piece.polygon) least = std::min(least, nearer(p));
            if (!(least < 0)) continue;
            beyond_.push_back(other);
            clip(piece.polygon, nearer, swap_);
            piece.polygon.swap(swap_);
            if (piece.polygon.size() < 3) break;
        }
        if (piece.polygon.size() < 3) continue;
        piece.facet = facet;
        piece.distance = here;
        ++count_;
        for (const int other : beyond_) {
            unsigned& asked = asked_[static_cast<std::size_t>(other)];
            if (asked == call_) continue;
            asked = call_;
            waiting_.push_back(other);
        }
    }
    return {pieces_.data(), count_};
}

}  // namespace icespar
