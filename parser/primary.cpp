// The smallest parts of expressions: literals, names, vectors, colours and arrays.
#include <algorithm>
#include <cmath>

#include "parser/limits.hpp"
#include "parser/parser.hpp"
#include "parser/spline.hpp"

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
        default: {
            const bool doubled = token.kind == last_.kind && last_place_.end == start.begin &&
                                 last_place_.file == start.file;
            throw Fault{start, "expected a value, found " + shown(token),
                        doubled ? "it is written once: " + shown(token) : std::string()};
        }
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
        if (!value.spline() || peek_operator().kind != '(') return value;
        next();
        const Argument none(*this, 0);
        const double t = number_argument("where the spline is asked");
        expect(')', "')'");
        return checked((**value.spline())(t), where);
    }
    const WordInfo& info = names_[token.index].info;
    if (info.kind != WordKind::name && !info.may_be_declared) {
        throw Fault{where, "expected a value, found the word '" + name + "'", {}};
    }
    std::string message = "'" + name + "' is not declared";
    std::string hint = hint_for_name(where, name, raw(1).kind == '(');
    for (const auto& [local, slot_given] : frame().locals) {
        if (local == token.index) {
            message = "parameter '" + name + "' was given a name that is not declared";
            hint.clear();
        }
    }
    if (const auto file = library_file_with(name)) {
        hint = "it stands in #include \"" + std::string(*file) + "\"";
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

}  // namespace icespar
