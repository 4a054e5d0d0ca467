// A formula is a list of steps on a stack of fixed height.
#include "scene/formula.hpp"

#include <array>
#include <cmath>

#include "math/error.hpp"

namespace icespar {
namespace {

constexpr int highest = 64;
constexpr std::size_t most_steps = 10'000;

}  // namespace

void Formula::add(const Step& step, int growth) {
    height_ += growth;
    if (height_ > highest || steps_.size() >= most_steps) {
        throw Error("this function is too long, or nested too deeply");
    }
    steps_.push_back(step);
}

void Formula::constant(double value) { add({Step::Kind::constant, value}, 1); }
void Formula::variable(int axis) { add({Step::Kind::variable, 0, axis}, 1); }
void Formula::apply(Function f, int arguments) {
    add({Step::Kind::apply, 0, arguments, f}, 1 - arguments);
}
void Formula::choose() { add({Step::Kind::choose}, -2); }

double Formula::operator()(const Vec3& p) const {
    const std::array<double, 3> variables{p.x, p.y, p.z};
    std::array<double, highest + 1> stack{};
    std::size_t n = 0;  // values on the stack
    for (const Step& step : steps_) {
        switch (step.kind) {
            case Step::Kind::constant:
                stack[n++] = step.value;
                break;
            case Step::Kind::variable:
                stack[n++] = variables[static_cast<std::size_t>(step.number)];
                break;
            case Step::Kind::apply:
                if (step.number == 1) {
                    stack[n - 1] = step.f(stack[n - 1], 0);
                } else {
                    --n;
                    stack[n - 1] = step.f(stack[n - 1], stack[n]);
                }
                break;
            case Step::Kind::choose:
                n -= 2;
                stack[n - 1] = stack[n - 1] != 0 ? stack[n] : stack[n + 1];
                break;
        }
    }
    return n > 0 ? stack[n - 1] : 0;
}

}  // namespace icespar
