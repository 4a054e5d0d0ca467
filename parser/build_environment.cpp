// What surrounds the scene: environment, background and sky_sphere.
#include <cmath>
#include <numbers>
#include <utility>

#include "math/error.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

/// A relative spectrum at luminance 1, as all illuminants are.
Spectrum of_luminance_1(const Spectrum& light, const Place& place) {
    const double luminance = xyz_from_rgb(rgb_of(light))[1];
    if (!(luminance > 0)) throw Fault{place, "this light is black to the eye", {}};
    return (1 / luminance) * light;
}

}  // namespace

Spectrum Builder::light(Cursor& cursor, std::string_view what) {
    const Ink colour = ink(cursor, what);
    for (std::size_t i = 0; i < 3; ++i) {
        if (colour.rgb[i] < 0) throw Fault{cursor.place(), "light is not negative", {}};
    }
    return colour.spectrum;
}

Spectrum Builder::illuminant_named(Cursor& cursor, std::string_view word) {
    try {
        if (word == "blackbody")
            return blackbody(cursor.number("a temperature in kelvin", 500, 50000));
        if (cursor.accept_word("blackbody")) return illuminant_named(cursor, "blackbody");
        if (const auto given = spectrum(cursor)) return of_luminance_1(*given, cursor.place());
        return illuminant(cursor.text("the name of an illuminant"));
    } catch (const Error& error) {
        throw Fault{cursor.place(), error.what(), {}};
    }
}

void Builder::background(const Block& block) {
    Cursor cursor(block);
    const Spectrum colour = light(cursor, "a colour");
    if (environment_seen_) return;
    scene_.environment = {};
    scene_.environment.below = scene_.environment.above = colour;
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
    bool shines = false, lamps_seen = false;
    std::optional<Ink> value;
    std::string_view name;
    Place value_place = block.place;
    std::optional<double> head;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        const std::string_view word = item.kind == Item::Kind::word ? item.word : "";
        if (word == "uniform") {
            cursor.take();
        } else if (word == "illuminant" || word == "blackbody") {
            cursor.take();
            out.illuminant = illuminant_named(cursor, word);
        } else if (word == "gradient") {
            cursor.take();
            while (cursor.next_is_word("illuminant") || cursor.next_is_word("blackbody")) {
                const std::string_view lamp = cursor.take().word;
                out.illuminant = illuminant_named(cursor, lamp);
            }
            out.below = light(cursor, "the colour below");
            out.above = light(cursor, "the colour above");
            shines = true;
        } else if (word == "image") {
            cursor.take();
            const std::string file = cursor.text("the name of a picture");
            panorama(file, cursor.place());
            shines = true;
        } else if (word == "iso" || word == "cosine" || word == "sc2" || word == "aset" ||
                   word == "idealscope") {
            name = cursor.take().word;
            shines = true;
        } else if (word == "head") {
            cursor.take();
            head = cursor.number("half the angle that the head covers, in degrees", 0, 90);
        } else if (const auto* formulas = item.value.formulas()) {
            cursor.take();
            out.formulas = **formulas;
            check_formulas(item.place);
            shines = true;
        } else if (item.word == "lamps" && item.kind == Item::Kind::block) {
            cursor.take();
            lamps(*item.block);
            lamps_seen = true;
        } else if (item.word == "polarised" && item.kind == Item::Kind::block) {
            cursor.take();
            polarised(*item.block);
        } else if (next_is_ink(cursor)) {
            value = Ink{light(cursor, "a value or a colour"), {}};
            value_place = cursor.place();
        } else if (!modifier(cursor, none, place)) {
            if (excused(block)) throw Poisoned{item.place};
            throw unexpected(item, "environment");
        } else if (item.kind == Item::Kind::word && item.word.empty()) {
            shines = true;
        }
    }
    if (head && name.empty()) {
        throw Fault{block.place, "'head' belongs to iso, cosine, sc2, aset or idealscope", {}};
    }
    if (!name.empty()) {
        const bool scope = name == "aset" || name == "idealscope";
        named_sky(name, head.value_or(scope ? 15 : 0));
    }
    if (!shines && !lamps_seen && !value && !block.broken) {
        throw Fault{block.place, "this environment has no light",
                    "write environment { uniform 1 }"};
    }
    if (!shines && value) out.below = out.above = value->spectrum;
    place_sky(place, shines ? value : std::nullopt, value_place);
}

void Builder::place_sky(const Transform& place, const std::optional<Ink>& value,
                        const Place& where) {
    Environment& out = scene_.environment;
    const Transform to_world = place.then(mirror());
    out.up = normalised(to_world.vector({0, 1, 0}));
    out.to_own = to_world.inverse();
    for (Disc& disc : out.discs) disc.direction = normalised(to_world.vector(disc.direction));
    if (out.pattern) out.pattern->to_pattern = out.to_own.then(out.pattern->to_pattern);
    const Vec3 x = place.vector({1, 0, 0}), y = place.vector({0, 1, 0}),
               z = place.vector({0, 0, 1});
    const bool turned =
        std::abs(dot(x, y)) + std::abs(dot(y, z)) + std::abs(dot(z, x)) < 1e-9 &&
        std::abs(dot(x, x) - 1) + std::abs(dot(y, y) - 1) + std::abs(dot(z, z) - 1) < 1e-9;
    if (out.formulas.size() == 4 && !(turned && place.determinant() > 0)) {
        throw Fault{
            where, "a polarised environment can be turned, but not stretched or mirrored", {}};
    }
    if (!value) return;
    if (out.pattern) {
        for (Spectrum& colour : out.pattern->colours) colour = colour * value->spectrum;
    } else if (!out.formulas.empty()) {
        const double factor = value->spectrum(560);
        if (value->spectrum(450) != factor || value->spectrum(650) != factor) {
            throw Fault{where, "a function of light has no colour but its illuminant's",
                        "write 'illuminant' and a spectrum"};
        }
        for (Formula& f : out.formulas) {
            f.constant(factor);
            f.apply([](double a, double b) { return a * b; }, 2);
        }
    } else {
        out.below = out.below * value->spectrum;
        out.above = out.above * value->spectrum;
    }
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

/// Its pigment is looked at where unit directions end.
void Builder::sky_sphere(const Block& block) {
    Look look;
    Transform place;
    std::optional<PigmentLook> sky;
    for (Cursor cursor(block); cursor.more();) {
        if (!modifier(cursor, look, place)) {
            throw Fault{cursor.peek().place, "a sky_sphere takes a pigment and transforms", {}};
        }
        if (!look.pigment) continue;
        if (sky) {
            throw Fault{cursor.place(), "only one pigment of a sky_sphere can be rendered", {}};
        }
        sky = std::exchange(look.pigment, std::nullopt);
        place = {};
    }
    if (look.at_fault) return;
    if (!sky) throw Fault{block.place, "this sky_sphere has no pigment", {}};
    if (environment_seen_) return;
    sky->place = sky->place.then(place);
    scene_.environment = {};
    scene_.environment.pattern = sky->placed();
}

}  // namespace icespar
