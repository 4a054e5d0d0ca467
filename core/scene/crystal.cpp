// What a stone is made of: attenuation in POV-Ray's words, and whether wavelengths matter.
#include "scene/crystal.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {

namespace {

constexpr double exponential_power = 1000;

bool varies(const Spectrum& s) { return !s.flat(); }

}  // namespace

bool Fade::exponential() const {
    return power >= exponential_power && distance > 0 && colour.greatest() <= 1;
}

double Fade::transmittance(double length, double wavelength_nm) const {
    const double c = colour(wavelength_nm), x = length / distance;
    if (power >= exponential_power) return std::exp(-(1 - c) * x);
    return c + (1 - c) / (1 + std::pow(x, power));
}

bool Crystal::parts_wavelengths() const {
    return std::any_of(indices.begin(), indices.end(),
                       [](const IndexFunction& n) { return n.dispersive(); });
}

bool Crystal::dispersive() const {
    return parts_wavelengths() || std::any_of(absorption.begin(), absorption.end(), varies) ||
           (fade && varies(fade->colour)) || varies(rotation);
}

}  // namespace icespar
