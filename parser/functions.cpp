// Functions of one or two floats, and writing numbers into strings.
#include "parser/functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace icespar {
namespace {

using Text = std::string_view;

Text not_zero(double, double y) { return y == 0 ? "division by zero" : ""; }
Text not_negative(double x, double) {
    return x < 0 ? "there is no real root of a negative number" : "";
}
Text positive(double x, double) { return x > 0 ? "" : "only positive numbers have a logarithm"; }
Text cosine(double x, double) {
    return std::abs(x) <= 1 + 1e-12 ? "" : "only numbers from -1 to 1 have one";
}
Text power(double x, double y) {
    if (x == 0 && y < 0) return "division by zero";
    return x < 0 && y != std::floor(y) ? "a negative number has no real power of this kind" : "";
}
double clamped(double x) { return std::clamp(x, -1.0, 1.0); }

constexpr double degree = std::numbers::pi / 180;

constexpr auto functions = std::to_array<NumberFunction>({
    {"abs", 1, [](double x, double) { return std::abs(x); }},
    {"acos", 1, [](double x, double) { return std::acos(clamped(x)); }, cosine},
    {"acosh", 1, [](double x, double) { return std::acosh(x); }},
    {"asin", 1, [](double x, double) { return std::asin(clamped(x)); }, cosine},
    {"asinh", 1, [](double x, double) { return std::asinh(x); }},
    {"atan", 1, [](double x, double) { return std::atan(x); }},
    {"atan2", 2, [](double y, double x) { return std::atan2(y, x); }},
    {"atanh", 1, [](double x, double) { return std::atanh(x); }},
    {"ceil", 1, [](double x, double) { return std::ceil(x); }},
    {"cos", 1, [](double x, double) { return std::cos(x); }},
    {"cosh", 1, [](double x, double) { return std::cosh(x); }},
    {"degrees", 1, [](double x, double) { return x / degree; }},
    {"div", 2, [](double x, double y) { return std::trunc(x / y); }, not_zero},
    {"exp", 1, [](double x, double) { return std::exp(x); }},
    {"floor", 1, [](double x, double) { return std::floor(x); }},
    {"int", 1, [](double x, double) { return std::trunc(x); }},
    {"ln", 1, [](double x, double) { return std::log(x); }, positive},
    {"log", 1, [](double x, double) { return std::log10(x); }, positive},
    {"mod", 2, [](double x, double y) { return std::fmod(x, y); }, not_zero},
    {"pow", 2, [](double x, double y) { return std::pow(x, y); }, power},
    {"radians", 1, [](double x, double) { return x * degree; }},
    {"sin", 1, [](double x, double) { return std::sin(x); }},
    {"sinh", 1, [](double x, double) { return std::sinh(x); }},
    {"sqr", 1, [](double x, double) { return x * x; }},
    {"sqrt", 1, [](double x, double) { return std::sqrt(x); }, not_negative},
    {"tan", 1, [](double x, double) { return std::tan(x); }},
    {"tanh", 1, [](double x, double) { return std::tanh(x); }},
});

}  // namespace

const NumberFunction* number_function(std::string_view name) {
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&](const NumberFunction& f) { return f.name == name; });
    return found == functions.end() ? nullptr : &*found;
}

std::string number_text(double value, int length, int precision) {
    const int width = std::min(std::abs(length), 1000);
    precision = std::clamp(precision, -1, 100);
    std::array<char, 1500> text{};
    const char* format =
        precision < 0 ? (length < 0 ? "%0*f" : "%*f") : (length < 0 ? "%0*.*f" : "%*.*f");
    // A double has at most 309 digits before the point, so that the longest text fits.
    if (precision < 0) {
        std::snprintf(text.data(), text.size(), format, width, value);
    } else {
        std::snprintf(text.data(), text.size(), format, width, precision, value);
    }
    return text.data();
}

}  // namespace icespar
