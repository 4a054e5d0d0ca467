// A design for another material, by tangent ratios.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <sstream>

#include "designs/solved.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// One side of the stone: the plane z = edge stays, and heights from it are multiplied.
struct Stretch {
    double edge = 0, factor = 1;
};

bool is_girdle(const Vec3& normal) { return std::abs(normal.z) < 1e-7; }

/// How far the direction of light from straight above turns on entering a slope.
double turned_by(double slope, double index) { return slope - std::asin(std::sin(slope) / index); }

double matching_crown(double slope, double from, double to) {
    const double wanted = turned_by(slope, from);
    double low = 0, high = std::numbers::pi / 2;
    if (turned_by(high, to) < wanted)
        throw Error("no crown angle turns light as much at an index of " + std::to_string(to) +
                    ": give --crown");
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (turned_by(middle, to) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double factor(double old_slope, double new_slope, const char* side) {
    if (!(new_slope > 0.5 * degree && new_slope < 89.5 * degree))
        throw Error(std::string("the ") + side + " would be cut at " +
                    std::to_string(new_slope / degree) +
                    " degrees: give an angle between 0.5 and 89.5");
    return std::tan(new_slope) / std::tan(old_slope);
}

Tier stretched(const Tier& tier, const Stretch& side) {
    const bool down = std::signbit(tier.angle) || (tier.angle == 0 && tier.distance < 0);
    const bool culet_sign = tier.angle == 0 && tier.distance < 0;
    const double slope = std::abs(tier.angle) * degree;
    const double sine = std::sin(slope), cosine = std::cos(slope) * (down ? -1 : 1);
    const double distance = culet_sign ? -tier.distance : tier.distance;
    const double size = std::hypot(sine, cosine / side.factor);
    Tier out = tier;
    out.angle = std::copysign(
        tier.angle == 0 ? 0.0 : std::atan2(sine * side.factor, std::abs(cosine)) / degree,
        tier.angle);
    out.distance = (distance - cosine * side.edge * (1 - 1 / side.factor)) / size;
    if (culet_sign) out.distance = -out.distance;
    return out;
}

}  // namespace

Design retargeted(const Design& design, const Retarget& to) {
    for (const double index : {to.from, to.to}) {
        if (index > 1 && index < 10) continue;
        std::ostringstream number;
        number << index;
        throw Error("a refractive index of " + number.str() +
                    " is not one of a stone: give one between 1 and 10");
    }
    const SolvedDesign solved(design);
    Stretch crown{HUGE_VAL, 1}, pavilion{-HUGE_VAL, 1};
    double crown_area = 0, crown_slope = 0, lowest = HUGE_VAL, pavilion_slope = 0;
    std::size_t plane = 0;
    for (const Tier& tier : design.tiers) {
        double area = 0, depth = HUGE_VAL;
        bool up = false;
        for (std::size_t i = 0; i < tier.cuts.size(); ++i, ++plane) {
            if (solved.facet_of[plane] < 0) continue;
            const Facet& facet =
                solved.stone.facets[static_cast<std::size_t>(solved.facet_of[plane])];
            if (is_girdle(facet.normal)) continue;
            up = facet.normal.z > 0;
            area += facet.area;
            for (const Vec3& corner : solved.polygon(plane)) {
                depth = std::min(depth, corner.z);
                if (up)
                    crown.edge = std::min(crown.edge, corner.z);
                else
                    pavilion.edge = std::max(pavilion.edge, corner.z);
            }
        }
        if (area == 0 || tier.angle == 0) continue;
        const double slope = std::abs(tier.angle) * degree;
        if (up && area > crown_area) {
            crown_area = area;
            crown_slope = slope;
        } else if (!up && depth < lowest - 1e-9) {
            lowest = depth;
            pavilion_slope = slope;
        }
    }
    if (pavilion_slope > 0) {
        const double critical = std::asin(1 / to.to) - std::asin(1 / to.from);
        const double wanted =
            to.pavilion != 0 ? std::abs(to.pavilion) * degree : pavilion_slope + critical;
        pavilion.factor = factor(pavilion_slope, wanted, "pavilion");
    }
    if (crown_slope > 0) {
        const double wanted = to.crown != 0 ? std::abs(to.crown) * degree
                                            : matching_crown(crown_slope, to.from, to.to);
        crown.factor = factor(crown_slope, wanted, "crown");
    }
    Design out = design;
    out.refractive_index = to.to;
    for (Tier& tier : out.tiers) {
        const bool down = std::signbit(tier.angle) || (tier.angle == 0 && tier.distance < 0);
        if (std::abs(std::abs(tier.angle) - 90) < 1e-5) continue;
        const Stretch& side = down ? pavilion : crown;
        if (std::isfinite(side.edge)) tier = stretched(tier, side);
    }
    return out;
}

}  // namespace icespar
