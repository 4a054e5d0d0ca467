// Telling the texts that a scene is made of from other files.
#pragma once

#include <string>
#include <string_view>

namespace icespar {

/// Why these bytes are no text that could be a scene; empty when they are one.
[[nodiscard]] std::string not_a_text(std::string_view bytes);

/// A return without a line feed, which old editors write, ends a line too: it becomes one.
void unify_line_ends(std::string& text);

}  // namespace icespar
