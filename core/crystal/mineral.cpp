// The minerals that are compiled in, and how one is found by what a user calls it.
#include "crystal/mineral.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
#include <utility>

#include "math/error.hpp"

namespace icespar {

extern const std::string_view minerals_csv;

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Lower case, with one underscore for each run of blanks, hyphens and underscores.
std::string as_id(std::string_view text) {
    std::string id;
    for (const char c : lower(text)) {
        const bool gap = c == ' ' || c == '-' || c == '_' || c == '\t';
        if (!gap)
            id += c;
        else if (!id.empty() && id.back() != '_')
            id += '_';
    }
    if (id.ends_with('_')) id.pop_back();
    return id;
}

/// Insertions, deletions and replacements that turn a into b (Levenshtein 1966).
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1] ? 1 : 0);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
        }
    }
    return row.back();
}

bool holds_word(std::string_view name, std::string_view word) {
    const auto letter = [&](std::size_t i) {
        return i < name.size() && std::isalpha(static_cast<unsigned char>(name[i]));
    };
    for (auto at = name.find(word); at != name.npos; at = name.find(word, at + 1))
        if (!(at > 0 && letter(at - 1)) && !letter(at + word.size())) return true;
    return false;
}

}  // namespace

std::span<const Mineral> minerals() {
    static const std::vector<Mineral> table = parse_minerals(minerals_csv);
    return table;
}

const Mineral* find_mineral(std::string_view name) {
    const std::string wanted = as_id(name);
    for (const Mineral& m : minerals())
        if (m.id == wanted || as_id(m.name) == wanted) return &m;
    return nullptr;
}

std::vector<std::string> nearest_minerals(std::string_view name) {
    const std::string wanted = as_id(name);
    if (wanted.empty() || wanted.size() > 64) return {};
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const Mineral& m : minerals()) {
        const std::size_t distance =
            holds_word(lower(m.name), lower(name)) ? 0 : edits(wanted, m.id);
        if (distance <= 2 && distance < wanted.size()) ranked.emplace_back(distance, m.id);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> ids;
    for (const auto& [distance, id] : ranked)
        if (ids.size() < 3) ids.push_back(id);
    return ids;
}

Medium medium_at(std::span<const IndexFunction> indices, double wavelength_nm,
                 const CrystalAxes& axes) {
    if (!std::isfinite(wavelength_nm) || wavelength_nm <= 0) {
        throw Error("the wavelength must be a finite positive number of nanometres");
    }
    if (indices.empty() || indices.size() > 3) {
        throw Error("a medium has one, two or three indices, not " +
                    std::to_string(indices.size()));
    }
    std::array<Complex, 3> n{1, 1, 1};
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const double value = indices[i](wavelength_nm);
        if (!std::isfinite(value) || value <= 0) {
            throw Error("the dispersion formula gives no index at " +
                        std::to_string(wavelength_nm) +
                        " nm; stay within the wavelengths it was fitted to");
        }
        n[i] = value;
    }
    if (indices.size() == 1) return Medium::isotropic(n[0]);
    if (indices.size() == 2) return Medium::uniaxial(n[0], n[1], axes.first);
    return Medium::biaxial(n, axes.first, axes.second);
}

}  // namespace icespar
