// What surfaces look like: pigment, finish and texture.
#include <algorithm>

#include "parser/builder.hpp"

namespace icespar {

Look Builder::texture(const Block& block) {
    Look look;
    Transform place;
    for (Cursor cursor(block); cursor.more();) {
        if (modifier(cursor, look, place)) continue;
        const Item& item = cursor.take();
        throw Fault{item.place,
                    "unexpected " + kind_of(item.value) + " in '" + std::string(block.word) + "'",
                    {}};
    }
    return look;
}

PigmentLook Builder::pigment(const Block& block) {
    PigmentLook look;
    look.where = block.place;
    bool coloured = false;
    for (Cursor cursor(block); cursor.more();) {
        step(cursor.peek().place);
        if (const auto t = read_transform(cursor)) {
            look.place = look.place.then(*t);
            continue;
        }
        const Item& item = cursor.peek();
        if (item.kind == Item::Kind::value) {
            if (const BlockPtr* declared = item.value.block()) {
                if ((*declared)->word != "pigment") {
                    throw Fault{item.place, "expected a pigment, found " + kind_of(item.value), {}};
                }
                look = pigment(**declared);
                cursor.take();
            } else {
                look.first = cursor.colour("a colour");
                look.kind = Pigment::Kind::plain;
            }
            coloured = true;
            continue;
        }
        cursor.take();
        if (item.word == "checker" || item.word == "grid") {
            const bool checker = item.word == "checker";
            look.kind = checker ? Pigment::Kind::checker : Pigment::Kind::grid;
            look.first = cursor.colour(checker ? "its first colour" : "the colour of the lines");
            look.second = cursor.colour(checker ? "its second colour" : "the colour of the ground");
            coloured = true;
        } else if (item.word == "line") {
            look.line_width = cursor.number("the width of a line in cells", 0, 1);
        } else if (item.word == "gradient") {
            throw Fault{item.place, "a gradient is not rendered on surfaces yet",
                        "use a colour, 'checker' or 'grid'"};
        } else if (item.word.empty()) {
            cursor.skip_values();
            coloured = true;
        } else {
            throw Fault{item.place, "unexpected '" + std::string(item.word) + "' in 'pigment'", {}};
        }
    }
    if (!coloured)
        throw Fault{block.place, "this pigment has no colour",
                    "write pigment { rgb <0.5, 0.5, 1> }"};
    return look;
}

FinishLook Builder::finish(const Block& block, const std::optional<FinishLook>& before) {
    FinishLook finish = before ? *before : defaults_.finish.value_or(FinishLook{});
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "diffuse") {
            finish.diffuse = cursor.number("diffuse", 0, 1e9);
        } else if (item.word == "emission" || item.word == "ambient") {
            const bool ambient = item.word == "ambient";
            const auto c = cursor.colour("how much light");
            std::array<double, 3> light{c[0], c[1], c[2]};
            if (ambient) {
                for (std::size_t i = 0; i < 3; ++i) light[i] *= ambient_light_[i];
            }
            const auto [least, most] = std::minmax({light[0], light[1], light[2]});
            if (least < 0) throw Fault{cursor.place(), "light is not negative", {}};
            if (most - least > 1e-12 * most) {
                diagnostics_.warning(
                    cursor.place(),
                    "coloured '" + std::string(item.word) +
                        "' is rendered with its mean: the pigment gives the colour");
            }
            (ambient ? finish.ambient : finish.own) = light;
            finish.emission = 0;
            for (std::size_t i = 0; i < 3; ++i)
                finish.emission += (finish.own[i] + finish.ambient[i]) / 3;
        } else if (item.kind == Item::Kind::value) {
            if (item.value.empty()) continue;
            const BlockPtr* declared = item.value.block();
            if (!declared || (*declared)->word != "finish") {
                throw Fault{item.place, "unexpected " + kind_of(item.value) + " in 'finish'", {}};
            }
            finish = this->finish(**declared, finish);
        } else if (item.word.empty()) {
            cursor.skip_values();
        }
    }
    return finish;
}

}  // namespace icespar
