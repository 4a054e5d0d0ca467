// Collecting messages: places become lines and carets, and misspelt words find their correction.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/load.hpp"
#include "parser/source.hpp"

namespace icespar {

/// A fault at a place, thrown to the nearest block that can go on after it.
struct Fault {
    Place place;
    std::string message, hint;
};

/// Thrown when going on makes no sense: too many errors, or a bound of limits.hpp was hit.
struct Stop {};

class Diagnostics {
public:
    explicit Diagnostics(const Sources& sources) : sources_(sources) {}

    /// Throws Stop when the bound on errors is reached.
    void error(const Place& place, std::string message, std::string hint = {});
    void error(const Fault& fault) { error(fault.place, fault.message, fault.hint); }
    /// A message about no place in particular.
    void error(std::string file, std::string message);
    /// `once`: at most one warning in a run has this key; an empty key always warns.
    void warning(const Place& place, std::string message, std::string hint = {},
                 const std::string& once = {});

    /// Something in the block at this place was at fault, so that nothing is said of what it lacks.
    void excuse(const Place& block) { excused_.insert({block.file, block.begin}); }

    /// The error, then Stop.
    [[noreturn]] void fatal(const Place& place, std::string message, std::string hint = {});

    /// While quiet, errors and warnings are dropped: the parser is looking for the end of a broken
    /// block.
    void set_quiet(bool quiet) { quiet_ = quiet; }
    /// A repair for a message that nobody reads need not be looked for.
    [[nodiscard]] bool quiet() const { return quiet_; }

    /// A fault that is not told, because it was told before or the parser is looking for an end.
    /// Throws Stop after very many: a loop may hold one that costs time in every turn.
    void pass_over();

    [[nodiscard]] int errors() const { return errors_; }
    [[nodiscard]] std::vector<Diagnostic> take() { return std::move(list_); }

private:
    bool is_new(const Place& place, const std::string& message);
    [[nodiscard]] Diagnostic at(const Place& place, std::string message, std::string hint) const;

    const Sources& sources_;
    std::vector<Diagnostic> list_;
    std::set<std::string> said_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> excused_;
    int errors_ = 0, warnings_ = 0, passed_over_ = 0;
    bool quiet_ = false;
};

/// Says so when a file was not UTF-8.
void warn_of_encoding(const Sources& sources, Diagnostics& diagnostics, std::uint32_t file);

/// The candidate that `word` most likely was meant to be; empty when none is near.
[[nodiscard]] std::string_view likeliest(std::string_view word,
                                         std::span<const std::string_view> candidates);
/// "did you mean 'reflection'?", or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       std::span<const std::string_view> candidates);
/// "a, b and c"
[[nodiscard]] std::string listed(std::span<const std::string_view> words, std::string_view last);
/// A piece of the user's text, made fit to print within quotes.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = 60);

}  // namespace icespar
