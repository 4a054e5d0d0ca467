// Refractive index as a function of wavelength: published dispersion formulas.
#pragma once

#include <string_view>
#include <vector>

namespace icespar {

/// n(wavelength). The formulas are numbered as in refractiveindex.info; coefficients take
/// wavelengths in micrometres, and the functions that take a list of them throw Error when there
/// are too few, an even number, or one that is not finite.
class IndexFunction {
public:
    IndexFunction() = default;  ///< n = 1
    explicit IndexFunction(double constant);

    /// n = A + B / l^2.
    static IndexFunction cauchy(double a, double b_um2);
    /// Formula 1: n^2 - 1 = C1 + sum C_2k l^2 / (l^2 - C_2k+1^2).
    static IndexFunction sellmeier1(std::vector<double> coefficients);
    /// Formula 2: n^2 - 1 = C1 + sum C_2k l^2 / (l^2 - C_2k+1).
    static IndexFunction sellmeier2(std::vector<double> coefficients);
    /// Formula 4: n^2 = C1 + C2 l^C3 / (l^2 - C4^C5) + C6 l^C7 / (l^2 - C8^C9) + C10 l^C11 + ...
    static IndexFunction formula4(std::vector<double> coefficients);

    [[nodiscard]] double operator()(double wavelength_nm) const;
    [[nodiscard]] bool dispersive() const { return kind_ != Kind::constant; }

    /// True when the index is finite and at least 1 over the whole rendered range.
    [[nodiscard]] bool valid() const;

private:
    enum class Kind { constant, cauchy, sellmeier, formula4 };
    Kind kind_ = Kind::constant;
    std::vector<double> c_{1.0};
};

}  // namespace icespar
