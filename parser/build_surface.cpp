// What surfaces look like: finish and texture.
#include <algorithm>

#include "parser/builder.hpp"

namespace icespar {

Look Builder::texture(const Block& block) {
    Look look;
    Transform place;
    for (Cursor cursor(block); cursor.more();) {
        if (modifier(cursor, look, place)) continue;
        const Item& item = cursor.take();
        throw unexpected(item, block.word);
    }
    return look;
}

FinishLook Builder::finish(const Block& block, const std::optional<FinishLook>& before) {
    FinishLook finish = before ? *before : defaults_.finish.value_or(FinishLook{});
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word == "diffuse") {
            // A brilliance of 1 makes an albedo of the same number.
            (void)cursor.accept_word("albedo");
            finish.diffuse = cursor.number("diffuse", 0, 1e9);
            if (cursor.next_is_number() && cursor.number("diffuse from behind", 0, 1e9) > 0) {
                diagnostics_.warning(cursor.place(), "light does not come through from behind",
                                     "a second number of 'diffuse' is left out");
            }
        } else if (item.word == "emission" || item.word == "ambient") {
            const bool ambient = item.word == "ambient";
            const auto c = cursor.colour("how much light");
            std::array<double, 3> light{c[0], c[1], c[2]};
            if (ambient) {
                for (std::size_t i = 0; i < 3; ++i) light[i] *= ambient_light_[i];
            }
            if (std::min({light[0], light[1], light[2]}) < 0) {
                throw Fault{cursor.place(), "light is not negative", {}};
            }
            (ambient ? finish.ambient : finish.own) = light;
            for (std::size_t i = 0; i < 3; ++i) light[i] = finish.own[i] + finish.ambient[i];
            const auto [least, most] = std::minmax({light[0], light[1], light[2]});
            finish.emission = most;
            finish.tint = Spectrum(1.0);
            if (least < most) {
                finish.tint =
                    reflectance_from_rgb({light[0] / most, light[1] / most, light[2] / most});
            }
        } else if (item.kind == Item::Kind::value) {
            if (item.value.empty()) continue;
            const BlockPtr* declared = item.value.block();
            if (!declared || (*declared)->word != "finish") {
                throw unexpected(item, "finish");
            }
            finish = this->finish(**declared, finish);
        } else if (item.word.empty()) {
            cursor.skip_values();
        }
    }
    return finish;
}

}  // namespace icespar
