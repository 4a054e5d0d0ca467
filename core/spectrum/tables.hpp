// The numbers in tables.cpp: equally spaced nodes over the rendered range.
#pragma once

#include <array>

namespace icespar::tables {

inline constexpr int nodes = 81;
inline constexpr double step_nm = 5;

extern const std::array<std::array<double, 3>, nodes> observer;     ///< CIE x, y, z
extern const std::array<std::array<double, 3>, nodes> illuminants;  ///< D65, D50, A
extern const std::array<std::array<double, 3>, nodes> primaries;    ///< red, green, blue

}  // namespace icespar::tables
