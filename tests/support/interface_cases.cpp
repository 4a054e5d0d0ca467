// Names, inputs in text, and the random numbers of the interface cases.
#include "support/interface_cases.hpp"

#include <cstdio>
#include <numbers>
#include <sstream>

namespace icespar::testing {

const char* name(Stress stress) {
    static constexpr std::array<const char*, static_cast<std::size_t>(Stress::count)> names{
        "ordinary",
        "normal incidence",
        "near normal",
        "grazing",
        "near critical",
        "near critical, reflected mode",
        "one mode evanescent",
        "axis on normal",
        "axis near normal",
        "axis on refracted",
        "axis on incident",
        "axis in face",
        "axis in plane",
        "tiny birefringence",
        "no birefringence",
        "strong birefringence",
        "high ratio",
        "same medium",
        "same medium turned",
        "matched index",
        "denser outside",
        "crystal to crystal",
        "backward wave",
        "merging evanescent",
        "critical along axis",
        "critical, tiny birefringence"};
    return names[static_cast<std::size_t>(stress)];
}

std::string in_digits(double value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.3e", value);
    return text.data();
}

std::string InterfaceCase::text() const {
    std::ostringstream out;
    out.precision(17);
    const auto vector = [&](const Vec3& v) {
        out << "{" << v.x << ", " << v.y << ", " << v.z << "}";
    };
    const auto medium = [&](const Medium& m) {
        out << (m.birefringent ? "uniaxial(" : "isotropic(") << m.n_o;
        if (m.birefringent) {
            out << ", " << m.n_e << ", ";
            vector(m.axis);
        }
        out << ")";
    };
    medium(from), out << " -> ", medium(to), out << " normal ", vector(normal);
    out << " direction ", vector(direction),
        out << " mode "
            << "spoe"[static_cast<int>(mode)];
    return out.str();
}

double Random::uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
}

double Random::power_of_ten(double low_exponent, double high_exponent) {
    return std::pow(10.0, uniform(low_exponent, high_exponent));
}

Vec3 Random::direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return normalised(Vec3{r * std::cos(angle), r * std::sin(angle), z});
}

Vec3 Random::perpendicular_to(const Vec3& u) {
    const Vec3 a = any_perpendicular(u), b = cross(u, a);
    const double angle = uniform(0, 2 * std::numbers::pi);
    const Vec3 v = std::cos(angle) * a + std::sin(angle) * b;
    return normalised(v - dot(v, u) * u);
}

}  // namespace icespar::testing
