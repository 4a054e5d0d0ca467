// Indentation from the tokens of each line; comments of several lines are left as they stand.
#include "parser/format.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "math/error.hpp"
#include "parser/encoding.hpp"
#include "parser/lexer.hpp"

namespace icespar {
namespace {

constexpr int step = 2, widest = 80;

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Something that is open: a brace, a bracket, a parenthesis, a directive that '#end' closes.
struct Open {
    char mark;   ///< 'm' for macros, '#' for the other directives
    int indent;  ///< of the line it stands in
};

class Formatter {
public:
    explicit Formatter(std::string_view text) : text_(text), file_(tokenize(0, text, names_)) {}

    std::string run();

private:
    void refuse_unclosed() const;
    [[nodiscard]] std::vector<std::size_t> lines_within_comments() const;
    void line(std::string_view line, std::size_t end);
    std::optional<int> closed_by(const Token& token);
    void opened_by(const Token& token, int indent, bool closed);
    [[nodiscard]] bool goes_on() const;
    [[nodiscard]] std::string_view directive(const Token& token) const {
        return token.kind == tok::directive ? names_[token.index].text : std::string_view();
    }

    std::string_view text_;
    Names names_;
    TokenFile file_;
    std::size_t next_ = 0;  ///< token, the first of the line
    std::vector<Open> open_;
    std::string out_;
};

void Formatter::refuse_unclosed() const {
    for (const Token& token : file_.tokens) {
        const bool unclosed =
            token.kind == tok::bad && (text_[token.begin] == '"' || text_[token.begin] == '/');
        if (!unclosed) continue;
        const auto line = 1 + std::count(text_.begin(), text_.begin() + token.begin, '\n');
        throw Error(std::to_string(line) + ": error: " + file_.strings[token.index]);
    }
}

/// Where lines begin within a comment. Between two tokens there are blanks and comments only.
std::vector<std::size_t> Formatter::lines_within_comments() const {
    std::vector<std::size_t> lines;
    std::size_t at = 0;
    for (const Token& token : file_.tokens) {
        int depth = 0;
        for (; at < token.begin; ++at) {
            const std::string_view two = text_.substr(at, 2);
            if (depth == 0 && two == "//") {
                at = std::min(text_.find('\n', at), text_.size());
            } else if (two == "/*") {
                ++depth, ++at;
            } else if (two == "*/") {
                --depth, ++at;
            } else if (depth > 0 && two[0] == '\n') {
                lines.push_back(at + 1);
            }
        }
        at = token.end;
    }
    return lines;
}

std::string Formatter::run() {
    refuse_unclosed();
    const std::vector<std::size_t> within = lines_within_comments();
    bool empty = true;
    for (std::size_t begin = 0, end = 0; begin < text_.size(); begin = end + 1) {
        end = std::min(text_.find('\n', begin), text_.size());
        std::string_view rest = text_.substr(begin, end - begin);
        while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
        if (std::binary_search(within.begin(), within.end(), begin)) {
            out_.append(rest) += '\n';
            rest = {};
            empty = false;
        } else {
            while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
            if (rest.empty() && !std::exchange(empty, true)) out_ += '\n';
            if (rest.empty()) continue;
            empty = false;
        }
        line(rest, end);
    }
    while (out_.ends_with("\n\n")) out_.pop_back();
    return std::move(out_);
}

/// Writes the line, and takes its tokens into account; an empty one was written before.
void Formatter::line(std::string_view line, std::size_t end) {
    const auto more = [&] {
        return file_.tokens[next_].kind != tok::end && file_.tokens[next_].begin < end;
    };
    int indent = open_.empty() ? 0 : open_.back().indent + step;
    if (goes_on()) indent += step;
    // A line that begins with what closes stands where that was opened.
    while (more()) {
        const Token& token = file_.tokens[next_];
        const auto opener = closed_by(token);
        if (!opener) break;
        indent = std::max(0, *opener);
        opened_by(token, indent, true);
        ++next_;
    }
    indent = std::min(indent, widest);
    if (!line.empty()) out_.append(static_cast<std::size_t>(indent), ' ').append(line) += '\n';
    for (; more(); ++next_) {
        const bool closed = closed_by(file_.tokens[next_]).has_value();
        opened_by(file_.tokens[next_], indent, closed);
    }
}

/// The indent of the line that opened what this token closes; nothing when it closes nothing.
std::optional<int> Formatter::closed_by(const Token& token) {
    const auto is_directive = [](const Open& o) { return o.mark == '#' || o.mark == 'm'; };
    const std::string_view name = directive(token);
    if (!name.empty()) {
        const bool branch = name == "else" || name == "elseif" || name == "case" || name == "range";
        if (!branch && name != "end") return std::nullopt;
        const auto found = std::find_if(open_.rbegin(), open_.rend(), is_directive);
        if (found == open_.rend()) return std::nullopt;
        const int indent = found->indent;
        const auto at = found.base() - 1;
        // Every branch may open the same brace: those of the last one stay.
        if (branch || at->mark == 'm') {
            open_.erase(at, open_.end());
        } else {
            open_.erase(at);
        }
        return indent;
    }
    static constexpr std::string_view closers = "})]", openers = "{([";
    const std::size_t which = closers.find(token.kind);
    if (which == std::string_view::npos) return std::nullopt;
    for (auto o = open_.rbegin(); o != open_.rend() && !is_directive(*o); ++o) {
        if (o->mark != openers[which]) continue;
        const int indent = o->indent;
        open_.erase(o.base() - 1, open_.end());
        return indent;
    }
    return std::nullopt;
}

/// `closed`: the token has closed the branch before it.
void Formatter::opened_by(const Token& token, int indent, bool closed) {
    static constexpr std::array<std::string_view, 6> opening{"if",    "ifdef", "ifndef",
                                                             "while", "for",   "switch"};
    const std::string_view name = directive(token);
    // A whole file within '#ifndef' is guarded against being included twice, not indented.
    const std::vector<Token>& tokens = file_.tokens;
    if (name == "ifndef" && next_ == 0 && directive(tokens[tokens.size() - 2]) == "end") {
        open_.push_back({'#', -step});
    } else if (name == "macro") {
        open_.push_back({'m', indent});
    } else if ((closed && !name.empty() && name != "end") ||
               std::find(opening.begin(), opening.end(), name) != opening.end()) {
        open_.push_back({'#', indent});
    } else if (std::string_view("{([").find(token.kind) != std::string_view::npos) {
        open_.push_back({token.kind, indent});
    }
}

/// An expression that ends its line with an operator goes on in the next.
bool Formatter::goes_on() const {
    return next_ > 0 && std::string_view("=+-*/?:&|").find(file_.tokens[next_ - 1].kind) !=
                            std::string_view::npos;
}

}  // namespace

std::string formatted(std::string_view text) {
    if (const std::string fault = not_a_text(text); !fault.empty()) {
        throw Error(" error: " + fault);
    }
    std::string lines(text);
    unify_line_ends(lines);
    return Formatter(lines).run();
}

}  // namespace icespar
