// What the eye makes of a spectrum, the lights it calls white, and a spectrum for a given colour.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "math/error.hpp"
#include "spectrum/spectrum.hpp"
#include "spectrum/tables.hpp"

namespace icespar {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

std::array<double, 3> times(const Matrix& m, const std::array<double, 3>& v) {
    std::array<double, 3> product{};
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

Matrix inverse(const Matrix& m) {
    Matrix adjugate{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            adjugate[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    const double determinant =
        m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
    for (auto& row : adjugate)
        for (double& element : row) element /= determinant;
    return adjugate;
}

using Column = std::array<std::array<double, 3>, tables::nodes>;

Spectrum column(const Column& table, std::size_t which) {
    std::vector<double> nodes, values;
    for (const auto& row : table) {
        nodes.push_back(shortest_nm + tables::step_nm * static_cast<double>(nodes.size()));
        values.push_back(row[which]);
    }
    return {nodes, values};
}

Spectrum spectrum_of(const tables::Lamp& lamp) {
    std::vector<double> nodes;
    for (int i = 0; i < tables::nodes; ++i) nodes.push_back(shortest_nm + tables::step_nm * i);
    return {std::move(nodes), {lamp.power.begin(), lamp.power.end()}};
}

/// The same function on the 1 nm grid of Spectrum::integrate, scaled to luminance Y = 1. On this
/// grid a product with any table has its nodes where the integral looks, and is exact.
template <class F>
Spectrum light_of_luminance_1(F&& shape) {
    const double luminance =
        Spectrum::integrate([&](double nm) { return shape(nm) * observer(nm)[1]; });
    std::vector<double> nodes, values;
    for (double nm = shortest_nm; nm <= longest_nm; nm += 1) {
        nodes.push_back(nm);
        values.push_back(shape(nm) / luminance);
    }
    return {std::move(nodes), std::move(values)};
}

template <class Radiance>
Xyz xyz_of(const Radiance& radiance) {
    Xyz sum{};
    for (std::size_t i = 0; i < 3; ++i)
        sum[i] = Spectrum::integrate([&](double nm) { return radiance(nm) * observer(nm)[i]; });
    return sum;
}

/// Columns: XYZ of Rec. 709's red, green and blue, so scaled that they add to our white.
Matrix make_xyz_from_rgb() {
    constexpr std::array<std::array<double, 2>, 3> xy{{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};
    Matrix m{};
    for (std::size_t i = 0; i < 3; ++i) {
        m[0][i] = xy[i][0] / xy[i][1];
        m[1][i] = 1;
        m[2][i] = (1 - xy[i][0] - xy[i][1]) / xy[i][1];
    }
    const Xyz amounts = times(inverse(m), xyz_of(white()));
    for (auto& row : m)
        for (std::size_t i = 0; i < 3; ++i) row[i] *= amounts[i];
    return m;
}

const Matrix& xyz_from_rgb_matrix() {
    static const Matrix m = make_xyz_from_rgb();
    return m;
}

/// The reflectances in tables.cpp are rounded; this gives the amounts of them that make red, green
/// and blue exactly under our white.
Matrix make_amounts_from_rgb() {
    Matrix rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Rgb seen = rgb_of(column(tables::primaries, i) * white());
        for (std::size_t j = 0; j < 3; ++j) rgb[j][i] = seen[j];
    }
    return inverse(rgb);
}

}  // namespace

Xyz observer(double wavelength_nm) {
    static const double scale = [] {
        const Spectrum y = column(tables::observer, 1);
        return 1 / Spectrum::integrate(y);
    }();
    if (!(wavelength_nm >= shortest_nm && wavelength_nm <= longest_nm)) return {};
    const double place = (wavelength_nm - shortest_nm) / tables::step_nm;
    const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(place), tables::nodes - 2);
    const double part = place - static_cast<double>(i);
    const auto &below = tables::observer[i], &above = tables::observer[i + 1];
    Xyz xyz{};
    for (std::size_t j = 0; j < 3; ++j) xyz[j] = scale * (below[j] + part * (above[j] - below[j]));
    return xyz;
}

Rgb rgb_from_xyz(const Xyz& xyz) {
    static const Matrix m = inverse(xyz_from_rgb_matrix());
    return times(m, xyz);
}

Xyz xyz_from_rgb(const Rgb& rgb) { return times(xyz_from_rgb_matrix(), rgb); }

Rgb rgb_of(const Spectrum& radiance) { return rgb_from_xyz(xyz_of(radiance)); }

const Spectrum& white() {
    static const Spectrum d65 = light_of_luminance_1(spectrum_of(tables::lamps[0]));
    return d65;
}

Spectrum illuminant(std::string_view name) {
    std::string upper(name);
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (upper == "D65") return white();
    if (upper == "E") return Spectrum(1.0);
    // The CIE writes FL2 for what lamps are sold as F2.
    if (upper.starts_with("FL")) upper.erase(1, 1);
    for (const tables::Lamp& lamp : tables::lamps)
        if (lamp.name == upper) return light_of_luminance_1(spectrum_of(lamp));
    throw Error(
        "unknown illuminant '" + std::string(name) +
        "'; there are D65, D50, D55, D75, A, C and E, F1 to F12, LED-B1 to LED-B5, LED-BH1, "
        "LED-RGB1, LED-V1 and LED-V2, and blackbody for other lamps");
}

std::vector<std::string_view> illuminant_names() {
    std::vector<std::string_view> names;
    for (const tables::Lamp& lamp : tables::lamps) names.push_back(lamp.name);
    names.emplace_back("E");
    return names;
}

Spectrum blackbody(double kelvin) {
    if (!(kelvin >= 500 && kelvin <= 50000))
        throw Error("a blackbody of " + std::to_string(kelvin) +
                    " K cannot be rendered; give 500 to 50000");
    // Exact by the definition of the SI (2019): h in J s, c in m/s, k in J/K.
    constexpr double h = 6.62607015e-34, c = 299792458, k = 1.380649e-23;
    const double second_constant_nm = h * c / k * 1e9;
    return light_of_luminance_1([&](double nm) {
        return std::pow(nm / 560, -5) / std::expm1(second_constant_nm / (nm * kelvin));
    });
}

Spectrum reflectance_from_rgb(const Rgb& rgb) {
    static const Matrix amounts_from_rgb = make_amounts_from_rgb();
    if (!std::isfinite(rgb[0]) || !std::isfinite(rgb[1]) || !std::isfinite(rgb[2]))
        throw Error("a colour holds a number that is not finite; give finite red, green and blue");
    // The three add to 1: a grey is flat, and costs nothing to look up.
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return Spectrum(rgb[0]);
    const auto amounts = times(amounts_from_rgb, rgb);
    std::vector<double> nodes, values;
    for (const auto& basis : tables::primaries) {
        nodes.push_back(shortest_nm + tables::step_nm * static_cast<double>(nodes.size()));
        values.push_back(amounts[0] * basis[0] + amounts[1] * basis[1] + amounts[2] * basis[2]);
    }
    return {std::move(nodes), std::move(values)};
}

}  // namespace icespar
