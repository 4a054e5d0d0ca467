// One exponential a colour for each event on the path.
#include "render/path_colour.hpp"

#include <algorithm>

#include "math/decay.hpp"

namespace icespar {

namespace {

/// Absorption for each of the lengths.
std::array<double, 3> absorption_of(const Crystal& c, double nm) {
    const auto along = [&](std::size_t i) {
        return i < c.absorption.size() ? c.absorption[i](nm) : 0;
    };
    const double fade = c.fade ? (1 - c.fade->colour(nm)) / c.fade->distance : 0;
    if (c.birefringent()) return {along(0), along(1), fade};
    return {along(0) + fade, 0, 0};
}

}  // namespace

void PathColour::set(const Crystal& crystal, std::span<const double> wavelengths_nm,
                     std::size_t per_colour) {
    crystal_ = &crystal;
    const std::size_t colours = wavelengths_nm.size() / per_colour;
    tint_.assign(colours, 1.0);
    mean_ = 1;
    lengths_ = {};
    narrow(0, colours);
    for (auto& table : per_length_) table.assign(colours, 0.0);
    for (std::size_t i = 0; i < colours * per_colour; ++i) {
        const auto absorption = absorption_of(crystal, wavelengths_nm[i]);
        for (std::size_t l = 0; l < 3; ++l) {
            per_length_[l][i / per_colour] += absorption[l] / static_cast<double>(per_colour);
        }
    }
}

void PathColour::narrow(std::size_t first, std::size_t last) {
    first_ = first;
    last_ = last;
}

double PathColour::transmit(std::span<const Affine> lengths) {
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths_[i] = lengths[i].value;
    const auto [x, y, z] = lengths_;
    double* const left = tint_.data();
    double sum = 0;
    if (lengths.size() == 1) {
        const double* const a = per_length_[0].data();
        for (std::size_t i = first_; i < last_; ++i) left[i] = decay(a[i] * x);
    } else {
        const double *const a = per_length_[0].data(), *const b = per_length_[1].data(),
                            *const c = per_length_[2].data();
        for (std::size_t i = first_; i < last_; ++i) {
            left[i] = decay(a[i] * x + b[i] * y + c[i] * z);
        }
    }
    for (std::size_t i = first_; i < last_; ++i) sum += left[i];
    const double count = static_cast<double>(last_ - first_), over = count / sum;
    for (std::size_t i = first_; i < last_; ++i) left[i] *= over;
    mean_ = sum / count;
    return mean_;
}

double PathColour::draw(double u) const {
    const double colours = static_cast<double>(tint_.size());
    if (!crystal_->absorbs()) {
        return (static_cast<double>(first_) + u * static_cast<double>(last_ - first_)) / colours;
    }
    const double wanted = u * static_cast<double>(last_ - first_);
    double before = 0;
    std::size_t i = first_;
    for (; i + 1 < last_ && before + tint_[i] <= wanted; ++i) before += tint_[i];
    const double within = std::clamp((wanted - before) / tint_[i], 0.0, 1.0);
    return (static_cast<double>(i) + within) / colours;
}

double PathColour::correction(double drawn, double wavelength_nm) const {
    if (!crystal_->absorbs()) return 1;
    const auto absorption = absorption_of(*crystal_, wavelength_nm);
    double depth = 0;
    for (std::size_t l = 0; l < 3; ++l) depth += absorption[l] * lengths_[l];
    const auto colour = static_cast<std::size_t>(drawn * static_cast<double>(tint_.size()));
    return decay(depth) / (mean_ * tint_[std::min(colour, tint_.size() - 1)]);
}

}  // namespace icespar
