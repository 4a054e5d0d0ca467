// Functions of strings.
#include <cmath>
#include <cstdlib>

#include "parser/arguments.hpp"
#include "parser/functions.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace {

std::string mapped(std::string text, int (*f)(int)) {
    for (char& c : text) c = static_cast<char>(f(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace

std::optional<std::variant<double, std::string>> string_function(std::string_view name,
                                                                 const Arguments& a) {
    if (name == "strlen") {
        a.count(1, 1);
        return static_cast<double>(a.text(0).size());
    }
    if (name == "strcmp") {
        a.count(2, 2);
        const int order = a.text(0).compare(a.text(1));
        return order < 0 ? -1.0 : order > 0 ? 1.0 : 0.0;
    }
    if (name == "asc") {
        a.count(1, 1);
        if (a.text(0).empty()) throw Fault{a.whole, "an empty string has no first character", {}};
        return static_cast<double>(static_cast<unsigned char>(a.text(0)[0]));
    }
    if (name == "val") {
        a.count(1, 1);
        const std::string& text = a.text(0);
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (end == text.c_str() || !std::isfinite(value))
            throw Fault{a.whole, "the text '" + printable(text) + "' holds no number", {}};
        return value;
    }
    if (name == "chr") {
        a.count(1, 1);
        const int code = a.integer(0);
        if (code < 1 || code > 255) throw Fault{a.whole, "chr() takes a number from 1 to 255", {}};
        return std::string(1, static_cast<char>(code));
    }
    if (name == "concat") {
        std::string out;
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            out += a.text(i);
            if (out.size() > limits::string_bytes) break;
        }
        return out;
    }
    if (name == "strlwr" || name == "strupr") {
        a.count(1, 1);
        return mapped(
            a.text(0), name == "strlwr" ? [](int c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; }
                                        : [](int c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
    }
    if (name == "substr") {
        a.count(3, 3);
        const int first = a.integer(1), length = a.integer(2);
        const auto size = static_cast<int>(a.text(0).size());
        if (first < 1 || length < 0 || first - 1 > size || length > size - (first - 1)) {
            throw Fault{a.whole,
                        "the string has " + std::to_string(size) +
                            " characters, counted from 1: there is no such part of it",
                        {}};
        }
        return a.text(0).substr(static_cast<std::size_t>(first - 1),
                                static_cast<std::size_t>(length));
    }
    if (name == "str") {
        a.count(3, 3);
        return number_text(a.number(0), a.integer(1), a.integer(2));
    }
    if (name == "vstr") {
        a.count(5, 5);
        const int size = std::clamp(a.integer(0), 2, 5);
        const Numbers* n = a.values[1].numbers();
        if (!n) a.wrong(1, "a vector");
        std::string out;
        for (int i = 0; i < size; ++i) {
            if (i > 0) out += a.text(2);
            const auto k = static_cast<std::size_t>(i);
            out += number_text(n->size == 1 ? n->c[0] : n->c[k], a.integer(3), a.integer(4));
        }
        return out;
    }
    return std::nullopt;
}

}  // namespace icespar
