// What shines from one direction of the surroundings.
#pragma once

#include <cmath>

#include "render/palette.hpp"
#include "render/surface.hpp"

namespace icespar {

/// Calls visit(emitter, strength) for each colour of a gradient's or pattern's light.
template <class Visit>
void smooth_light(const Environment& sky, const Palette& palette, const Vec3& direction,
                  const Visit& visit) {
    if (sky.pattern) {
        const Mix mix = mix_at(*sky.pattern, direction, direction);
        for (std::size_t i = 0; i < static_cast<std::size_t>(mix.count); ++i) {
            visit(palette.sky[mix.colour[i]], mix.share[i]);
        }
    } else {
        const double height = 0.5 * (1 + dot(direction, sky.up));
        visit(palette.below, 1 - height);
        visit(palette.above, height);
    }
}

/// The same for each lamp.
template <class Visit>
void lamp_light(const Environment& sky, const Palette& palette, const Vec3& direction,
                const Visit& visit) {
    for (std::size_t i = 0; i < sky.discs.size(); ++i) {
        const Disc& disc = sky.discs[i];
        if (dot(direction, disc.direction) >= disc.cos_radius) visit(palette.discs[i], 1.0);
    }
}

/// The y of the sky's Stokes vectors: unit, across the direction, as near to `up` as can be.
[[nodiscard]] inline Vec3 up_across(const Vec3& direction, const Vec3& up) {
    Vec3 pole = up;
    if (std::abs(dot(direction, up)) >= 1 - 1e-12) {
        pole = std::abs(up.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    }
    return normalised(pole - dot(pole, direction) * direction);
}

/// All of a sky: see(emitter, seen), where seen_of(stokes, up) is what is seen of
/// light of that Stokes vector, on axes of which y is towards `up`.
template <class SeenOf, class See>
void sky_light(const Environment& sky, const Palette& palette, const Vec3& direction,
               const SeenOf& seen_of, const See& see) {
    const Stokes seen = seen_of(sky.state, Vec3{0, 1, 0});
    const auto add = [&](const Emitter& light, double strength) { see(light, strength * seen); };
    if (sky.formulas.empty()) {
        smooth_light(sky, palette, direction, add);
    } else {
        const Vec3 up = normalised(sky.to_own.inverse().vector({0, 1, 0}));
        see(palette.illuminant, seen_of(formula_light(sky, direction), up));
    }
    lamp_light(sky, palette, direction, add);
}

}  // namespace icespar
