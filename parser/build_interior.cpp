// What stones are made of in POV-Ray's words: interior.
#include <cmath>

#include "parser/builder.hpp"

namespace icespar {
namespace {

/// Cauchy's formula with this index at 589.3 nm and this ratio of the indices for violet and red,
/// which is POV-Ray's `dispersion`; taken at the lines G and B, as for gems.
IndexFunction from_ratio(double n, double ratio) {
    const auto off = [](double um) { return 1 / (um * um) - 1 / (0.5893 * 0.5893); };
    const double b = n * (ratio - 1) / (off(0.4308) - ratio * off(0.6867));
    return IndexFunction::cauchy(n - b / (0.5893 * 0.5893), b);
}

}  // namespace

double index_value(Cursor& cursor) {
    const double n = cursor.number("a refractive index");
    if (!(n >= 1 && n <= 10)) {
        throw Fault{cursor.place(), "a refractive index lies between 1 and 10",
                    n > 0 && n < 1 ? "below 1 light would be faster than in vacuum" : ""};
    }
    return n;
}

void InteriorLook::turn(const Transform& t) {
    crystal.axis = t.vector(crystal.axis);
    crystal.third_axis = t.vector(crystal.third_axis);
}

InteriorLook Builder::interior(const Block& block) {
    InteriorLook look;
    look.where = block.place;
    Fade fade{0, 0, Spectrum(0.0)};
    Place fade_place = block.place;
    std::optional<double> ratio;
    if (block.broken) throw Poisoned{block.place};
    bool at_fault = false;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "ior") {
            look.crystal.indices = {IndexFunction(index_value(cursor))};
        } else if (item.word == "crystal" && item.kind == Item::Kind::block) {
            crystal(*item.block, look);
        } else if (item.word == "dispersion") {
            ratio = cursor.number("the index for violet over that for red", 0.5, 2);
        } else if (item.word == "fade_distance") {
            fade.distance = cursor.number("a distance", 0, 1e300);
            fade_place = item.place;
        } else if (item.word == "fade_power") {
            fade.power = cursor.number("a power", 0, 1e300);
        } else if (item.word == "fade_color" || item.word == "fade_colour") {
            const auto c = cursor.colour("a colour");
            for (std::size_t i = 0; i < 3; ++i) {
                if (!(c[i] >= 0 && c[i] <= 1)) {
                    throw Fault{cursor.place(), "a fade colour lies between 0 and 1",
                                "1 is what passes without loss"};
                }
            }
            fade.colour = reflectance_from_rgb({c[0], c[1], c[2]});
        } else if (item.kind == Item::Kind::value) {
            const BlockPtr* declared = item.value.block();
            if (item.value.empty()) {
                at_fault = true;
            } else if (declared && (*declared)->word == "interior") {
                look = interior(**declared);
            } else if (declared && (*declared)->word == "crystal") {
                crystal(**declared, look);
            } else {
                throw unexpected(item, "interior");
            }
        } else if (item.word.empty()) {
            cursor.skip_values();
            at_fault = true;
        } else {
            throw Fault{item.place, "'" + std::string(item.word) + "' needs '{' after it", {}};
        }
    }
    if (look.crystal.indices.empty()) {
        if (!at_fault) {
            throw Fault{block.place, "this interior says nothing of a refractive index",
                        "add 'ior 1.5', or crystal { mineral \"quartz\" axis y }"};
        }
        look.crystal.indices = {IndexFunction(1.5)};
    }
    if (fade.distance > 0) {
        if (fade.power == 0) {
            diagnostics_.warning(
                fade_place,
                "with a fade_power of 0 each stretch between facets loses the same "
                "part, however long it is, as in POV-Ray",
                "'fade_power 1000' is Beer and Lambert's law");
        }
        look.crystal.fade = fade;
    }
    if (ratio) {
        for (IndexFunction& n : look.crystal.indices) {
            n = from_ratio(n(589.3), *ratio);
            if (n.valid()) continue;
            throw Fault{block.place, "this dispersion takes the refractive index below 1",
                        "POV-Ray's dispersion is a ratio, such as 1.02"};
        }
    }
    return look;
}

}  // namespace icespar
