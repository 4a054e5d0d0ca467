// Where the surroundings are bright: directions for surfaces to look in, so that no small lamp is
// found by luck alone.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace icespar {

/// Draws directions in proportion to luminance: a lamp's evenly over its disc, a pattern's or
/// formula's evenly over the cells of a table. A plain or graded sky without lamps has none to
/// offer.
class BrightSky {
public:
    explicit BrightSky(const Environment& sky);

    [[nodiscard]] bool empty() const { return reached_.empty(); }
    /// (u, v) of the unit square choose.
    [[nodiscard]] Vec3 direction(double u, double v) const;
    /// Per steradian: the density of `direction` for (u, v) drawn evenly.
    [[nodiscard]] double density(const Vec3& direction) const;

private:
    struct Cell {
        int row = 0, column = 0;
    };
    [[nodiscard]] Cell cell_at(const Vec3& direction) const;
    [[nodiscard]] double height_above(int row) const;  ///< y of the line above it
    [[nodiscard]] double cell_solid_angle(int row) const;
    /// Within a cell, evenly for (u, v) from the unit square.
    [[nodiscard]] Vec3 in_cell(const Cell& cell, double u, double v) const;
    void tabulate(const Environment& sky);

    std::vector<Disc> discs_;
    std::vector<double> solid_angles_;  ///< of the discs
    std::vector<double> reached_;       ///< sums of power: discs first, then cells
    /// Of the table, down in latitude from +y; twice as many columns go round. 0: no table.
    int rows_ = 0;
};

}  // namespace icespar
