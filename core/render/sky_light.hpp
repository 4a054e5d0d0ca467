// What shines from one direction of the surroundings.
#pragma once

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

/// All of a sky that is not polarised.
template <class Visit>
void sky_light(const Environment& sky, const Palette& palette, const Vec3& direction,
               const Visit& visit) {
    if (sky.formulas.empty()) {
        smooth_light(sky, palette, direction, visit);
    } else {
        visit(palette.illuminant, formula_light(sky, direction).s0);
    }
    lamp_light(sky, palette, direction, visit);
}

}  // namespace icespar
