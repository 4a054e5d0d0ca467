// Accumulation and the way to a finished image.
#include "render/film.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace icespar {
namespace {

/// Beyond this a picture in floats would hold infinities.
constexpr double brightest = 1e30;
/// Of the unit interval: where a wavelength is to be found in it.
constexpr std::size_t guides = 512;

/// How far pixels share their variances, along and across.
constexpr int reach = 2;

double luminance(const double* rgb, int stride) {
    return xyz_from_rgb({rgb[0], rgb[stride], rgb[2 * stride]})[1];
}

}  // namespace

WavelengthSampler::WavelengthSampler(bool uniform) : uniform_(uniform), cumulative_{0.0} {
    for (double nm = shortest_nm; nm < longest_nm; nm += 1) {
        const Xyz o = observer(nm + 0.5);
        cumulative_.push_back(cumulative_.back() + o[0] + o[1] + o[2] + 1e-4);
        rgb_.push_back(rgb_from_xyz(observer(nm)));
    }
    rgb_.push_back(rgb_from_xyz(observer(longest_nm)));
    for (double& c : cumulative_) c /= cumulative_.back();
    for (std::size_t i = 0, cell = 0; i < guides; ++i) {
        while (cumulative_[cell + 1] * guides <= static_cast<double>(i)) ++cell;
        start_.push_back(cell);
    }
}

WavelengthSampler::Draw WavelengthSampler::draw(double u) const {
    Draw d{};
    std::size_t cell = 0;
    double within = 0;
    if (uniform_) {
        const double place = u * (longest_nm - shortest_nm);
        cell = std::min(static_cast<std::size_t>(place), rgb_.size() - 2);
        within = place - static_cast<double>(cell);
        d.per_density = longest_nm - shortest_nm;
    } else {
        cell = start_[std::min(static_cast<std::size_t>(u * guides), guides - 1)];
        while (cell + 2 < cumulative_.size() && cumulative_[cell + 1] <= u) ++cell;
        const double step = cumulative_[cell + 1] - cumulative_[cell];
        within = (u - cumulative_[cell]) / step;
        d.per_density = 1 / step;
    }
    d.wavelength_nm = shortest_nm + static_cast<double>(cell) + within;
    // The observer is linear between whole nm.
    for (std::size_t c = 0; c < 3; ++c) {
        const double below = rgb_[cell][c], above = rgb_[cell + 1][c];
        d.rgb[c] = d.per_density * (below + within * (above - below));
    }
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
    // Along rows, then along columns; at the picture's edges there are fewer neighbours.
    const auto neighbours = [](int at, int size) {
        return std::pair(std::max(0, at - reach), std::min(size - 1, at + reach));
    };
    std::vector<double> rows(own.size()), shared(own.size(), 0.0);
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const auto [first, last] = neighbours(x, width_);
            double sum = 0;
            for (int u = first; u <= last; ++u) sum += own[pixel(u, y)];
            rows[pixel(x, y)] = sum / (last - first + 1);
        }
    }
    for (int y = 0; y < height_; ++y) {
        const auto [first, last] = neighbours(y, height_);
        for (int v = first; v <= last; ++v) {
            for (int x = 0; x < width_; ++x) shared[pixel(x, y)] += rows[pixel(x, v)];
        }
        const double share = 1.0 / (last - first + 1);
        for (int x = 0; x < width_; ++x) shared[pixel(x, y)] *= share;
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
