// Symmetric views: what images of one another repeat is traced once.
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"
#include "views/light_return.hpp"
#include "views/symmetry.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr double third = 0.57735026918962576;

std::size_t images(const Stone& stone, const Medium& medium, const ParallelView& view) {
    ViewOptions options;
    options.max_beams = 1;
    return trace_view(stone, medium, view, options).images.size();
}

const Medium zircon_of_issue = Medium::uniaxial(1.925, 1.984, {0, 0, 1});

/// A brilliant's planes, those of its crown turned by an angle: no mirrors are left.
Stone twisted(double angle) {
    auto planes = read_design(ICESPAR_SCENES_DIR "/designs/srb_tolkowsky_diamond.asc").planes();
    for (FacetPlane& p : planes) {
        if (!(p.normal.z > 1e-3)) continue;
        const double x = p.normal.x;
        p.normal.x = std::cos(angle) * x - std::sin(angle) * p.normal.y;
        p.normal.y = std::sin(angle) * x + std::cos(angle) * p.normal.y;
    }
    return Stone::from_planes(planes);
}

}  // namespace

TEST_CASE("a view has the symmetry that stone, crystal and line of sight share", "[views]") {
    const Medium glass_of_2 = Medium::isotropic(2);
    CHECK(images(brilliant_stone(), glass_of_2, {}) == 16);
    CHECK(images(brilliant_stone(), zircon_of_issue, {}) == 16);
    CHECK(images(brilliant_stone(), Medium::uniaxial(1.925, 1.984, {1, 0, 0}), {}) == 4);
    CHECK(images(brilliant_stone(), Medium::uniaxial(1.925, 1.984, {1, 0, 1}), {}) == 2);
    CHECK(images(brilliant_stone(), Medium::uniaxial(1.925, 1.984, {0.3, 0.1, 1}), {}) == 1);
    CHECK(images(brilliant_stone(), Medium::biaxial({1.6, 1.61, 1.7}, {1, 0, 0}, {0, 1, 0}), {}) ==
          4);
    CHECK(images(brilliant_stone(), glass_of_2, {{0, 0.2, -1}}) == 2);
    CHECK(images(brilliant_stone(), glass_of_2, {{0.1, 0.23, -1}}) == 1);
    CHECK(images(twisted(0.1), glass_of_2, {}) == 8);
    CHECK(images(cube_stone(), glass_of_2, {}) == 8);
    CHECK(images(cube_stone(), glass_of_2, {{-third, -third, -third}, {0, 1, 0}}) == 6);
    CHECK(images(rhomb_stone(), Medium::uniaxial(1.6584, 1.4864, {0, 0, 1}), {}) == 6);
}

TEST_CASE("a sector and its images are the whole view, polarisation included", "[views]") {
    struct Case {
        Stone stone;
        Medium medium;
        ParallelView view;
    };
    const Case cases[] = {
        {brilliant_stone(), Medium::isotropic(2.42), {{0, 0, -1}, {0.2, 1, 0}}},
        {brilliant_stone(), zircon_of_issue, {{0, 0, -1}, {0.4, 1, 0}}},
        {twisted(0.1), Medium::isotropic(1.8), {{0, 0, -1}, {0.2, 1, 0}}},
        {rhomb_stone(), Medium::uniaxial(1.6584, 1.4864, {0, 0, 1}), {{0, 0, -1}, {1, 0, 0}}},
        {brilliant_stone(), Medium::isotropic(1.54), {{0, 0.3, -1}, {0, 1, 0}}}};
    for (const Case& c : cases) {
        ViewOptions options;
        options.bound = 0;
        options.max_beams = 0;
        options.max_hits = 4;
        options.weights = Weights::stokes;
        options.fan = RealTensor::diagonal(0.1, 0.1, 0.1);
        options.turns = true;
        const Exits part = trace_view(c.stone, c.medium, c.view, options), whole = part.expanded();
        options.symmetry = false;
        const Exits plain = trace_view(c.stone, c.medium, c.view, options);
        REQUIRE(part.images.size() > 1);
        REQUIRE(whole.size() == part.size() * part.images.size());
        CHECK(std::abs(part.area_total - plain.area_total) < 1e-12);
        // Weighted by a function of the direction that has no symmetry.
        const auto sum = [](const Exits& e) {
            Stokes out;
            for (std::size_t i = 0; i < e.size(); ++i) {
                const Vec3& d = e.direction[i];
                out += (e.area[i] * (1 + d.x + 2 * d.y * d.z + d.x * d.y * d.y)) * e.weight[i];
            }
            return out;
        };
        CAPTURE(text(sum(whole)), text(sum(plain)));
        CHECK(difference(sum(whole), sum(plain)) < 1e-10);
        // Of how directions move, too; a grazing one moves too fast for a plain sum.
        const auto moves = [](const Exits& e) {
            double out = 0;
            for (std::size_t i = 0; i < e.size(); ++i) {
                double kind = 1;
                for (const Vec3& m : {e.fan[i], e.turned[i][0], e.turned[i][1]}) {
                    const double there = m.x + 2 * m.y + 3 * m.z * e.direction[i].x;
                    out += kind++ * e.area[i] * e.weight[i].s0 * there / (1 + dot(m, m));
                }
            }
            return out;
        };
        CHECK(std::abs(moves(whole) - moves(plain)) < 1e-10);
        const DomeLight light{Dome::cosine, normalised(Vec3{0.3, 0.1, 1}), 0.2};
        for (const int facet : {0, 3, 20, 50}) {
            if (facet >= static_cast<int>(c.stone.facets.size())) continue;
            CHECK(std::abs(light_return(part, light, facet).value -
                           light_return(plain, light, facet).value) < 1e-10);
        }
        CHECK(std::abs(light_return(part, light).value - light_return(whole, light).value) < 1e-12);
        CHECK(std::abs(part.cut - plain.cut) < 1e-10);
    }
}
