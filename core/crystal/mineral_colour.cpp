// Colours of minerals: bands, or a named colour made into a smooth spectrum.
#include "crystal/mineral_colour.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "crystal/table.hpp"

namespace icespar {

extern const std::string_view colours_csv;

namespace {

/// A colour in words is what white light shows after this length.
constexpr double named_mm = 5;

/// Bands of a centre, a full width at half height (nm) and a height (1/mm), added up.
Spectrum from_bands(const Table& table, const std::string& text, int line) {
    const std::vector<double> c = table.numbers(text, "/ ", line);
    if (c.empty() || c.size() % 3 != 0)
        table.fail(line, "'" + text + "' is not made of bands CENTRE/WIDTH/HEIGHT");
    std::vector<double> nodes, values;
    for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
        double sum = 0;
        for (std::size_t i = 0; i < c.size(); i += 3) {
            const double off = (nm - c[i]) / c[i + 1];
            sum += c[i + 2] * std::exp2(-4 * off * off);
        }
        nodes.push_back(nm);
        values.push_back(sum);
    }
    return {std::move(nodes), std::move(values)};
}

/// "#rrggbb", sRGB.
Spectrum from_colour(const Table& table, const std::string& text, int line) {
    Rgb rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        int value = 0;
        const char* at = text.data() + 1 + 2 * i;
        if (text.size() != 7 || std::from_chars(at, at + 2, value, 16).ptr != at + 2)
            table.fail(line, "'" + text + "' is not a colour #rrggbb");
        const double v = value / 255.0;
        rgb[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const Spectrum left = reflectance_from_rgb(rgb);
    constexpr double least = 1e-6;
    std::vector<double> nodes, values;
    for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
        nodes.push_back(nm);
        values.push_back(-std::log(std::clamp(left(nm), least, 1.0)) / named_mm);
    }
    return {std::move(nodes), std::move(values)};
}

}  // namespace

std::span<const MineralColour> mineral_colours() {
    static const std::vector<MineralColour> table = parse_mineral_colours(colours_csv);
    return table;
}

const MineralColour* find_colour(const Mineral& mineral, std::string_view name) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    for (const MineralColour& colour : mineral_colours())
        if (colour.mineral == mineral.id &&
            std::equal(name.begin(), name.end(), colour.name.begin(), colour.name.end(), same))
            return &colour;
    return nullptr;
}

std::vector<MineralColour> parse_mineral_colours(std::string_view csv) {
    constexpr const char* heads[] = {"mineral", "colour", "first",  "second",
                                     "third",   "words",  "source", "confidence"};
    const Table table("colours", csv, heads);
    std::vector<MineralColour> found;
    for (const Table::Row& row : table.rows()) {
        MineralColour c;
        c.mineral = table.field(row, "mineral");
        c.name = table.field(row, "colour");
        c.words = table.field(row, "words");
        c.source = table.field(row, "source");
        c.confidence = table.field(row, "confidence");
        for (const char* head : {"first", "second", "third"}) {
            const std::string& text = table.field(row, head);
            if (text.empty()) continue;
            c.absorption.push_back(text[0] == '#' ? from_colour(table, text, row.line)
                                                  : from_bands(table, text, row.line));
        }
        const Mineral* mineral = find_mineral(c.mineral);
        if (!mineral) table.fail(row.line, "there is no mineral '" + c.mineral + "'");
        if (c.absorption.size() != mineral->indices.size())
            table.fail(row.line, c.mineral + " takes " + std::to_string(mineral->indices.size()) +
                                     " spectra, not " + std::to_string(c.absorption.size()));
        found.push_back(std::move(c));
    }
    return found;
}

Rgb colour_through(const Spectrum& absorption, double length_mm) {
    std::vector<double> nodes, values;
    for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
        nodes.push_back(nm);
        values.push_back(std::exp(-length_mm * absorption(nm)) * white()(nm));
    }
    return rgb_of({std::move(nodes), std::move(values)});
}

}  // namespace icespar
