// Stones to test with, and what must be true of every closed convex polyhedron.
#pragma once

#include <string>
#include <vector>

#include "stone/stone.hpp"
#include "support/interface_cases.hpp"

namespace icespar::testing {

/// Empty, or what is wrong: Euler's formula, edges that do not join two facets, corners clockwise
/// or off their planes, vertices outside a plane, vector areas that do not cancel, a volume that is
/// not that of the pyramids over the facets. Lengths are compared with the stone's size and
/// distance from the origin.
[[nodiscard]] std::string fault_of(const Stone& stone);

/// The planes of a box between two corners, in the order -x +x -y +y -z +z.
[[nodiscard]] std::vector<FacetPlane> box_planes(const Vec3& low, const Vec3& high);

/// Corners of the five regular solids, with edge 2 where nothing else is said.
[[nodiscard]] std::vector<Vec3> tetrahedron();  ///< edge 2 sqrt 2
[[nodiscard]] std::vector<Vec3> cube();
[[nodiscard]] std::vector<Vec3> octahedron();  ///< edge sqrt 2
[[nodiscard]] std::vector<Vec3> dodecahedron();
[[nodiscard]] std::vector<Vec3> icosahedron();

/// Planes that touch the unit ball, or miss it by up to `spread`.
[[nodiscard]] std::vector<FacetPlane> random_planes(Random& random, int count, double spread);

}  // namespace icespar::testing
