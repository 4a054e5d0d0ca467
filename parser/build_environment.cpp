// What surrounds the scene: environment, background and sky_sphere.
#include <cmath>
#include <numbers>

#include "math/error.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

Spectrum coloured(const std::array<double, 5>& c, const Place& place) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (c[i] < 0) throw Fault{place, "light is not negative", {}};
    }
    if (c[0] == c[1] && c[1] == c[2]) return Spectrum(c[0]);
    return reflectance_from_rgb({c[0], c[1], c[2]});
}

}  // namespace

Spectrum Builder::illuminant_named(Cursor& cursor, std::string_view word) {
    try {
        if (word == "blackbody")
            return blackbody(cursor.number("a temperature in kelvin", 500, 50000));
        if (cursor.accept_word("blackbody")) return illuminant_named(cursor, "blackbody");
        return illuminant(cursor.text("the name of an illuminant"));
    } catch (const Error& error) {
        throw Fault{cursor.place(), error.what(), {}};
    }
}

void Builder::background(const Block& block) {
    Cursor cursor(block);
    const auto colour = cursor.colour("a colour");
    if (environment_seen_) return;
    scene_.environment = {};
    scene_.environment.below = scene_.environment.above = coloured(colour, cursor.place());
}

void Builder::environment(const Block& block) {
    if (environment_seen_) {
        diagnostics_.warning(block.place,
                             "a scene has one environment: this one takes the place of the former");
    }
    environment_seen_ = true;
    Environment& out = scene_.environment;
    out = {};
    Transform place;
    Look none;
    bool valued = false;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        if (item.word == "uniform") {
            cursor.take();
        } else if (item.word == "illuminant" || item.word == "blackbody") {
            cursor.take();
            out.illuminant = illuminant_named(cursor, item.word);
        } else if (item.word == "gradient") {
            cursor.take();
            while (cursor.next_is_word("illuminant") || cursor.next_is_word("blackbody")) {
                const std::string_view word = cursor.take().word;
                out.illuminant = illuminant_named(cursor, word);
            }
            const auto below = cursor.colour("the colour below");
            out.below = coloured(below, cursor.place());
            const auto above = cursor.colour("the colour above");
            out.above = coloured(above, cursor.place());
            valued = true;
        } else if (item.word == "polarised" && item.kind == Item::Kind::block) {
            cursor.take();
            polarised(*item.block);
        } else if (item.kind == Item::Kind::value && item.value.numbers()) {
            const auto colour = cursor.colour("a value or a colour");
            out.below = out.above = coloured(colour, cursor.place());
            valued = true;
        } else if (!modifier(cursor, none, place)) {
            throw Fault{item.place,
                        "unexpected " +
                            (item.kind == Item::Kind::value ? kind_of(item.value)
                                                            : "'" + std::string(item.word) + "'") +
                            " in 'environment'",
                        {}};
        } else if (item.kind == Item::Kind::word && item.word.empty()) {
            valued = true;
        }
    }
    if (!valued && !block.broken) {
        throw Fault{block.place, "this environment has no light",
                    "write environment { uniform 1 }"};
    }
    out.up = mirrored(normalised(place.vector({0, 1, 0})));
}

void Builder::polarised(const Block& block) {
    Stokes& state = scene_.environment.state;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        const auto degree = [&] {
            return cursor.next_is_number() ? cursor.number("the degree of polarisation", 0, 1)
                                           : 1.0;
        };
        if (item.word == "linear") {
            const double angle = cursor.number("an angle in degrees") * std::numbers::pi / 90;
            const double p = degree();
            state = {1, p * std::cos(angle), p * std::sin(angle), 0};
        } else if (item.word == "circular") {
            if (!cursor.next_is_word("right") && !cursor.next_is_word("left")) {
                throw Fault{cursor.place(), "'circular' needs 'right' or 'left' after it", {}};
            }
            const bool right = cursor.take().word == "right";
            state = {1, 0, 0, (right ? 1 : -1) * degree()};
        } else if (item.word.empty()) {
            cursor.skip_values();
        } else {
            throw Fault{
                item.place, "'polarised' takes linear ANGLE DEGREE, or circular right DEGREE", {}};
        }
    }
}

/// A sky_sphere that is a plain colour, or a gradient along y which is linear over the whole sky.
void Builder::sky_sphere(const Block& block) {
    const Fault too_much{block.place, "only a plain or a linear sky_sphere can be rendered",
                         "use 'environment { gradient BELOW ABOVE }'"};
    Look none;
    Transform outside;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        const Block* pigment = item.kind == Item::Kind::block ? item.block.get()
                               : item.value.block()           ? item.value.block()->get()
                                                              : nullptr;
        if (!pigment || pigment->word != "pigment") {
            if (modifier(cursor, none, outside)) continue;
            throw too_much;
        }
        cursor.take();
        Transform place;
        std::optional<Vec3> axis;
        std::vector<std::pair<double, std::array<double, 5>>> map;
        std::optional<std::array<double, 5>> plain;
        for (Cursor inner(*pigment); inner.more();) {
            if (const auto t = read_transform(inner)) {
                place = place.then(*t);
            } else if (inner.accept_word("gradient")) {
                axis = inner.vector("an axis");
            } else if (inner.next_is(Item::Kind::block)) {
                const Block& entries = *inner.take().block;
                for (const Item& entry : entries.items) {
                    if (entry.kind != Item::Kind::entry) throw too_much;
                    Cursor e(*entry.block);
                    const double at = e.number("a place from 0 to 1");
                    map.emplace_back(at, e.colour("a colour"));
                }
            } else if (inner.next_is_number()) {
                plain = inner.colour("a colour");
            } else {
                throw too_much;
            }
        }
        if (environment_seen_) return;
        Environment& out = scene_.environment;
        out = {};
        if (plain && !axis) {
            out.below = out.above = coloured(*plain, block.place);
            continue;
        }
        if (!axis || map.size() != 2 || map[0].first != 0 || map[1].first != 1) throw too_much;
        // The pattern's value at direction d is axis . place^-1(d), and linear where it stays in 0
        // .. 1.
        const Transform back = place.then(outside).inverse();
        const double middle = dot(*axis, back.point({0, 0, 0}));
        const Vec3 slope{dot(*axis, back.vector({1, 0, 0})), dot(*axis, back.vector({0, 1, 0})),
                         dot(*axis, back.vector({0, 0, 1}))};
        const double steep = length(slope);
        if (!(steep > 0) || middle - steep < -1e-9 || middle + steep > 1 + 1e-9) throw too_much;
        const auto at = [&](double v) {
            std::array<double, 5> c{};
            for (std::size_t i = 0; i < 3; ++i) {
                c[i] = map[0].second[i] + v * (map[1].second[i] - map[0].second[i]);
            }
            return coloured(c, block.place);
        };
        out.below = at(std::max(0.0, middle - steep));
        out.above = at(std::min(1.0, middle + steep));
        out.up = mirrored(slope / steep);
    }
}

}  // namespace icespar
