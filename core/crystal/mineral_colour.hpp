// The colours that minerals are found in: what each wave of a coloured stone loses.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "crystal/mineral.hpp"
#include "spectrum/spectrum.hpp"

namespace icespar {

/// One row of colours.csv.
struct MineralColour {
    std::string mineral, name;
    std::vector<Spectrum> absorption;  ///< of intensity, per mm; one for each index of the mineral
    std::string words;                 ///< as gemmologists name it along each axis
    std::string source, confidence;
};

/// All colours, those of a mineral one after the other.
[[nodiscard]] std::span<const MineralColour> mineral_colours();

/// The colour of that name, whatever the case, or nothing.
[[nodiscard]] const MineralColour* find_colour(const Mineral& mineral, std::string_view name);

/// A table with the columns of colours.csv. Throws Error with the line.
[[nodiscard]] std::vector<MineralColour> parse_mineral_colours(std::string_view csv);

/// Linear RGB of daylight (D65) after a length in mm of this absorption.
[[nodiscard]] Rgb colour_through(const Spectrum& absorption, double length_mm);

}  // namespace icespar
