// `icespar minerals [NAME]`: what a stone may be made of.
#include <cstdio>

#include "cli/commands.hpp"
#include "crystal/mineral.hpp"

namespace icespar {

namespace {

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

void describe(const Mineral& mineral, std::ostream& out) {
    const char* const names[3][3] = {{"n"}, {"n_o", "n_e"}, {"n_alpha", "n_beta", "n_gamma"}};
    out << mineral.name << " (mineral \"" << mineral.id << "\"), " << mineral.formula << ", "
        << mineral.crystal_system << ", " << mineral.optic << ", "
        << number("%.4g", mineral.density) << " g/cm3, confidence " << mineral.confidence
        << "\n  nm    ";
    const std::size_t count = mineral.indices.size();
    for (std::size_t i = 0; i < count && i < 3; ++i) out << padded(names[count - 1][i], 8);
    for (const double nm : {400.0, 486.1, 546.1, 589.3, 656.3, 700.0}) {
        out << "\n  " << padded(number("%.1f", nm), 5);
        for (const IndexFunction& n : mineral.indices) out << padded(number("%.5f", n(nm)), 8);
    }
    out << '\n';
}

}  // namespace

int minerals_command(const std::string& name, std::ostream& out, std::ostream& messages) {
    if (!name.empty()) {
        const Mineral* mineral = find_mineral(name);
        if (mineral == nullptr) {
            messages << "icespar: no mineral is called '" << name
                     << "'; `icespar minerals` lists them all\n";
            return exit_fault;
        }
        describe(*mineral, out);
        return exit_done;
    }
    out << padded("mineral", 22) << padded("optic", 12) << padded("n at 589.3 nm", 26)
        << padded("g/cm3", 7) << "name\n";
    for (const Mineral& mineral : minerals())
        out << padded(mineral.id, 22) << padded(mineral.optic, 12) << padded(published(mineral), 26)
            << padded(number("%.4g", mineral.density), 7) << mineral.name << '\n';
    return exit_done;
}

}  // namespace icespar
