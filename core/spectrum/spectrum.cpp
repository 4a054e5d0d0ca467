// Functions of wavelength: how they are looked up and multiplied.
#include "spectrum/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "math/error.hpp"

namespace icespar {
namespace {

/// 1 / step when the nodes are equally spaced, to a billionth of the step; otherwise 0.
double inverse_step(const std::vector<double>& nodes) {
    if (nodes.size() < 2) return 0;
    const double step = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (std::abs(nodes[i] - nodes.front() - static_cast<double>(i) * step) > 1e-9 * step)
            return 0;
    return 1 / step;
}

std::vector<double> united(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> nodes;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(nodes));
    return nodes;
}

}  // namespace

Spectrum::Spectrum(double constant) : Spectrum({shortest_nm}, {constant}) {}

Spectrum::Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values)
    : wavelengths_nm_(std::move(wavelengths_nm)), values_(std::move(values)) {
    if (wavelengths_nm_.empty() || wavelengths_nm_.size() != values_.size())
        throw Error("a spectrum has " + std::to_string(wavelengths_nm_.size()) +
                    " wavelengths and " + std::to_string(values_.size()) +
                    " values; give one value for each wavelength, and at least one");
    for (std::size_t i = 0; i < values_.size(); ++i) {
        if (!std::isfinite(wavelengths_nm_[i]) || !std::isfinite(values_[i]))
            throw Error("a spectrum holds a number that is not finite at node " +
                        std::to_string(i + 1) + "; give finite wavelengths and values");
        if (i > 0 && wavelengths_nm_[i] <= wavelengths_nm_[i - 1])
            throw Error("a spectrum's wavelengths do not rise at node " + std::to_string(i + 1) +
                        "; sort them and give each once");
    }
    inverse_step_ = inverse_step(wavelengths_nm_);
}

double Spectrum::operator()(double wavelength_nm) const {
    if (values_.empty()) return 0;
    if (wavelength_nm <= wavelengths_nm_.front()) return values_.front();
    if (wavelength_nm >= wavelengths_nm_.back()) return values_.back();
    if (inverse_step_ > 0) {
        const double place = (wavelength_nm - wavelengths_nm_.front()) * inverse_step_;
        const std::size_t i = std::min(static_cast<std::size_t>(place), values_.size() - 2);
        return values_[i] + (place - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
    }
    const auto above =
        std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), wavelength_nm);
    const auto i = static_cast<std::size_t>(above - wavelengths_nm_.begin()) - 1;
    const double part =
        (wavelength_nm - wavelengths_nm_[i]) / (wavelengths_nm_[i + 1] - wavelengths_nm_[i]);
    return values_[i] + part * (values_[i + 1] - values_[i]);
}

Spectrum operator*(double factor, const Spectrum& a) {
    Spectrum product = a;
    for (double& value : product.values_) value *= factor;
    return product;
}

Spectrum operator+(const Spectrum& a, const Spectrum& b) {
    if (a.values_.empty()) return b;
    if (b.values_.empty()) return a;
    // What is the same at every wavelength has one node, which must not part those of the other.
    if (a.values_.size() == 1 && b.values_.size() > 1) return b + a;
    if (b.values_.size() == 1) {
        Spectrum sum = a;
        for (double& value : sum.values_) value += b.values_.front();
        return sum;
    }
    std::vector<double> nodes = united(a.wavelengths_nm_, b.wavelengths_nm_), values;
    values.reserve(nodes.size());
    for (const double nm : nodes) values.push_back(a(nm) + b(nm));
    return {std::move(nodes), std::move(values)};
}

Spectrum operator*(const Spectrum& a, const Spectrum& b) {
    if (a.values_.empty() || b.values_.empty()) return {};
    if (a.values_.size() == 1) return a.values_.front() * b;
    if (b.values_.size() == 1) return b.values_.front() * a;
    const std::vector<double> nodes = united(a.wavelengths_nm_, b.wavelengths_nm_);
    std::vector<double> values;
    values.reserve(nodes.size());
    for (const double nm : nodes) values.push_back(a(nm) * b(nm));
    return {nodes, std::move(values)};
}

}  // namespace icespar
