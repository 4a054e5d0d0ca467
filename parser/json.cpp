// Messages as JSON, for editors and other programs.
#include <cstdio>

#include "designs/text.hpp"
#include "parser/load.hpp"

namespace icespar {
namespace {

std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : utf8(text)) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            out += escape;
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string place(int line, int column) {
    return "\"line\": " + std::to_string(line) + ", \"column\": " + std::to_string(column);
}

std::string object(const Diagnostic& d) {
    std::string stack;
    for (const CallSite& call : d.stack) {
        stack += (stack.empty() ? "" : ", ") + ("{\"macro\": " + in_quotes(call.macro)) +
                 ", \"file\": " + in_quotes(call.file) + ", " + place(call.line, call.column) + "}";
    }
    const bool error = d.severity == Diagnostic::Severity::error;
    return "{\"file\": " + in_quotes(d.file) + ", " + place(d.line, d.column) + ", \"end\": {" +
           place(d.end_line, d.end_column) +
           "}, \"severity\": " + in_quotes(error ? "error" : "warning") +
           ", \"message\": " + in_quotes(d.message) + ", \"hint\": " + in_quotes(d.hint) +
           ", \"stack\": [" + stack + "]}";
}

}  // namespace

std::string to_json(const std::vector<Diagnostic>& diagnostics) {
    std::string out;
    for (const Diagnostic& d : diagnostics) out += (out.empty() ? "[\n  " : ",\n  ") + object(d);
    return out.empty() ? "[]" : out + "\n]";
}

}  // namespace icespar
