// What leaves see of a sky of smooth gradient and round lamps, in all colours of a piece of the
// spectrum at once.
#pragma once

#include <cmath>
#include <span>
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
                const WavelengthSampler& wavelengths, int bands, int components,
                std::size_t least_cells, std::size_t pixels);

    /// Narrow bands, of equal importance to the eye, or of equal width in pictures with bands,
    /// each of which is made up of whole ones. No fewer than `least_cells`.
    [[nodiscard]] int cells() const { return static_cast<int>(cells_); }

    /// The leaves that follow are those of the middle of cells `first` to `last` - 1: its
    /// wavelength. Where paths of all colours end is wrong by as much on either side of it, so that
    /// hardly any of the error is one of luminance: two thirds of the weights are luminances.
    double begin(int first, int last);

    /// `k`: unit wave vectors over the polygon, whose centroid is the origin; `fan`: dk/dc. `tint`:
    /// factors of the response, one a cell; none are 1.
    /// Returns the luminance, but for how lines lean.
    double add(std::size_t pixel, const Expansion& k, const Vec3& fan, PolygonView polygon,
               double area, const Stokes& response, std::span<const double> tint = {});

    /// Hands a pixel's sums to the sampler and starts it anew.
    void flush(std::size_t pixel, Sampler& sampler);

    [[nodiscard]] static double colour(double wavelength_nm) {
        return 1e6 / (wavelength_nm * wavelength_nm);
    }
    [[nodiscard]] static double wavelength_nm(double colour) { return 1e3 / std::sqrt(colour); }

private:
    /// Of light and colour: the sum over all cells below, of 1 and of c.
    struct Radiance {
        double whole = 0, slope = 0;
    };
    struct Line {
        double value = 0, slope = 0;
    };

    void add_lamp(std::size_t number, const Expansion& k, const Vec3& fan, PolygonView polygon,
                  double area, const Stokes& response, double across, double swing, int halvings);
    /// The response value + slope c, c being counted from the middle.
    void add_line(std::size_t light, const Stokes& value, const Stokes& slope);
    /// That times the tint of the leaf.
    void add_line(std::size_t light, const Stokes& response, double value, double slope);
    /// The response times part(c) and the tint.
    template <class Part>
    void add_light(std::size_t light, const Stokes& response, const Part& part);
    /// The response times part(number of the cell).
    template <class Part>
    void add_cells(std::size_t light, const Stokes& response, const Part& part);
    /// What a pixel has seen.
    struct Seen {
        std::vector<Line> lines;         ///< [component][light]: of this piece
        std::vector<double> cell_light;  ///< [component][light][cell]: what is no line
        std::vector<char> in_cells;      ///< [component][light]: there is such
        std::vector<double> sums;        ///< [component][channel]
    };
    /// Lines of the piece to channels.
    void end_piece(Seen& seen);

    const Environment& sky_;
    std::size_t components_, channels_, cells_;
    std::size_t lights_;              ///< below, above, then the discs
    std::vector<double> colours_;     ///< of cells
    std::vector<double> sight_;       ///< of cells: what they weigh in the middle of a piece
    std::vector<double> radiance_;    ///< [light][channel][cell]
    std::vector<Radiance> up_to_;     ///< [light][cell, and the end][channel]
    std::vector<Seen> seen_;          ///< [pixel]
    Seen* own_ = nullptr;             ///< of the leaf's pixel
    std::vector<double> brightness_;  ///< luminance of each light [light][cell]
    std::vector<double> in_piece_;    ///< and of its whole piece
    std::span<const double> tint_;    ///< of the leaf
    double luminance_ = 0;            ///< of the leaf
    std::size_t first_ = 0, last_ = 0;
    double middle_ = 0;
};

}  // namespace icespar
