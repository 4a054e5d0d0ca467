// What stones are made of: interior and crystal.
#include <algorithm>
#include <cmath>

#include "crystal/mineral.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

double index_value(Cursor& cursor) {
    const double n = cursor.number("a refractive index");
    if (!(n >= 1 && n <= 10)) {
        throw Fault{cursor.place(), "a refractive index lies between 1 and 10",
                    n > 0 && n < 1 ? "below 1 light would be faster than in vacuum" : ""};
    }
    return n;
}

/// Cauchy's formula with this index at 589.3 nm and this difference between 430.8 and 686.7 nm.
IndexFunction from_bg(double n, double bg) {
    const auto inverse_square = [](double um) { return 1 / (um * um); };
    const double b = bg / (inverse_square(0.4308) - inverse_square(0.6867));
    return IndexFunction::cauchy(n - b * inverse_square(0.5893), b);
}

}  // namespace

InteriorLook Builder::interior(const Block& block) {
    InteriorLook look;
    look.where = block.place;
    if (block.broken) throw Poisoned{block.place};
    bool at_fault = false;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "ior") {
            look.indices = {IndexFunction(index_value(cursor))};
        } else if (item.word == "crystal" && item.kind == Item::Kind::block) {
            crystal(*item.block, look);
        } else if (item.word == "dispersion") {
            diagnostics_.warning(item.place, "'dispersion' beside 'ior' is not rendered yet",
                                 "use crystal { indices ... dispersion { bg ... } }", "dispersion");
            cursor.skip_values();
        } else if (item.word == "fade_distance" || item.word == "fade_power") {
            diagnostics_.warning(item.place, "absorption is not rendered yet: the stone is clear",
                                 {}, "fade");
            cursor.skip_values();
        } else if (item.kind == Item::Kind::value) {
            const BlockPtr* declared = item.value.block();
            if (item.value.empty()) {
                at_fault = true;
            } else if (declared && (*declared)->word == "interior") {
                look = interior(**declared);
            } else if (declared && (*declared)->word == "crystal") {
                crystal(**declared, look);
            } else {
                throw Fault{item.place, "unexpected " + kind_of(item.value) + " in 'interior'", {}};
            }
        } else if (item.word.empty()) {
            cursor.skip_values();
            at_fault = true;
        } else {
            throw Fault{item.place, "'" + std::string(item.word) + "' needs '{' after it", {}};
        }
    }
    if (look.indices.empty()) {
        if (!at_fault) {
            throw Fault{block.place, "this interior says nothing of a refractive index",
                        "add 'ior 1.5', or crystal { mineral \"quartz\" axis y }"};
        }
        look.indices = {IndexFunction(1.5)};
    }
    return look;
}

std::vector<double> Builder::indices(Cursor& cursor) {
    std::vector<double> values;
    do {
        values.push_back(index_value(cursor));
    } while (cursor.next_is_number());
    if (values.size() > 2) {
        throw Fault{cursor.place(), "biaxial stones are not rendered yet",
                    "give two indices: n_o, n_e; or one"};
    }
    return values;
}

void Builder::crystal(const Block& block, InteriorLook& look) {
    std::vector<double> values;
    std::vector<IndexFunction> formulas;
    std::optional<double> bg;
    std::optional<Place> axis_place;
    if (block.broken) throw Poisoned{block.place};
    bool at_fault = false;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "mineral") {
            const std::string name = cursor.text("the name of a mineral");
            if (name.empty()) continue;
            const Mineral* mineral = find_mineral(name);
            if (!mineral) {
                std::vector<std::string_view> known;
                for (const Mineral& m : minerals()) {
                    known.push_back(m.id);
                    known.push_back(m.name);
                }
                std::string hint = did_you_mean(name, known);
                if (hint.empty()) hint = "give its 'indices n_o, n_e' instead";
                throw Fault{cursor.place(), "there is no mineral '" + printable(name) + "'", hint};
            }
            if (mineral->indices.size() > 2) {
                throw Fault{cursor.place(),
                            "biaxial stones are not rendered yet, and " + mineral->id + " is one",
                            "give two 'indices n_o, n_e', or one, to see it without"};
            }
            look.indices = mineral->indices;
        } else if (item.word == "indices") {
            values = indices(cursor);
        } else if (item.word == "axis") {
            look.axis = cursor.vector("a direction");
            axis_place = cursor.place();
            const double size = length(look.axis);
            if (!(size > 0) || !std::isfinite(size)) {
                throw Fault{cursor.place(), "an axis of length 0 has no direction",
                            "such as y, or <1, 0, 1>"};
            }
            look.axis = look.axis / size;
        } else if (item.word == "dispersion" && item.kind == Item::Kind::block) {
            dispersion(*item.block, formulas, bg);
        } else if (item.kind == Item::Kind::value && item.value.empty()) {
            at_fault = true;
        } else if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
            at_fault = true;
        } else if (item.kind == Item::Kind::value && item.value.block() &&
                   (*item.value.block())->word == "crystal") {
            crystal(**item.value.block(), look);
        } else {
            throw Fault{item.place,
                        "unexpected " +
                            (item.kind == Item::Kind::value ? kind_of(item.value)
                                                            : "'" + std::string(item.word) + "'") +
                            " in 'crystal'",
                        item.word == "dispersion" ? "write dispersion { bg 0.02 }" : ""};
        }
    }
    if (!values.empty()) look.indices.clear();
    for (const double n : values) look.indices.push_back(bg ? from_bg(n, *bg) : IndexFunction(n));
    if (bg && values.empty() && !look.indices.empty()) {
        for (IndexFunction& n : look.indices) n = from_bg(n(589.3), *bg);
    }
    if (!formulas.empty()) look.indices = formulas;
    if (look.indices.empty()) {
        if (at_fault) return;
        throw Fault{block.place, "this crystal has no refractive index",
                    "add 'mineral \"quartz\"' or 'indices 1.544, 1.553'"};
    }
    if (look.indices.size() > 2) {
        throw Fault{block.place, "biaxial stones are not rendered yet",
                    "give two formulas, for n_o and n_e; or one"};
    }
    for (const IndexFunction& n : look.indices) {
        if (!n.valid()) {
            throw Fault{block.place,
                        "the index of this crystal is not at least 1 and finite from 380 to 780 nm",
                        "formulas take micrometres"};
        }
    }
    if (axis_place && look.indices.size() == 1) {
        diagnostics_.warning(*axis_place, "an axis means nothing to an isotropic stone",
                             "give two indices: n_o, n_e");
    }
}

/// One formula for each index, or one difference for all.
void Builder::dispersion(const Block& block, std::vector<IndexFunction>& formulas,
                         std::optional<double>& bg) {
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "bg") {
            bg = cursor.number("n at 430.8 nm less n at 686.7 nm", 0, 2);
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
            throw Fault{item.place, "'dispersion' takes bg, cauchy or sellmeier", {}};
        }
    }
}

}  // namespace icespar
