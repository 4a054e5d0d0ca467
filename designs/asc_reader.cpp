// Reads GemCad's text format (.asc): facets by angle, distance and indices, and what the file says
// about gear, symmetry and refractive index.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "designs/design.hpp"
#include "designs/text.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

constexpr std::size_t most_facets = 10'000;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Takes the next word off the front of `rest`; empty at its end.
std::string_view next_word(std::string_view& rest) {
    rest = trimmed(rest);
    const auto end = std::find_if(rest.begin(), rest.end(), is_blank);
    const auto word = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    rest.remove_prefix(word.size());
    return word;
}

/// An `a` record so far.
struct Open {
    int line = 0;
    Tier tier{};
    bool has_angle = false, has_distance = false, name_follows = false, in_text = false;
};

class GemCadReader {
public:
    explicit GemCadReader(std::string file) : file_(std::move(file)) {}

    Design read(std::string_view text);

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw Error(file_ + ":" + std::to_string(line_) + ": " + message);
    }
    void read_line(std::string_view line);
    void read_tier_words(std::string_view rest);
    void finish_tier();
    double number(std::string_view word, const std::string& what) const;
    void set_gear(std::string_view rest);
    void set_symmetry(std::string_view rest);
    void set_refractive_index(std::string_view rest);

    std::string file_;
    int line_ = 1;
    char record_ = 0;  // of the line before: what an indented line goes on with
    bool has_gear_ = false;
    std::size_t facets_ = 0;
    std::optional<Open> open_;
    Design design_;
};

double GemCadReader::number(std::string_view word, const std::string& what) const {
    if (word.empty()) fail(what + " is missing: write it as a number");
    std::string_view digits = word;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (fault != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value)) {
        fail(shown(word) + " is not " + what + ": write it as a number, with a point for decimals");
    }
    return value;
}

void GemCadReader::set_gear(std::string_view rest) {
    design_.gear = number(next_word(rest), "the gear");
    if (design_.gear == 0) fail("the gear is 0: give the number of its teeth, such as 'g 96 0.0'");
    const std::string_view offset = next_word(rest);
    design_.gear_offset = offset.empty() ? 0 : number(offset, "the gear's offset");
    has_gear_ = true;
}

void GemCadReader::set_symmetry(std::string_view rest) {
    const std::string_view word = next_word(rest);
    const double folds = number(word, "the symmetry");
    if (folds < 1 || folds > 10'000 || folds != std::floor(folds)) {
        fail("the symmetry " + shown(word) +
             " is not a count: write 'y 8 y' for eightfold, mirrored");
    }
    design_.symmetry = static_cast<int>(folds);
    const std::string_view mirror = next_word(rest);
    design_.mirror = mirror == "y" || mirror == "Y";
}

void GemCadReader::set_refractive_index(std::string_view rest) {
    const std::string_view word = next_word(rest);
    const double n = number(word, "the refractive index");
    if (n != 0 && n < 1)
        fail("the refractive index " + shown(word) + " is below 1: write 'I 1.54'");
    design_.refractive_index = n;
}

void GemCadReader::read_tier_words(std::string_view rest) {
    Tier& tier = open_->tier;
    for (;;) {
        rest = trimmed(rest);
        if (rest.empty()) return;
        if (open_->in_text) {
            tier.instructions += (tier.instructions.empty() ? "" : " ") + utf8(rest);
            return;
        }
        const std::string_view word = next_word(rest);
        if (!open_->has_angle) {
            // A culet may be written -0, whose sign is lost in no double.
            tier.angle = number(word, "the facet's angle");
            open_->has_angle = true;
        } else if (!open_->has_distance) {
            tier.distance = number(word, "the facet's distance");
            open_->has_distance = true;
        } else if (open_->name_follows) {
            tier.cuts.back().name = utf8(word);
            open_->name_follows = false;
        } else if (word == "n") {
            if (tier.cuts.empty()) fail("'n' names no index: put it after the index it names");
            open_->name_follows = true;
        } else if (word == "G") {
            open_->in_text = true;
        } else {
            tier.cuts.push_back({number(word, "an index, 'n' or 'G'")});
        }
    }
}

void GemCadReader::finish_tier() {
    if (!open_) return;
    const Open open = std::move(*open_);
    Tier tier = open.tier;
    open_.reset();
    line_ = open.line;
    if (!open.has_angle) fail("the facet's angle is missing: write 'a ANGLE DISTANCE INDEX ...'");
    if (!open.has_distance)
        fail("the facet's distance is missing: write 'a ANGLE DISTANCE INDEX ...'");
    if (open.name_follows) fail("'n' is not followed by a name: give one, or remove it");
    if (!has_gear_) fail("a facet comes before the gear: put a line such as 'g 96 0.0' above it");
    // A table needs no index: it looks the same at all of them.
    if (tier.cuts.empty() && tier.angle == 0) tier.cuts.push_back({design_.gear_offset});
    if (tier.cuts.empty()) fail("the facet has no index: say where on the gear it is cut");
    facets_ += tier.cuts.size();
    if (facets_ > most_facets) {
        fail("more than " + std::to_string(most_facets) + " facets: split the design");
    }
    spread_names(tier);
    try {
        for (const Tier::Cut& cut : tier.cuts) {
            (void)cut_plane(tier.angle, tier.distance, cut.index, design_.gear, design_.gear_offset,
                            std::signbit(tier.angle), cut.name);
        }
    } catch (const Error& error) {
        fail(error.what());
    }
    design_.tiers.push_back(std::move(tier));
}

void GemCadReader::read_line(std::string_view line) {
    const std::string_view content = trimmed(line);
    if (content.empty()) return;
    std::string_view rest = content;
    const std::string_view word = next_word(rest);
    const bool is_record =
        !is_blank(line.front()) &&
        (word == "GemCad" ||
         (word.size() == 1 && std::string_view("gyIHFa").find(word[0]) != std::string_view::npos));
    if (!is_record) {
        // The rest of a wrapped line. Lists of indices wrap even at column 1.
        if (record_ == 'a') {
            const bool goes_on =
                is_blank(line.front()) || word == "n" || word == "G" ||
                std::string_view("+-.0123456789").find(word[0]) != std::string_view::npos;
            if (goes_on) return read_tier_words(content);
        }
        if (is_blank(line.front()) && record_ == 'H')
            return design_.headers.push_back(utf8(content));
        if (is_blank(line.front()) && record_ == 'F')
            return design_.footnotes.push_back(utf8(content));
        fail(
            "a line begins with " + shown(word) +
            ", which GemCad's format does not know: lines begin with g, y, I, H, a or F; is this a "
            "GemCad .asc file?");
    }

    const int here = line_;
    finish_tier();
    line_ = here;
    record_ = word[0];
    switch (record_) {
        case 'g':
            return set_gear(rest);
        case 'y':
            return set_symmetry(rest);
        case 'I':
            return set_refractive_index(rest);
        case 'H':
            return design_.headers.push_back(utf8(trimmed(rest)));
        case 'F':
            return design_.footnotes.push_back(utf8(trimmed(rest)));
        case 'a':
            open_.emplace().line = line_;
            return read_tier_words(rest);
        default:
            return;
    }
}

Design GemCadReader::read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text = text.substr(0, text.find('\x1A'));  // DOS ends a text with it
    // Lines end in LF, CR LF, or (old Macintosh) CR.
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        const bool is_text = std::all_of(line.begin(), line.end(), [](char c) {
            return is_blank(c) || static_cast<unsigned char>(c) >= ' ';
        });
        if (!is_text) {
            fail("this is not a text file: in GemCad, save the design as .asc");
        }
        read_line(line);
        text.remove_prefix(end);
        if (text.starts_with("\r\n")) text.remove_prefix(1);
        if (!text.empty()) text.remove_prefix(1);
        ++line_;
    }
    finish_tier();
    if (design_.tiers.empty()) {
        throw Error(file_ + ": the design has no facets: lines that begin with 'a' give them");
    }
    return std::move(design_);
}

}  // namespace

Design read_asc(std::string_view text, const std::string& name) {
    return GemCadReader(name).read(text);
}

}  // namespace icespar
