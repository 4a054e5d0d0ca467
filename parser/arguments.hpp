// The arguments of a function call, checked one by one as the function asks for them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/value.hpp"

namespace icespar {

struct Arguments {
    std::string_view name;
    Place whole;
    std::vector<Value> values;
    std::vector<Place> places;

    void count(std::size_t least, std::size_t most) const {
        if (values.size() >= least && values.size() <= most) return;
        throw Fault{whole,
                    "'" + std::string(name) + "' takes " + std::to_string(least) +
                        (most == least ? "" : " or more") +
                        (most == 1 ? " argument, not " : " arguments, not ") +
                        std::to_string(values.size()),
                    {}};
    }
    [[noreturn]] void wrong(std::size_t i, std::string_view wanted) const {
        throw Fault{places[i],
                    "'" + std::string(name) + "' needs " + std::string(wanted) + " here, not " +
                        kind_of(values[i]),
                    {}};
    }
    [[nodiscard]] double number(std::size_t i) const {
        const Numbers* n = values[i].numbers();
        if (!n || n->size != 1) wrong(i, "a float");
        return n->c[0];
    }
    [[nodiscard]] int integer(std::size_t i) const {
        return static_cast<int>(std::clamp(number(i), -1e9, 1e9));
    }
    [[nodiscard]] std::array<double, 3> vector(std::size_t i) const {
        const Numbers* n = values[i].numbers();
        if (!n || (n->size > 3 && !n->colour)) wrong(i, "a vector of 3");
        if (n->size == 1) return {n->c[0], n->c[0], n->c[0]};
        return {n->c[0], n->c[1], n->size > 2 ? n->c[2] : 0};
    }
    [[nodiscard]] const std::string& text(std::size_t i) const {
        if (!values[i].text()) wrong(i, "a string");
        return *values[i].text();
    }
};

/// Functions that take vectors; nothing when there is none of this name.
[[nodiscard]] std::optional<Value> vector_function(std::string_view name, const Arguments& a);
/// Functions that yield strings, or measure them.
[[nodiscard]] std::optional<std::variant<double, std::string>> string_function(
    std::string_view name, const Arguments& a);

}  // namespace icespar
