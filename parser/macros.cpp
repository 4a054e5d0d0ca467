// Macros: a named piece of text with parameters.
#include <algorithm>
#include <unordered_map>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {

Token Parser::take_raw(char kind, std::string_view what) {
    const Token token = raw();
    if (token.kind != kind) {
        throw Fault{place(token), "expected " + std::string(what) + ", found " + shown(token), {}};
    }
    ++frame().at;
    return token;
}

void Parser::define_macro(const Token& directive) {
    const auto take_name = [&](std::string_view what) {
        const Token token = take_raw(tok::word, what);
        if (!names_[token.index].info.may_be_declared) {
            throw Fault{place(token),
                        shown(token) + " is a word of the language and cannot be declared",
                        "choose another name"};
        }
        return token.index;
    };
    const auto macro = std::make_shared<Macro>();
    std::uint32_t name = 0;
    try {
        name = take_name("the macro's name");
        take_raw('(', "'(' and the macro's parameters");
        if (raw().kind != ')') {
            macro->parameters.push_back(take_name("a parameter's name"));
            while (raw().kind == ',') {
                ++frame().at;
                macro->parameters.push_back(take_name("a parameter's name"));
            }
        }
        take_raw(')', "',' or ')'");
    } catch (const Fault& fault) {
        // The body must not be read as if it stood here.
        diagnostics_.error(fault);
        skip_to({"end"}, directive);
        return;
    }
    macro->file = frame().file;
    macro->begin = frame().at;
    skip_to({"end"}, directive);
    macro->end = frame().at - 1;
    *declare_slot(name) = Slot{std::nullopt, macro};
}

/// `function (x, y) { EXPRESSION }`: a macro whose text is the expression in parentheses. Its
/// parameters may be called x, y, z, u, v or t, which mean vectors elsewhere: they get names of
/// their own.
std::shared_ptr<const Parser::Macro> Parser::function_macro() {
    const auto take = [this](char kind, std::string_view what) {
        count_token();
        return take_raw(kind, what);
    };
    const auto macro = std::make_shared<Macro>();
    std::unordered_map<std::uint32_t, std::uint32_t> own_names;
    take(tok::word, "'function'");
    take('(', "'('");
    do {
        const Token token = take(tok::word, "a parameter's name");
        const Name& name = names_[token.index];
        if (!name.info.may_be_declared && name.text.size() > 1) {
            throw Fault{place(token), shown(token) + " is a word of the language",
                        "choose another name"};
        }
        macro->parameters.push_back(names_.number(name.text + " (a parameter)"));
        own_names[token.index] = macro->parameters.back();
    } while (raw().kind == ',' && ++frame().at);
    take(')', "',' or ')'");
    const Token open = take('{', "'{' and an expression");
    auto body = std::make_unique<TokenFile>();
    body->file = frame().file->file;
    body->tokens.push_back(open);
    body->tokens.back().kind = '(';
    while (raw().kind != '}') {
        Token token = raw();
        if (token.kind == tok::end || token.kind == '{' || token.kind == tok::text ||
            token.kind == tok::bad || token.kind == tok::directive) {
            throw Fault{place(token), "expected an expression and '}', found " + shown(token), {}};
        }
        const auto own = own_names.find(token.index);
        if (token.kind == tok::word && body->tokens.back().kind != '.' && own != own_names.end())
            token.index = own->second;
        body->tokens.push_back(token);
        ++frame().at;
        count_token();
    }
    body->tokens.push_back(take('}', "'}'"));
    body->tokens.back().kind = ')';
    macro->begin = 0;
    macro->end = body->tokens.size();
    body->tokens.push_back(Token{});
    files_.push_back(std::move(body));
    macro->file = files_.back().get();
    return macro;
}

void Parser::call_macro(std::shared_ptr<const Macro> macro) {
    const Token name_token = raw();
    const Place where = place(name_token);
    const std::string& name = names_[name_token.index].text;
    ++frame().at;
    count_token();
    const Nesting nesting(*this, where);
    const Argument none(*this, 0);

    const auto signature = [&] {
        std::string text = name + "(";
        for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
            const std::string& parameter = names_[macro->parameters[i]].text;
            text += (i > 0 ? ", " : "") + parameter.substr(0, parameter.find(' '));
        }
        return text + ")";
    };
    if (!peek_is('(')) {
        throw Fault{where, "a macro is called with its arguments in parentheses",
                    "write " + signature()};
    }
    next();
    std::vector<std::pair<std::uint32_t, SlotPtr>> arguments;
    std::size_t given = 0;
    while (!peek_is(')')) {
        if (given > 0) expect(',', "',' or ')'");
        peek();
        SlotPtr slot;
        const Token first = raw();
        const char second = raw(1).kind;
        if (first.kind == tok::word && names_[first.index].info.may_be_declared &&
            (second == ',' || second == ')')) {
            // A bare name is handed over itself: the macro may declare it.
            slot = find_shared(first.index);
            if (!slot && names_[first.index].info.kind == WordKind::name)
                slot = global_slot(first.index);
        }
        if (slot) {
            next();
        } else {
            slot = std::make_shared<Slot>(Slot{declared_value(), nullptr});
        }
        if (given < macro->parameters.size())
            arguments.emplace_back(macro->parameters[given], slot);
        ++given;
    }
    next();
    if (given != macro->parameters.size()) {
        throw Fault{joined(where, last_place_),
                    "macro '" + name + "' takes " + std::to_string(macro->parameters.size()) +
                        (macro->parameters.size() == 1 ? " argument, not " : " arguments, not ") +
                        std::to_string(given),
                    "it is " + signature()};
    }
    const auto depth = std::count_if(frames_.begin(), frames_.end(),
                                     [](const Frame& f) { return f.macro != nullptr; });
    if (depth >= limits::macro_depth) {
        diagnostics_.fatal(where,
                           "macros call each other more than " +
                               std::to_string(limits::macro_depth) + " deep, the bound",
                           "does '" + name + "' call itself without end?");
    }
    const std::uint32_t route = sources_.add_route({RouteStep::Kind::macro, name, where});
    Frame called{macro->file, macro->begin, macro->end, route, macro};
    called.locals = std::move(arguments);
    frames_.push_back(std::move(called));
}

}  // namespace icespar
