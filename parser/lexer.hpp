// Text to tokens. Names are numbered, so that the rest of the parser never compares strings.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/limits.hpp"
#include "parser/source.hpp"
#include "parser/words.hpp"

namespace icespar {

/// Punctuation is its own character; the rest has these.
namespace tok {
inline constexpr char end = '\0', number = 'n', word = 'w', text = 't', directive = '#', bad = 'b',
                      less_equal = 'l', greater_equal = 'g', not_equal = 'd';
}

struct Token {
    char kind = tok::end;
    std::uint32_t begin = 0, end = 0;  ///< bytes in the file
    std::uint32_t index =
        0;  ///< of words and directives: the name; of texts and bad ones: the string
    double number = 0;
};

struct Name {
    std::string text;
    WordInfo info;
};

class Names {
public:
    [[nodiscard]] std::uint32_t number(std::string_view text);
    [[nodiscard]] const Name& operator[](std::uint32_t name) const { return names_[name]; }
    [[nodiscard]] std::size_t size() const { return names_.size(); }

private:
    std::deque<Name> names_;
    std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

struct TokenFile {
    std::uint32_t file = 0;
    std::vector<Token> tokens;         ///< the last one is tok::end
    std::vector<std::string> strings;  ///< of text tokens; of bad ones, the message
};

/// Never fails: what cannot be read becomes a bad token, which is an error only when it is reached.
/// Ends with one after `most` tokens.
[[nodiscard]] TokenFile tokenize(std::uint32_t file, std::string_view text, Names& names,
                                 std::size_t most = limits::tokens);

}  // namespace icespar
