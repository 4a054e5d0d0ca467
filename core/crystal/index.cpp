// Published dispersion formulas, evaluated.
#include "crystal/index.hpp"

#include <cmath>
#include <string>

#include "math/error.hpp"

namespace icespar {
namespace {

constexpr int shortest_nm = 380, longest_nm = 780;

std::vector<double> checked(std::vector<double> c, const char* formula, std::size_t at_least) {
    if (c.size() < at_least || c.size() % 2 == 0)
        throw Error(std::string(formula) + " takes an odd number of coefficients, at least " +
                    std::to_string(at_least) + ", not " + std::to_string(c.size()) +
                    "; give them in the order of the formula");
    for (const double value : c)
        if (!std::isfinite(value))
            throw Error(std::string("a coefficient of ") + formula +
                        " is not finite; give finite numbers");
    return c;
}

}  // namespace

IndexFunction::IndexFunction(double constant) : c_{constant} {}

IndexFunction IndexFunction::cauchy(double a, double b_um2) {
    IndexFunction n;
    n.kind_ = Kind::cauchy;
    n.c_ = {a, b_um2};
    return n;
}

IndexFunction IndexFunction::sellmeier1(std::vector<double> coefficients) {
    IndexFunction n = sellmeier2(checked(std::move(coefficients), "Sellmeier's formula 1", 3));
    for (std::size_t i = 2; i < n.c_.size(); i += 2) n.c_[i] *= n.c_[i];
    return n;
}

IndexFunction IndexFunction::sellmeier2(std::vector<double> coefficients) {
    IndexFunction n;
    n.kind_ = Kind::sellmeier;
    n.c_ = checked(std::move(coefficients), "Sellmeier's formula 2", 3);
    return n;
}

IndexFunction IndexFunction::formula4(std::vector<double> coefficients) {
    IndexFunction n;
    n.kind_ = Kind::formula4;
    n.c_ = checked(std::move(coefficients), "formula 4", 9);
    // C4^C5 and C8^C9 do not depend on the wavelength: kept in place of C4 and C8.
    for (const std::size_t i : {3u, 7u}) n.c_[i] = std::pow(n.c_[i], n.c_[i + 1]);
    return n;
}

double IndexFunction::operator()(double wavelength_nm) const {
    const double l = wavelength_nm * 1e-3, l2 = l * l;
    switch (kind_) {
        case Kind::constant:
            return c_[0];
        case Kind::cauchy:
            return c_[0] + c_[1] / l2;
        case Kind::sellmeier: {
            double n2 = 1 + c_[0];
            for (std::size_t i = 1; i < c_.size(); i += 2) n2 += c_[i] * l2 / (l2 - c_[i + 1]);
            return std::sqrt(n2);
        }
        case Kind::formula4:
            break;
    }
    // A term whose coefficient is 0 is absent, whatever its denominator.
    double n2 = c_[0];
    for (const std::size_t i : {1u, 5u})
        if (c_[i] != 0) n2 += c_[i] * std::pow(l, c_[i + 1]) / (l2 - c_[i + 2]);
    for (std::size_t i = 9; i < c_.size(); i += 2) n2 += c_[i] * std::pow(l, c_[i + 1]);
    return std::sqrt(n2);
}

bool IndexFunction::valid() const {
    // A resonance between two of the wavelengths tried below could be missed.
    const auto resonates = [](double strength, double square_um2) {
        return strength != 0 && square_um2 > shortest_nm * shortest_nm * 1e-6 &&
               square_um2 < longest_nm * longest_nm * 1e-6;
    };
    if (kind_ == Kind::sellmeier)
        for (std::size_t i = 1; i < c_.size(); i += 2)
            if (resonates(c_[i], c_[i + 1])) return false;
    if (kind_ == Kind::formula4 && (resonates(c_[1], c_[3]) || resonates(c_[5], c_[7])))
        return false;
    for (int nm = shortest_nm; nm <= longest_nm; ++nm) {
        const double n = (*this)(nm);
        if (!(n >= 1) || !std::isfinite(n)) return false;
    }
    return true;
}

}  // namespace icespar
