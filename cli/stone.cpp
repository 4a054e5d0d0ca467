// Prints a design's tiers as its file gives them, and the measures of the finished stone.
#include "cli/stone.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "designs/solved.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

template <class... Values>
std::string text(const char* format, Values... values) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

void print_tiers(const Design& design, const SolvedDesign& solved, std::ostream& out) {
    std::size_t widest = 4;
    for (const Tier& tier : design.tiers)
        widest = std::max(widest, std::min<std::size_t>(24, tier.cuts.front().name.size()));
    const auto padded = [&](std::string name) {
        name.resize(std::max(widest, name.size()), ' ');
        return name;
    };
    out << padded("tier")
        << text("  %8s  %11s  %5s  %7s  %s\n", "angle", "distance", "cut", "reached", "index");
    const std::string indent(widest + 41, ' ');
    std::size_t plane = 0;
    for (const Tier& tier : design.tiers) {
        int reached = 0;
        for (std::size_t i = 0; i < tier.cuts.size(); ++i) reached += solved.facet_of[plane++] >= 0;
        const std::string& name = tier.cuts.front().name;
        std::string line =
            padded(name.empty() ? "-" : name) + text("  %8.2f  %11.8f  %5zu  %7d ", tier.angle,
                                                     tier.distance, tier.cuts.size(), reached);
        for (const Tier::Cut& cut : tier.cuts) {
            std::string word = text(" %g", cut.index);
            if (cut.name != name) word += ":" + cut.name;
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

SolvedDesign solved(const Design& design, const std::filesystem::path& file) {
    try {
        return SolvedDesign(design);
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
    const SolvedDesign whole = solved(design, file);
    const Stone& stone = whole.stone;
    const GirdleSize size = girdle_size(stone);

    for (const std::string& header : design.headers) {
        if (!header.empty()) out << header << '\n';
    }
    out << text("gear %g, symmetry %d-fold%s\n\n", std::abs(design.gear), design.symmetry,
                design.mirror ? ", mirrored" : "");
    print_tiers(design, whole, out);
    for (const std::string& remark : design.remarks) out << "remark: " << remark << '\n';

    const double table = table_width(stone);
    out << '\n'
        << "closed            yes\n"
        << text("facets            %zu of %zu planes\n", stone.facets.size(), whole.planes.size())
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
