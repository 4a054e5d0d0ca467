// Light return by the definitions of faceters.
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"
#include "views/light_return.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

/// As GemRay traces: s and p averaged, ten faces, nothing below a thousandth.
Exits as_gemray(const Stone& stone, double n, double tilt_degrees) {
    ViewOptions options;
    options.weights = Weights::averaged;
    options.max_hits = 10;
    options.least_power = 1e-3;
    options.bound = 2e-4;
    // The stone turned about x is the view turned the other way.
    const double a = tilt_degrees * degree;
    return trace_view(stone, Medium::isotropic(n),
                      {{0, -std::sin(a), -std::cos(a)}, {0, std::cos(a), -std::sin(a)}}, options);
}

}  // namespace

TEST_CASE("light return is GemRay's where light is cut off as GemRay does", "[views][published]") {
    // Per cent, by GemRay 1.2 at 1000 x 1000 pixels: srb_tolkowsky_diamond, index 2.42, head 10
    // degrees; its grid is good to about 0.05.
    struct Row {
        double tilt, iso, cosine, sc2;
    };
    const Row rows[] = {{0, 74.389, 55.390, 55.710},
                        {10, 85.694, 64.907, 64.173},
                        {-10, 85.694, 64.907, 64.173},
                        {20, 79.186, 59.152, 64.599}};
    const Stone stone = brilliant_stone();
    const auto percent = [](const Exits& e, Dome dome, std::optional<int> facet = {}) {
        const Vec3 zenith = -e.frame.direction;
        return 100 * light_return(e, {dome, zenith, 10 * degree}, facet).value;
    };
    for (const Row& row : rows) {
        const Exits e = as_gemray(stone, 2.42, row.tilt);
        CAPTURE(row.tilt);
        CHECK(std::abs(percent(e, Dome::iso) - row.iso) < 0.1);
        CHECK(std::abs(percent(e, Dome::cosine) - row.cosine) < 0.1);
        CHECK(std::abs(percent(e, Dome::sc2) - row.sc2) < 0.1);
        if (row.tilt != 0) continue;
        const auto table = table_facet(stone);
        REQUIRE(table);
        CHECK(std::abs(percent(e, Dome::iso, table) - 66.942) < 0.1);
        CHECK(std::abs(percent(e, Dome::cosine, table) - 59.679) < 0.1);
        CHECK(std::abs(percent(e, Dome::sc2, table) - 42.935) < 0.1);
    }
}

TEST_CASE("a cube seen face on returns its outer and inner reflections to the viewer alone",
          "[views]") {
    constexpr double n = 2, r = 1.0 / 9;
    ViewOptions options;
    options.bound = 0;
    options.max_beams = 60;
    const Exits e = trace_view(cube_stone(), Medium::isotropic(n), {}, options);
    CHECK(std::abs(light_return(e, {Dome::iso, {0, 0, 1}, 0}).value - 2 * r / (1 + r)) < 1e-14);
    CHECK(std::abs(light_return(e, {Dome::cosine, {0, 0, 1}, 0}).value - 2 * r / (1 + r)) < 1e-14);
    CHECK(light_return(e, {Dome::sc2, {0, 0, 1}, 0}).value < 1e-7);
    CHECK(light_return(e, {Dome::iso, {0, 0, 1}, 10 * degree}).value == 0);
    // From the side the sun of a level horizon does not shine.
    CHECK(light_return(e, {Dome::iso, {0, 1, 0}, 0}).value == 0);
}

TEST_CASE("the facets of a view share its light return and its bound", "[views]") {
    const Stone stone = brilliant_stone();
    ViewOptions options;
    options.bound = 0.04;
    const Exits e =
        trace_view(stone, Medium::uniaxial(1.925, 1.984, {0, 0, 1}), {{0.2, 0.1, -1}}, options);
    const DomeLight light{Dome::sc2, {0, 0, 1}, 10 * degree};
    double value = 0, bound = 0, area = 0;
    for (std::size_t i = 0; i < stone.facets.size(); ++i) {
        const LightReturn part = light_return(e, light, static_cast<int>(i));
        value += part.value * e.entry_area[i];
        bound += part.bound * e.entry_area[i];
        area += e.entry_area[i];
    }
    const LightReturn whole = light_return(e, light);
    CHECK(std::abs(value / area - whole.value) < 1e-12);
    CHECK(std::abs(bound / area - whole.bound) < 1e-12);
}
