// Sharing out samples.
#include "render/effort.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace icespar {

double relative_error(const std::vector<double>& variances, double mean_luminance,
                      ErrorMetric metric) {
    if (variances.empty() || !(mean_luminance > 0)) return 0;
    const double variance = metric == ErrorMetric::largest
                                ? *std::max_element(variances.begin(), variances.end())
                                : std::accumulate(variances.begin(), variances.end(), 0.0) /
                                      static_cast<double>(variances.size());
    return std::sqrt(variance) / mean_luminance;
}

std::vector<int> unfinished(const Tiles& tiles, const std::vector<double>& variances,
                            double mean_luminance, const std::vector<int>& done, double error,
                            ErrorMetric metric) {
    const double allowed = error * error * mean_luminance * mean_luminance;
    struct Tile {
        double variance = 0, largest = 0, deviation = 0;
    };
    std::vector<Tile> found(done.size());
    double squares = 0;
    for (std::size_t t = 0; t < done.size(); ++t) {
        Tile& tile = found[t];
        tiles.visit(static_cast<int>(t), [&](int x, int y) {
            const double v =
                variances[static_cast<std::size_t>(y) * static_cast<std::size_t>(tiles.width) +
                          static_cast<std::size_t>(x)];
            tile.variance += v;
            tile.largest = std::max(tile.largest, v);
            return true;
        });
        // Of one sample.
        tile.deviation = std::sqrt(tile.variance / tiles.pixels(static_cast<int>(t)) * done[t]);
        squares += tile.variance * done[t];
    }
    // A tile that seems calm may not have seen its lamp yet: it does a quarter of the work.
    const double least = 0.25 * std::sqrt(squares / static_cast<double>(variances.size()));
    double sum = 0;
    for (std::size_t t = 0; t < done.size(); ++t) {
        found[t].deviation = std::max(found[t].deviation, least);
        sum += tiles.pixels(static_cast<int>(t)) * found[t].deviation;
    }
    const double samples_per_deviation = sum / (static_cast<double>(variances.size()) * allowed);
    std::vector<int> out;
    for (std::size_t t = 0; t < done.size(); ++t) {
        const bool enough = metric == ErrorMetric::largest
                                ? found[t].largest <= allowed
                                : done[t] >= found[t].deviation * samples_per_deviation;
        if (!enough) out.push_back(static_cast<int>(t));
    }
    return out;
}

}  // namespace icespar
