// The edge of a lamp crosses a leaf while the colour changes: each cell takes the part that is lit.
#include "render/sky_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "render/lamp_edge.hpp"

namespace icespar {
namespace {

std::size_t cells_for(std::size_t bands, std::size_t enough) {
    return bands == 0 ? enough : bands * ((enough + bands - 1) / bands);
}

/// Four sums side by side, which the processor takes at once.
double product(std::span<const double> a, std::span<const double> b) {
    std::array<double, 4> sums{};
    std::size_t i = 0;
    for (; i + 4 <= a.size(); i += 4) {
        for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += a[i + lane] * b[i + lane];
    }
    for (; i < a.size(); ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

SkySpectrum::SkySpectrum(const Environment& sky, const Palette& palette,
                         const WavelengthSampler& wavelengths, int bands, int components,
                         std::size_t least_cells, std::size_t pixels)
    : sky_(sky),
      components_(static_cast<std::size_t>(components)),
      channels_(static_cast<std::size_t>(3 + bands)),
      cells_(cells_for(static_cast<std::size_t>(bands), least_cells)),
      lights_(2 + sky.discs.size()),
      radiance_(lights_ * cells_ * channels_),
      up_to_(lights_ * (cells_ + 1) * channels_),
      seen_(pixels, {std::vector<Line>(components_ * lights_),
                     std::vector<double>(components_ * lights_ * cells_),
                     std::vector<char>(components_ * lights_),
                     std::vector<double>(components_ * channels_)}),
      brightness_(lights_ * cells_),
      in_piece_(lights_) {
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
        sight_.push_back(xyz_from_rgb(at(0.5).rgb)[1]);
        for (int i = 0; i < points; ++i) {
            const auto draw = at((i + 0.5) / points);
            for (std::size_t l = 0; l < lights_; ++l) {
                const double radiance = lights[l]->radiance(draw.wavelength_nm) / (points * whole);
                const auto channel = [&](std::size_t c) -> double& {
                    return radiance_[(l * channels_ + c) * cells_ + cell];
                };
                for (std::size_t c = 0; c < 3; ++c) channel(c) += radiance * draw.rgb[c];
                if (bands == 0) continue;
                channel(3 + static_cast<std::size_t>(layout.of(draw.wavelength_nm))) +=
                    radiance * draw.per_density / layout.width();
            }
        }
    }
    const double even = std::accumulate(sight_.begin(), sight_.end(), 0.0) / whole;
    for (double& s : sight_) s = 2 * s / 3 + even / 3;
    for (std::size_t l = 0; l < lights_; ++l) {
        for (std::size_t cell = 0; cell < cells_; ++cell) {
            const auto channel = [&](std::size_t c) {
                return radiance_[(l * channels_ + c) * cells_ + cell];
            };
            brightness_[l * cells_ + cell] = xyz_from_rgb({channel(0), channel(1), channel(2)})[1];
            const Radiance* before = &up_to_[(l * (cells_ + 1) + cell) * channels_];
            for (std::size_t c = 0; c < channels_; ++c) {
                const double radiance = channel(c);
                up_to_[(l * (cells_ + 1) + cell + 1) * channels_ + c] = {
                    before[c].whole + radiance, before[c].slope + radiance * colours_[cell]};
            }
        }
    }
}

double SkySpectrum::begin(int first, int last) {
    for (Seen& seen : seen_) end_piece(seen);
    first_ = static_cast<std::size_t>(first);
    last_ = static_cast<std::size_t>(last);
    double whole = 0, sum = 0;
    for (std::size_t cell = first_; cell < last_; ++cell) {
        whole += sight_[cell];
        sum += sight_[cell] * colours_[cell];
    }
    middle_ = sum / whole;
    for (std::size_t l = 0; l < lights_; ++l) {
        const auto from = brightness_.begin() + static_cast<std::ptrdiff_t>(l * cells_);
        in_piece_[l] = std::accumulate(from + first, from + last, 0.0);
    }
    return wavelength_nm(middle_);
}

void SkySpectrum::add_line(std::size_t light, const Stokes& value, const Stokes& slope) {
    luminance_ += value.s0 * in_piece_[light];
    const double values[4] = {value.s0, value.s1, value.s2, value.s3};
    const double slopes[4] = {slope.s0, slope.s1, slope.s2, slope.s3};
    for (std::size_t c = 0; c < components_; ++c) {
        Line& line = own_->lines[c * lights_ + light];
        line.value += values[c];
        line.slope += slopes[c];
    }
}

void SkySpectrum::add_line(std::size_t light, const Stokes& response, double value, double slope) {
    if (tint_.empty()) return add_line(light, value * response, slope * response);
    add_light(light, response, [&](double c) { return value + slope * c; });
}

template <class Part>
void SkySpectrum::add_light(std::size_t light, const Stokes& response, const Part& part) {
    const auto plain = [&](std::size_t i) { return part(colours_[i] - middle_); };
    if (tint_.empty()) return add_cells(light, response, plain);
    add_cells(light, response, [&](std::size_t i) { return tint_[i] * plain(i); });
}

template <class Part>
void SkySpectrum::add_cells(std::size_t light, const Stokes& response, const Part& part) {
    const double* brightness = &brightness_[light * cells_];
    double bright = 0;
    for (std::size_t i = first_; i < last_; ++i) bright += brightness[i] * part(i);
    luminance_ += response.s0 * bright;
    const double parts[4] = {response.s0, response.s1, response.s2, response.s3};
    for (std::size_t c = 0; c < components_; ++c) {
        own_->in_cells[c * lights_ + light] = true;
        double* seen = &own_->cell_light[(c * lights_ + light) * cells_];
        for (std::size_t i = first_; i < last_; ++i) {
            seen[i] += parts[c] * part(i);
        }
    }
}

double SkySpectrum::add(std::size_t pixel, const Expansion& k, const Vec3& fan, PolygonView polygon,
                        double area, const Stokes& response, std::span<const double> tint) {
    own_ = &seen_[pixel];
    luminance_ = 0;
    tint_ = tint;
    const double height = 0.5 * (1 + dot(k.value, sky_.up)), slope = 0.5 * dot(fan, sky_.up);
    add_line(0, response, area * (1 - height), area * -slope);
    add_line(1, response, area * height, area * slope);
    if (sky_.discs.empty()) return luminance_;
    constexpr int halvings = 8;
    const double across = spread(k, polygon);
    const double swing =
        length(fan) * std::max(colours_[first_] - middle_, middle_ - colours_[last_ - 1]);
    for (std::size_t i = 0; i < sky_.discs.size(); ++i) {
        add_lamp(i, k, fan, polygon, area, response, across, swing, halvings);
    }
    return luminance_;
}

void SkySpectrum::add_lamp(std::size_t number, const Expansion& k, const Vec3& fan,
                           PolygonView polygon, double area, const Stokes& response, double across,
                           double swing, int halvings) {
    const Disc& disc = sky_.discs[number];
    const double inside = dot(k.value, disc.direction) - disc.cos_radius;
    if (inside <= -across - swing) return;
    const std::size_t light = 2 + number;
    if (inside >= across + swing) return add_line(light, response, area, 0);
    constexpr double still = 0.1;
    if (swing < still * across) {
        return add_line(light, response, lit_area(disc, k, polygon, area, halvings), 0);
    }
    if (!edge_is_straight(disc, across) && halvings > 0) {
        Polygon half;
        for (const double side : {-1.0, 1.0}) {
            Expansion there = k;
            const double part = halve(there, polygon, side, half);
            if (!(part > 0)) continue;
            add_lamp(number, there, fan, half, part, response, spread(there, half), swing,
                     halvings - 1);
        }
        return;
    }
    // The part beyond a straight edge that moves over a polygon rises from 0 to 1: a ramp of the
    // same mean and variance.
    const Moments m = moments(polygon, {area, {}});
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

void SkySpectrum::end_piece(Seen& seen) {
    for (std::size_t c = 0; c < components_; ++c) {
        double* sums = &seen.sums[c * channels_];
        for (std::size_t l = 0; l < lights_; ++l) {
            Line& line = seen.lines[c * lights_ + l];
            if (line.value == 0 && line.slope == 0) continue;
            const Radiance* light = &up_to_[l * (cells_ + 1) * channels_];
            const Radiance *from = light + first_ * channels_, *to = light + last_ * channels_;
            const double at_zero = line.value - line.slope * middle_;
            for (std::size_t i = 0; i < channels_; ++i) {
                sums[i] += at_zero * (to[i].whole - from[i].whole) +
                           line.slope * (to[i].slope - from[i].slope);
            }
            line = {};
        }
    }
}

void SkySpectrum::flush(std::size_t pixel, Sampler& sampler) {
    Seen& own = seen_[pixel];
    end_piece(own);
    for (std::size_t c = 0; c < components_; ++c) {
        double* sums = &own.sums[c * channels_];
        for (std::size_t l = 0; l < lights_; ++l) {
            if (!own.in_cells[c * lights_ + l]) continue;
            own.in_cells[c * lights_ + l] = false;
            double* seen = &own.cell_light[(c * lights_ + l) * cells_];
            for (std::size_t i = 0; i < channels_; ++i) {
                sums[i] +=
                    product({seen, cells_}, {&radiance_[(l * channels_ + i) * cells_], cells_});
            }
            std::fill_n(seen, cells_, 0.0);
        }
        sampler.see({sums, channels_}, c, 1);
        std::fill_n(sums, channels_, 0.0);
    }
}

}  // namespace icespar
