// Every light that leaves a surface or the surroundings, with its colour worked out once.
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace icespar {

/// A spectral radiance together with its exact colour and band means.
struct Emitter {
    Spectrum radiance;
    Rgb rgb{};
    std::vector<double> bands;
    Emitter(Spectrum spectrum, int band_count);
};

/// Equal bands over the rendered range.
struct Bands {
    int count = 0;
    [[nodiscard]] double width() const { return (longest_nm - shortest_nm) / count; }
    [[nodiscard]] double centre(int band) const { return shortest_nm + (band + 0.5) * width(); }
    [[nodiscard]] int of(double wavelength_nm) const;
};

struct Palette {
    /// Emission at strength 1 of each of a thing's colours: pigment times tint times D65.
    std::vector<std::vector<Emitter>> things;
    Emitter below, above;      ///< the environment's ends
    std::vector<Emitter> sky;  ///< the colours of its pattern
    Emitter illuminant;
    std::vector<Emitter> discs;
    Palette(const Scene& scene, int band_count);
};

}  // namespace icespar
