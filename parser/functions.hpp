// The functions of numbers, as a table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace icespar {

/// f(x) or f(x, y) on floats.
struct NumberFunction {
    std::string_view name;
    int arguments = 1;
    double (*f)(double, double) = nullptr;
    /// Why the function has no value there; empty when it has.
    std::string_view (*fault)(double, double) = nullptr;
};

[[nodiscard]] const NumberFunction* number_function(std::string_view name);

/// POV-Ray's str(): `length` at least so wide (filled with 0 when negative), `precision` places
/// after the point, -1 for as many as it takes.
[[nodiscard]] std::string number_text(double value, int length, int precision);

}  // namespace icespar
