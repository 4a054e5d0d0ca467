// The indices of a crystal over the spectrum: dispersion by bg, abbe, cauchy and sellmeier.
#include "parser/crystal_words.hpp"

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

}  // namespace

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

}  // namespace icespar
