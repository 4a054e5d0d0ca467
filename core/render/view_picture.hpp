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
    double error = 0;         ///< the relative RMS error of the picture, by the sample of the rest
    std::uint64_t beams = 0;  ///< followed from one facet to the next
    int wavelengths = 0;      ///< traced; 0: nothing was added to the film
    bool interrupted = false;
};

/// Adds the picture to the film as one sample. Follows light exactly until a sample of the rest has
/// about the relative error options.error, and adds samples until it has (sixteen at most; when it
/// is 0, until about 0.004, and a thousandth at least is left), or for options.seconds; a stone
/// that treats wavelengths differently is traced for options.samples of them (when that is 0, 16,
/// or 4 where it parts none). Interrupted, it adds the wavelengths that are done, as bright
/// together as all are; of one wavelength what was followed; of the first few of many a coarse
/// picture.
[[nodiscard]] ViewPicture add_view(const Scene& scene, const Palette& palette,
                                   const WavelengthSampler& wavelengths,
                                   const RenderOptions& options, const ProgressCallback& progress,
                                   Film& film);

}  // namespace icespar
