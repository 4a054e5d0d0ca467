// Pictures of a lone stone in a parallel view, by exact beams: no samples, no noise.
#pragma once

#include <string>

#include "render/film.hpp"
#include "render/render.hpp"

namespace icespar {

/// Why exact beams cannot make this scene's picture; empty when they can.
[[nodiscard]] std::string view_obstacle(const Scene& scene);

struct ViewPicture {
    double dropped = 0;       ///< mean light per pixel that was neither followed nor sampled
    double absorbed = 0;      ///< mean light per pixel that the stone kept
    double variance = 0;      ///< of the sample of the rest, summed over the pixels' luminance
    double error = 0;         ///< by that the relative RMS error of the picture
    std::uint64_t beams = 0;  ///< followed from one facet to the next
    int wavelengths = 1;
    bool interrupted = false;  ///< nothing was added to the film
};

/// Adds the picture to the film as one sample. Follows light exactly until a sample of the rest has
/// about the relative error options.error (0.004 when that is 0; then until a thousandth is left,
/// at least) or for options.seconds; a stone that treats wavelengths differently is traced for
/// options.samples of them (64 when that is 0).
[[nodiscard]] ViewPicture add_view(const Scene& scene, const Palette& palette,
                                   const WavelengthSampler& wavelengths,
                                   const RenderOptions& options, const ProgressCallback& progress,
                                   Film& film);

}  // namespace icespar
