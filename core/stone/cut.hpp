// What a faceting diagram says, turned into planes.
#pragma once

#include <string>
#include <vector>

#include "stone/stone.hpp"

namespace icespar {

/// The plane of one facet in GemCad's right-handed frame, table up along z. `angle` in degrees from
/// the dop axis (0 = table, 90 = girdle), negative on the pavilion; azimuth 360 (index - offset) /
/// gear (a negative gear turns the other way); distance from the stone's centre. An angle of 0 with
/// a negative distance is a culet: it faces down.
[[nodiscard]] FacetPlane cut_plane(double angle, double distance, double index, double gear,
                                   double offset, bool pavilion, std::string name);

/// A design as read from a file: planes in GemCad's frame, and what the file says about itself.
struct Design {
    std::vector<FacetPlane> planes;
    double gear = 96, gear_offset = 0;
    int symmetry = 1;
    bool mirror = false;
    double refractive_index = 0;  ///< 0 where the file does not say
    std::vector<std::string> headers, footnotes;
};

}  // namespace icespar
