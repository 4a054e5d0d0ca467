// One part of the spectrum in a picture by exact beams: traced, lit and drawn.
#pragma once

#include <functional>
#include <vector>

#include "render/film.hpp"
#include "render/render.hpp"
#include "views/raster.hpp"
#include "views/view.hpp"

namespace icespar {

/// What light of a part of the spectrum made of the picture.
struct PaintedPart {
    double dropped = 0;         ///< mean light per pixel that was neither followed nor sampled
    double absorbed = 0;        ///< mean light per pixel that the stone kept
    double variance = 0;        ///< of the sample of the rest, summed over the pixels' luminance
    std::uint64_t beams = 0;    ///< followed from one facet to the next
    std::vector<double> white;  ///< channels of the illuminant's light in this part

    void add(const PaintedPart& other);
};

/// As many parts of the spectrum as make a good picture: of each one wavelength is traced, with
/// which others share the way that their light takes, but for its last direction.
[[nodiscard]] int parts_of(const Crystal& crystal);

class ViewPainter {
public:
    /// Traced at once, whatever the number of threads.
    static constexpr int batch = 8;

    ViewPainter(const Scene& scene, const Palette& palette, const WavelengthSampler& wavelengths,
                const RenderOptions& options, const Film& film, int pass);

    [[nodiscard]] Raster raster() const { return {film_.width(), film_.height(), values_}; }

    /// What light of part `i` of `parts` of the spectrum makes of the picture: all of it travels as
    /// that of the part's middle.
    PaintedPart paint(int i, int parts, const std::function<bool()>& go_on, Raster& raster) const;

    /// Channels of the illuminant's light in the whole spectrum.
    [[nodiscard]] std::vector<double> white() const;

private:
    /// One of the colours of a part of the spectrum.
    struct Hue {
        double place;  ///< how far along the part's fan it lies
        Absorption absorption;
        Palette colours;
    };
    /// Of the permittivity, from one place in the spectrum to another.
    [[nodiscard]] RealTensor change(const Crystal& crystal, double u0, double u1) const;
    [[nodiscard]] std::vector<Hue> hues_of(const Crystal& crystal, int i, int parts) const;
    [[nodiscard]] double squares(const std::vector<double>& sample, double area) const;
    [[nodiscard]] double pixels_of(const Stone& stone) const;
    [[nodiscard]] ViewOptions how(int parts, double pixels,
                                  const std::function<bool()>& go_on) const;

    const Scene& scene_;
    const Palette& palette_;
    const WavelengthSampler& wavelengths_;
    const RenderOptions& options_;
    const Film& film_;
    int values_;
    ParallelView view_;
    int pass_;  ///< has a sample of its own
};

}  // namespace icespar
