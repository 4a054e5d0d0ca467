// Comments, numbers, names, strings and punctuation of the scene language.
#include "parser/lexer.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "parser/diagnostic.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name(char c) { return is_letter(c) || is_digit(c); }
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// What other languages write with this character.
std::string habit(std::string_view character) {
    if (character == "%") return ": the remainder is mod(a, b)";
    if (character == "^") return ": the power is pow(a, b)";
    if (character == "'" || character == "\xe2\x80\x9c" || character == "\xe2\x80\x9d" ||
        character == "\xe2\x80\x9e") {
        return ": strings stand within straight double quotes";
    }
    return {};
}

bool is_unit(std::string_view text) {
    static constexpr std::array<std::string_view, 8> units{"mm", "cm", "m",   "nm",
                                                           "um", "in", "deg", "rad"};
    return std::find(units.begin(), units.end(), text) != units.end();
}

class Lexer {
public:
    Lexer(std::uint32_t file, std::string_view text, Names& names, std::size_t most)
        : text_(text), names_(names), most_(most) {
        out_.file = file;
        out_.tokens.reserve(std::min(text.size() / 4, most) + 2);
    }

    TokenFile run() {
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
        while (skip_blanks()) {
            one();
            const bool many_names = names_.size() > limits::names;
            if (out_.tokens.size() < most_ && !many_names) continue;
            push_string(tok::bad, at_,
                        many_names ? "more than " + std::to_string(limits::names) +
                                         " different names, the bound"
                                   : "the files of this scene have more than " +
                                         std::to_string(limits::tokens) + " tokens, the bound");
            break;
        }
        push(tok::end, text_.size());
        return std::move(out_);
    }

private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    void push(char kind, std::size_t begin, std::uint32_t index = 0, double number = 0) {
        out_.tokens.push_back({kind, static_cast<std::uint32_t>(begin),
                               static_cast<std::uint32_t>(at_), index, number});
    }
    void push_string(char kind, std::size_t begin, std::string text) {
        out_.strings.push_back(std::move(text));
        push(kind, begin, static_cast<std::uint32_t>(out_.strings.size() - 1));
    }

    /// Past spaces and comments; false at the end.
    bool skip_blanks() {
        for (;;) {
            while (at_ < text_.size() && is_space(text_[at_])) ++at_;
            if (at_ >= text_.size()) return false;
            if (peek() == '/' && peek(1) == '/') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (peek() == '/' && peek(1) == '*') {
                block_comment();
            } else {
                return true;
            }
        }
    }

    /// Comments nest, as in POV-Ray.
    void block_comment() {
        const std::size_t begin = at_;
        int depth = 0;
        while (at_ < text_.size()) {
            if (peek() == '/' && peek(1) == '*') {
                ++depth;
                at_ += 2;
            } else if (peek() == '*' && peek(1) == '/') {
                at_ += 2;
                if (--depth == 0) return;
            } else {
                ++at_;
            }
        }
        at_ = std::min(begin + 2, text_.size());
        push_string(tok::bad, begin, "this comment is never closed: '*/' is missing");
        at_ = text_.size();
    }

    void one() {
        const std::size_t begin = at_;
        const char c = peek();
        if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
        if (is_letter(c)) {
            while (is_name(peek())) ++at_;
            if (at_ - begin > limits::name_bytes) {
                return push_string(tok::bad, begin,
                                   "this name is longer than " +
                                       std::to_string(limits::name_bytes) +
                                       " characters, the bound");
            }
            return push(tok::word, begin, names_.number(text_.substr(begin, at_ - begin)));
        }
        if (c == '"') return text();
        if (c == '#') return directive();
        ++at_;
        const char next = peek();
        if (c == '<' && next == '=') return ++at_, push(tok::less_equal, begin);
        if (c == '>' && next == '=') return ++at_, push(tok::greater_equal, begin);
        if (c == '!' && next == '=') return ++at_, push(tok::not_equal, begin);
        if (std::string_view("{}()[]<>=!+-*/,;:?&|.").find(c) != std::string_view::npos) {
            return push(c, begin);
        }
        // A character of several bytes is one mistake.
        while ((static_cast<unsigned char>(peek()) & 0xc0) == 0x80) ++at_;
        const std::string_view character = text_.substr(begin, at_ - begin);
        push_string(tok::bad, begin,
                    "unexpected character '" + printable(character) + "'" + habit(character));
    }

    void number() {
        const std::size_t begin = at_;
        double value = 0;
        const char* first = text_.data() + begin;
        const auto result = fast_float::from_chars(first, text_.data() + text_.size(), value);
        at_ = begin + std::max<std::size_t>(1, static_cast<std::size_t>(result.ptr - first));
        if (is_name(peek()) || (peek() == '.' && is_digit(peek(1)))) {
            const std::size_t digits = at_;
            while (is_name(peek()) || peek() == '.') ++at_;
            std::string message =
                "'" + printable(text_.substr(begin, at_ - begin)) + "' is not a number";
            if (is_unit(text_.substr(digits, at_ - digits)))
                message += ": leave out the unit (lengths are millimetres, angles degrees)";
            return push_string(tok::bad, begin, std::move(message));
        }
        if (!std::isfinite(value)) {
            return push_string(tok::bad, begin, "this number is too large");
        }
        push(tok::number, begin, 0, value);
    }

    void text() {
        const std::size_t begin = at_++;
        std::string value;
        for (;; ++at_) {
            const char c = peek();
            if (at_ >= text_.size() || c == '\n') {
                return push_string(tok::bad, begin, "this string is never closed: '\"' is missing");
            }
            if (c == '"') break;
            if (c != '\\' || at_ + 1 >= text_.size() || peek(1) == '\n') {
                value += c;
                continue;
            }
            ++at_;
            static constexpr std::string_view letters = "abfnrtv", meanings = "\a\b\f\n\r\t\v";
            const std::size_t escape = letters.find(peek());
            value += escape == std::string_view::npos ? peek() : meanings[escape];
        }
        ++at_;
        if (value.size() > limits::string_bytes) {
            return push_string(tok::bad, begin,
                               "this string is longer than " +
                                   std::to_string(limits::string_bytes) + " bytes, the bound");
        }
        push_string(tok::text, begin, std::move(value));
    }

    void directive() {
        const std::size_t begin = at_++;
        while (peek() == ' ' || peek() == '\t') ++at_;
        const std::size_t word = at_;
        while (is_name(peek())) ++at_;
        if (word == at_) {
            at_ = begin + 1;
            return push_string(tok::bad, begin, "'#' without a word after it");
        }
        if (at_ - word > limits::name_bytes) {
            return push_string(tok::bad, begin, "this is no directive");
        }
        push(tok::directive, begin, names_.number(text_.substr(word, at_ - word)));
    }

    std::string_view text_;
    Names& names_;
    std::size_t most_;
    TokenFile out_;
    std::size_t at_ = 0;
};

}  // namespace

std::uint32_t Names::number(std::string_view text) {
    const auto found = numbers_.find(text);
    if (found != numbers_.end()) return found->second;
    names_.push_back({std::string(text), word_info(text)});
    const auto index = static_cast<std::uint32_t>(names_.size() - 1);
    numbers_.emplace(names_.back().text, index);
    return index;
}

TokenFile tokenize(std::uint32_t file, std::string_view text, Names& names, std::size_t most) {
    return Lexer(file, text, names, most).run();
}

}  // namespace icespar
