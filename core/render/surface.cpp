// Patterns: cells, lines, colour maps and pictures.
#include "render/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace icespar {
namespace {

using std::numbers::pi;

/// A surface that lies in a cell's wall belongs to the cell above it whatever rounding says.
constexpr double wall = 1e-9;

bool on_line(double coordinate, double width) {
    return std::abs(coordinate - std::round(coordinate)) < 0.5 * width;
}

Mix only(std::uint32_t colour) { return {1, {1, 0, 0}, {colour, 0, 0}}; }

bool is_on_grid(const Pigment& pigment, const Vec3& p, const Vec3& normal) {
    const Vec3 n = normalised(pigment.to_pattern.normal(normal));
    constexpr double parallel = 1 - 1e-9;
    return (std::abs(n.x) < parallel && on_line(p.x, pigment.line_width)) ||
           (std::abs(n.y) < parallel && on_line(p.y, pigment.line_width)) ||
           (std::abs(n.z) < parallel && on_line(p.z, pigment.line_width));
}

/// POV-Ray's: 1 stays 1, beyond it and below 0 the value starts over.
double repeated(double value) {
    return value > 0 && value <= 1 ? value : value - std::floor(value);
}

Mix mapped(const Pigment& pigment, double value) {
    const auto& stops = pigment.stops;
    const auto above = std::upper_bound(stops.begin(), stops.end(), value);
    const auto i = static_cast<std::uint32_t>(above - stops.begin());
    if (i == 0) return only(0);
    if (i == stops.size()) return only(i - 1);
    const double part = (value - stops[i - 1]) / (stops[i] - stops[i - 1]);
    return {2, {1 - part, part, 0}, {i - 1, i, 0}};
}

/// Where the point lies on the picture, from its upper left corner; false: beside it.
bool on_picture(const Pigment& pigment, const Vec3& p, double& x, double& y) {
    if (pigment.projection == Pigment::Projection::plane) {
        x = p.x;
        y = 1 - p.y;
        if (pigment.once) return x >= 0 && x <= 1 && y >= 0 && y <= 1;
        x -= std::floor(x);
        y -= std::floor(y);
        return true;
    }
    const double size = length(p);
    if (!(size > 0)) return false;
    y = 0.5 - std::asin(std::clamp(p.y / size, -1.0, 1.0)) / pi;
    if (pigment.projection == Pigment::Projection::sphere) {
        x = std::atan2(p.z, p.x) / (2 * pi);
        x -= std::floor(x);
    } else {
        x = 0.5 + std::atan2(p.x, p.z) / (2 * pi);
    }
    return true;
}

Mix pictured(const Pigment& pigment, const Vec3& p) {
    double x = 0, y = 0;
    if (!on_picture(pigment, p, x, y)) return {0, {}, {}};
    const Picture& picture = *pigment.picture;
    if (pigment.smooth) {
        const bool round = pigment.projection == Pigment::Projection::plane && !pigment.once;
        return {3, picture.between(x, y, round), {0, 1, 2}};
    }
    const auto cell = [](double t, int size) {
        return std::clamp(static_cast<int>(std::floor(t * size)), 0, size - 1);
    };
    return {3, picture.pixel(cell(x, picture.width), cell(y, picture.height)), {0, 1, 2}};
}

}  // namespace

Mix mix_at(const Pigment& pigment, const Vec3& point, const Vec3& normal) {
    if (pigment.kind == Pigment::Kind::plain) return only(0);
    const Vec3 p = pigment.to_pattern.point(point);
    switch (pigment.kind) {
        case Pigment::Kind::checker: {
            const double cell =
                std::floor(p.x + wall) + std::floor(p.y + wall) + std::floor(p.z + wall);
            return only(std::fmod(std::abs(cell), 2) < 0.5 ? 0 : 1);
        }
        case Pigment::Kind::grid:
            return only(is_on_grid(pigment, p, normal) ? 0 : 1);
        case Pigment::Kind::gradient:
            return mapped(pigment, repeated(dot(pigment.axis, p)));
        default:
            return pictured(pigment, p);
    }
}

}  // namespace icespar
