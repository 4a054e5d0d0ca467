// The stream of tokens that the tree is built from, with directives and macros already carried out.
#include <algorithm>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {

Parser::Nesting::Nesting(Parser& parser, const Place& place) : parser_(parser) {
    if (parser_.nesting_ >= limits::nesting_depth) {
        parser_.diagnostics_.fatal(place, "nested deeper than " +
                                              std::to_string(limits::nesting_depth) +
                                              " levels, the bound on nesting");
    }
    ++parser_.nesting_;
}

Place Parser::place(const Token& token) const {
    const Frame& f = frames_.back();
    return {f.file->file, token.begin, token.end, f.route};
}

/// A token of the innermost frame without executing anything; the end of a frame is an end token.
const Token& Parser::raw(std::size_t ahead) const {
    static constexpr Token end{};
    const Frame& f = frames_.back();
    if (f.at + ahead < f.end) return f.file->tokens[f.at + ahead];
    return f.macro ? end : f.file->tokens[f.end];
}

void Parser::count_token() {
    if (++tokens_ > limits::tokens) {
        diagnostics_.fatal(place(raw()),
                           "the scene takes more than " + std::to_string(limits::tokens) +
                               " tokens to read, the bound",
                           "is a loop or a macro running away?");
    }
}

const TokenFile& Parser::read_tokens(std::uint32_t file) {
    files_.push_back(std::make_unique<TokenFile>(
        tokenize(file, sources_.file(file).text, names_, limits::tokens - lexed_)));
    lexed_ = std::min(limits::tokens, lexed_ + files_.back()->tokens.size());
    return *files_.back();
}

const Token& Parser::peek() {
    for (;;) {
        const Token& token = raw();
        if (frame().at >= frame().end) {
            if (frames_.size() == 1) return token;
            pop_frame();
        } else if (token.kind == tok::directive) {
            run_directive();
        } else if (token.kind == tok::word) {
            const SlotPtr slot =
                names_[token.index].info.may_be_declared ? find_shared(token.index) : nullptr;
            if (!slot || !slot->macro) return token;
            call_macro(slot->macro);
        } else {
            return token;
        }
    }
}

const Token& Parser::peek_operator() {
    if (argument_frame_ == 0) return peek();
    while (frame().at >= frame().end && frames_.size() > argument_frame_) pop_frame();
    if (frames_.size() > argument_frame_) return peek();
    return raw();
}

Token Parser::next() {
    const Token token = peek();
    last_place_ = place(token);
    last_ = token;
    if (frame().at < frame().end) ++frame().at;
    if (token.kind == '{') ++braces_;
    if (token.kind == '}') --braces_;
    count_token();
    return token;
}

bool Parser::accept(char kind) {
    if (!peek_is(kind)) return false;
    next();
    return true;
}

Token Parser::expect(char kind, std::string_view what) {
    const Token& token = peek();
    if (token.kind != kind) {
        throw Fault{place(token), "expected " + std::string(what) + ", found " + shown(token), {}};
    }
    return next();
}

std::string Parser::shown(const Token& token) const {
    if (token.kind == tok::end) return "the end of the file";
    if (token.kind == tok::bad) return frames_.back().file->strings[token.index];
    const std::string& text = sources_.file(frames_.back().file->file).text;
    return "'" + printable(std::string_view(text).substr(token.begin, token.end - token.begin)) +
           "'";
}

/// Past the tokens that begin before the line of `from` ends, up to a brace or a directive.
void Parser::skip_line(const Token& from) {
    const std::string& text = sources_.file(frame().file->file).text;
    const std::size_t line_end = std::min(text.find('\n', from.begin), text.size());
    const auto scene_words = *words_in("scene");
    for (int depth = 0; frame().at < frame().end && raw().begin < line_end; ++frame().at) {
        const char kind = raw().kind;
        if (kind == tok::directive || (kind == '}' && depth == 0)) break;
        const bool new_block = kind == tok::word && raw(1).kind == '{' && depth == 0 &&
                               std::find(scene_words.begin(), scene_words.end(),
                                         names_[raw().index].text) != scene_words.end();
        if (new_block) break;
        if (kind == '{') ++depth;
        if (kind == '}') --depth;
    }
}

void Parser::pop_frame() {
    if (!frame().conditions.empty()) {
        const Token token = frame().conditions.back().token;
        const Place where = place(token);
        const std::string name = names_[token.index].text;
        frame().conditions.clear();
        diagnostics_.error(where, "this '#" + name + "' has no '#end'");
    }
    frames_.pop_back();
}

}  // namespace icespar
