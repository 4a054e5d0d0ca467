// Colour words: rgb, srgb and color, with filter and transmit.
#include <algorithm>
#include <array>
#include <cmath>

#include "parser/parser.hpp"

namespace icespar {
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

}  // namespace icespar
