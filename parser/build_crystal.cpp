// What stones are made of: the words of a crystal, put together.
#include <algorithm>
#include <cmath>

#include "crystal/mineral_colour.hpp"
#include "parser/crystal_words.hpp"

namespace icespar {
namespace {

/// Rotary power that falls with the square of the wavelength, as it does far from absorption.
Spectrum rotation_of(double degrees_per_mm) {
    constexpr double sodium_nm = 589.3;
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

}  // namespace icespar
