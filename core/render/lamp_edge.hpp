// How much of a leaf looks into a round lamp.
#pragma once

#include "beams/expansion.hpp"
#include "scene/scene.hpp"

namespace icespar {

/// The largest distance of a polygon's directions from the middle one.
[[nodiscard]] double spread(const Expansion& k, PolygonView polygon);

/// A lamp's edge is straight within a polygon whose directions spread no further.
[[nodiscard]] bool edge_is_straight(const Disc& disc, double spread);

/// One half of a polygon, which is cut through its centroid across its longer side: about its own
/// centroid, `k` with it. Its area, 0 when nothing is left.
double halve(Expansion& k, PolygonView polygon, double side, Polygon& half);

/// Area of the part of a polygon whose directions lie in a disc. `k`: unit vectors over the
/// polygon, whose centroid is the origin.
[[nodiscard]] double lit_area(const Disc& disc, const Expansion& k, PolygonView polygon,
                              double area, int halvings = 8);

}  // namespace icespar
