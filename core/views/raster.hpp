// Pictures of polygons, each pixel by the exact part of it that a polygon covers.
#pragma once

#include <span>
#include <vector>

#include "beams/polygon.hpp"

namespace icespar {

/// Adds values, weighted by coverage, to pixels: x to the right and y down, pixel (0, 0) from 0 to
/// 1 in both. The cost of a polygon is that of its outline, whatever it holds.
class Raster {
public:
    Raster(int width, int height, int values);

    /// Convex or not; whichever way it goes round. Values are multiplied by `factor`, taken at the
    /// middle of each pixel.
    void add(PolygonView polygon, std::span<const double> values, const Affine& factor = {1, 0, 0});
    void add(const Raster& other);

    /// Sums along the rows; nothing can be added afterwards.
    void finish();
    /// Of a finished picture.
    [[nodiscard]] std::span<const double> pixel(int x, int y) const {
        return {sums_.data() + place(x, y), static_cast<std::size_t>(values_)};
    }

private:
    [[nodiscard]] std::size_t place(int x, int y) const {
        return (static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 2) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(values_);
    }
    void edge(Point2 from, Point2 to, double sign, std::span<const double> values);
    void part(const Point2& from, const Point2& to, double sign, std::span<const double> values);
    void put(int x, int y, double amount, std::span<const double> values) {
        const std::size_t at = place(x, y);
        const double level = amount * (factor_.value + factor_.dy * (y + 0.5));
        for (std::size_t i = 0; i < values.size(); ++i) sums_[at + i] += level * values[i];
        if (factor_.dx == 0) return;
        const double slope = amount * factor_.dx;
        for (std::size_t i = 0; i < values.size(); ++i) slopes_[at + i] += slope * values[i];
    }

    int width_, height_, values_;
    std::vector<double> sums_;    ///< by how much a pixel's coverage exceeds its left neighbour's
    std::vector<double> slopes_;  ///< the same of what grows with x; empty as long as nothing does
    Affine factor_;
};

}  // namespace icespar
