// The edge of a lamp cuts small polygons along a straight line; large ones are halved first.
#include "render/lamp_edge.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {
namespace {

/// Half the sides of a box about the polygon, as angles.
Point2 sides(const Expansion& k, PolygonView polygon) {
    Point2 out;
    for (const Point2& p : polygon) {
        out.x = std::max(out.x, std::abs(p.x));
        out.y = std::max(out.y, std::abs(p.y));
    }
    return {out.x * length(k.dx), out.y * length(k.dy)};
}

}  // namespace

double spread(const Expansion& k, PolygonView polygon) {
    const Point2 box = sides(k, polygon);
    return box.x + box.y;
}

bool edge_is_straight(const Disc& disc, double spread) {
    constexpr double straight = 0.1;
    const double sine = std::sqrt(std::max(0.0, 1 - disc.cos_radius * disc.cos_radius));
    return spread <= straight * sine;
}

double halve(Expansion& k, PolygonView polygon, double side, Polygon& half) {
    const Point2 box = sides(k, polygon);
    clip(polygon, box.x > box.y ? Affine{0, side, 0} : Affine{0, 0, side}, half);
    const Extent e = extent(half);
    if (!(e.area > 0)) return 0;
    for (Point2& p : half) p = p - e.centroid;
    const Vec3 there = k.at(e.centroid);
    const double size = length(there);
    k = {there / size, k.dx / size, k.dy / size};
    return e.area;
}

double lit_area(const Disc& disc, const Expansion& k, PolygonView polygon, double area,
                int halvings) {
    const Point2 box = sides(k, polygon);
    const double reach = box.x + box.y;
    const double inside = dot(k.value, disc.direction) - disc.cos_radius;
    if (inside <= -reach) return 0;
    if (inside >= reach) return area;
    Polygon piece;
    if (!edge_is_straight(disc, reach) && halvings > 0) {
        double sum = 0;
        for (const double side : {-1.0, 1.0}) {
            Expansion there = k;
            const double half = halve(there, polygon, side, piece);
            if (half > 0) sum += lit_area(disc, there, piece, half, halvings - 1);
        }
        return sum;
    }
    // k has unit length only in the middle: the mean of its second-order part over the polygon.
    const double longer = (box.x * box.x + box.y * box.y) / 6;
    clip(polygon,
         {inside - longer * disc.cos_radius, dot(k.dx, disc.direction), dot(k.dy, disc.direction)},
         piece);
    return extent(piece).area;
}

}  // namespace icespar
