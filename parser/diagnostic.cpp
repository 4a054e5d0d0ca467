// The form of a message, and the search for the likeliest repair.
#include "parser/diagnostic.hpp"

#include <algorithm>
#include <numeric>

#include "parser/limits.hpp"

namespace icespar {
namespace {

/// Edits (insert, delete, replace, swap neighbours) from a to b, whatever the case.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    std::iota(above.begin(), above.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0U : 1U)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1])) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

constexpr std::size_t widest_line = 110;  // characters of source shown in a message
constexpr std::size_t most_calls = 8;     // of the stack

bool same(const CallSite& a, const CallSite& b) {
    return a.macro == b.macro && a.file == b.file && a.line == b.line && a.column == b.column;
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

/// Byte offset of the n-th character, from 0.
std::size_t byte_of(std::string_view text, std::size_t n) {
    std::size_t i = 0;
    for (; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) {
            if (n == 0) break;
            --n;
        }
    }
    return i;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string out;
    for (const char c : text.substr(0, most)) {
        const auto byte = static_cast<unsigned char>(c);
        out += byte < 0x20 || byte == 0x7f ? '?' : c;
    }
    if (text.size() > most) out += "...";
    return out;
}

std::string_view likeliest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.size() > 40) return {};
    // A third of the word may be wrong, and at least one letter of a word of two.
    std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
    std::string_view found;
    for (const std::string_view candidate : candidates) {
        const auto [less, more] = std::minmax({word.size(), candidate.size()});
        if (more - less >= best) continue;
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best && distance < std::max(word.size(), candidate.size())) {
            best = distance;
            found = candidate;
        }
    }
    return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    const std::string_view found = likeliest(word, candidates);
    return found.empty() ? std::string() : "did you mean '" + std::string(found) + "'?";
}

std::string listed(std::span<const std::string_view> words, std::string_view last) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) out += i + 1 == words.size() ? last : ", ";
        out += words[i];
    }
    return out;
}

std::string to_string(const Diagnostic& d) {
    std::string out = d.file;
    if (d.line > 0) out += ":" + std::to_string(d.line) + ":" + std::to_string(d.column);
    out += d.severity == Diagnostic::Severity::error ? ": error: " : ": warning: ";
    out += d.message;
    if (d.line > 0) {
        // The line, cut to a window about the caret when it is long.
        std::string line = d.source_line;
        for (char& c : line) {
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
        }
        auto caret = static_cast<std::size_t>(std::max(0, d.column - 1));
        if (characters(line) > widest_line) {
            const std::size_t first = caret > widest_line / 2 ? caret - widest_line / 2 : 0;
            const std::size_t from = byte_of(line, first);
            line = line.substr(from, byte_of(line, first + widest_line) - from);
            caret -= first;
        }
        const std::string margin(std::to_string(d.line).size(), ' ');
        const std::size_t shown = characters(line);
        const bool within = d.end_line == d.line && d.end_column > d.column;
        auto under = within                ? static_cast<std::size_t>(d.end_column - d.column)
                     : d.end_line > d.line ? widest_line
                                           : 1;
        under = std::max<std::size_t>(1, std::min(under, shown > caret ? shown - caret : 1));
        out += "\n  " + std::to_string(d.line) + " | " + line;
        out +=
            "\n  " + margin + " | " + std::string(caret, ' ') + "^" + std::string(under - 1, '~');
        if (!d.hint.empty()) out += " " + d.hint;
    } else if (!d.hint.empty()) {
        out += "; " + d.hint;
    }
    for (const std::string& note : notes(d)) out += "\n  " + note;
    return out;
}

std::vector<std::string> notes(const Diagnostic& d) {
    std::vector<std::string> lines;
    for (const CallSite& call : d.stack) {
        if (lines.size() == most_calls) {
            lines.emplace_back("... and so on up to the scene");
            break;
        }
        lines.push_back(
            (call.macro.empty() ? "included from " : "in macro '" + call.macro + "' called at ") +
            call.file + ":" + std::to_string(call.line) + ":" + std::to_string(call.column));
    }
    return lines;
}

Diagnostic Diagnostics::at(const Place& place, std::string message, std::string hint) const {
    Diagnostic d;
    d.message = std::move(message);
    d.hint = std::move(hint);
    d.file = sources_.file(place.file).name;
    const LineColumn where = sources_.line_column(place.file, place.begin);
    d.line = where.line;
    d.column = where.column;
    d.source_line = std::string(sources_.line(place.file, where.line));
    const std::size_t size = sources_.file(place.file).text.size();
    const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(place.end, size));
    const LineColumn end = sources_.line_column(place.file, std::max(place.begin, last));
    d.end_line = end.line;
    d.end_column = end.column;
    for (std::uint32_t r = place.route; r != 0; r = sources_.route(r).call.route) {
        const RouteStep& step = sources_.route(r);
        const LineColumn at = sources_.line_column(step.call.file, step.call.begin);
        CallSite call{step.kind == RouteStep::Kind::macro ? std::string(step.name) : std::string(),
                      sources_.file(step.call.file).name, at.line, at.column};
        // What calls itself is said once.
        if (!d.stack.empty() && same(d.stack.back(), call)) continue;
        d.stack.push_back(std::move(call));
        if (d.stack.size() > most_calls) break;
    }
    return d;
}

void warn_of_encoding(const Sources& sources, Diagnostics& diagnostics, std::uint32_t file) {
    const SourceFile& source = sources.file(file);
    if (source.was_utf8) return;
    const auto first = std::find_if(source.text.begin(), source.text.end(),
                                    [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    const auto at = static_cast<std::uint32_t>(first - source.text.begin());
    diagnostics.warning({file, at, at + 2, 0}, "this file is not UTF-8: it is read as Windows-1252",
                        "save it as UTF-8");
}

/// What stands in a loop or a macro is wrong once, however often it is reached.
bool Diagnostics::is_new(const Place& place, const std::string& message) {
    return said_
        .insert(std::to_string(place.file) + ":" + std::to_string(place.begin) + ":" + message)
        .second;
}

void Diagnostics::pass_over() {
    if (++passed_over_ > limits::errors_passed_over && errors_ > 0) throw Stop{};
}

void Diagnostics::error(const Place& place, std::string message, std::string hint) {
    const bool excused = errors_ > 0 && excused_.contains({place.file, place.begin});
    if (quiet_ || excused || !is_new(place, message)) return pass_over();
    list_.push_back(at(place, std::move(message), std::move(hint)));
    if (++errors_ >= limits::errors) throw Stop{};
}

void Diagnostics::error(std::string file, std::string message) {
    Diagnostic d;
    d.file = std::move(file);
    d.message = std::move(message);
    list_.push_back(std::move(d));
    if (++errors_ >= limits::errors) throw Stop{};
}

void Diagnostics::warning(const Place& place, std::string message, std::string hint,
                          const std::string& once) {
    if (quiet_ || warnings_ >= limits::warnings) return;
    if (!is_new(place, message) || (!once.empty() && !said_.insert(once).second)) return;
    Diagnostic d = at(place, std::move(message), std::move(hint));
    d.severity = Diagnostic::Severity::warning;
    list_.push_back(std::move(d));
    ++warnings_;
}

void Diagnostics::fatal(const Place& place, std::string message, std::string hint) {
    quiet_ = false;
    if (errors_ < limits::errors) {
        list_.push_back(at(place, std::move(message), std::move(hint)));
        ++errors_;
    }
    throw Stop{};
}

}  // namespace icespar
