// What a crystal block says, on its way to a crystal; for build_crystal.cpp and its neighbours.
#pragma once

#include "crystal/mineral.hpp"
#include "parser/builder.hpp"

namespace icespar {

struct Builder::CrystalWords {
    std::vector<double> indices;
    std::vector<IndexFunction> formulas;
    std::vector<double> bg, abbe;
    const Mineral* mineral = nullptr;
    std::string colour;
    std::optional<Place> axis, axes, dispersion, absorption, rotation, coloured;
    std::array<std::optional<Spectrum>, 3> bands;  ///< by index
    bool every_index = false;                      ///< the first of them serves for all
    bool at_fault = false;
};

}  // namespace icespar
