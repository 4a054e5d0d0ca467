// How much light passes through what absorbs along paths of different lengths.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "beams/polygon.hpp"

namespace icespar {

/// The mean of exp(-depth) over a convex polygon with an area, in closed form.
[[nodiscard]] double mean_transmission(PolygonView polygon, const Affine& depth);

/// Least and greatest depth of a polygon.
[[nodiscard]] inline std::pair<double, double> range_of(PolygonView polygon, const Affine& depth) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point2& p : polygon) {
        low = std::min(low, depth(p));
        high = std::max(high, depth(p));
    }
    return {low, high};
}

/// Depths that vary by less pass light evenly.
inline constexpr double even_depth = 0.01;

/// Calls visit(strip, transmission) for strips of a convex polygon, whichever way it goes round, in
/// which exp(-depth) is linear to four thousandths of itself; the mean over each is exact. Where it
/// varies by less than a hundredth it is constant.
template <class Visit>
void each_strip(PolygonView polygon, const Affine& depth, Visit&& visit) {
    constexpr double step = 0.12, dark = 40;
    const auto [low, high] = range_of(polygon, depth);
    if (extent(polygon).area == 0) return;
    if (high - low < even_depth) return visit(polygon, {mean_transmission(polygon, depth), 0, 0});
    const double strips = std::ceil((high - low) / step), width = (high - low) / strips;
    Polygon above, strip;
    for (double i = 0; i < strips && i * width < dark; ++i) {
        const double from = low + i * width;
        clip(polygon, {depth.value - from, depth.dx, depth.dy}, above);
        clip(above, {from + width - depth.value, -depth.dx, -depth.dy}, strip);
        const Extent e = extent(strip);
        if (e.area == 0) continue;
        // To first order about the centroid, where depth is its mean.
        const double mean = mean_transmission(strip, depth), middle = depth(e.centroid);
        visit(PolygonView(strip),
              {mean * (1 + middle - depth.value), -mean * depth.dx, -mean * depth.dy});
    }
}

}  // namespace icespar
