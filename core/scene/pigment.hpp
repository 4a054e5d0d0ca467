// What colours lie where on a surface, or over the sky.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/picture.hpp"
#include "math/transform.hpp"
#include "spectrum/spectrum.hpp"

namespace icespar {

/// Patterns live in their own space, left-handed as scenes are: `to_pattern` takes world points
/// there.
struct Pigment {
    enum class Kind { plain, checker, grid, gradient, picture };
    Kind kind = Kind::plain;
    /// plain: one; checker: A, B; grid: line, ground; gradient: those of its map; picture: what
    /// red, green and blue are made of.
    std::vector<Spectrum> colours{Spectrum(1.0)};
    double line_width = 0.1;      ///< grid, in cells
    Vec3 axis{0, 1, 0};           ///< gradient: its value is axis . point, repeated from 1 on
    std::vector<double> stops{};  ///< gradient: the value of each colour, not falling
    std::shared_ptr<const Picture> picture{};
    /// picture: the unit square of x and y, repeated unless `once` (black beside it); all round,
    /// from +x by +z, as POV-Ray's map_type 1; or as seen from inside, centre +z, right of it +x.
    enum class Projection { plane, sphere, panorama };
    Projection projection = Projection::plane;
    bool once = false, smooth = false;
    Transform to_pattern{};
};

/// Shares of a pigment's colours at a point.
struct Mix {
    int count = 1;
    std::array<double, 3> share{1, 0, 0};
    std::array<std::uint32_t, 3> colour{0, 1, 2};
};

}  // namespace icespar
