// The smallest parts of expressions: literals, names, vectors, colours and arrays.
#include <algorithm>
#include <cmath>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {

Value Parser::primary(Context context) {
    const Token token = peek();
    const Place start = place(token);
    switch (token.kind) {
        case tok::number:
            next();
            return token.number;
        case tok::text: {
            const std::string& text = frame().file->strings[token.index];
            next();
            return text_value(text, start);
        }
        case '(': {
            next();
            const Argument none(*this, 0);
            const Value value = expression();
            expect(')', "')'");
            return value;
        }
        case '<':
            return vector_literal();
        case tok::bad:
            next();
            throw Fault{start, shown(token), {}};
        case tok::word:
            break;
        default:
            throw Fault{start, "expected a value, found " + shown(token), {}};
    }
    const std::string_view name = names_[token.index].text;
    if (name.starts_with("rgb") || name.starts_with("srgb") || name == "color" ||
        name == "colour") {
        if (names_[token.index].info.kind == WordKind::value) return colour_value(token, context);
    }
    if (name == "array") {
        next();
        return array_value(start);
    }
    if (const auto value = constant(name)) {
        next();
        return *value;
    }
    if (names_[token.index].info.kind == WordKind::value && raw(1).kind == '(') {
        next();
        const Nesting nesting(*this, start);
        const Argument none(*this, 0);
        return function_call(name, token);
    }
    return name_value(token);
}

Value Parser::text_value(std::string text, const Place& where) {
    text_bytes_ += text.size();
    if (text.size() > limits::string_bytes || text_bytes_ > limits::string_bytes_in_all) {
        diagnostics_.fatal(where, "this string is longer than " +
                                      std::to_string(limits::string_bytes) +
                                      " bytes, the bound, or all are together longer than " +
                                      std::to_string(limits::string_bytes_in_all >> 20) + " MiB");
    }
    return text;
}

Value Parser::name_value(const Token& token) {
    const Place where = place(token);
    const std::string name = names_[token.index].text;
    const SlotPtr slot = find_shared(token.index);
    if (slot && slot->value) {
        const Value value = *slot->value;
        next();
        return value;
    }
    const WordInfo& info = names_[token.index].info;
    if (info.kind != WordKind::name && !info.may_be_declared) {
        throw Fault{where, "expected a value, found the word '" + name + "'", {}};
    }
    std::string message = "'" + name + "' is not declared";
    std::string hint = hint_for_name(name, raw(1).kind == '(');
    for (const auto& [local, slot_given] : frame().locals) {
        if (local == token.index) {
            message = "parameter '" + name + "' was given a name that is not declared";
            hint.clear();
        }
    }
    next();
    diagnostics_.error(where, message, hint);
    // The arguments of a macro that does not exist say nothing.
    if (peek_operator().kind == '(') {
        next();
        const Argument none(*this, 0);
        while (!peek_is(')') && !peek_is(tok::end)) {
            expression();
            if (!accept(',')) break;
        }
        expect(')', "')'");
    }
    return {};
}

Value Parser::vector_literal() {
    next();
    const Place start = last_place_;
    const Nesting nesting(*this, start);
    const Argument none(*this, 0);
    Numbers vector;
    int size = 0;
    bool known = true;
    do {
        const Place at = here();
        const Value value = expression(Context::vector);
        if (size == 5) throw Fault{at, "a vector has at most five components", {}};
        known = known && !value.empty();
        if (!value.empty()) {
            const Numbers* n = value.numbers();
            if (!n || n->size != 1) {
                throw Fault{joined(at, last_place_),
                            "a component of a vector is a float, not " + kind_of(value),
                            {}};
            }
            vector.c[static_cast<std::size_t>(size)] = n->c[0];
        }
        ++size;
    } while (accept(','));
    expect('>', "',' or '>'");
    if (size < 2)
        throw Fault{joined(start, last_place_), "a vector has at least two components", {}};
    vector.size = size;
    if (!known) return {};
    return vector;
}

namespace {

double linear_from_srgb(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

/// `rgb <1, 0, 0>`, `srgbt <...>`, `color Red`, `color red 1 green 0.5`.
Value Parser::colour_value(const Token& word, Context context) {
    next();
    const Place start = last_place_;
    const Nesting nesting(*this, start);
    const std::string_view name = names_[word.index].text;
    const bool prefix = name == "color" || name == "colour";
    if (prefix) {
        const Token& after = peek();
        if (after.kind == tok::word) {
            const std::string_view next_name = names_[after.index].text;
            static constexpr std::array<std::string_view, 5> parts{"red", "green", "blue", "filter",
                                                                   "transmit"};
            if (std::find(parts.begin(), parts.end(), next_name) != parts.end()) {
                return colour_components(Numbers{{}, 5, true});
            }
        }
    }
    // `rgb` takes the whole expression after it, as in POV-Ray: rgb <1, 1, 1>*0.5 is a grey.
    const Place at = here();
    const Value value = sum(context == Context::full ? Context::item : context);
    if (value.empty()) return {};
    const Numbers* given = value.numbers();
    const Place whole = joined(at, last_place_);
    if (!given) throw Fault{whole, "a colour is made of numbers, not of " + kind_of(value), {}};
    Numbers colour{given->c, 5, true};
    const bool filter = !prefix && (name.ends_with("f") || name.ends_with("ft"));
    const bool transmit = !prefix && name.ends_with("t");
    if (!given->colour) {
        const int wanted = 3 + (filter ? 1 : 0) + (transmit ? 1 : 0);
        if (given->size == 1) {
            colour.c.fill(given->c[0]);
        } else if (given->size != wanted && !(prefix && given->size == 5)) {
            throw Fault{whole,
                        "'" + std::string(name) + "' takes a vector of " + std::to_string(wanted) +
                            ", not of " + std::to_string(given->size),
                        given->size == 4 ? "rgbf or rgbt take four, rgbft five" : ""};
        }
        if (transmit && !filter) colour.c[4] = colour.c[3];
        if (!prefix && !transmit) colour.c[4] = 0;
        if (!prefix && !filter) colour.c[3] = 0;
        if (prefix && given->size != 5) colour.c[3] = colour.c[4] = 0;
    }
    if (name.starts_with("srgb")) {
        for (std::size_t i = 0; i < 3; ++i) colour.c[i] = linear_from_srgb(colour.c[i]);
    }
    return colour_components(colour);
}

/// Words such as `filter 0.5` after a colour change that component.
Value Parser::colour_components(Numbers colour) {
    static constexpr std::array<std::string_view, 5> parts{"red", "green", "blue", "filter",
                                                           "transmit"};
    for (;;) {
        const Token token = peek_operator();
        if (token.kind != tok::word) return colour;
        const auto part = std::find(parts.begin(), parts.end(), names_[token.index].text);
        if (part == parts.end()) return colour;
        next();
        colour.c[static_cast<std::size_t>(part - parts.begin())] = number_argument("a float");
    }
}

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
