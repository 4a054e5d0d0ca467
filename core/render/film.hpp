// The picture while it is being made: sums per pixel, and how sure they are.
#pragma once

#include <vector>

#include "image/image.hpp"
#include "polarisation/stokes.hpp"
#include "render/palette.hpp"

namespace icespar {

/// Draws wavelengths in proportion to what the eye makes of them.
class WavelengthSampler {
public:
    /// `uniform`: evenly over the rendered range, for pictures in bands.
    explicit WavelengthSampler(bool uniform);
    struct Draw {
        double wavelength_nm;
        Rgb rgb;             ///< colour of unit spectral radiance, over the density
        double per_density;  ///< 1 / density, nm
    };
    [[nodiscard]] Draw draw(double u) const;

private:
    bool uniform_;
    std::vector<double> cumulative_;  ///< per nm of the rendered range, from 0 to 1
    std::vector<std::size_t>
        start_;             ///< of equal parts of the unit interval: where they begin there
    std::vector<Rgb> rgb_;  ///< of unit spectral radiance, at each nm
};

/// Sums of one pixel's samples. A component is S0 alone or S0..S3; channels are R, G, B and the
/// bands.
class Film {
public:
    Film(int width, int height, int bands, bool stokes);

    [[nodiscard]] int channels() const { return 3 + bands_.count; }
    [[nodiscard]] int components() const { return components_; }
    [[nodiscard]] const Bands& bands() const { return bands_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// Adds one sample, which counts as `weight` of them: channels() x components() values. Returns
    /// false, and adds nothing, when one of them is not finite or beyond 1e30.
    bool add(int x, int y, const std::vector<double>& sample, int weight = 1);

    /// Ends a pixel's pass: a run of samples that cover pixel and spectrum evenly together.
    /// `variance` of the mean luminance of the pass's samples, where it is known (not negative).
    void end_pass(int x, int y, double variance = -1);

    /// Variance of the luminance of each pixel, from how much its passes differ, since samples
    /// within a pass are not independent, unless every pass told its own. Neighbours share what
    /// they know: the mean over 5x5 pixels. Empty while a pixel has ended fewer than 2 passes.
    [[nodiscard]] std::vector<double> variances() const;
    [[nodiscard]] double mean_luminance() const;

    /// With the standard error of each pixel's luminance where `variances` are given.
    [[nodiscard]] Image image(const std::vector<double>& variances = {}) const;

    /// Of all samples: pixel by pixel, channel by channel, component by component.
    [[nodiscard]] const std::vector<double>& sums() const { return sums_; }

private:
    [[nodiscard]] std::size_t pixel(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    int width_, height_, components_;
    Bands bands_;
    struct Spread {
        double before = 0;   ///< luminance summed over the passes that ended
        double squares = 0;  ///< of each pass's sum, over the pass's weight
        double known = 0;    ///< variance of `before`, as far as the passes told
        int passes = 0, samples = 0, told = 0;
    };
    std::vector<double> sums_;
    std::vector<Spread> spread_;
    std::vector<int> samples_;
};

}  // namespace icespar
