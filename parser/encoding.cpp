// Telling texts from other files by their bytes.
#include "parser/encoding.hpp"

namespace icespar {

std::string not_a_text(std::string_view bytes) {
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        return "this is a text in UTF-16: save it as UTF-8";
    if (bytes.find('\0') != std::string_view::npos)
        return "this is not a text: it has bytes that no text has";
    return {};
}

void unify_line_ends(std::string& text) {
    for (std::size_t at = 0; (at = text.find('\r', at)) != std::string::npos; ++at) {
        if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
    }
}

}  // namespace icespar
