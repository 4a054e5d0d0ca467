// Accumulation and the way to a finished image.
#include "render/film.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {
namespace {

/// Beyond this a picture in floats would hold infinities.
constexpr double brightest = 1e30;

double luminance(const double* rgb, int stride) {
    return xyz_from_rgb({rgb[0], rgb[stride], rgb[2 * stride]})[1];
}

}  // namespace

WavelengthSampler::WavelengthSampler(bool uniform) : uniform_(uniform), cumulative_{0.0} {
    for (double nm = shortest_nm; nm < longest_nm; nm += 1) {
        const Xyz o = observer(nm + 0.5);
        cumulative_.push_back(cumulative_.back() + o[0] + o[1] + o[2] + 1e-4);
    }
    for (double& c : cumulative_) c /= cumulative_.back();
}

WavelengthSampler::Draw WavelengthSampler::draw(double u) const {
    Draw d{};
    if (uniform_) {
        d.wavelength_nm = shortest_nm + u * (longest_nm - shortest_nm);
        d.per_density = longest_nm - shortest_nm;
    } else {
        const auto next = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, u);
        const double step = *next - *(next - 1);
        const auto cell = static_cast<double>(next - 1 - cumulative_.begin());
        d.wavelength_nm = shortest_nm + cell + (u - *(next - 1)) / step;
        d.per_density = 1 / step;
    }
    const Rgb rgb = rgb_from_xyz(observer(d.wavelength_nm));
    d.rgb = {rgb[0] * d.per_density, rgb[1] * d.per_density, rgb[2] * d.per_density};
    return d;
}

Film::Film(int width, int height, int bands, bool stokes)
    : width_(width), height_(height), components_(stokes ? 4 : 1), bands_{bands} {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    sums_.assign(pixels * static_cast<std::size_t>(channels() * components_), 0.0);
    spread_.resize(pixels);
    samples_.assign(pixels, 0);
}

bool Film::add(int x, int y, const std::vector<double>& sample, int weight) {
    for (const double v : sample) {
        if (!(std::abs(v) < brightest)) return false;
    }
    const std::size_t p = pixel(x, y);
    double* sums = &sums_[p * sample.size()];
    for (std::size_t i = 0; i < sample.size(); ++i) sums[i] += weight * sample[i];
    samples_[p] += weight;
    return true;
}

void Film::end_pass(int x, int y, double variance) {
    const std::size_t p = pixel(x, y);
    Spread& s = spread_[p];
    const double total =
        luminance(&sums_[p * static_cast<std::size_t>(channels() * components_)], components_);
    const int weight = samples_[p] - s.samples;
    if (weight == 0) return;
    s.squares += (total - s.before) * (total - s.before) / weight;
    if (variance >= 0) {
        s.known += variance * weight * weight;
        ++s.told;
    }
    s.before = total;
    s.samples = samples_[p];
    ++s.passes;
}

std::vector<double> Film::variances() const {
    std::vector<double> own;
    own.reserve(spread_.size());
    for (const Spread& s : spread_) {
        const double passes = s.passes, samples = s.samples;
        const bool told = s.passes > 0 && s.told == s.passes;
        if (passes < 2 && !told) return {};
        // A pass of weight w has the variance of one sample over w.
        own.push_back(told ? s.known / (samples * samples)
                           : std::max(0.0, s.squares - s.before * s.before / samples) /
                                 ((passes - 1) * samples));
    }
    std::vector<double> shared(own.size());
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            double sum = 0;
            int pixels = 0;
            for (int v = std::max(0, y - 2); v <= std::min(height_ - 1, y + 2); ++v) {
                for (int u = std::max(0, x - 2); u <= std::min(width_ - 1, x + 2); ++u) {
                    sum += own[pixel(u, v)];
                    ++pixels;
                }
            }
            shared[pixel(x, y)] = sum / pixels;
        }
    }
    return shared;
}

double Film::mean_luminance() const {
    double sum = 0;
    for (const Spread& s : spread_) {
        if (s.samples > 0) sum += s.before / s.samples;
    }
    return sum / static_cast<double>(spread_.size());
}

Image Film::image(const std::vector<double>& variances) const {
    Image out;
    out.width = width_;
    out.height = height_;
    const auto stride = static_cast<std::size_t>(channels() * components_);
    const std::size_t pixels = samples_.size();
    const auto parts = static_cast<std::size_t>(components_);
    const auto count = static_cast<std::size_t>(bands_.count);
    out.rgb.resize(pixels * 3);
    for (const double v : variances) out.standard_error.push_back(static_cast<float>(std::sqrt(v)));
    if (components_ == 4 && count == 0) out.rgb_stokes.resize(pixels * 9);
    out.spectral.resize(pixels * count * parts);
    out.spectral_components = count > 0 ? components_ : 0;
    for (int b = 0; b < bands_.count; ++b) out.wavelengths_nm.push_back(bands_.centre(b));
    for (std::size_t p = 0; p < pixels; ++p) {
        const double scale = samples_[p] > 0 ? 1.0 / samples_[p] : 0;
        const double* sums = &sums_[p * stride];
        for (std::size_t c = 0; c < 3; ++c) {
            out.rgb[p * 3 + c] = static_cast<float>(scale * sums[c * parts]);
            for (std::size_t s = 1; s < 4 && !out.rgb_stokes.empty(); ++s) {
                out.rgb_stokes[(p * 3 + c) * 3 + s - 1] =
                    static_cast<float>(scale * sums[c * parts + s]);
            }
        }
        for (std::size_t i = 0; i < count * parts; ++i) {
            out.spectral[p * count * parts + i] = static_cast<float>(scale * sums[3 * parts + i]);
        }
    }
    return out;
}

}  // namespace icespar
