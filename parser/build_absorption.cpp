// What a crystal takes from light along each of its axes.
#include <algorithm>

#include "parser/crystal_words.hpp"

namespace icespar {

/// Spectra in the order of the indices, or after the name of the wave they belong to; several for
/// one wave add up.
void Builder::absorption(const Block& block, CrystalWords& words) {
    static constexpr std::array<std::string_view, 5> names{"ordinary", "extraordinary", "first",
                                                           "second", "third"};
    static constexpr std::array<std::size_t, 5> places{0, 1, 0, 1, 2};
    std::optional<std::size_t> named;
    std::size_t unnamed = 0;
    for (Cursor cursor(block); cursor.more();) {
        const auto name = cursor.next_is(Item::Kind::word)
                              ? std::find(names.begin(), names.end(), cursor.peek().word)
                              : names.end();
        if (name != names.end()) {
            named = places[static_cast<std::size_t>(name - names.begin())];
            cursor.take();
            continue;
        }
        std::optional<Spectrum> value = spectrum(cursor, -1e5);
        if (!value) value = Spectrum(cursor.number("an absorption per mm", 0, 10000));
        if (!(value->least() >= 0)) {
            throw Fault{cursor.place(), "a stone does not add light: absorption is at least 0", {}};
        }
        if (!named && unnamed > 2) {
            throw Fault{cursor.place(), "absorption takes one spectrum for each index", {}};
        }
        std::optional<Spectrum>& at = words.bands[named ? *named : unnamed++];
        at = at ? *at + *value : *value;
    }
    words.every_index = unnamed == 1 && !named;
}

void Builder::crystal_absorption(Crystal& crystal, const CrystalWords& words) {
    const std::size_t count = crystal.indices.size();
    crystal.absorption.clear();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& given = words.bands[words.every_index ? 0 : i];
        if (i < count && !given) {
            throw Fault{*words.absorption,
                        "a stone of " + std::to_string(count) + " indices takes " +
                            std::to_string(count) + " spectra of absorption",
                        count == 2   ? "write absorption { ordinary spectrum { ... } extraordinary "
                                       "spectrum { ... } }"
                        : count == 3 ? "one for each index, in their order"
                                     : ""};
        }
        if (i >= count && !words.every_index && given) {
            throw Fault{*words.absorption,
                        "this stone has only " + std::to_string(count) +
                            (count == 1 ? " index" : " indices") + " to absorb with",
                        {}};
        }
        if (i < count) crystal.absorption.push_back(*given);
    }
}

}  // namespace icespar
