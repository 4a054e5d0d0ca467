// The directives that declare, include and report.
#include <algorithm>
#include <array>

#include "parser/encoding.hpp"
#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

bool opens_condition(std::string_view directive) {
    static constexpr std::array<std::string_view, 6> openers{"if",    "ifdef", "ifndef",
                                                             "while", "for",   "switch"};
    return std::find(openers.begin(), openers.end(), directive) != openers.end();
}

}  // namespace

void Parser::run_directive() {
    const Token token = raw();
    const Place where = place(token);
    const std::size_t frames = frames_.size();
    ++frame().at;
    count_token();
    const Nesting nesting(*this, where);
    const Argument argument(*this, frames);
    const std::string_view name = names_[token.index].text;
    try {
        if (name == "declare" || name == "local") return declare(name == "local");
        if (name == "if") return branch(token, condition_value());
        if (name == "ifdef") return branch(token, defined_argument());
        if (name == "ifndef") return branch(token, !defined_argument());
        if (name == "else" || name == "elseif") return else_or_elseif(token);
        if (name == "end") return end_of_condition(token);
        if (name == "while") return start_while(token);
        if (name == "for") return start_for(token);
        if (name == "switch") return start_switch(token);
        if (name == "case" || name == "range") return else_or_elseif(token);
        if (name == "break") return leave_by_break(token);
        if (name == "macro") return define_macro(token);
        if (name == "include") return include();
        if (name == "undef") return undef();
        if (name == "default") return set_default();
        if (name == "debug" || name == "warning" || name == "error") {
            return text_directive(name, where);
        }
        if (name == "version") return version();
        const WordInfo& info = names_[token.index].info;
        if (info.kind == WordKind::refused) {
            throw Fault{where, "'#" + std::string(name) + "' is not read here",
                        std::string(info.advice)};
        }
        throw Fault{
            where, "unknown directive '#" + std::string(name) + "'",
            name == "define" ? "did you mean 'declare'?" : did_you_mean(name, directive_words())};
    } catch (const Fault& fault) {
        diagnostics_.error(fault);
        // What is left of the line belongs to the broken directive.
        while (frames_.size() > frames) frames_.pop_back();
        if (frames_.size() < frames) return;
        // What a broken head governs is passed over with it, so that its '#end' is not a fault too.
        if (opens_condition(name)) {
            try {
                skip_to({"end"}, token);
            } catch (const Fault& unclosed) {
                diagnostics_.error(unclosed);
            }
            return;
        }
        Token from = token;
        if (fault.place.file == where.file) from.begin = std::max(token.end, fault.place.begin);
        skip_line(from);
    }
}

void Parser::declare(bool local) {
    const Token token = raw();
    if (token.kind != tok::word) {
        throw Fault{place(token), "expected a name to declare, found " + shown(token), {}};
    }
    const Place where = place(token);
    const Name& name = names_[token.index];
    if (!name.info.may_be_declared) {
        throw Fault{where, "'" + name.text + "' is a word of the language and cannot be declared",
                    "choose another name"};
    }
    ++frame().at;
    if (raw().kind == '[') {
        const SlotPtr slot = find_shared(token.index);
        if (!slot || !slot->value) {
            throw Fault{where, "'" + name.text + "' is not declared",
                        hint_for_name(where, name.text, false)};
        }
        assign_element(slot, where);
    } else {
        if (raw().kind != '=') {
            throw Fault{
                place(raw()), "expected '=' after '" + name.text + "', found " + shown(raw()), {}};
        }
        ++frame().at;
        const auto slot_for_name = [&] {
            return local ? local_slot(token.index) : declare_slot(token.index);
        };
        if (raw().kind == tok::word && names_[raw().index].text == "function" &&
            raw(1).kind == '(') {
            *slot_for_name() = Slot{std::nullopt, function_macro()};
            if (raw().kind == ';') ++frame().at;
            return;
        }
        Value value;
        try {
            value = declared_value();
        } catch (const Fault&) {
            // The name is there all the same, so that its uses are not faults too.
            while (frames_.size() > argument_frame_) frames_.pop_back();
            *slot_for_name() = Slot{Value{}, nullptr};
            throw;
        }
        // An array is a value: the copy shares elements until one of them is assigned.
        *slot_for_name() = Slot{std::move(value), nullptr};
    }
    if (peek_operator().kind == ';') ++frame().at;
}

void Parser::assign_element(const SlotPtr& slot, const Place& where) {
    std::vector<std::pair<double, Place>> path;
    while (raw().kind == '[') {
        ++frame().at;
        const Argument none(*this, 0);
        const Place start = here();
        const double index = number_argument("an index");
        path.emplace_back(index, joined(start, last_place_));
        expect(']', "']'");
    }
    if (raw().kind != '=') throw Fault{place(raw()), "expected '=', found " + shown(raw()), {}};
    ++frame().at;
    Value value = declared_value();
    if (!slot->value || slot->value->empty()) return;

    // Arrays are values: one that something else holds too is copied before it is changed.
    Value* element = &*slot->value;
    int depth = depth_of(value);
    for (const auto& [index, at] : path) {
        if (!element->array()) {
            throw Fault{
                where, "this is " + kind_of(*element) + ", not an array of so many dimensions", {}};
        }
        auto& array = std::get<std::shared_ptr<Array>>(element->is);
        if (array.use_count() > 1) {
            count_array(array->elements.size(), where);
            array = std::make_shared<Array>(*array);
        }
        element = &array->elements[checked_index(index, *array, at)];
        check_depth(++depth, where);
    }
    element = &*slot->value;
    depth = depth_of(value) + static_cast<int>(path.size());
    for (const auto& [index, at] : path) {
        auto& array = std::get<std::shared_ptr<Array>>(element->is);
        array->depth = std::max(array->depth, depth--);
        element = &array->elements[checked_index(index, *array, at)];
    }
    *element = std::move(value);
}

void Parser::undef() {
    const Token token = raw();
    if (token.kind != tok::word) {
        throw Fault{place(token), "expected a name after '#undef', found " + shown(token), {}};
    }
    ++frame().at;
    if (Slot* slot = find(token.index)) *slot = Slot{};
    if (raw().kind == ';') ++frame().at;
}

void Parser::include() {
    const Place where = place(raw());
    if (raw().kind == tok::word && !find(raw().index) && raw(1).kind == '.') {
        throw Fault{where, "the name of a file stands in quotes",
                    "#include \"" + names_[raw().index].text + ".inc\""};
    }
    const Value value = primary(Context::full);
    if (value.empty()) return;
    if (!value.text()) throw Fault{where, "expected the name of a file in quotes", {}};
    const std::string& name = *value.text();

    const auto depth = std::count_if(frames_.begin(), frames_.end(),
                                     [](const Frame& f) { return f.macro == nullptr; });
    if (depth > limits::include_depth) {
        const bool self = name == sources_.file(where.file).name;
        diagnostics_.fatal(where,
                           "files include each other more than " +
                               std::to_string(limits::include_depth) + " deep, the bound",
                           self ? "'" + printable(name) + "' includes itself" : std::string());
    }

    const auto found = sources_.find(name, sources_.file(where.file).folder);
    const auto from_library = found.path ? std::nullopt : library_file(name);
    if (!found.path && !from_library) {
        if (found.forbidden) {
            throw Fault{where, "'" + printable(name) + "' lies outside the scene's folder",
                        "move it beside the scene, or allow its folder with --allow"};
        }
        if (is_pov_include(name)) {
            diagnostics_.warning(where, "POV-Ray's " + name + " is left out: there is none here",
                                 "what it declares has to be declared by the scene");
            return;
        }
        std::string hint = did_you_mean(name, library_names());
        if (hint.empty()) hint = "the library has " + listed(library_names(), " and ");
        throw Fault{where, "there is no file '" + printable(name) + "'", hint};
    }
    const std::string key = found.path ? found.path->string() : "library:" + name;
    const TokenFile*& tokens = included_[key];
    if (!tokens) {
        std::optional<std::string> text =
            found.path ? Sources::read(*found.path) : std::string(*from_library);
        bytes_ += text ? text->size() : 0;
        if (!text || bytes_ > limits::file_bytes_in_all) {
            diagnostics_.fatal(
                where, "'" + printable(name) + "' cannot be read, or is larger than " +
                           std::to_string(limits::file_bytes >> 20) + " MiB, the bound on a file");
        }
        if (const std::string fault = not_a_text(*text); !fault.empty()) {
            throw Fault{where, "'" + printable(name) + "' cannot be included: " + fault, {}};
        }
        const std::uint32_t file = sources_.add(
            name, found.path ? found.path->parent_path() : sources_.file(0).folder, *text);
        warn_of_encoding(sources_, diagnostics_, file);
        tokens = &read_tokens(file);
    }
    const std::uint32_t route = sources_.add_route({RouteStep::Kind::include, {}, where});
    frames_.push_back({tokens, 0, tokens->tokens.size() - 1, route});
}

/// The language is that of 3.7, whatever version is asked for; `version` yields what was.
void Parser::version() {
    if (raw().kind == tok::word && names_[raw().index].text == "unofficial") {
        frame().at += raw(1).kind == tok::word ? 2 : 1;  // the patch's name
    }
    const Place where = place(raw());
    const double number = number_argument("a version, such as 3.7");
    if (!(number >= 1 && number < 3.9)) {
        diagnostics_.warning(joined(where, last_place_),
                             "the language is that of POV-Ray 3.7, not of this version");
    }
    version_ = number;
    if (peek_operator().kind == ';') ++frame().at;
}

void Parser::text_directive(std::string_view kind, const Place& where) {
    const Value value = expression();
    std::string text = value.text() ? *value.text() : std::string();
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    text = printable(text, 400);
    if (peek_operator().kind == ';') ++frame().at;
    const Place whole = joined(where, last_place_);
    if (kind == "error") diagnostics_.fatal(whole, "the scene says: " + text);
    diagnostics_.warning(whole, "the scene says: " + text);
}

void Parser::set_default() {
    const Token token = raw();
    if (token.kind != '{') throw Fault{place(token), "expected '{', found " + shown(token), {}};
    Token word = token;
    word.index = names_.number("#default");
    const BlockPtr defaults = block(word);
    for (const Item& item : defaults->items) defaults_.push_back(item);
}

}  // namespace icespar
