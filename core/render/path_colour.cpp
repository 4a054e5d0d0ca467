// One exponential a colour for each event on the path.
#include "render/path_colour.hpp"

#include <algorithm>

#include "math/decay.hpp"

namespace icespar {

void PathColour::set(const Crystal& c, std::span<const double> wavelengths_nm,
                     std::size_t per_colour) {
    const std::size_t colours = wavelengths_nm.size() / per_colour;
    tint_.assign(colours, 1.0);
    narrow(0, colours);
    for (auto& table : per_length_) table.assign(colours, 0.0);
    for (std::size_t i = 0; i < colours * per_colour; ++i) {
        const double nm = wavelengths_nm[i], share = 1.0 / static_cast<double>(per_colour);
        const auto absorption = [&](std::size_t axis) {
            return axis < c.absorption.size() ? share * c.absorption[axis](nm) : 0;
        };
        const double fade = c.fade ? share * (1 - c.fade->colour(nm)) / c.fade->distance : 0;
        const std::size_t colour = i / per_colour;
        per_length_[0][colour] += absorption(0);
        per_length_[1][colour] += absorption(1);
        per_length_[c.birefringent() ? 2 : 0][colour] += fade;
    }
}

void PathColour::narrow(std::size_t first, std::size_t last) {
    first_ = first;
    last_ = last;
}

double PathColour::transmit(std::span<const Affine> lengths) {
    double* const left = tint_.data();
    double sum = 0;
    if (lengths.size() == 1) {
        const double length = lengths[0].value;
        const double* const a = per_length_[0].data();
        for (std::size_t i = first_; i < last_; ++i) left[i] = decay(a[i] * length);
    } else {
        const double x = lengths[0].value, y = lengths[1].value, z = lengths[2].value;
        const double *const a = per_length_[0].data(), *const b = per_length_[1].data(),
                            *const c = per_length_[2].data();
        for (std::size_t i = first_; i < last_; ++i) {
            left[i] = decay(a[i] * x + b[i] * y + c[i] * z);
        }
    }
    for (std::size_t i = first_; i < last_; ++i) sum += left[i];
    const double count = static_cast<double>(last_ - first_), over = count / sum;
    for (std::size_t i = first_; i < last_; ++i) left[i] *= over;
    return sum / count;
}

double PathColour::draw(double u) const {
    const double wanted = u * static_cast<double>(last_ - first_);
    double before = 0;
    std::size_t i = first_;
    for (; i + 1 < last_ && before + tint_[i] <= wanted; ++i) before += tint_[i];
    const double within = std::clamp((wanted - before) / tint_[i], 0.0, 1.0);
    return (static_cast<double>(i) + within) / static_cast<double>(tint_.size());
}

}  // namespace icespar
