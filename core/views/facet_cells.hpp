// The part of a beam that meets each facet: a parallel beam sees the facets ahead of it side by
// side, as a map of convex cells.
#pragma once

#include <cstddef>
#include <vector>

#include "beams/facet_search.hpp"
#include "beams/polygon.hpp"

namespace icespar {

/// Where the lines of a beam are at a facet they have just met: linear in picture coordinates.
struct BeamPlace {
    Vec3 origin, along_x, along_y;

    [[nodiscard]] Vec3 at(const Point2& p) const { return origin + p.x * along_x + p.y * along_y; }
    /// Further along `flow`, by a multiple of it that differs from line to line.
    [[nodiscard]] BeamPlace moved(const Affine& t, const Vec3& flow) const {
        return {origin + t.value * flow, along_x + t.dx * flow, along_y + t.dy * flow};
    }
};

class FacetCells {
public:
    explicit FacetCells(const Stone& stone);

    [[nodiscard]] const FacetSearch& facets() const { return facets_; }

    struct Piece {
        int facet = -1;
        Affine distance;  ///< to the facet, in multiples of `flow`
        Polygon polygon;
    };
    /// What of a beam meets which facet next: its cell in the map, which ends where another facet
    /// is nearer. Starts from the facet that the point `inside` of the polygon meets and goes on to
    /// those beyond the cell's edges. The pieces are valid until the next call.
    [[nodiscard]] std::span<const Piece> divide(const BeamPlace& place, const Vec3& flow, int left,
                                                PolygonView polygon, const Point2& inside);

private:
    [[nodiscard]] const Affine& distance(int facet, const BeamPlace& place, const Vec3& flow);

    FacetSearch facets_;
    std::vector<std::vector<int>> neighbours_;
    std::vector<Affine> distances_;
    std::vector<unsigned> known_, asked_;  ///< the call that set them
    unsigned call_ = 0;
    std::vector<int> waiting_, beyond_;
    std::vector<Piece> pieces_;
    std::size_t count_ = 0;
    Polygon swap_;
};

}  // namespace icespar
