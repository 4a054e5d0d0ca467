// Patterns on opaque surfaces.
#include "render/surface.hpp"

#include <cmath>

namespace icespar {
namespace {

/// A surface that lies in a cell's wall belongs to the cell above it whatever rounding says.
constexpr double wall = 1e-9;

bool on_line(double coordinate, double width) {
    return std::abs(coordinate - std::round(coordinate)) < 0.5 * width;
}

}  // namespace

bool shows_first(const Pigment& pigment, const Vec3& point, const Vec3& normal) {
    if (pigment.kind == Pigment::Kind::plain) return true;
    const Vec3 p = pigment.to_pattern.point(point);
    if (pigment.kind == Pigment::Kind::checker) {
        const double cell =
            std::floor(p.x + wall) + std::floor(p.y + wall) + std::floor(p.z + wall);
        return std::fmod(std::abs(cell), 2) < 0.5;
    }
    const Vec3 n = normalised(pigment.to_pattern.normal(normal));
    constexpr double parallel = 1 - 1e-9;
    return (std::abs(n.x) < parallel && on_line(p.x, pigment.line_width)) ||
           (std::abs(n.y) < parallel && on_line(p.y, pigment.line_width)) ||
           (std::abs(n.z) < parallel && on_line(p.z, pigment.line_width));
}

}  // namespace icespar
