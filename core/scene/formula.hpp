// A real function of a direction, as a scene writes it: function { x*x + y }.
#pragma once

#include <vector>

#include "math/vec3.hpp"

namespace icespar {

/// Built from its operands towards its operations, as a desk calculator is fed.
class Formula {
public:
    using Function = double (*)(double, double);

    void constant(double value);
    void variable(int axis);  ///< 0: x, 1: y, 2: z
    /// Takes the place of the last value (or two) by f of it.
    void apply(Function f, int arguments);
    /// Of the last three values, the second where the first is not 0, otherwise the third.
    void choose();

    /// Whatever the numbers are: it may be infinite, or not a number.
    [[nodiscard]] double operator()(const Vec3& p) const;

private:
    struct Step {
        enum class Kind { constant, variable, apply, choose } kind;
        double value = 0;
        int number = 0;  ///< of the axis, or of arguments
        Function f = nullptr;
    };
    void add(const Step& step, int growth);

    std::vector<Step> steps_;
    int height_ = 0;
};

}  // namespace icespar
