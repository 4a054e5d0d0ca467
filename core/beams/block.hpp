// A few pixels whose beams are followed together, and what of a polygon lies in each.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "beams/polygon.hpp"

namespace icespar {

/// A rectangle of pixels about the origin, picture x to the right and y up. They are numbered from
/// the top left, row by row. Polygons have their corners relative to `centre`.
struct Block {
    int across = 1, down = 1;

    [[nodiscard]] int count() const { return across * down; }
    [[nodiscard]] std::size_t number(int x, int y) const {
        return static_cast<std::size_t>(y * across + x);
    }

    /// The columns and rows that a polygon touches, from first to last.
    struct Span {
        int x0, x1, y0, y1;
        [[nodiscard]] bool one() const { return x0 == x1 && y0 == y1; }
    };
    [[nodiscard]] Span span(PolygonView polygon, const Point2& centre) const {
        Point2 low = polygon[0], high = polygon[0];
        for (const Point2& p : polygon.subspan(1)) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        // What reaches beyond a line by rounding alone does not count.
        constexpr double least = 1e-9;
        const auto within = [](double at, int size) {
            return std::clamp(static_cast<int>(std::floor(at)), 0, size - 1);
        };
        const double x = centre.x + 0.5 * across, y = 0.5 * down - centre.y;
        return {within(x + low.x + least, across), within(x + high.x - least, across),
                within(y - high.y + least, down), within(y - low.y - least, down)};
    }

    /// The pixel of a point.
    [[nodiscard]] std::size_t holding(const Point2& p) const {
        const auto x = static_cast<int>(std::floor(p.x + 0.5 * across)),
                   y = static_cast<int>(std::floor(0.5 * down - p.y));
        return number(std::clamp(x, 0, across - 1), std::clamp(y, 0, down - 1));
    }

    /// Positive to the right of a column, or below a row.
    [[nodiscard]] Affine right_of(int column, const Point2& centre) const {
        return {centre.x + 0.5 * across - (column + 1), 1, 0};
    }
    [[nodiscard]] Affine below(int row, const Point2& centre) const {
        return {0.5 * down - centre.y - (row + 1), 0, -1};
    }
};

/// Cuts polygons along the lines between pixels.
class PixelCutter {
public:
    /// add(pixel, part, its area, its centroid) for each part that is in one pixel. Corners are
    /// relative to the centroid: of the part, which itself is relative to the polygon's.
    template <class Add>
    void cut(const Block& block, PolygonView polygon, const Point2& centre, double area,
             const Add& add) {
        if (block.count() == 1) return add(0, polygon, area, Point2{});
        const Block::Span over = block.span(polygon, centre);
        if (over.one()) return add(block.number(over.x0, over.y0), polygon, area, Point2{});
        if (area == block.count()) return cut_whole(block, centre, add);
        rest_.assign(polygon.begin(), polygon.end());
        for (int y = over.y0; y <= over.y1; ++y) {
            take(rest_, y < over.y1, block.below(y, centre), row_);
            for (int x = over.x0; x <= over.x1; ++x) {
                take(row_, x < over.x1, block.right_of(x, centre), part_);
                const Extent e = extent(part_);
                if (!(e.area > 0)) continue;
                for (Point2& p : part_) p = p - e.centroid;
                add(block.number(x, y), PolygonView(part_), e.area, e.centroid);
            }
        }
    }

private:
    /// All of the block: sky, or what one facet reflects.
    template <class Add>
    static void cut_whole(const Block& block, const Point2& centre, const Add& add) {
        static constexpr std::array<Point2, 4> square{
            {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
        for (int y = 0; y < block.down; ++y) {
            for (int x = 0; x < block.across; ++x) {
                const Point2 middle{x + 0.5 - 0.5 * block.across, 0.5 * block.down - y - 0.5};
                add(block.number(x, y), PolygonView(square), 1.0, middle - centre);
            }
        }
    }

    /// What is not beyond the line; all if there is none.
    void take(Polygon& from, bool line, const Affine& beyond, Polygon& taken) {
        if (line) {
            split(from, beyond, beyond_, taken);
            from.swap(beyond_);
        } else {
            taken.swap(from);
        }
    }
    Polygon rest_, row_, part_, beyond_;
};

}  // namespace icespar
