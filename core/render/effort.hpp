// Where a picture needs more samples: tiles of pixels, and how far each is from what was asked.
#pragma once

#include <algorithm>
#include <vector>

#include "beams/footprint.hpp"
#include "render/film.hpp"
#include "render/render.hpp"

namespace icespar {

/// A picture cut into squares, the last of a row or column perhaps narrower.
struct Tiles {
    static constexpr int side = 16;
    int width, height;
    [[nodiscard]] int across() const { return (width + side - 1) / side; }
    [[nodiscard]] int count() const { return across() * ((height + side - 1) / side); }
    [[nodiscard]] int pixels(int tile) const {
        return std::min(side, width - tile % across() * side) *
               std::min(side, height - tile / across() * side);
    }
    /// Calls visit(frame) for each square of so many pixels a side, cut off at the picture's edge,
    /// until it returns false.
    template <class Visit>
    void visit(int tile, int size, const Visit& visit_block) const {
        const int x0 = tile % across() * side, y0 = tile / across() * side;
        const int x1 = std::min(x0 + side, width), y1 = std::min(y0 + side, height);
        for (int y = y0; y < y1; y += size) {
            for (int x = x0; x < x1; x += size) {
                if (!visit_block(Frame{x, y, std::min(x + size, x1), std::min(y + size, y1)}))
                    return;
            }
        }
    }
    /// Calls visit(x, y) for each pixel of a tile until it returns false.
    template <class Visit>
    void visit(int tile, const Visit& visit_pixel) const {
        const int x0 = tile % across() * side, y0 = tile / across() * side;
        for (int y = y0; y < std::min(y0 + side, height); ++y) {
            for (int x = x0; x < std::min(x0 + side, width); ++x) {
                if (!visit_pixel(x, y)) return;
            }
        }
    }
};

/// The picture's error, from the variance of each pixel's luminance; 0 when it is not known.
[[nodiscard]] double relative_error(const std::vector<double>& variances, double mean_luminance,
                                    ErrorMetric metric);

/// The tiles that need more samples for this error, from the samples a pixel that each has had. For
/// the root mean square, samples are shared out in proportion to a tile's standard deviation, which
/// makes their number least (Neyman 1934).
[[nodiscard]] std::vector<int> unfinished(const Tiles& tiles, const std::vector<double>& variances,
                                          double mean_luminance, const std::vector<int>& done,
                                          double error, ErrorMetric metric);

}  // namespace icespar
