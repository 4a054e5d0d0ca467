// Each edge adds what lies to the right of it, so that edges of either direction leave the inside:
// coverage is kept as differences along a row and summed once, for all polygons together.
#include "views/raster.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace icespar {

Raster::Raster(int width, int height, int values)
    : width_(width), height_(height), values_(values) {
    sums_.assign(place(0, height), 0);
}

void Raster::add(PolygonView polygon, std::span<const double> values, const Affine& factor) {
    factor_ = factor;
    if (factor.dx != 0 && slopes_.empty()) slopes_.assign(sums_.size(), 0);
    const double sign = extent(polygon).area > 0 ? 1 : -1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        edge(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0], sign, values);
    }
}

void Raster::add(const Raster& other) {
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += other.sums_[i];
    if (other.slopes_.empty()) return;
    if (slopes_.empty()) slopes_.assign(sums_.size(), 0);
    for (std::size_t i = 0; i < slopes_.size(); ++i) slopes_[i] += other.slopes_[i];
}

void Raster::finish() {
    const auto step = static_cast<std::size_t>(values_);
    for (int y = 0; y < height_; ++y) {
        const std::size_t end = place(width_, y);
        for (std::size_t i = place(0, y) + step; i < end; ++i) sums_[i] += sums_[i - step];
        if (slopes_.empty()) continue;
        for (std::size_t i = place(0, y) + step; i < end; ++i) slopes_[i] += slopes_[i - step];
        for (int x = 0; x < width_; ++x) {
            for (std::size_t i = place(x, y); i < place(x + 1, y); ++i) {
                sums_[i] += (x + 0.5) * slopes_[i];
            }
        }
    }
}

/// Downwards edges end what lies to their right, upwards ones begin it. What is beside the picture
/// on the left counts at its border, what is on the right not at all.
void Raster::edge(Point2 from, Point2 to, double sign, std::span<const double> values) {
    if (from.y == to.y) return;
    if (from.y > to.y) {
        std::swap(from, to);
    } else {
        sign = -sign;
    }
    const double low = std::max(from.y, 0.0), high = std::min(to.y, static_cast<double>(height_));
    if (!(low < high)) return;
    const double slope = (to.x - from.x) / (to.y - from.y);
    if (!std::isfinite(slope)) return;
    const auto at = [&](double y) {
        const double x = from.x + (y - from.y) * slope;
        return std::clamp(x, std::min(from.x, to.x), std::max(from.x, to.x));
    };
    // Cut where the edge crosses the borders, and held within them.
    double cuts[4] = {low, high, high, high};
    int count = 1;
    for (const double border : {0.0, static_cast<double>(width_)}) {
        const double y = from.y + (border - from.x) / slope;
        if (slope != 0 && y > low && y < high) cuts[count++] = y;
    }
    if (count == 3 && cuts[1] > cuts[2]) std::swap(cuts[1], cuts[2]);
    cuts[count] = high;
    const auto held = [&](double y) {
        return Point2{std::clamp(at(y), 0.0, static_cast<double>(width_)), y};
    };
    for (int i = 0; i < count; ++i) {
        // The middle decides, so that rounding at a border does not move the part along it.
        const double middle = at(0.5 * (cuts[i] + cuts[i + 1]));
        Point2 a = held(cuts[i]), b = held(cuts[i + 1]);
        if (middle >= width_) continue;
        if (middle <= 0) a.x = b.x = 0;
        part(a, b, sign, values);
    }
}

/// An edge within the picture, downwards.
void Raster::part(const Point2& from, const Point2& to, double sign,
                  std::span<const double> values) {
    const double slope = (to.x - from.x) / (to.y - from.y);
    const double least = std::min(from.x, to.x), most = std::max(from.x, to.x);
    double x = from.x;
    const int last = std::min(height_ - 1, static_cast<int>(to.y));
    for (int row = static_cast<int>(from.y); row <= last; ++row) {
        const double top = std::max(from.y, static_cast<double>(row)),
                     bottom = std::min(to.y, row + 1.0), height = bottom - top;
        if (!(height > 0)) continue;
        const double next = bottom == to.y ? to.x : std::clamp(x + slope * height, least, most);
        const double left = std::min(x, next), right = std::max(x, next);
        const double steepness = right > left ? 1 / (right - left) : 0;
        // Right of the edge lies, at t, the part (t - left) / (right - left) of the row's height;
        // its mean over each column is what the column's pixel is covered by.
        double before = 0;
        int column = static_cast<int>(left);
        do {
            const double a = std::max(left, static_cast<double>(column)),
                         b = std::min(right, column + 1.0);
            const double covered =
                0.5 * steepness * (b - a) * ((a - left) + (b - left)) + (column + 1 - b);
            put(column, row, sign * height * (covered - before), values);
            before = covered;
        } while (++column < right);
        put(column, row, sign * height * (1 - before), values);
        x = next;
    }
}

}  // namespace icespar
