// What leaves see of a sky of smooth gradient and round lamps, in all colours of a piece of the
// spectrum at once.
#pragma once

#include <cmath>
#include <vector>

#include "beams/expansion.hpp"
#include "render/palette.hpp"
#include "render/sampler.hpp"

namespace icespar {

/// Sums responses by light and narrow band of the spectrum, so that one path paints the rainbow
/// that it makes of a lamp. A colour c is 1 / wavelength^2 in 1/um^2: indices are nearly linear in
/// it.
class SkySpectrum {
public:
    SkySpectrum(const Environment& sky, const Palette& palette,
                const WavelengthSampler& wavelengths, int bands, int components);

    /// Narrow bands, of equal importance to the eye, or of equal width in pictures with bands,
    /// each of which is made up of whole ones.
    [[nodiscard]] int cells() const { return static_cast<int>(cells_); }

    /// The leaves that follow are those of the middle of cells `first` to `last` - 1: its
    /// wavelength.
    double begin(int first, int last);

    /// `k`: unit wave vectors over the polygon, whose centroid is the origin; `fan`: dk/dc.
    void add(const Expansion& k, const Vec3& fan, PolygonView polygon, double area,
             const Stokes& response);

    /// Hands the sums to the sampler and starts anew.
    void flush(Sampler& sampler);

    [[nodiscard]] static double colour(double wavelength_nm) {
        return 1e6 / (wavelength_nm * wavelength_nm);
    }
    [[nodiscard]] static double wavelength_nm(double colour) { return 1e3 / std::sqrt(colour); }

private:
    void add_lamp(std::size_t light, const Expansion& k, const Vec3& fan, PolygonView polygon,
                  double area, const Stokes& response, int halvings);
    /// part(c) of the response, c being counted from the middle.
    template <class Part>
    void add_light(std::size_t light, const Stokes& response, const Part& part);

    const Environment& sky_;
    const WavelengthSampler& wavelengths_;
    std::size_t components_, channels_, cells_;
    std::size_t lights_;            ///< below, above, then the discs
    std::vector<double> colours_;   ///< of cells
    std::vector<double> radiance_;  ///< [light][cell][channel]
    std::vector<double> seen_;      ///< [component][light][cell]
    std::size_t first_ = 0, last_ = 0;
    double middle_ = 0;
};

}  // namespace icespar
