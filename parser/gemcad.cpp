// Reads GemCad's text format (.asc): facets by angle, distance and indices, and what the file says
// about gear, symmetry and refractive index.
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "math/error.hpp"
#include "parser/load.hpp"

namespace icespar {
namespace {

constexpr std::size_t most_facets = 100'000;
constexpr std::uintmax_t largest_file = 16u << 20;

/// A word of the file, fit for a message: short and printable.
std::string shown(std::string_view word) {
    std::string text = "'";
    for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > 24 ? "...'" : "'");
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int following = lead < 0x80   ? 0
                              : lead < 0xC2 ? -1
                              : lead < 0xE0 ? 1
                              : lead < 0xF0 ? 2
                              : lead < 0xF5 ? 3
                                            : -1;
        if (following < 0) return false;
        for (int k = 0; k < following; ++k) {
            if (++i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80)
                return false;
        }
    }
    return true;
}

/// GemCad writes the code page of Windows; what is UTF-8 already stays.
std::string utf8(std::string_view text) {
    if (is_utf8(text)) return std::string(text);
    constexpr std::array<char16_t, 32> from_0x80{
        0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
        0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const unsigned code = byte >= 0x80 && byte < 0xA0 ? from_0x80[byte - 0x80u] : byte;
        if (code < 0x80) {
            out += static_cast<char>(code);
        } else if (code < 0x800) {
            out += static_cast<char>(0xC0 | code >> 6);
            out += static_cast<char>(0x80 | (code & 0x3F));
        } else {
            out += static_cast<char>(0xE0 | code >> 12);
            out += static_cast<char>(0x80 | (code >> 6 & 0x3F));
            out += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return out;
}

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

class GemCadReader {
public:
    explicit GemCadReader(std::string file) : file_(std::move(file)) {}

    Design read(std::string_view text);

private:
    /// An `a` record: one angle and distance, and the indices it is cut at.
    struct Tier {
        int line = 0;
        std::optional<double> angle, distance;
        bool pavilion = false;
        struct Cut {
            double index;
            std::string name;
        };
        std::vector<Cut> cuts;
        bool name_follows = false, in_text = false;
    };

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
    std::optional<Tier> tier_;
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
    Tier& tier = *tier_;
    for (;;) {
        rest = trimmed(rest);
        if (rest.empty() || tier.in_text) return;
        const std::string_view word = next_word(rest);
        if (!tier.angle) {
            tier.angle = number(word, "the facet's angle");
            tier.pavilion = word.front() == '-';
        } else if (!tier.distance) {
            tier.distance = number(word, "the facet's distance");
        } else if (tier.name_follows) {
            tier.cuts.back().name = utf8(word);
            tier.name_follows = false;
        } else if (word == "n") {
            if (tier.cuts.empty()) fail("'n' names no index: put it after the index it names");
            tier.name_follows = true;
        } else if (word == "G") {
            tier.in_text = true;
        } else {
            tier.cuts.push_back({number(word, "an index, 'n' or 'G'"), {}});
        }
    }
}

void GemCadReader::finish_tier() {
    if (!tier_) return;
    Tier tier = std::move(*tier_);
    tier_.reset();
    line_ = tier.line;
    if (!tier.angle) fail("the facet's angle is missing: write 'a ANGLE DISTANCE INDEX ...'");
    if (!tier.distance) fail("the facet's distance is missing: write 'a ANGLE DISTANCE INDEX ...'");
    if (tier.name_follows) fail("'n' is not followed by a name: give one, or remove it");
    if (!has_gear_) fail("a facet comes before the gear: put a line such as 'g 96 0.0' above it");
    // A table needs no index: it looks the same at all of them.
    if (tier.cuts.empty() && *tier.angle == 0) tier.cuts.push_back({design_.gear_offset, {}});
    if (tier.cuts.empty()) fail("the facet has no index: say where on the gear it is cut");
    if (design_.planes.size() + tier.cuts.size() > most_facets) {
        fail("more than " + std::to_string(most_facets) + " facets: split the design");
    }

    // An index without a name has that of the one before it; those before the first name have it.
    const auto named = std::find_if(tier.cuts.begin(), tier.cuts.end(),
                                    [](const Tier::Cut& cut) { return !cut.name.empty(); });
    std::string name = named == tier.cuts.end() ? std::string() : named->name;
    for (const auto& cut : tier.cuts) {
        if (!cut.name.empty()) name = cut.name;
        try {
            design_.planes.push_back(cut_plane(*tier.angle, *tier.distance, cut.index, design_.gear,
                                               design_.gear_offset, tier.pavilion, name));
        } catch (const Error& error) {
            fail(error.what());
        }
    }
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
            tier_.emplace().line = line_;
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
    if (design_.planes.empty()) {
        throw Error(file_ + ": the design has no facets: lines that begin with 'a' give them");
    }
    return std::move(design_);
}

}  // namespace

Design parse_gemcad_asc(std::string_view text, const std::string& name) {
    return GemCadReader(name).read(text);
}

Design read_design(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending != ".asc") {
        throw Error(name + ": only GemCad's .asc designs can be read: save the design as .asc");
    }
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) {
        throw Error(name + ": there is no such file: check the name and the folder");
    }
    if (std::filesystem::file_size(file, fault) > largest_file) {
        throw Error(name + ": the file is larger than 16 MiB, which no design is: check the name");
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    if (!stream) throw Error(name + ": the file cannot be read: check its permissions");
    return parse_gemcad_asc(text, name);
}

}  // namespace icespar
