// One branch of the tree of light behind a pixel, followed from the camera.
#pragma once

#include <array>

#include "interface/interface.hpp"
#include "polarisation/stokes.hpp"
#include "render/world.hpp"

namespace icespar {

/// A wave launched from the sensor. By reciprocity (symmetric permittivity) the field that the
/// sensor receives along its x axis from a field E at the far end is u_x . E, unconjugated, where
/// u_x is what a unit wave launched with polarisation x has become there; likewise y. Amplitudes
/// are normalised to normal flux, so that |amplitude|^2 are powers and the n^2 of radiance cancels.
struct Branch {
    Vec3 position, ray;   ///< energy moves along `ray`
    Vec3 k;               ///< wave vector
    int gem = -1;         ///< inside this gem, or -1 outside
    int facet = -1;       ///< inside: the facet just left
    Departure from;       ///< outside: the object just left
    Mode mode = Mode::s;  ///< inside a birefringent gem: which of its two
    /// Unit polarisations that belong to the two columns of `amplitude`. In a birefringent gem only
    /// the first, the mode's E; in a biaxial or active one the real and the imaginary part of E.
    std::array<Vec3, 2> basis;
    /// [sensor axis x or y][basis vector]; in a birefringent gem only column 0, of `mode`, and
    /// where there is a twin column 1, of its mode.
    std::array<std::array<Complex, 2>, 2> amplitude{};
    /// After a diffuse surface only the power counts: the sensor's response to unit power there.
    Stokes response;
    bool diffused = false;
    bool one_wavelength = false;  ///< the path depends on the wavelength it is traced at
    int twin = -1;      ///< in an active gem: number of the Twin that shares the path, or -1
    int hits = 0;       ///< interface events so far
    int bounces = 0;    ///< diffuse surfaces so far
    double weight = 1;  ///< power that reaches the sensor's S0 from unit unpolarised radiance

    [[nodiscard]] double power() const {
        double sum = 0;
        for (const auto& row : amplitude) sum += std::norm(row[0]) + std::norm(row[1]);
        return 0.5 * sum;
    }
    void scale(double power_factor) {
        const double f = std::sqrt(power_factor);
        for (auto& row : amplitude) row = {f * row[0], f * row[1]};
        weight *= power_factor;
    }

    /// What the sensor sees of unpolarised unit radiance coming in along this branch.
    [[nodiscard]] Stokes unpolarised() const;
    /// What it sees of polarised radiance whose Stokes vector refers to unit vectors x, y across
    /// the ray.
    [[nodiscard]] Stokes polarised(const Stokes& light, const Vec3& x, const Vec3& y) const;

    static Branch from_sensor(const Vec3& origin, const Vec3& direction, const Vec3& right);
};

/// The slow mode that left an event beside the fast one of a branch.
struct Twin {
    Vec3 k, ray;
    std::array<Vec3, 2> basis;  ///< real and imaginary part of E
};

}  // namespace icespar
