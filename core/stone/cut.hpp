// What a faceting diagram says, turned into planes.
#pragma once

#include <string>

#include "stone/stone.hpp"

namespace icespar {

/// The plane of one facet in GemCad's right-handed frame, table up along z. `angle` in degrees from
/// the dop axis (0 = table, 90 = girdle), negative on the pavilion; azimuth 360 (index - offset) /
/// gear (a negative gear turns the other way); distance from the stone's centre. An angle of 0 with
/// a negative distance is a culet: it faces down.
[[nodiscard]] FacetPlane cut_plane(double angle, double distance, double index, double gear,
                                   double offset, bool pavilion, std::string name);

}  // namespace icespar
