// A cut stone: a convex polyhedron, and how light finds its way to the next facet.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "math/transform.hpp"
#include "math/vec3.hpp"

namespace icespar {

/// The half-space normal . p <= distance. The normal points out of the stone and need not be a unit
/// vector when a stone is built from it.
struct FacetPlane {
    Vec3 normal;
    double distance = 0;
    std::string name{};
};

/// A facet of a finished stone: unit normal, and the polygon of its corners, counter-clockwise as
/// seen from outside (in right-handed coordinates).
struct Facet {
    Vec3 normal;
    double distance = 0;
    std::string name;
    std::vector<std::uint32_t> corners;  ///< indices into Stone::vertices
    double area = 0;
};

/// A closed convex polyhedron. Facets are ordered as the planes they came from, planes that
/// coincide being one facet (with the first's name).
struct Stone {
    std::vector<Facet> facets;
    std::vector<Vec3> vertices;
    double volume = 0;
    std::vector<std::string>
        unreached;  ///< names (or "facet 7") of planes that do not touch the stone

    /// Exact arithmetic on the doubles given. Planes whose unit normals differ by up to 1e-9, and
    /// whose distances from within the stone by up to 1e-9 of themselves, coincide. Facets narrower
    /// than 1e-7 of the stone (area over longest diagonal) come from rounding in design files:
    /// their planes are left out as unreached, unless that would change the volume by 1e-6. Edges
    /// may be as short as rounding. Throws Error when a number is not finite, a normal is 0, the
    /// half-spaces have no common interior (which: named), or the stone is not closed (the message
    /// names directions that are open).
    static Stone from_planes(std::span<const FacetPlane> planes);

    /// The convex hull of the points. Neighbouring triangles that lie in one plane to within 1e-6
    /// of the hull's size are one facet, whose plane touches the points from outside. Facets are
    /// ordered by the numbers of their corners in `points`, and have no names. Throws Error when a
    /// number is not finite or all points lie in one plane.
    static Stone from_points(std::span<const Vec3> points);

    /// The hull of a closed convex mesh, whose triangles may go round either way. Throws Error as
    /// from_points does, and when an edge does not join two triangles, or the mesh is dented by
    /// more than numbers with six decimals explain: the message says where.
    static Stone from_mesh(std::span<const Vec3> points,
                           std::span<const std::array<std::uint32_t, 3>> triangles);

    /// The stone moved by t. A mirroring transform keeps corners counter-clockwise.
    [[nodiscard]] Stone transformed(const Transform& t) const;
};

/// Sizes as a faceting diagram states them: the outline seen along the dop axis (z), measured along
/// the diagram's axes x and y. W is the lesser extent, L the greater, H the extent along z.
struct GirdleSize {
    double length = 0, width = 0, height = 0;
};
[[nodiscard]] GirdleSize girdle_size(const Stone& stone);

/// Where two stones overlap by more than they merely touch: true, and a point within both.
[[nodiscard]] bool overlap(const Stone& a, const Stone& b, Vec3& where);

}  // namespace icespar
