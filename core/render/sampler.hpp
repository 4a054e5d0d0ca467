// A guide for the walker: roulette, and the sum of what one sample of a pixel sees.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "render/branch.hpp"
#include "render/film.hpp"
#include "render/random.hpp"

namespace icespar {

/// A branch that carries less of the pixel's light than this plays roulette (docs/method.md).
inline constexpr double roulette_weight = 0.1;
/// Outside a stone it costs one look at the surroundings, so it is followed for less.
inline constexpr double outside_weight = 0.01;
/// Light that is all but caught in a stone, or in a white room, ends by chance, too.
inline constexpr int patient_hits = 256, patient_bounces = 8;
inline constexpr double patience = 0.9;

/// Follows branches by roulette and adds what they see to one sample of a pixel.
class Sampler {
public:
    Sampler(const Film& film, const WavelengthSampler& wavelengths, int max_hits)
        : bands_(film.bands()),
          components_(film.components()),
          max_hits_(max_hits),
          wavelengths_(wavelengths),
          sample(static_cast<std::size_t>(film.channels() * film.components())) {}

    void begin(std::uint64_t seed) {
        random_ = Random(seed);
        std::fill(sample.begin(), sample.end(), 0.0);
    }
    void at_wavelength(double u) { draw_ = wavelengths_.draw(u); }
    double uniform() { return random_.uniform(); }
    [[nodiscard]] double wavelength_nm() const { return draw_.wavelength_nm; }

    bool admit(Branch& b) {
        double survival =
            std::min(1.0, b.weight / (b.gem < 0 ? outside_threshold : inside_threshold));
        if (b.hits > patient_hits || b.bounces > patient_bounces)
            survival = std::min(survival, patience);
        if (survival >= 1) return true;
        if (!(random_.uniform() < survival)) return false;
        if (b.diffused) {
            b.response = (1 / survival) * b.response;
            b.weight /= survival;
        } else {
            b.scale(1 / survival);
        }
        return true;
    }
    [[nodiscard]] bool may_meet(const Branch& b) const {
        return max_hits_ == 0 || b.hits < max_hits_;
    }
    void lose(const Stokes& response) { dropped += response.s0; }
    void absorb(const Stokes& response) { absorbed += response.s0; }

    void see(const Emitter& light, const Stokes& seen, bool one_wavelength) {
        if (one_wavelength) return see_at_wavelength(light.radiance(draw_.wavelength_nm), seen);
        for (int c = 0; c < 3; ++c) add(c, light.rgb[static_cast<std::size_t>(c)], seen);
        for (int b = 0; b < bands_.count; ++b) {
            add(3 + b, light.bands[static_cast<std::size_t>(b)], seen);
        }
    }
    void see_at_wavelength(double radiance, const Stokes& seen) {
        for (int c = 0; c < 3; ++c) add(c, radiance * draw_.rgb[static_cast<std::size_t>(c)], seen);
        if (bands_.count > 0) {
            add(3 + bands_.of(draw_.wavelength_nm), radiance * draw_.per_density / bands_.width(),
                seen);
        }
    }
    /// A part of the spectrum: one component, of a light whose channels are known.
    void see(std::span<const double> radiance, std::size_t component, double seen) {
        double* at = &sample[component];
        for (const double r : radiance) {
            *at += r * seen;
            at += components_;
        }
    }
    [[nodiscard]] int diffuse_rays(const Branch&) const { return 1; }
    std::pair<double, double> light_point() { return diffuse_point(0, 1); }
    std::pair<double, double> diffuse_point(int ray, int rays) {
        const double u = (ray + random_.uniform()) / rays;
        return {u, random_.uniform()};
    }

private:
    void add(int channel, double value, const Stokes& seen) {
        double* at = &sample[static_cast<std::size_t>(channel * components_)];
        at[0] += value * seen.s0;
        if (components_ == 4) {
            at[1] += value * seen.s1;
            at[2] += value * seen.s2;
            at[3] += value * seen.s3;
        }
    }

    Bands bands_;
    int components_, max_hits_;
    const WavelengthSampler& wavelengths_;
    WavelengthSampler::Draw draw_{};
    Random random_{0};

public:
    std::vector<double> sample;
    double dropped = 0, absorbed = 0;
    double inside_threshold = roulette_weight, outside_threshold = outside_weight;
};

}  // namespace icespar
