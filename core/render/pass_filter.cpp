// Polariser, wave plate and grey filter, each a symmetric matrix, so that light and the waves
// launched from the sensor pass alike.
#include "render/pass_filter.hpp"

#include <cmath>
#include <numbers>

namespace icespar {
namespace {

/// Refers the amplitudes to e and to the unit vector across it.
bool refer_to(Branch& b, Vec3 e) {
    const double size = length(e);
    if (!(size > 1e-12)) return false;
    e = e / size;
    const std::array<Vec3, 2> basis{e, cross(b.ray, e)};
    for (auto& row : b.amplitude) {
        const auto old = row;
        for (std::size_t i = 0; i < 2; ++i) {
            row[i] = old[0] * dot(b.basis[0], basis[i]) + old[1] * dot(b.basis[1], basis[i]);
        }
    }
    b.basis = basis;
    return true;
}

}  // namespace

bool pass_filter(Branch& b, const Filter& filter, const Vec3& normal, double wavelength_nm) {
    if (filter.kind == Filter::Kind::neutral) {
        if (filter.transmission <= 0) return false;
        b.scale(filter.transmission);
        return true;
    }
    if (filter.kind == Filter::Kind::polariser) {
        // What passes has no field along the fibres, which lie in the sheet across the axis.
        if (!refer_to(b, cross(b.ray, cross(normal, filter.axis)))) return false;
        for (auto& row : b.amplitude) row[1] = 0;
        return true;
    }
    // The slow wave has no field along the fast axis, and lies behind by the retardance.
    if (!refer_to(b, cross(b.ray, filter.axis))) return true;
    const Complex behind =
        std::polar(1.0, 2 * std::numbers::pi * filter.retardance_nm / wavelength_nm);
    for (auto& row : b.amplitude) row[0] *= behind;
    b.one_wavelength = true;
    return true;
}

}  // namespace icespar
