// The edge of a lamp crosses a leaf while the colour changes: each cell takes the part that is lit.
#include "render/sky_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "render/lamp_edge.hpp"

namespace icespar {
namespace {

std::size_t cells_for(std::size_t bands) {
    constexpr std::size_t enough = 64;
    return bands == 0 ? enough : bands * ((enough + bands - 1) / bands);
}

}  // namespace

SkySpectrum::SkySpectrum(const Environment& sky, const Palette& palette,
                         const WavelengthSampler& wavelengths, int bands, int components)
    : sky_(sky),
      wavelengths_(wavelengths),
      components_(static_cast<std::size_t>(components)),
      channels_(static_cast<std::size_t>(3 + bands)),
      cells_(cells_for(static_cast<std::size_t>(bands))),
      lights_(2 + sky.discs.size()),
      radiance_(lights_ * cells_ * channels_),
      seen_(components_ * lights_ * cells_) {
    std::vector<const Emitter*> lights{&palette.below, &palette.above};
    for (const Emitter& e : palette.discs) lights.push_back(&e);
    const Bands layout{bands};
    constexpr int points = 32;
    const double whole = static_cast<double>(cells_);
    for (std::size_t cell = 0; cell < cells_; ++cell) {
        const auto at = [&](double part) {
            return wavelengths.draw((static_cast<double>(cell) + part) / whole);
        };
        colours_.push_back(colour(at(0.5).wavelength_nm));
        for (int i = 0; i < points; ++i) {
            const auto draw = at((i + 0.5) / points);
            for (std::size_t l = 0; l < lights_; ++l) {
                const double radiance = lights[l]->radiance(draw.wavelength_nm) / (points * whole);
                double* channel = &radiance_[(l * cells_ + cell) * channels_];
                for (std::size_t c = 0; c < 3; ++c) channel[c] += radiance * draw.rgb[c];
                if (bands == 0) continue;
                channel[3 + layout.of(draw.wavelength_nm)] +=
                    radiance * draw.per_density / layout.width();
            }
        }
    }
}

double SkySpectrum::begin(int first, int last) {
    first_ = static_cast<std::size_t>(first);
    last_ = static_cast<std::size_t>(last);
    const double nm = wavelengths_.draw(0.5 * (first + last) / cells()).wavelength_nm;
    middle_ = colour(nm);
    return nm;
}

template <class Part>
void SkySpectrum::add_light(std::size_t light, const Stokes& response, const Part& part) {
    const double parts[4] = {response.s0, response.s1, response.s2, response.s3};
    for (std::size_t c = 0; c < components_; ++c) {
        double* seen = &seen_[(c * lights_ + light) * cells_];
        for (std::size_t i = first_; i < last_; ++i) {
            seen[i] += parts[c] * part(colours_[i] - middle_);
        }
    }
}

void SkySpectrum::add(const Expansion& k, const Vec3& fan, PolygonView polygon, double area,
                      const Stokes& response) {
    const double height = 0.5 * (1 + dot(k.value, sky_.up)), slope = 0.5 * dot(fan, sky_.up);
    add_light(0, area * response, [&](double c) { return 1 - height - slope * c; });
    add_light(1, area * response, [&](double c) { return height + slope * c; });
    constexpr int halvings = 8;
    for (std::size_t i = 0; i < sky_.discs.size(); ++i) {
        add_lamp(i, k, fan, polygon, area, response, halvings);
    }
}

void SkySpectrum::add_lamp(std::size_t number, const Expansion& k, const Vec3& fan,
                           PolygonView polygon, double area, const Stokes& response, int halvings) {
    const Disc& disc = sky_.discs[number];
    const double across = spread(k, polygon);
    const double swing =
        length(fan) * std::max(colours_[first_] - middle_, middle_ - colours_[last_ - 1]);
    const double inside = dot(k.value, disc.direction) - disc.cos_radius;
    if (inside <= -across - swing) return;
    const std::size_t light = 2 + number;
    const auto all = [](double) { return 1.0; };
    if (inside >= across + swing) return add_light(light, area * response, all);
    constexpr double still = 0.1;
    if (swing < still * across) {
        return add_light(light, lit_area(disc, k, polygon, area, halvings) * response, all);
    }
    if (!edge_is_straight(disc, across) && halvings > 0) {
        Polygon half;
        for (const double side : {-1.0, 1.0}) {
            Expansion there = k;
            const double part = halve(there, polygon, side, half);
            if (part > 0) add_lamp(number, there, fan, half, part, response, halvings - 1);
        }
        return;
    }
    // The part beyond a straight edge that moves over a polygon rises from 0 to 1: a ramp of the
    // same mean and variance.
    const Moments m = moments(polygon, area);
    const double kx = dot(k.dx, disc.direction), ky = dot(k.dy, disc.direction),
                 kc = dot(fan, disc.direction);
    const double steepness = 1 / std::sqrt(12 * m.variance(kx, ky) + 1e-24);
    // k has unit length only in the middle: half its second-order part.
    const double longer = 0.5 * (m.xx * dot(k.dx, k.dx) + 2 * m.xy * dot(k.dx, k.dy) +
                                 m.yy * dot(k.dy, k.dy)),
                 longer_c2 = 0.5 * dot(fan, fan);
    const double start = 0.5 + steepness * (inside - longer * disc.cos_radius);
    const double rise = steepness * kc, bend = steepness * longer_c2 * disc.cos_radius;
    add_light(light, area * response,
              [&](double c) { return std::clamp(start + c * (rise - c * bend), 0.0, 1.0); });
}

void SkySpectrum::flush(Sampler& sampler) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        if (seen_[i] == 0) continue;
        const std::size_t per_component = lights_ * cells_;
        sampler.see({&radiance_[i % per_component * channels_], channels_}, i / per_component,
                    seen_[i]);
    }
    std::fill(seen_.begin(), seen_.end(), 0.0);
}

}  // namespace icespar
