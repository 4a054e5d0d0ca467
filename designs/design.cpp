// A design as tiers and as planes.
#include "designs/design.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace icespar {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

std::vector<FacetPlane> Design::planes() const {
    std::vector<FacetPlane> out;
    out.reserve(facet_count());
    for (const Tier& tier : tiers) {
        for (const Tier::Cut& cut : tier.cuts) {
            out.push_back(cut_plane(tier.angle, tier.distance, cut.index, gear, gear_offset,
                                    std::signbit(tier.angle), cut.name));
        }
    }
    return out;
}

std::size_t Design::facet_count() const {
    std::size_t count = 0;
    for (const Tier& tier : tiers) count += tier.cuts.size();
    return count;
}

double angle_of(const Vec3& normal) {
    const double slope = std::atan2(std::hypot(normal.x, normal.y), std::abs(normal.z)) / degree;
    return std::copysign(slope, normal.z);
}

double index_of(const Vec3& normal, const Design& design) {
    const double teeth = std::abs(design.gear);
    const double turns = std::atan2(normal.x, normal.y) / (360 * degree);
    const double index = std::fmod(turns * design.gear + design.gear_offset, teeth);
    // Files give indices with few decimals; what is left is rounding of the plane.
    const double tidy = std::round(index * 1e4) / 1e4;
    const double shown = std::abs(index - tidy) < 1e-9 ? tidy : index;
    return shown > 0 ? shown : shown + teeth;
}

void spread_names(Tier& tier) {
    const auto named = std::find_if(tier.cuts.begin(), tier.cuts.end(),
                                    [](const Tier::Cut& cut) { return !cut.name.empty(); });
    std::string name = named == tier.cuts.end() ? std::string() : named->name;
    for (Tier::Cut& cut : tier.cuts) {
        if (cut.name.empty()) cut.name = name;
        name = cut.name;
    }
}

void TierBuilder::add(int number, const FacetPlane& plane, const std::string& instructions) {
    constexpr double same_angle = 1e-7, same_distance = 1e-9;
    const double angle = angle_of(plane.normal);
    const bool goes_on = !design_.tiers.empty() && number == number_ &&
                         std::abs(design_.tiers.back().angle - angle) < same_angle &&
                         std::signbit(design_.tiers.back().angle) == std::signbit(angle) &&
                         std::abs(design_.tiers.back().distance - plane.distance) <=
                             same_distance * std::abs(plane.distance);
    if (!goes_on) design_.tiers.push_back({angle, plane.distance, {}, instructions});
    number_ = number;
    design_.tiers.back().cuts.push_back({index_of(plane.normal, design_), plane.name});
}

void TierBuilder::finish() {
    for (Tier& tier : design_.tiers) spread_names(tier);
}

}  // namespace icespar
