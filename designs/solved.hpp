// A design with its finished stone: which corners each of its planes has.
#pragma once

#include "designs/design.hpp"

namespace icespar {

struct SolvedDesign {
    std::vector<FacetPlane> planes;
    Stone stone;
    std::vector<int> facet_of;  ///< of each plane: its facet of the stone, or -1

    /// Throws Error when the design's facets enclose no stone.
    explicit SolvedDesign(const Design& design);

    /// Corners of a plane's facet, counter-clockwise from outside; none when it is not on the
    /// stone, or an earlier plane is the same facet.
    [[nodiscard]] std::vector<Vec3> polygon(std::size_t plane) const;
};

}  // namespace icespar
