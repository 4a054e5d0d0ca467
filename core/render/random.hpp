// Numbers for sampling: a hash-seeded generator, and a lattice that fills pixel and spectrum
// evenly.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "math/vec3.hpp"

namespace icespar {

/// SplitMix64's finaliser (Steele, Lea and Flood 2014): neighbouring inputs give unrelated outputs.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// Uniform in [0, 1).
    double uniform() {
        state_ += 0x9e3779b97f4a7c15u;
        return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

struct CameraSample {
    double x, y;        ///< within the pixel, [0, 1)
    double wavelength;  ///< [0, 1), for the wavelength's distribution
};

/// Point number `index` of additive recurrences, shifted by a random vector of the pixel (Cranley
/// and Patterson 1976): over the pixel by powers of the plastic number (Roberts 2018), over the
/// wavelengths by the golden ratio, so that any run of samples covers the spectrum evenly.
[[nodiscard]] inline CameraSample camera_sample(std::uint64_t pixel_seed, std::uint64_t index) {
    constexpr double plastic = 1.3247179572447460;
    constexpr double steps[3] = {1 / plastic, 1 / (plastic * plastic), 1 / std::numbers::phi};
    const auto coordinate = [&](int d) {
        const double shift =
            static_cast<double>(mixed(pixel_seed + static_cast<unsigned>(d)) >> 11) * 0x1p-53;
        const double v = shift + static_cast<double>(index) * steps[d];
        return v - std::floor(v);
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
}

struct LensSample {
    double a, b;  ///< [0, 1)
};

/// The same over the lens, by other irrational steps.
[[nodiscard]] inline LensSample lens_sample(std::uint64_t pixel_seed, std::uint64_t index) {
    const auto coordinate = [&](unsigned d, double step) {
        const double shift = static_cast<double>(mixed(pixel_seed + d) >> 11) * 0x1p-53;
        const double v = shift + static_cast<double>(index) * step;
        return v - std::floor(v);
    };
    return {coordinate(3, std::numbers::sqrt2), coordinate(4, std::numbers::sqrt3)};
}

/// Cosine-weighted direction about the unit normal n.
[[nodiscard]] inline Vec3 cosine_direction(const Vec3& n, double u, double v) {
    const double r = std::sqrt(u), phi = 2 * std::numbers::pi * v;
    const Vec3 a = any_perpendicular(n), b = cross(n, a);
    return normalised(r * std::cos(phi) * a + r * std::sin(phi) * b + std::sqrt(1 - u) * n);
}

}  // namespace icespar
