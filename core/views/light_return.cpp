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
    double sum = 0;
    for (std::size_t i = 0; i < exits.size(); ++i) {
        if (facet && exits.entry[i] != *facet) continue;
        sum += exits.area[i] * exits.weight[i].s0 * light.radiance(exits.direction[i]);
    }
    double area = exits.area_total, untraced = exits.untraced;
    if (facet) {
        area = exits.entry_area[static_cast<std::size_t>(*facet)];
        untraced = exits.entry_untraced[static_cast<std::size_t>(*facet)];
    }
    if (!(area > 0)) return {};
    return {sum / area, light.greatest() * untraced / area};
}

std::optional<int> table_facet(const Stone& stone) {
    constexpr double level = 1e-9;
    for (std::size_t i = 0; i < stone.facets.size(); ++i) {
        if (stone.facets[i].normal.z > 1 - level) return static_cast<int>(i);
    }
    return {};
}

}  // namespace icespar
