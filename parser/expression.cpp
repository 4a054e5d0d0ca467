// Expressions: operators and their precedence, with POV-Ray's promotion of floats to vectors.
#include <algorithm>
#include <cmath>

#include "parser/parser.hpp"

namespace icespar {
namespace {

constexpr double epsilon = 1e-10;  // POV-Ray's, in comparisons

/// Both the same size: a float fills all components, a shorter vector is filled up with zeros.
void promote(Numbers& a, Numbers& b) {
    const int size = std::max(a.size, b.size);
    for (Numbers* n : {&a, &b}) {
        if (n->size == 1) std::fill(n->c.begin(), n->c.begin() + size, n->c[0]);
        n->size = size;
    }
    a.colour = b.colour = a.colour || b.colour;
}

}  // namespace

Value Parser::checked(Numbers numbers, const Place& where) const {
    for (int i = 0; i < numbers.size; ++i) {
        if (!std::isfinite(numbers.c[static_cast<std::size_t>(i)])) {
            throw Fault{where, "the result is not a finite number", {}};
        }
    }
    return numbers;
}

Value Parser::expression(Context context) {
    const Nesting nesting(*this, place(raw()));
    const Place start = here();
    Value condition = logical(context);
    if (peek_operator().kind != '?') return condition;
    next();
    const Value yes = expression(context);
    expect(':', "':' and the value for the other case");
    const Value no = expression(context);
    if (condition.empty()) return condition;
    const Numbers* n = condition.numbers();
    if (!n || n->size != 1) {
        throw Fault{start, "what stands before '?' is a float, not " + kind_of(condition), {}};
    }
    return std::abs(n->c[0]) > epsilon ? yes : no;
}

Value Parser::logical(Context context) {
    const Place start = here();
    Value left = comparison(context);
    for (;;) {
        const char op = peek_operator().kind;
        if (op != '&' && op != '|') return left;
        next();
        const Value right = comparison(context);
        if (left.empty() || right.empty()) return {};
        const Numbers *a = left.numbers(), *b = right.numbers();
        if (!a || !b || a->size != 1 || b->size != 1) {
            throw Fault{joined(start, last_place_),
                        std::string("'") + op + "' joins two floats, not " + kind_of(left) +
                            " and " + kind_of(right),
                        {}};
        }
        const bool first = std::abs(a->c[0]) > epsilon, second = std::abs(b->c[0]) > epsilon;
        left = Value(op == '&' ? (first && second ? 1.0 : 0.0) : (first || second ? 1.0 : 0.0));
    }
}

Value Parser::comparison(Context context) {
    const Place start = here();
    Value left = sum(context);
    for (;;) {
        const char op = peek_operator().kind;
        const bool less = op == '<' || op == tok::less_equal;
        const bool greater = op == '>' || op == tok::greater_equal;
        if (!less && !greater && op != '=' && op != tok::not_equal) return left;
        if (less && context != Context::full) return left;
        if (greater && context == Context::vector) return left;
        next();
        const Value right = sum(context);
        if (left.empty() || right.empty()) return {};
        const Numbers *a = left.numbers(), *b = right.numbers();
        if (!a || !b || a->size != 1 || b->size != 1) {
            throw Fault{
                joined(start, last_place_),
                "only floats can be compared, not " + kind_of(left) + " and " + kind_of(right),
                {}};
        }
        const double p = a->c[0], q = b->c[0];
        const bool equal = std::abs(p - q) < epsilon;
        bool result = false;
        switch (op) {
            case '<':
                result = p < q;
                break;
            case '>':
                result = p > q;
                break;
            case tok::less_equal:
                result = p < q || equal;
                break;
            case tok::greater_equal:
                result = p > q || equal;
                break;
            case '=':
                result = equal;
                break;
            default:
                result = !equal;
                break;
        }
        left = Value(result ? 1.0 : 0.0);
    }
}

namespace {

Numbers combined(char op, Numbers a, Numbers b, const Place& where, const Place& divisor) {
    promote(a, b);
    for (std::size_t i = 0; i < static_cast<std::size_t>(a.size); ++i) {
        switch (op) {
            case '+':
                a.c[i] += b.c[i];
                break;
            case '-':
                a.c[i] -= b.c[i];
                break;
            case '*':
                a.c[i] *= b.c[i];
                break;
            default:
                // A colour has no filter or transmit more often than not: 0/0 stays 0 there.
                if (b.c[i] == 0 && a.colour && i >= 3 && a.c[i] == 0) break;
                if (b.c[i] == 0) throw Fault{divisor, "division by zero", {}};
                a.c[i] /= b.c[i];
        }
        if (!std::isfinite(a.c[i])) throw Fault{where, "the result is not a finite number", {}};
    }
    return a;
}

[[noreturn]] void wrong_operand(char op, const Value& left, const Value& right,
                                const Place& where) {
    const bool texts = left.text() && right.text();
    throw Fault{where,
                std::string("'") + op + "' works on floats, vectors and colours, not on " +
                    kind_of(left) + " and " + kind_of(right),
                texts ? "use concat(...) to join strings" : ""};
}

}  // namespace

Value Parser::sum(Context context) {
    const Place start = here();
    Value left = product(context);
    for (;;) {
        const char op = peek_operator().kind;
        if (op != '+' && op != '-') return left;
        next();
        const Place second = here();
        const Value right = product(context);
        if (left.empty() || right.empty()) {
            left = Value{};
            continue;
        }
        const Place whole = joined(start, last_place_);
        if (!left.numbers() || !right.numbers()) wrong_operand(op, left, right, whole);
        left = combined(op, *left.numbers(), *right.numbers(), whole, second);
    }
}

Value Parser::product(Context context) {
    const Place start = here();
    Value left = factor(context);
    for (;;) {
        const char op = peek_operator().kind;
        if (op != '*' && op != '/') return left;
        next();
        const Place second = here();
        const Value right = factor(context);
        if (left.empty() || right.empty()) {
            left = Value{};
            continue;
        }
        const Place whole = joined(start, last_place_);
        if (!left.numbers() || !right.numbers()) wrong_operand(op, left, right, whole);
        left = combined(op, *left.numbers(), *right.numbers(), whole, joined(second, last_place_));
    }
}

Value Parser::factor(Context context) {
    const Token token = peek();
    const Place start = place(token);
    if (token.kind != '-' && token.kind != '+' && token.kind != '!') {
        return postfix(primary(context), start);
    }
    next();
    const Nesting nesting(*this, start);
    Value value = factor(context);
    if (value.empty() || token.kind == '+') return value;
    if (!value.numbers()) {
        throw Fault{start, std::string("'") + token.kind + "' before " + kind_of(value), {}};
    }
    Numbers n = *value.numbers();
    for (double& c : n.c) c = token.kind == '-' ? -c : (std::abs(c) > epsilon ? 0.0 : 1.0);
    return n;
}

/// `.x`, `.red` ... and `[index]` after a value.
Value Parser::postfix(Value value, const Place& start) {
    for (;;) {
        const char kind = peek_operator().kind;
        if (kind == '.') {
            next();
            const Token word = expect(tok::word, "a component such as x or red after '.'");
            static constexpr std::array<std::string_view, 15> components{
                "x", "y", "z",   "t",     "t",    "u",      "v",       "z",
                "t", "t", "red", "green", "blue", "filter", "transmit"};
            const std::string_view name = names_[word.index].text;
            const auto found = std::find(components.begin(), components.end(), name);
            if (found == components.end()) {
                throw Fault{last_place_, "'" + std::string(name) + "' is no component of a vector",
                            "they are x y z u v t, red green blue filter transmit"};
            }
            if (value.empty()) continue;
            const Numbers* n = value.numbers();
            if (!n)
                throw Fault{joined(start, last_place_), kind_of(value) + " has no components", {}};
            const auto index = static_cast<std::size_t>(found - components.begin()) % 5;
            if (static_cast<int>(index) >= n->size && n->size > 1) {
                throw Fault{joined(start, last_place_),
                            kind_of(value) + " has no component '" + std::string(name) + "'",
                            {}};
            }
            value = Value(n->size == 1 ? n->c[0] : n->c[index]);
        } else if (kind == '[') {
            if (!value.array() && !value.empty()) {
                throw Fault{joined(start, last_place_), kind_of(value) + " has no elements", {}};
            }
            next();
            const Argument none(*this, 0);
            const Place at = here();
            const double index = number_argument("an index");
            const Place where = joined(at, last_place_);
            expect(']', "']'");
            if (value.empty()) continue;
            const std::shared_ptr<Array> array = *value.array();
            value = array->elements[checked_index(index, *array, where)];
            if (value.empty() && diagnostics_.errors() == 0) {
                throw Fault{where, "this element of the array has not been given a value", {}};
            }
        } else {
            return value;
        }
    }
}

}  // namespace icespar
