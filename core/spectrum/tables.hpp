// The numbers in tables.cpp and lamps.cpp: equally spaced nodes over the rendered range.
#pragma once

#include <array>
#include <string_view>

namespace icespar::tables {

inline constexpr int nodes = 81;
inline constexpr double step_nm = 5;

extern const std::array<std::array<double, 3>, nodes> observer;   ///< CIE x, y, z
extern const std::array<std::array<double, 3>, nodes> primaries;  ///< red, green, blue

/// An illuminant of the CIE, in units of its own.
struct Lamp {
    std::string_view name;
    std::array<double, nodes> power;
};
inline constexpr int lamp_count = 27;
extern const std::array<Lamp, lamp_count> lamps;  ///< D65 first

}  // namespace icespar::tables
