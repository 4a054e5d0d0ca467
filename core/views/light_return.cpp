// Sums over the exits of a view.
#include "views/light_return.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {

double DomeLight::radiance(const Vec3& direction) const {
    const double d = dot(direction, zenith);
    if (!(d > 0) || (head > 0 && d > std::cos(head))) return 0;
    switch (dome) {
        case Dome::iso:
            return 1;
        case Dome::cosine:
            return d;
        case Dome::sc2:
            return 2 * d * std::sqrt(std::max(0.0, 1 - d * d));
    }
    return 0;
}

LightReturn light_return(const Exits& exits, const DomeLight& light, std::optional<int> facet) {
    std::vector<double> sums(static_cast<std::size_t>(exits.groups) + 1);
    // Turns and mirrors about the line of sight do not change how high a beam stands above it.
    const Vec3 across = cross(light.zenith, exits.frame.direction);
    constexpr double rounding = 1e-15;
    double path = 0;  // the most that one of the sample carries
    const bool axial = length(across) <= rounding;
    for (std::size_t i = 0; i < exits.size(); ++i) {
        double radiance = light.radiance(exits.direction[i]), sum_of_images = 0;
        const auto entry = static_cast<std::size_t>(exits.entry[i]);
        bool counts = false;
        for (const PictureImage& image : exits.images) {
            if (facet && image.facets[entry] != *facet) continue;
            counts = true;
            if (!axial) radiance = light.radiance(image.of(exits.direction[i], exits.frame));
            sum_of_images += radiance;
        }
        const double seen = exits.area[i] * exits.weight[i].s0;
        sums[static_cast<std::size_t>(exits.group[i])] += seen * sum_of_images;
        if (counts && exits.group[i] > 0) path = std::max(path, seen);
    }
    double area = exits.area_total, untraced = exits.untraced;
    if (facet) {
        area = exits.entry_area[static_cast<std::size_t>(*facet)];
        untraced = exits.entry_untraced[static_cast<std::size_t>(*facet)];
    }
    if (!(area > 0)) return {};
    const Estimate estimate = estimate_of(sums);
    const double bound = light.greatest() * untraced / area,
                 residue = light.greatest() * exits.residue / area;
    // What was never met may be there once.
    const double error =
        std::hypot(estimate.error, path * static_cast<double>(exits.images.size())) / area;
    const double sampled = std::min(estimate.value - sums[0], light.greatest() * untraced);
    return {(sums[0] + sampled) / area, bound,
            exits.groups > 0 ? std::min(bound, error + residue) : bound};
}

std::optional<int> table_facet(const Stone& stone) {
    constexpr double level = 1e-9;
    for (std::size_t i = 0; i < stone.facets.size(); ++i) {
        if (stone.facets[i].normal.z > 1 - level) return static_cast<int>(i);
    }
    return {};
}

}  // namespace icespar
