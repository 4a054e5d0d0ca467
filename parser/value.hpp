// What an expression yields: numbers, colours, strings, arrays and blocks.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/formula.hpp"

namespace icespar {

struct Block;
using BlockPtr = std::shared_ptr<const Block>;

/// A float (size 1), a vector of 2 to 5, or a colour: red, green, blue, filter, transmit.
struct Numbers {
    std::array<double, 5> c{};
    int size = 1;
    bool colour = false;
};

struct Array;
using FormulasPtr = std::shared_ptr<const std::vector<Formula>>;
struct Spline;
using SplinePtr = std::shared_ptr<const Spline>;

/// The empty value stands where a fault was reported: it passes through everything without a word.
struct Value {
    std::variant<std::monostate, Numbers, std::shared_ptr<const std::string>,
                 std::shared_ptr<Array>, BlockPtr, FormulasPtr, SplinePtr>
        is;

    Value() = default;
    Value(double number) : is(Numbers{{number}, 1, false}) {}
    Value(const Numbers& numbers) : is(numbers) {}
    Value(std::string text) : is(std::make_shared<const std::string>(std::move(text))) {}
    Value(std::shared_ptr<Array> array) : is(std::move(array)) {}
    Value(BlockPtr block) : is(std::move(block)) {}
    Value(FormulasPtr formulas) : is(std::move(formulas)) {}
    Value(SplinePtr spline) : is(std::move(spline)) {}

    [[nodiscard]] bool empty() const { return is.index() == 0; }
    [[nodiscard]] const Numbers* numbers() const { return std::get_if<Numbers>(&is); }
    [[nodiscard]] const std::string* text() const {
        const auto* p = std::get_if<std::shared_ptr<const std::string>>(&is);
        return p ? p->get() : nullptr;
    }
    [[nodiscard]] const std::shared_ptr<Array>* array() const {
        return std::get_if<std::shared_ptr<Array>>(&is);
    }
    [[nodiscard]] const BlockPtr* block() const { return std::get_if<BlockPtr>(&is); }
    [[nodiscard]] const SplinePtr* spline() const { return std::get_if<SplinePtr>(&is); }
    [[nodiscard]] const FormulasPtr* formulas() const { return std::get_if<FormulasPtr>(&is); }
};

/// Elements may be of any kind; an array of two dimensions is an array of arrays.
struct Array {
    std::vector<Value> elements;
    int depth = 1;  ///< arrays and blocks within each other
};

/// "a float", "a vector of 3", "a colour", "a string" ... for messages.
[[nodiscard]] std::string kind_of(const Value& value);
/// How deep arrays and blocks nest in it; 0 for numbers and strings.
[[nodiscard]] int depth_of(const Value& value);

}  // namespace icespar
