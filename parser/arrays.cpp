// Arrays: their sizes, their elements, and the bounds on both.
#include <algorithm>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {

void Parser::count_array(std::size_t elements, const Place& where) {
    array_elements_ += elements;
    if (elements > limits::array_elements || array_elements_ > limits::array_elements_in_all) {
        diagnostics_.fatal(where, "arrays of more than " + std::to_string(limits::array_elements) +
                                      " elements, the bound, or of more than " +
                                      std::to_string(limits::array_elements_in_all) + " in all");
    }
}

void Parser::check_depth(int depth, const Place& where) {
    if (depth > limits::block_depth) {
        diagnostics_.fatal(where, "more than " + std::to_string(limits::block_depth) +
                                      " blocks or arrays within each other, the bound");
    }
}

std::size_t Parser::checked_index(double index, const Array& array, const Place& where) {
    if (!(index > -0.5 && index < static_cast<double>(array.elements.size()) - 0.5)) {
        throw Fault{where,
                    "this index is outside of the array: it has " +
                        std::to_string(array.elements.size()) + " elements, counted from 0",
                    {}};
    }
    return static_cast<std::size_t>(index + 0.5);
}

/// `array[2][3]`, `array[3] {1, 2, 3}` or `array {1, 2, 3}`, after the word.
Value Parser::array_value(const Place& where) {
    std::vector<std::size_t> sizes;
    std::size_t elements = 1;
    while (peek_operator().kind == '[') {
        next();
        const Argument none(*this, 0);
        const Place at = here();
        const double size = number_argument("the array's size");
        if (!(size >= 1 && size <= static_cast<double>(limits::array_elements))) {
            throw Fault{
                at,
                "an array has from 1 to " + std::to_string(limits::array_elements) + " elements",
                {}};
        }
        sizes.push_back(static_cast<std::size_t>(size));
        if (sizes.size() > 5) throw Fault{at, "an array has at most five dimensions", {}};
        elements *= sizes.back();
        count_array(elements, where);
        expect(']', "']'");
    }
    if (peek_operator().kind == '{') return initialiser(sizes, 0);
    if (sizes.empty()) {
        throw Fault{where, "an array needs its size or its elements",
                    "write array[3], or array {1, 2, 3}"};
    }
    return array_of(sizes, 0);
}

Value Parser::array_of(const std::vector<std::size_t>& sizes, std::size_t level) {
    auto array = std::make_shared<Array>();
    array->depth = static_cast<int>(sizes.size() - level);
    array->elements.resize(sizes[level]);
    if (level + 1 < sizes.size()) {
        for (Value& element : array->elements) element = array_of(sizes, level + 1);
    }
    return array;
}

Value Parser::initialiser(const std::vector<std::size_t>& sizes, std::size_t level) {
    const Token open = peek();
    const Place where = place(open);
    const Nesting nesting(*this, where);
    expect('{', "'{'");
    const Argument none(*this, 0);
    auto array = std::make_shared<Array>();
    while (!peek_is('}')) {
        const bool nested = peek_is('{');
        array->elements.push_back(nested ? initialiser(sizes, level + 1) : declared_value());
        array->depth = std::max(array->depth, 1 + depth_of(array->elements.back()));
        check_depth(array->depth, where);
        count_array(1, where);
        if (!accept(',')) break;
    }
    expect('}', "',' or '}'");
    if (level < sizes.size()) {
        if (array->elements.size() > sizes[level]) {
            throw Fault{where,
                        "this array was declared for " + std::to_string(sizes[level]) +
                            " elements and is given " + std::to_string(array->elements.size()),
                        {}};
        }
        array->elements.resize(sizes[level]);
    }
    return array;
}

}  // namespace icespar
