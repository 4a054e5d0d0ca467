// Conditions and loops: the text that a condition keeps, drops or repeats.
#include <algorithm>
#include <array>
#include <cmath>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

/// POV-Ray's tolerance in comparisons.
constexpr double epsilon = 1e-10;

bool opens(std::string_view directive) {
    return directive == "if" || directive == "ifdef" || directive == "ifndef" ||
           directive == "while" || directive == "for" || directive == "switch" ||
           directive == "macro";
}

}  // namespace

std::string_view Parser::skip_to(std::initializer_list<std::string_view> directives,
                                 const Token& opened) {
    int depth = 0;
    for (; frame().at < frame().end; ++frame().at) {
        count_token();
        const Token& token = raw();
        if (token.kind != tok::directive) continue;
        const std::string_view name = names_[token.index].text;
        if (depth == 0 &&
            std::find(directives.begin(), directives.end(), name) != directives.end()) {
            ++frame().at;
            return name;
        }
        if (opens(name)) ++depth;
        if (name == "end" && --depth < 0) break;
    }
    throw Fault{place(opened), "this '#" + names_[opened.index].text + "' has no '#end'", {}};
}

/// The value in parentheses after a directive; a fault there is reported and counts as false.
bool Parser::condition_value() {
    const std::size_t frames = frames_.size();
    try {
        const Value value = factor(Context::full);
        const Numbers* n = value.numbers();
        if (!n && !value.empty()) {
            throw Fault{last_place_, "a condition is a float, not " + kind_of(value), {}};
        }
        while (frames_.size() > frames && frame().at >= frame().end) pop_frame();
        constexpr std::array operators{'=',
                                       '<',
                                       '>',
                                       '+',
                                       '-',
                                       '*',
                                       '/',
                                       '&',
                                       '|',
                                       tok::less_equal,
                                       tok::greater_equal,
                                       tok::not_equal};
        if (frame().at < frame().end &&
            std::find(operators.begin(), operators.end(), raw().kind) != operators.end()) {
            throw Fault{place(raw()), "a condition stands within parentheses", "write #if (A > 0)"};
        }
        return n && std::abs(n->c[0]) > epsilon;
    } catch (const Fault& fault) {
        diagnostics_.error(fault);
        while (frames_.size() > frames) frames_.pop_back();
        if (frame().at > 0) skip_line(frame().file->tokens[frame().at - 1]);
        return false;
    }
}

/// `(Name)`, not evaluated.
bool Parser::defined_argument() {
    if (raw().kind != '(') throw Fault{place(raw()), "expected '(', found " + shown(raw()), {}};
    ++frame().at;
    const Token name = raw();
    if (name.kind != tok::word) {
        throw Fault{place(name), "expected a name, found " + shown(name), {}};
    }
    ++frame().at;
    if (raw().kind != ')') throw Fault{place(raw()), "expected ')', found " + shown(raw()), {}};
    ++frame().at;
    return find(name.index) != nullptr;
}

void Parser::branch(const Token& directive, bool taken) {
    while (!taken) {
        const std::string_view found = skip_to({"else", "elseif", "end"}, directive);
        if (found == "end") return;
        taken = found == "else" || condition_value();
    }
    frame().conditions.push_back({Condition::Kind::branch, directive});
}

/// A further branch is reached by running into it: the end of the one that was taken.
void Parser::else_or_elseif(const Token& directive) {
    const std::string name = names_[directive.index].text;
    auto& conditions = frame().conditions;
    const bool in_choice = !conditions.empty() && conditions.back().kind == Condition::Kind::choice;
    if (in_choice && name != "elseif") {
        // Without a #break one case runs into the next, as in POV-Ray.
        if (name != "else") {
            const Argument none(*this, 0);
            expect('(', "'('");
            do {
                number_argument("a number");
            } while (accept(','));
            expect(')', "')'");
        }
        return;
    }
    if (conditions.empty() || conditions.back().kind != Condition::Kind::branch || name == "case" ||
        name == "range") {
        throw Fault{place(directive),
                    "'#" + name + "' without a '#" +
                        (name == "case" || name == "range" ? "switch" : "if") + "' before it",
                    {}};
    }
    const Token opened = conditions.back().token;
    conditions.pop_back();
    skip_to({"end"}, opened);
}

void Parser::end_of_condition(const Token& directive) {
    if (frame().conditions.empty()) {
        throw Fault{place(directive), "'#end' without anything to end", {}};
    }
    const std::size_t f = frames_.size() - 1;
    Condition& top = frames_[f].conditions.back();
    const bool loop =
        top.kind == Condition::Kind::while_loop || top.kind == Condition::Kind::for_loop;
    if (loop && ++top.turns >= limits::loop_turns) {
        diagnostics_.fatal(place(top.token),
                           "this '#" + names_[top.token.index].text + "' has run " +
                               std::to_string(limits::loop_turns) + " times, the bound on loops",
                           "does its condition ever become false?");
    }
    if (!loop) {
        frames_[f].conditions.pop_back();
        return;
    }
    const std::size_t after = frames_[f].at;
    frames_[f].at = top.again;
    const bool go_on = top.kind == Condition::Kind::for_loop ? for_goes_on(top) : condition_value();
    if (!go_on) {
        frames_[f].at = after;
        frames_[f].conditions.pop_back();
    }
}

void Parser::start_while(const Token& directive) {
    const std::size_t again = frame().at;
    if (condition_value()) {
        frame().conditions.push_back({Condition::Kind::while_loop, directive, again});
    } else {
        skip_to({"end"}, directive);
    }
}

bool Parser::for_goes_on(Condition& loop) {
    loop.value += loop.step;
    const bool on =
        loop.step > 0 ? loop.value <= loop.last + epsilon : loop.value >= loop.last - epsilon;
    if (on) *loop.variable = Slot{Value(loop.value), nullptr};
    return on;
}

void Parser::start_for(const Token& directive) {
    if (raw().kind != '(') throw Fault{place(raw()), "expected '(', found " + shown(raw()), {}};
    ++frame().at;
    const Token name = raw();
    if (name.kind != tok::word || !names_[name.index].info.may_be_declared) {
        throw Fault{place(name), "expected a name for the loop to count, found " + shown(name), {}};
    }
    ++frame().at;
    Condition loop{Condition::Kind::for_loop, directive};
    {
        const Argument none(*this, 0);
        expect(',', "',' and the first value");
        loop.value = number_argument("the first value");
        expect(',', "',' and the last value");
        loop.last = number_argument("the last value");
        if (accept(',')) loop.step = number_argument("the step");
        if (loop.step == 0) throw Fault{last_place_, "the step of this '#for' is 0", {}};
        expect(')', "')'");
    }
    loop.variable = local_slot(name.index);
    loop.again = frame().at;
    loop.value -= loop.step;
    if (for_goes_on(loop)) {
        frame().conditions.push_back(std::move(loop));
    } else {
        skip_to({"end"}, directive);
    }
}

void Parser::start_switch(const Token& directive) {
    double value = 0;
    {
        const Argument none(*this, 0);
        expect('(', "'('");
        value = number_argument("a number");
        expect(')', "')'");
    }
    for (;;) {
        const std::string_view found = skip_to({"case", "range", "else", "end"}, directive);
        if (found == "end") return;
        bool taken = found == "else";
        if (!taken) {
            const Argument none(*this, 0);
            expect('(', "'('");
            const double low = number_argument("a number");
            double high = low;
            if (found == "range") {
                expect(',', "','");
                high = number_argument("a number");
            }
            expect(')', "')'");
            taken = value >= low - epsilon && value <= high + epsilon;
        }
        if (taken) break;
    }
    frame().conditions.push_back({Condition::Kind::choice, directive});
}

void Parser::leave_by_break(const Token& directive) {
    auto& conditions = frame().conditions;
    const bool leaves_something =
        std::any_of(conditions.begin(), conditions.end(),
                    [](const auto& c) { return c.kind != Condition::Kind::branch; });
    if (!leaves_something) {
        throw Fault{place(directive), "'#break' outside of a loop and a '#switch'", {}};
    }
    for (bool done = false; !done;) {
        const Condition top = conditions.back();
        conditions.pop_back();
        skip_to({"end"}, top.token);
        done = top.kind != Condition::Kind::branch;
    }
}

}  // namespace icespar
