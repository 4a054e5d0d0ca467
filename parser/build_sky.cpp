// Environments that differ from direction to direction: panoramas, functions, lamps, and the
// domes by which faceters judge stones.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parser/builder.hpp"

namespace icespar {
namespace {

using std::numbers::pi;

/// A step pattern over the height y of a direction, from -1 to 1.
Pigment bands_of_height(const std::vector<std::pair<double, Rgb>>& from) {
    Pigment p;
    p.kind = Pigment::Kind::gradient;
    p.colours.clear();
    // The gradient's value is (y + 1) / 2, which stays within 0 .. 1.
    p.to_pattern = Transform::translation({0, 1, 0}).then(Transform::scaling({0.5, 0.5, 0.5}));
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Spectrum colour = reflectance_from_rgb(from[i].second);
        const double foot = std::max(0.0, (from[i].first + 1) / 2);
        const double head = i + 1 < from.size() ? (from[i + 1].first + 1) / 2 : 1;
        p.stops.insert(p.stops.end(), {foot, head});
        p.colours.insert(p.colours.end(), {colour, colour});
    }
    return p;
}

/// Light from above the horizon, but not from behind the head.
Formula dome(double cos_head, Formula::Function brightness) {
    Formula f;
    f.variable(1);
    f.apply(brightness, 1);
    f.variable(1);
    f.constant(0);
    f.apply([](double a, double b) { return a > b ? 1.0 : 0.0; }, 2);
    f.apply([](double a, double b) { return a * b; }, 2);
    f.variable(1);
    f.constant(cos_head);
    f.apply([](double a, double b) { return a < b ? 1.0 : 0.0; }, 2);
    f.apply([](double a, double b) { return a * b; }, 2);
    return f;
}

}  // namespace

bool Builder::named_sky(std::string_view name, double head_degrees) {
    Environment& out = scene_.environment;
    const double head = head_degrees * pi / 180;
    // A head of no size shades nothing, straight up included.
    const double cos_head = head > 0 ? std::cos(head) : 2;
    if (name == "iso") {
        out.formulas = {dome(cos_head, [](double, double) { return 1.0; })};
    } else if (name == "cosine") {
        out.formulas = {dome(cos_head, [](double y, double) { return y; })};
    } else if (name == "sc2") {
        out.formulas = {
            dome(cos_head, [](double y, double) { return 2 * y * std::sqrt(1 - y * y); })};
    } else if (name == "aset") {
        const double red_from = std::sin(45 * pi / 180);
        out.pattern = bands_of_height({{-1, {0, 0, 0}},
                                       {0, {0, 1, 0}},
                                       {red_from, {1, 0, 0}},
                                       {std::max(red_from, std::cos(head)), {0, 0, 1}}});
    } else if (name == "idealscope") {
        out.pattern = bands_of_height(
            {{-1, {1, 1, 1}}, {0, {1, 0, 0}}, {std::max(0.0, std::cos(head)), {0, 0, 0}}});
    } else {
        return false;
    }
    return true;
}

void Builder::panorama(const std::string& file, const Place& place) {
    PigmentLook look;
    look.pigment.kind = Pigment::Kind::picture;
    look.pigment.projection = Pigment::Projection::panorama;
    look.pigment.smooth = true;
    look.pigment.picture = picture(file, place);
    look.pigment.colours = {reflectance_from_rgb({1, 0, 0}), reflectance_from_rgb({0, 1, 0}),
                            reflectance_from_rgb({0, 0, 1})};
    scene_.environment.pattern = std::move(look.pigment);
}

/// lamps { disc DIRECTION, RADIUS, COLOUR ... }: in the environment's own space until it is placed.
void Builder::lamps(const Block& block) {
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.take();
        if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
            continue;
        }
        if (item.word != "disc" || item.kind != Item::Kind::word) {
            throw Fault{item.place, "'lamps' takes disc DIRECTION, RADIUS, COLOUR",
                        "such as disc y, 5, rgb 20"};
        }
        const Vec3 direction = cursor.vector("a direction");
        if (!(length(direction) > 0)) throw Fault{cursor.place(), "a direction is not 0", {}};
        const double radius = cursor.number("the radius of a lamp in degrees", 0, 180);
        Disc disc{normalised(direction), std::cos(radius * pi / 180), light(cursor, "a colour")};
        scene_.environment.discs.push_back(std::move(disc));
    }
}

/// A function that has no light for a direction, or none that could be, makes a dark place there.
void Builder::check_formulas(const Place& place) {
    const Environment& sky = scene_.environment;
    constexpr int looks = 2000;
    for (int i = 0; i < looks; ++i) {
        const double y = 1 - (2 * i + 1.0) / looks, r = std::sqrt(1 - y * y);
        const double turn = 2 * pi * i / std::numbers::phi;
        const Vec3 d{r * std::cos(turn), y, r * std::sin(turn)};
        const double radiance = sky.formulas[0](d);
        std::string fault;
        if (!(radiance >= 0 && std::isfinite(radiance))) {
            fault = "this function is negative or has no value";
        } else if (sky.formulas.size() == 4) {
            const double part =
                std::hypot(sky.formulas[1](d), sky.formulas[2](d), sky.formulas[3](d));
            if (!(part <= radiance * (1 + 1e-9))) fault = "more is polarised here than there is";
        }
        if (fault.empty()) continue;
        const auto digits = [](double v) {
            std::string text = std::to_string(v);
            return text.substr(0, text.find('.') + 3);
        };
        diagnostics_.warning(place,
                             fault + " towards <" + digits(d.x) + ", " + digits(d.y) + ", " +
                                 digits(d.z) + ">: it is cut to what light can be",
                             "use max(0, ...), and make I at least sqrt(Q*Q + U*U + V*V)");
        return;
    }
}

}  // namespace icespar
