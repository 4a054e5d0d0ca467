// spline { ... }: a curve through values, asked like a function.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "parser/value.hpp"

namespace icespar {

struct Spline {
    enum class Kind { linear, quadratic, cubic, natural };
    Kind kind = Kind::linear;
    std::vector<std::pair<double, Numbers>> points;  ///< rising
    std::vector<Numbers> bends{};                    ///< natural: second derivatives

    /// As POV-Ray: constant beyond the ends. A cubic spline's first and last points only bend it.
    [[nodiscard]] Numbers operator()(double t) const;
    /// Once the points are there.
    void prepare();
};

}  // namespace icespar
