// What a stone is made of: attenuation in POV-Ray's words, and whether wavelengths matter.
#include "scene/crystal.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {

double Fade::transmittance(double length, double wavelength_nm) const {
    constexpr double exponential = 1000;
    const double c = colour(wavelength_nm), x = length / distance;
    if (power >= exponential) return std::exp(-(1 - c) * x);
    return c + (1 - c) / (1 + std::pow(x, power));
}

bool Crystal::dispersive() const {
    const auto varies = [](const Spectrum& s) { return !s.flat(); };
    return std::any_of(indices.begin(), indices.end(),
                       [](const IndexFunction& n) { return n.dispersive(); }) ||
           std::any_of(absorption.begin(), absorption.end(), varies) ||
           (fade && varies(fade->colour)) || varies(rotation);
}

}  // namespace icespar
