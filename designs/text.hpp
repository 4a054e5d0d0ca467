// Text of design files: GemCad's code page, and numbers that read back as they were.
#pragma once

#include <string>
#include <string_view>

namespace icespar {

[[nodiscard]] bool is_utf8(std::string_view text);
/// UTF-8 of a text that is UTF-8 or in the code page of Windows (1252), which GemCad writes.
[[nodiscard]] std::string utf8(std::string_view text);
/// The same text for GemCad: code page 1252 where that holds it and `utf8` would read it back,
/// else UTF-8.
[[nodiscard]] std::string for_gemcad(std::string_view text);
/// The shortest digits that read back as the same double.
[[nodiscard]] std::string exact(double value);
/// A word of a file, fit for a message: short and printable.
[[nodiscard]] std::string shown(std::string_view word);
/// In one word, as names in .asc files must be; '-' when nothing is left.
[[nodiscard]] std::string one_word(std::string_view text);

}  // namespace icespar
