// Strips are those of the hue that varies most.
#include "views/shading.hpp"

#include <cmath>

#include "views/transmission.hpp"

namespace icespar {

void shade(PolygonView polygon, std::span<const Affine> depths,
           const std::vector<std::vector<double>>& shares, std::span<const double> sum,
           Raster& raster) {
    std::size_t lead = 0;
    double widest = 0;
    for (std::size_t h = 0; h < depths.size(); ++h) {
        const auto [low, high] = range_of(polygon, depths[h]);
        if (high - low <= widest) continue;
        widest = high - low;
        lead = h;
    }
    if (widest < even_depth) return raster.add(polygon, sum);
    std::vector<double> wholes, values;
    for (const Affine& depth : depths) wholes.push_back(mean_transmission(polygon, depth));
    each_strip(polygon, depths[lead], [&](PolygonView strip, const Affine&) {
        const Point2 centre = extent(strip).centroid;
        double light = 0, dx = 0, dy = 0;
        values.assign(sum.size(), 0.0);
        for (std::size_t h = 0; h < depths.size(); ++h) {
            if (!(wholes[h] > 0)) continue;
            const double passed = mean_transmission(strip, depths[h]) / wholes[h];
            double weight = 1e-300;
            for (std::size_t v = 0; v < values.size(); ++v) {
                values[v] += passed * shares[h][v];
                weight += passed * std::abs(shares[h][v]);
            }
            light += weight;
            dx += weight * depths[h].dx;
            dy += weight * depths[h].dy;
        }
        dx /= light;
        dy /= light;
        raster.add(strip, values, {1 + dx * centre.x + dy * centre.y, -dx, -dy});
    });
}

}  // namespace icespar
