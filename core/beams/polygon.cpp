// Convex polygons: fans of triangles, and one pass per half-plane (Sutherland and Hodgman 1974).
#include "beams/polygon.hpp"

#include <cmath>

namespace icespar {
namespace {

double twice_area(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// Where a number is 0 on an edge at whose ends it has opposite signs: the same point whichever way
/// the edge is walked.
Point2 crossing(const Point2& from, const Point2& to, double at_from, double at_to) {
    const bool forwards = from.x < to.x || (from.x == to.x && from.y < to.y);
    const Point2 &a = forwards ? from : to, &b = forwards ? to : from;
    const double fa = forwards ? at_from : at_to, fb = forwards ? at_to : at_from;
    return a + (fa / (fa - fb)) * (b - a);
}

}  // namespace

Extent extent(PolygonView p) {
    if (p.empty()) return {};
    const Point2 origin = p[0];
    double sum = 0;
    Point2 moment;
    for (std::size_t i = 2; i < p.size(); ++i) {
        const Point2 a = p[i - 1] - origin, b = p[i] - origin;
        const double w = twice_area(a, b);
        sum += w;
        moment = moment + w * (a + b);
    }
    if (sum == 0) return {0, origin};
    return {0.5 * sum, origin + (1 / (3 * sum)) * moment};
}

Moments moments(PolygonView p, const Extent& e) {
    Moments sum;
    if (p.empty()) return sum;
    Point2 a = p.back() - e.centroid;
    for (const Point2& corner : p) {
        const Point2 b = corner - e.centroid;
        const double w = twice_area(a, b);
        sum.xx += w * (a.x * a.x + a.x * b.x + b.x * b.x);
        sum.yy += w * (a.y * a.y + a.y * b.y + b.y * b.y);
        sum.xy += w * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y);
        a = b;
    }
    return {sum.xx / (12 * e.area), sum.xy / (24 * e.area), sum.yy / (12 * e.area)};
}

void clip(PolygonView p, const Affine& f, Polygon& out) {
    out.clear();
    if (p.empty()) return;
    Point2 from = p.back();
    double before = f(from);
    for (const Point2& to : p) {
        const double now = f(to);
        if (before * now < 0) out.push_back(crossing(from, to, before, now));
        if (now >= 0) out.push_back(to);
        from = to;
        before = now;
    }
}

void split(PolygonView p, const Affine& f, Polygon& above, Polygon& below) {
    above.clear();
    below.clear();
    if (p.empty()) return;
    Point2 from = p.back();
    double before = f(from);
    for (const Point2& to : p) {
        const double now = f(to);
        if (before * now < 0) {
            const Point2 there = crossing(from, to, before, now);
            above.push_back(there);
            below.push_back(there);
        }
        if (now >= 0) above.push_back(to);
        if (now <= 0) below.push_back(to);
        from = to;
        before = now;
    }
}

Point2 point_in(PolygonView p, double u, double v) {
    // A triangle of the fan by its area, then a point in it.
    const Point2 origin = p[0];
    const double whole = 2 * extent(p).area;
    double wanted = u * whole, share = 0;
    std::size_t last = p.size() - 1;
    for (std::size_t i = 2; i < p.size(); ++i) {
        share = twice_area(p[i - 1] - origin, p[i] - origin);
        if (wanted < share || i == p.size() - 1) {
            last = i;
            break;
        }
        wanted -= share;
    }
    if (p.size() < 3) return origin;
    const double within = share > 0 ? std::fmin(1, std::fmax(0, wanted / share)) : 0.5;
    const double root = std::sqrt(within);
    return origin + root * ((1 - v) * (p[last - 1] - origin) + v * (p[last] - origin));
}

}  // namespace icespar
