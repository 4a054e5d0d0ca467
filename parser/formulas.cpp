// function { ... }: expressions of x, y and z that are kept, not evaluated.
#include <algorithm>
#include <cmath>

#include "math/error.hpp"
#include "parser/functions.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

using F = Formula::Function;

double truth(bool b) { return b ? 1 : 0; }

struct Operator {
    char token;
    int level;  ///< from the loosest on
    F f;
};

constexpr Operator operators[] = {
    {'&', 0, [](double a, double b) { return truth(a != 0 && b != 0); }},
    {'|', 0, [](double a, double b) { return truth(a != 0 || b != 0); }},
    {'<', 1, [](double a, double b) { return truth(a < b); }},
    {'>', 1, [](double a, double b) { return truth(a > b); }},
    {tok::less_equal, 1, [](double a, double b) { return truth(a <= b); }},
    {tok::greater_equal, 1, [](double a, double b) { return truth(a >= b); }},
    {'=', 1, [](double a, double b) { return truth(a == b); }},
    {tok::not_equal, 1, [](double a, double b) { return truth(a != b); }},
    {'+', 2, [](double a, double b) { return a + b; }},
    {'-', 2, [](double a, double b) { return a - b; }},
    {'*', 3, [](double a, double b) { return a * b; }},
    {'/', 3, [](double a, double b) { return a / b; }},
};
constexpr int tightest = 4;

}  // namespace

/// One function, or four: a Stokes vector.
Value Parser::function_value(const Token& word) {
    const Place where = place(word);
    next();
    if (peek_is('(')) {
        diagnostics_.error(here(), "a function with parameters cannot be declared",
                           "write a #macro");
        while (!peek_is('{') && !peek_is(tok::end)) next();
        if (accept('{')) recover(braces_);
        return {};
    }
    expect('{', "'{' and an expression of x, y and z");
    const Nesting nesting(*this, where);
    const Argument none(*this, 0);
    const int depth = braces_;
    auto list = std::make_shared<std::vector<Formula>>();
    try {
        do {
            formula(list->emplace_back());
        } while (accept(','));
        expect('}', "',' or '}'");
        if (list->size() != 1 && list->size() != 4) {
            diagnostics_.error(joined(where, last_place_),
                               "a function of light has one expression, or the four of a Stokes "
                               "vector, not " +
                                   std::to_string(list->size()));
            return {};
        }
    } catch (const Fault& fault) {
        diagnostics_.error(fault);
        recover(depth);
        return {};
    } catch (const Error& error) {
        diagnostics_.error(where, error.what());
        recover(depth);
        return {};
    }
    return Value(FormulasPtr(std::move(list)));
}

void Parser::formula(Formula& out) {
    const Nesting nesting(*this, here());
    formula_level(out, 0);
    if (!accept('?')) return;
    formula(out);
    expect(':', "':' and the value for the other case");
    formula(out);
    out.choose();
}

void Parser::formula_level(Formula& out, int level) {
    if (level == tightest) return formula_factor(out);
    formula_level(out, level + 1);
    for (;;) {
        const char kind = peek().kind;
        const auto* found =
            std::find_if(std::begin(operators), std::end(operators),
                         [&](const Operator& o) { return o.token == kind && o.level == level; });
        if (found == std::end(operators)) return;
        next();
        formula_level(out, level + 1);
        out.apply(found->f, 2);
    }
}

void Parser::formula_factor(Formula& out) {
    const Token token = peek();
    const Place where = place(token);
    const Nesting nesting(*this, where);
    if (token.kind == '-' || token.kind == '+' || token.kind == '!') {
        next();
        formula_factor(out);
        if (token.kind == '-') out.apply([](double a, double) { return -a; }, 1);
        if (token.kind == '!') out.apply([](double a, double) { return truth(a == 0); }, 1);
        return;
    }
    if (accept('(')) {
        formula(out);
        expect(')', "')'");
        return;
    }
    if (token.kind == tok::word) {
        const std::string_view name = names_[token.index].text;
        const std::size_t axis = std::string_view("xyz").find(name);
        if (name.size() == 1 && axis < 3) {
            next();
            return out.variable(static_cast<int>(axis));
        }
        if (raw(1).kind == '(' && names_[token.index].info.kind == WordKind::value) {
            next();
            return formula_call(out, name, where);
        }
    }
    // Everything else has its value now.
    const Value value = factor(Context::full);
    if (value.empty()) return out.constant(0);
    const Numbers* n = value.numbers();
    if (!n || n->size != 1) {
        throw Fault{joined(where, last_place_),
                    "a function is made of floats, not of " + kind_of(value),
                    {}};
    }
    out.constant(n->c[0]);
}

void Parser::formula_call(Formula& out, std::string_view name, const Place& where) {
    const Argument none(*this, 0);
    expect('(', "'('");
    int count = 0;
    const F larger = [](double a, double b) { return std::max(a, b); };
    const F smaller = [](double a, double b) { return std::min(a, b); };
    const bool folds = name == "max" || name == "min";
    do {
        formula(out);
        if (folds && ++count > 1) out.apply(name == "max" ? larger : smaller, 2);
        if (!folds) ++count;
    } while (accept(','));
    expect(')', "')'");
    if (folds) return;
    const NumberFunction* f = number_function(name);
    if (!f) {
        throw Fault{where, "'" + std::string(name) + "' cannot be used in a function of light", {}};
    }
    if (count != f->arguments) {
        throw Fault{joined(where, last_place_),
                    "'" + std::string(name) + "' takes " + std::to_string(f->arguments) +
                        (f->arguments == 1 ? " argument, not " : " arguments, not ") +
                        std::to_string(count),
                    {}};
    }
    out.apply(f->f, f->arguments);
}

}  // namespace icespar
