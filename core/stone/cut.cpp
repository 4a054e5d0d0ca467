// Facet planes from the angles, indices and distances of a faceting diagram.
#include "stone/cut.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "math/error.hpp"

namespace icespar {
namespace {

struct SinCos {
    double sin, cos;
};

/// Of an angle in degrees, with the octant folded away first: 90 degrees have a cosine of exactly
/// 0, and facets that mirror one another in the diagram do so to the last bit.
SinCos sin_cos_degrees(double degrees) {
    double rest = std::remainder(degrees, 360.0);  // exact, in [-180, 180]
    const bool negative = rest < 0;
    rest = std::abs(rest);
    const bool obtuse = rest > 90;
    if (obtuse) rest = 180 - rest;
    const bool steep = rest > 45;
    if (steep) rest = 90 - rest;
    SinCos out{std::sin(rest * (std::numbers::pi / 180)),
               std::cos(rest * (std::numbers::pi / 180))};
    if (steep) std::swap(out.sin, out.cos);
    if (obtuse) out.cos = 0 - out.cos;
    if (negative) out.sin = 0 - out.sin;
    return out;
}

}  // namespace

FacetPlane cut_plane(double angle, double distance, double index, double gear, double offset,
                     bool pavilion, std::string name) {
    const std::string facet = name.empty() ? "a facet" : "facet '" + name + "'";
    if (!std::isfinite(angle) || !std::isfinite(distance) || !std::isfinite(index - offset)) {
        throw Error(facet +
                    " has a number that is not finite: give angle, distance and index as "
                    "numbers");
    }
    if (!std::isfinite(gear) || gear == 0) {
        throw Error(facet + " has a gear without teeth: give the number of teeth, such as 96");
    }
    if (std::abs(angle) > 90) {
        throw Error(facet +
                    " has an angle beyond 90 degrees: 0 is the table, 90 the girdle, and the "
                    "pavilion is negative");
    }
    // A culet is written as a table at a negative distance.
    const bool culet = angle == 0 && distance < 0;
    const bool down = pavilion || angle < 0 || culet;
    const SinCos slope = sin_cos_degrees(std::abs(angle));
    const SinCos azimuth = sin_cos_degrees(360 * std::remainder(index - offset, gear) / gear);
    return {{azimuth.sin * slope.sin, azimuth.cos * slope.sin, down ? 0 - slope.cos : slope.cos},
            culet ? -distance : distance,
            std::move(name)};
}

}  // namespace icespar
