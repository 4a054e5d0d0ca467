// The vocabulary: which words there are, where each may stand, and what becomes of those we do not
// render.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace icespar {

enum class WordKind {
    name,  ///< no word of the language: free to be declared
    ours,  ///< a word POV-Ray does not have: a word where it belongs, free to be declared elsewhere
    word,  ///< a word of POV-Ray's that we render
    value,      ///< starts or joins expressions: functions, constants, colour words
    directive,  ///< what may follow a '#'
    skipped,    ///< cannot matter here: left out with one warning
    refused,    ///< would change the picture: an error that names what to use instead
    other,      ///< reserved by POV-Ray, and of no use by itself
};

struct WordInfo {
    WordKind kind = WordKind::name;
    std::string_view advice{};  ///< for skipped and refused words: why, or what to use instead
    bool may_be_declared = false;
};

[[nodiscard]] WordInfo word_info(std::string_view word);

/// The words that mean something directly within this block; empty where only values may stand.
/// Nothing for a block that we do not know.
[[nodiscard]] std::optional<std::span<const std::string_view>> words_in(std::string_view block);

/// True for blocks that make sense at the top of a scene only, or within a union.
[[nodiscard]] bool is_scene_block(std::string_view word);

/// Words that may start an expression.
/// A file of POV-Ray's own library that we have nothing like.
[[nodiscard]] bool is_pov_include(std::string_view file);
[[nodiscard]] std::span<const std::string_view> value_words();
[[nodiscard]] std::span<const std::string_view> directive_words();
/// Words of POV-Ray's that are left out wherever they stand.
[[nodiscard]] std::span<const std::string_view> skipped_words();
/// Every word of the language, in the order of the alphabet, for editors.
[[nodiscard]] std::vector<std::string_view> all_words();

}  // namespace icespar
