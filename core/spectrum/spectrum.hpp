// Functions of wavelength: linear between their nodes, constant beyond the first and the last.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace icespar {

/// The rendered range; the eye sees nothing beyond.
inline constexpr double shortest_nm = 380, longest_nm = 780;

class Spectrum {
public:
    Spectrum() = default;                ///< zero everywhere
    explicit Spectrum(double constant);  ///< the same value everywhere

    /// Nodes must rise strictly in wavelength; throws Error otherwise or when a number is not
    /// finite.
    Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

    [[nodiscard]] double operator()(double wavelength_nm) const;

    /// The same value at every wavelength.
    [[nodiscard]] bool flat() const { return values_.size() < 2; }
    [[nodiscard]] double least() const {
        return values_.empty() ? 0 : *std::min_element(values_.begin(), values_.end());
    }
    [[nodiscard]] double greatest() const {
        return values_.empty() ? 0 : *std::max_element(values_.begin(), values_.end());
    }

    /// The sum of f(wavelength) over the 1 nm grid of the rendered range, times 1 nm.
    template <class F>
    static double integrate(F&& f) {
        double sum = 0.5 * (f(shortest_nm) + f(longest_nm));
        for (double nm = shortest_nm + 1; nm < longest_nm; nm += 1) sum += f(nm);
        return sum;
    }

    friend Spectrum operator+(const Spectrum& a, const Spectrum& b);
    friend Spectrum operator*(const Spectrum& a, const Spectrum& b);
    friend Spectrum operator*(double factor, const Spectrum& a);

private:
    std::vector<double> wavelengths_nm_, values_;
    double inverse_step_ = 0;  ///< above 0: the nodes are equally spaced
};

/// Linear sRGB primaries (Rec. 709, D65 white).
using Rgb = std::array<double, 3>;
using Xyz = std::array<double, 3>;

/// CIE 1931 2-degree observer at a wavelength, zero outside the rendered range; scaled so that the
/// equal-energy light E at value 1 has luminance Y = 1, and so has the illuminant D65 (see
/// `white`).
[[nodiscard]] Xyz observer(double wavelength_nm);

[[nodiscard]] Rgb rgb_from_xyz(const Xyz& xyz);
[[nodiscard]] Xyz xyz_from_rgb(const Rgb& rgb);

/// Colour of a spectral radiance L: the integral of L times the observer. `colour(white())` is
/// RGB 1, 1, 1 to rounding.
[[nodiscard]] Rgb rgb_of(const Spectrum& radiance);

/// Relative radiance of the light D65 at value 1. A table of the CIE; normalised so that the
/// equal-energy light E of luminance 1 has radiance 1 at every wavelength.
[[nodiscard]] const Spectrum& white();

/// A CIE illuminant by name, whatever the case, scaled to luminance Y = 1. Throws Error with the
/// names there are.
[[nodiscard]] Spectrum illuminant(std::string_view name);
[[nodiscard]] std::vector<std::string_view> illuminant_names();
/// Planck's law, scaled to luminance Y = 1; kelvin in 500 .. 50000.
[[nodiscard]] Spectrum blackbody(double kelvin);

/// A smooth reflectance (or filter) that looks like this linear RGB colour under D65, exactly: for
/// rgb in 0 .. 1 it lies in 0 .. 1, and rgb (1, 1, 1) is 1 at every wavelength. Linear in rgb, so
/// values above 1 serve for emission.
[[nodiscard]] Spectrum reflectance_from_rgb(const Rgb& rgb);

/// The sum, on the union of both sets of nodes.
[[nodiscard]] Spectrum operator+(const Spectrum& a, const Spectrum& b);
/// The product, on the union of both sets of nodes.
[[nodiscard]] Spectrum operator*(const Spectrum& a, const Spectrum& b);
[[nodiscard]] Spectrum operator*(double factor, const Spectrum& a);

}  // namespace icespar
