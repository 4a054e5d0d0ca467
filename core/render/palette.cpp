// Colours worked out once.
#include "render/palette.hpp"

#include <algorithm>

namespace icespar {

int Bands::of(double wavelength_nm) const {
    return std::clamp(static_cast<int>((wavelength_nm - shortest_nm) / width()), 0, count - 1);
}

Emitter::Emitter(Spectrum spectrum, int band_count)
    : radiance(std::move(spectrum)), rgb(rgb_of(radiance)) {
    const Bands layout{band_count};
    constexpr int steps = 64;
    for (int b = 0; b < band_count; ++b) {
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            sum += radiance(layout.centre(b) + ((i + 0.5) / steps - 0.5) * layout.width());
        }
        bands.push_back(sum / steps);
    }
}

Palette::Palette(const Scene& scene, int band_count)
    : below(scene.environment.illuminant * scene.environment.below, band_count),
      above(scene.environment.illuminant * scene.environment.above, band_count),
      illuminant(scene.environment.illuminant, band_count) {
    for (const Disc& disc : scene.environment.discs) {
        discs.emplace_back(scene.environment.illuminant * disc.radiance, band_count);
    }
    if (scene.environment.pattern) {
        for (const Spectrum& colour : scene.environment.pattern->colours) {
            sky.emplace_back(scene.environment.illuminant * colour, band_count);
        }
    }
    for (const Thing& thing : scene.things) {
        std::vector<Emitter>& paints = things.emplace_back();
        if (thing.finish.emission == 0) continue;
        for (const Spectrum& colour : thing.pigment.colours) {
            paints.emplace_back(colour * thing.finish.tint * white(), band_count);
        }
    }
}

}  // namespace icespar
