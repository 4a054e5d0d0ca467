// The two modes of an active stone that travel together, at a facet.
#pragma once

#include <array>
#include <optional>

#include "interface/interface.hpp"

namespace icespar {

/// What both modes become where they meet a facet from within and go on as one wave would.
/// Coefficients are normalised to flux: [incident mode][outgoing wave].
struct TwinFace {
    std::array<Wave, 2> reflected;
    std::array<std::array<Complex, 2>, 2> reflect, transmit{};
    bool leaves = false;          ///< light goes out, too: s and p of one wave
    Vec3 k{};                     ///< of what leaves
    std::array<Vec3, 2> basis{};  ///< its s and p
};

/// Nothing when their wave vectors part by more than 1e-4, about 1e-4 rad: then they are followed
/// alone, and add as powers. The fast wave's direction stands for both.
[[nodiscard]] std::optional<TwinFace> meet_facet(const Medium& medium, const Vec3& normal,
                                                 const Wave& fast, const Wave& slow);

}  // namespace icespar
