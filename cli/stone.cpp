// Prints a design's tiers as its file gives them, and the measures of the finished stone.
#include "cli/stone.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "math/error.hpp"
#include "parser/load.hpp"
#include "stone/cut.hpp"
#include "stone/stone.hpp"

namespace icespar {
namespace {

/// Facets that follow one another in the file with the same name, angle and distance.
struct Tier {
    std::string name;
    double angle, distance;
    std::vector<double> indices;
    int reached = 0;
};

template <class... Values>
std::string text(const char* format, Values... values) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

double degrees(double radians) { return radians * (180 / std::numbers::pi); }

/// From the dop axis, negative on the pavilion; a culet's is 0.
double angle_of(const Vec3& normal) {
    const double slope = degrees(std::atan2(std::hypot(normal.x, normal.y), std::abs(normal.z)));
    return normal.z < 0 && slope > 0 ? -slope : slope;
}

/// Where on the gear the facet is cut, between 0 (not included) and the gear's teeth.
double index_of(const Vec3& normal, const Design& design) {
    const double teeth = std::abs(design.gear);
    const double turns = std::atan2(normal.x, normal.y) / (2 * std::numbers::pi);
    const double index = std::fmod(turns * design.gear + design.gear_offset, teeth);
    const double tidy = std::round(index * 1e4) / 1e4;
    return tidy > 0 ? tidy : tidy + teeth;
}

bool is_on(const Stone& stone, const FacetPlane& plane) {
    return std::any_of(stone.facets.begin(), stone.facets.end(), [&](const Facet& facet) {
        return length(facet.normal - plane.normal) < 1e-8 &&
               std::abs(facet.distance - plane.distance) < 1e-8 * std::abs(plane.distance) + 1e-15;
    });
}

std::vector<Tier> tiers_of(const Design& design, const Stone& stone) {
    std::vector<Tier> tiers;
    for (const FacetPlane& plane : design.planes) {
        const double angle = std::round(angle_of(plane.normal) * 1e9) / 1e9;
        const bool is_culet = plane.normal.z == -1;
        const double distance = is_culet ? -plane.distance : plane.distance;
        const bool goes_on = !tiers.empty() && tiers.back().name == plane.name &&
                             tiers.back().angle == angle && tiers.back().distance == distance;
        if (!goes_on) tiers.push_back({plane.name, angle, distance, {}});
        tiers.back().indices.push_back(index_of(plane.normal, design));
        if (is_on(stone, plane)) ++tiers.back().reached;
    }
    return tiers;
}

void print_tiers(const std::vector<Tier>& tiers, std::ostream& out) {
    std::size_t widest = 4;
    for (const Tier& tier : tiers)
        widest = std::max(widest, std::min<std::size_t>(24, tier.name.size()));
    const auto padded = [&](std::string name) {
        name.resize(std::max(widest, name.size()), ' ');
        return name;
    };
    out << padded("tier")
        << text("  %8s  %11s  %5s  %7s  %s\n", "angle", "distance", "cut", "reached", "index");
    const std::string indent(widest + 41, ' ');
    for (const Tier& tier : tiers) {
        std::string line = padded(tier.name.empty() ? "-" : tier.name) +
                           text("  %8.2f  %11.8f  %5zu  %7d ", tier.angle, tier.distance,
                                tier.indices.size(), tier.reached);
        for (const double index : tier.indices) {
            const std::string word = text(" %g", index);
            if (line.size() + word.size() > 99) {
                out << line << '\n';
                line = indent;
            }
            line += word;
        }
        out << line << '\n';
    }
}

/// Of the facet that faces up, along the axis in which the stone is narrowest; 0 without a table.
double table_width(const Stone& stone) {
    const auto table =
        std::max_element(stone.facets.begin(), stone.facets.end(),
                         [](const Facet& a, const Facet& b) { return a.normal.z < b.normal.z; });
    if (table == stone.facets.end() || table->normal.z < 1 - 1e-12) return 0;
    const auto extent = [&](const auto& corners, double Vec3::*axis) {
        const auto [low, high] =
            std::minmax_element(corners.begin(), corners.end(),
                                [&](const Vec3& a, const Vec3& b) { return a.*axis < b.*axis; });
        return (*high).*axis - (*low).*axis;
    };
    std::vector<Vec3> corners;
    for (const std::uint32_t corner : table->corners) corners.push_back(stone.vertices[corner]);
    const bool narrow_in_x = extent(stone.vertices, &Vec3::x) <= extent(stone.vertices, &Vec3::y);
    return extent(corners, narrow_in_x ? &Vec3::x : &Vec3::y);
}

Stone cut(const Design& design, const std::filesystem::path& file) {
    try {
        return Stone::from_planes(design.planes);
    } catch (const Error& error) {
        throw Error(file.string() + ": " + error.what());
    }
}

/// "X (4), Y (4), T0": each name once, in the order of the file.
std::string counted(const std::vector<std::string>& names) {
    std::map<std::string, int> count;
    for (const std::string& name : names) ++count[name];
    std::string line;
    for (const std::string& name : names) {
        const int n = std::exchange(count[name], 0);
        if (n == 0) continue;
        line += (line.empty() ? "" : ", ") + name + (n > 1 ? " (" + std::to_string(n) + ")" : "");
    }
    return line.empty() ? "none" : line;
}

}  // namespace

void stone_command(const std::filesystem::path& file, std::ostream& out) {
    const Design design = read_design(file);
    const Stone stone = cut(design, file);
    const GirdleSize size = girdle_size(stone);

    for (const std::string& header : design.headers) {
        if (!header.empty()) out << header << '\n';
    }
    out << text("gear %g, symmetry %d-fold%s\n\n", std::abs(design.gear), design.symmetry,
                design.mirror ? ", mirrored" : "");
    print_tiers(tiers_of(design, stone), out);

    const double table = table_width(stone);
    out << '\n'
        << "closed            yes\n"
        << text("facets            %zu of %zu planes\n", stone.facets.size(), design.planes.size())
        << "unreached facets  " << counted(stone.unreached) << '\n'
        << text("volume            %.6g design units^3 (%.4f W^3)\n", stone.volume,
                stone.volume / (size.width * size.width * size.width))
        << text("L/W               %.4f\n", size.length / size.width)
        << text("H/W               %.4f\n", size.height / size.width) << "T/W               "
        << (table > 0 ? text("%.4f", table / size.width) : "no table") << '\n'
        << "refractive index  "
        << (design.refractive_index > 0 ? text("%g", design.refractive_index) : "not given")
        << '\n';
}

}  // namespace icespar
