// What stones are made of: crystal.
#include <algorithm>
#include <cmath>

#include "crystal/mineral_colour.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

constexpr double sodium_nm = 589.3;

double inverse_square(double nm) { return 1e6 / (nm * nm); }

/// Cauchy's formula with this index at 589.3 nm and this difference between 430.8 and 686.7 nm.
IndexFunction from_bg(double n, double bg) {
    const double b = bg / (inverse_square(430.8) - inverse_square(686.7));
    return IndexFunction::cauchy(n - b * inverse_square(sodium_nm), b);
}

/// With this index at 589.3 nm and this Abbe number (n_d - 1) / (n_F - n_C).
IndexFunction from_abbe(double n, double abbe) {
    const double d = 587.5618, F = 486.1327, C = 656.2725;
    const double b = (n - 1) / (abbe * (inverse_square(F) - inverse_square(C)) -
                                (inverse_square(d) - inverse_square(sodium_nm)));
    return IndexFunction::cauchy(n - b * inverse_square(sodium_nm), b);
}

/// Rotary power that falls with the square of the wavelength, as it does far from absorption.
Spectrum rotation_of(double degrees_per_mm) {
    std::vector<double> nodes, values;
    for (double nm = sodium_nm - 210; nm < longest_nm + 1; nm += 1) {
        nodes.push_back(nm);
        values.push_back(degrees_per_mm * (sodium_nm / nm) * (sodium_nm / nm));
    }
    return {std::move(nodes), std::move(values)};
}

Vec3 direction(Cursor& cursor) {
    const Vec3 v = cursor.vector("a direction");
    const double size = length(v);
    if (!(size > 0) || !std::isfinite(size)) {
        throw Fault{cursor.place(), "an axis of length 0 has no direction",
                    "such as y, or <1, 0, 1>"};
    }
    return v / size;
}

const Mineral& mineral_named(const std::string& name, const Place& place) {
    if (const Mineral* mineral = find_mineral(name)) return *mineral;
    std::vector<std::string_view> known;
    for (const Mineral& m : minerals()) {
        known.push_back(m.id);
        known.push_back(m.name);
    }
    std::string hint = did_you_mean(name, known);
    if (hint.empty()) {
        for (const MineralColour& c : mineral_colours()) {
            if (c.name == name)
                hint = "write mineral \"" + c.mineral + "\" colour \"" + c.name + "\"";
        }
    }
    if (const auto near = nearest_minerals(name); hint.empty() && !near.empty()) {
        hint = "did you mean '" + near.front() + "'?";
    }
    if (hint.empty()) hint = "give its 'indices n_o, n_e' instead";
    throw Fault{place, "there is no mineral '" + printable(name) + "'", hint};
}

const MineralColour& colour_named(const Mineral& mineral, const std::string& name,
                                  const Place& place) {
    if (const MineralColour* colour = find_colour(mineral, name)) return *colour;
    std::vector<std::string_view> known;
    for (const MineralColour& c : mineral_colours()) {
        if (c.mineral == mineral.id) known.push_back(c.name);
    }
    std::string hint = did_you_mean(name, known);
    if (hint.empty() && !known.empty()) hint = "there is " + listed(known, " and ");
    if (hint.empty()) hint = "none is known of it: give 'absorption'";
    throw Fault{place, mineral.id + " has no colour '" + printable(name) + "'", hint};
}

}  // namespace

/// What a crystal block says, before it is put together.
struct Builder::CrystalWords {
    std::vector<double> indices;
    std::vector<IndexFunction> formulas;
    std::vector<double> bg, abbe;
    const Mineral* mineral = nullptr;
    std::string colour;
    std::optional<Place> axis, axes, dispersion, absorption, rotation, coloured;
    std::array<std::optional<Spectrum>, 3> bands;  ///< by index
    bool every_index = false;                      ///< the first of them serves for all
    bool at_fault = false;
};

void Builder::crystal(const Block& block, InteriorLook& look) {
    if (block.broken) throw Poisoned{block.place};
    CrystalWords words;
    for (Cursor cursor(block); cursor.more();) crystal_item(cursor, look, words);
    crystal_indices(block, look.crystal, words);
    if (look.crystal.indices.empty()) return;
    const std::size_t count = look.crystal.indices.size();
    for (const IndexFunction& n : look.crystal.indices) {
        if (!n.valid()) {
            throw Fault{block.place,
                        "the index of this crystal is not at least 1 and finite from 380 to 780 nm",
                        "formulas take micrometres"};
        }
    }
    if (words.axis && count == 3) {
        throw Fault{*words.axis, "one axis does not say how a biaxial stone lies",
                    "write axes X, Z: of the first and of the third index"};
    }
    if (words.axes && count == 2) {
        throw Fault{*words.axes, "a uniaxial stone has one axis", "write axis y"};
    }
    if (count == 1 && (words.axis || words.axes)) {
        diagnostics_.warning(words.axis ? *words.axis : *words.axes,
                             "an axis means nothing to an isotropic stone",
                             "give two indices: n_o, n_e");
    }
    if (words.rotation && count != 2) {
        throw Fault{*words.rotation, "optical activity is rendered in uniaxial stones only",
                    "give two indices, which may be equal"};
    }
    if (words.coloured && !words.colour.empty()) {
        if (!words.mineral) {
            throw Fault{*words.coloured, "a colour belongs to a mineral",
                        "write mineral \"corundum\" colour \"ruby\""};
        }
        look.crystal.absorption =
            colour_named(*words.mineral, words.colour, *words.coloured).absorption;
    }
    if (words.absorption) crystal_absorption(look.crystal, words);
    if (!look.crystal.absorption.empty() && look.crystal.absorption.size() != count) {
        throw Fault{block.place, "the absorption given before does not fit these indices",
                    "give it anew, after them"};
    }
}

void Builder::crystal_item(Cursor& cursor, InteriorLook& look, CrystalWords& words) {
    const Item& item = cursor.take();
    Crystal& crystal = look.crystal;
    if (item.word == "mineral") {
        const std::string name = cursor.text("the name of a mineral");
        if (name.empty()) return;
        words.mineral = &mineral_named(name, cursor.place());
        crystal.indices = words.mineral->indices;
    } else if (item.word == "colour" || item.word == "color") {
        words.colour = cursor.text("the name of a colour");
        words.coloured = cursor.place();
    } else if (item.word == "indices") {
        do {
            words.indices.push_back(index_value(cursor));
        } while (cursor.next_is_number());
        if (words.indices.size() > 3) {
            throw Fault{cursor.place(), "a crystal has at most three indices",
                        "one: isotropic; n_o, n_e: uniaxial; three: biaxial"};
        }
    } else if (item.word == "axis") {
        crystal.axis = direction(cursor);
        words.axis = cursor.place();
    } else if (item.word == "axes") {
        crystal.axis = direction(cursor);
        crystal.third_axis = direction(cursor);
        words.axes = cursor.place();
        const double cosine = dot(crystal.axis, crystal.third_axis);
        if (std::abs(cosine) > 1e-3) {
            throw Fault{cursor.place(), "the principal axes of a crystal are perpendicular",
                        "the axis of the first and that of the third index, such as x, z"};
        }
    } else if (item.word == "dispersion" && item.kind == Item::Kind::block) {
        words.dispersion = item.place;
        dispersion(*item.block, words);
    } else if (item.word == "absorption" && item.kind == Item::Kind::block) {
        words.absorption = item.place;
        absorption(*item.block, words);
    } else if (item.word == "rotation") {
        words.rotation = item.place;
        const auto given = spectrum(cursor, -1e5);
        crystal.rotation =
            given ? *given
                  : rotation_of(cursor.number("degrees per millimetre at 589 nm", -1000, 1000));
    } else if (item.kind == Item::Kind::value && item.value.empty()) {
        words.at_fault = true;
    } else if (item.word.empty() && item.kind == Item::Kind::word) {
        cursor.skip_values();
        words.at_fault = true;
    } else if (item.kind == Item::Kind::value && item.value.block() &&
               (*item.value.block())->word == "crystal") {
        this->crystal(**item.value.block(), look);
    } else {
        throw unexpected(item, "crystal",
                         item.word == "dispersion" ? "write dispersion { bg 0.02 }" : "");
    }
}

void Builder::crystal_indices(const Block& block, Crystal& crystal, const CrystalWords& words) {
    auto& indices = crystal.indices;
    if (!words.indices.empty()) {
        indices.clear();
        for (const double n : words.indices) indices.push_back(IndexFunction(n));
    }
    for (const auto* numbers : {&words.bg, &words.abbe}) {
        if (numbers->empty() || indices.empty()) continue;
        if (numbers->size() > 1 && numbers->size() != indices.size()) {
            throw Fault{*words.dispersion,
                        std::to_string(numbers->size()) + " values for " +
                            std::to_string(indices.size()) + " indices",
                        "give one for all, or one for each index"};
        }
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const double n = indices[i](sodium_nm), d = (*numbers)[numbers->size() > 1 ? i : 0];
            indices[i] = numbers == &words.bg ? from_bg(n, d) : from_abbe(n, d);
        }
    }
    if (!words.formulas.empty()) {
        if (words.formulas.size() > 3) {
            throw Fault{*words.dispersion, "a crystal has at most three indices",
                        "one formula for each index"};
        }
        indices = words.formulas;
    }
    if (indices.empty() && !words.at_fault) {
        throw Fault{block.place, "this crystal has no refractive index",
                    "add 'mineral \"quartz\"' or 'indices 1.544, 1.553'"};
    }
}

/// One formula for each index; or one number for each, or for all.
void Builder::dispersion(const Block& block, CrystalWords& words) {
    auto& formulas = words.formulas;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "bg") {
            do {
                words.bg.push_back(cursor.number("n at 430.8 nm less n at 686.7 nm", 0, 2));
            } while (cursor.next_is_number());
        } else if (item.word == "abbe") {
            do {
                words.abbe.push_back(cursor.number("an Abbe number", 1, 1000));
            } while (cursor.next_is_number());
        } else if (item.word == "cauchy" && item.kind == Item::Kind::word) {
            const double a = cursor.number("A of n = A + B / l^2");
            formulas.push_back(
                IndexFunction::cauchy(a, cursor.number("B of n = A + B / l^2, in um^2")));
        } else if ((item.word == "cauchy" || item.word == "sellmeier") &&
                   item.kind == Item::Kind::block) {
            std::vector<double> c;
            for (Cursor inner(*item.block); inner.more();)
                c.push_back(inner.number("a coefficient"));
            if (item.word == "cauchy") {
                if (c.size() != 2)
                    throw Fault{item.place, "Cauchy's formula has two coefficients: A, B", {}};
                formulas.push_back(IndexFunction::cauchy(c[0], c[1]));
                continue;
            }
            if (c.empty() || c.size() % 2 != 0 || c.size() > 20) {
                throw Fault{item.place,
                            "Sellmeier's formula has pairs of coefficients: B1, C1, B2, C2 ...",
                            "n^2 = 1 + sum of B l^2 / (l^2 - C), l in um, C in um^2"};
            }
            c.insert(c.begin(), 0.0);
            formulas.push_back(IndexFunction::sellmeier2(c));
        } else if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
        } else {
            throw Fault{item.place, "'dispersion' takes bg, abbe, cauchy or sellmeier", {}};
        }
    }
}

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
