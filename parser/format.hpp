// Even indentation for a scene: what stands at the beginning of its lines, and nothing else.
#pragma once

#include <string>
#include <string_view>

namespace icespar {

/// The text with two blanks of indentation for each level of braces, brackets and directives, no
/// blanks at the ends of lines, at most one empty line in a row, and a line break at its end.
/// Tokens and comments stay as they are. Throws Error, "LINE: error: ...", where a comment or a
/// string is never closed, since then nobody knows what is text.
[[nodiscard]] std::string formatted(std::string_view text);

}  // namespace icespar
