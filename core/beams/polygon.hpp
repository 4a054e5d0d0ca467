// Convex polygons in the picture plane: area, centroid, and cutting by half-planes.
#pragma once

#include <span>
#include <vector>

namespace icespar {

struct Point2 {
    double x = 0, y = 0;
    friend Point2 operator+(const Point2& a, const Point2& b) { return {a.x + b.x, a.y + b.y}; }
    friend Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
    friend bool operator==(const Point2&, const Point2&) = default;
    friend Point2 operator*(double f, const Point2& p) { return {f * p.x, f * p.y}; }
};

/// Corners in counter-clockwise order (x right, y up), or clockwise with a negative area.
using Polygon = std::vector<Point2>;
using PolygonView = std::span<const Point2>;

/// A number that varies linearly over the plane.
struct Affine {
    double value = 0, dx = 0, dy = 0;  ///< at the origin; per unit of x and y
    [[nodiscard]] double operator()(const Point2& p) const { return value + dx * p.x + dy * p.y; }
    friend Affine operator-(const Affine& a, const Affine& b) {
        return {a.value - b.value, a.dx - b.dx, a.dy - b.dy};
    }
};

struct Extent {
    double area = 0;
    Point2 centroid;  ///< a corner where the area is 0
};

[[nodiscard]] Extent extent(PolygonView polygon);

/// Mean squares over the area.
struct Moments {
    double xx = 0, xy = 0, yy = 0;
    /// Of a number that varies linearly: its variance.
    [[nodiscard]] double variance(double dx, double dy) const {
        return dx * dx * xx + 2 * dx * dy * xy + dy * dy * yy;
    }
};

/// About the centroid.
[[nodiscard]] Moments moments(PolygonView polygon, const Extent& extent);

/// Sets `out` to the part of the polygon where f >= 0, empty when there is none. Two functions of
/// opposite sign cut along the same points, so that the parts sum to the whole. `out` must be
/// another polygon.
void clip(PolygonView polygon, const Affine& f, Polygon& out);

/// Both parts at once: where f >= 0, and where f <= 0.
void split(PolygonView polygon, const Affine& f, Polygon& above, Polygon& below);

/// The point of a polygon that belongs to (u, v) of the unit square, areas being kept: uniform
/// numbers give uniform points.
[[nodiscard]] Point2 point_in(PolygonView polygon, double u, double v);

}  // namespace icespar
