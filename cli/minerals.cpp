// `icespar minerals [NAME]`: what a stone may be made of, and its colours.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/commands.hpp"
#include "crystal/mineral_colour.hpp"

namespace icespar {

namespace {

constexpr double shown_mm = 5;

std::string number(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string published(const Mineral& mineral) {
    std::string text;
    for (const double n : mineral.indices_589)
        text += (text.empty() ? "" : ", ") + number("%.5g", n);
    return text;
}

std::string padded(std::string text, std::size_t width) {
    // Letters such as o-umlaut take two bytes and one column.
    std::size_t columns = 0;
    for (const char c : text) columns += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    if (columns < width) text.append(width - columns, ' ');
    return text + " ";
}

/// Daylight behind 5 mm of it, as "#rrggbb".
std::string seen(const Spectrum& absorption) {
    std::string text = "#";
    for (const double linear : colour_through(absorption, shown_mm)) {
        const double v = std::clamp(linear, 0.0, 1.0);
        const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
        char digits[8];
        std::snprintf(digits, sizeof digits, "%02x", static_cast<int>(std::lround(255 * encoded)));
        text += digits;
    }
    return text;
}

constexpr const char* index_names[3][3] = {{"n"}, {"n_o", "n_e"}, {"n_alpha", "n_beta", "n_gamma"}};

void describe_colours(const Mineral& mineral, std::ostream& out) {
    const auto& names = index_names[mineral.indices.size() - 1];
    for (const MineralColour& c : mineral_colours()) {
        if (c.mineral != mineral.id) continue;
        out << "  colour \"" << c.name << "\": " << c.words << "; through " << shown_mm << " mm";
        for (std::size_t i = 0; i < c.absorption.size(); ++i)
            out << (i == 0 ? " " : ", ") << names[i] << ' ' << seen(c.absorption[i]);
        out << "; confidence " << c.confidence << "\n    " << c.source << '\n';
    }
}

void describe(const Mineral& mineral, std::ostream& out) {
    out << mineral.name << " (mineral \"" << mineral.id << "\"), " << mineral.formula << ", "
        << mineral.crystal_system << ", " << mineral.optic << ", "
        << number("%.4g", mineral.density) << " g/cm3, confidence " << mineral.confidence
        << "\n  nm    ";
    const std::size_t count = mineral.indices.size();
    for (std::size_t i = 0; i < count && i < 3; ++i) out << padded(index_names[count - 1][i], 8);
    for (const double nm : {400.0, 430.8, 486.1, 546.1, 589.3, 656.3, 686.7, 700.0}) {
        out << "\n  " << padded(number("%.1f", nm), 5);
        for (const IndexFunction& n : mineral.indices) out << padded(number("%.5f", n(nm)), 8);
    }
    out << "\n  B-G   ";
    for (const double d : mineral.dispersion_bg) out << padded(number("%.4f", d), 8);
    out << '\n';
    const std::pair<const char*, const std::string*> words[] = {
        {"rotation, degrees/mm", &mineral.rotation},
        {"axes", &mineral.orientation},
        {"pleochroism", &mineral.pleochroism},
        {"absorption bands, nm", &mineral.bands},
        {"source", &mineral.source}};
    for (const auto& [name, text] : words)
        if (!text->empty()) out << "  " << name << ": " << *text << '\n';
    describe_colours(mineral, out);
}

std::string hint_for(const std::string& name) {
    for (const MineralColour& c : mineral_colours())
        if (c.name == name) return "it is a colour of " + c.mineral;
    std::string hint;
    for (const std::string& near : nearest_minerals(name))
        hint += (hint.empty() ? "did you mean " : " or ") + near;
    return hint.empty() ? "`icespar minerals` lists them all" : hint + "?";
}

void list_csv(std::ostream& out) {
    out << "mineral,colour,first,second,third,words,confidence\n";
    for (const MineralColour& c : mineral_colours()) {
        out << c.mineral << ',' << c.name;
        for (std::size_t i = 0; i < 3; ++i)
            out << ',' << (i < c.absorption.size() ? seen(c.absorption[i]) : "");
        out << ',' << c.words << ',' << c.confidence << '\n';
    }
}

}  // namespace

int minerals_command(const std::string& name, bool colours, std::ostream& out,
                     std::ostream& messages) {
    if (colours) {
        list_csv(out);
        return exit_done;
    }
    if (!name.empty()) {
        const Mineral* mineral = find_mineral(name);
        if (mineral == nullptr) {
            messages << "icespar: no mineral is called '" << name << "'; " << hint_for(name)
                     << '\n';
            return exit_fault;
        }
        describe(*mineral, out);
        return exit_done;
    }
    out << padded("mineral", 15) << padded("optic", 12) << padded("n at 589.3 nm", 26)
        << padded("g/cm3", 6) << padded("name", 38) << "colours\n";
    for (const Mineral& mineral : minerals()) {
        out << padded(mineral.id, 15) << padded(mineral.optic, 12) << padded(published(mineral), 26)
            << padded(number("%.4g", mineral.density), 6);
        std::string known;
        for (const MineralColour& c : mineral_colours())
            if (c.mineral == mineral.id) known += (known.empty() ? "" : ", ") + c.name;
        out << (known.empty() ? mineral.name : padded(mineral.name, 38) + known) << '\n';
    }
    return exit_done;
}

}  // namespace icespar
