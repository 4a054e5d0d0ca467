// The minerals that ship with icespar: their table against itself, and how they are found.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "crystal/mineral_colour.hpp"
#include "math/error.hpp"

using namespace icespar;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

const std::string heads =
    "id,name,formula,crystal_system,optic,n1,n2,n3,dispersion_BG,dispersion_model,coef1,coef2,"
    "coef3,density,confidence\n";

}  // namespace

TEST_CASE("each mineral's formula gives its published index and dispersion", "[mineral]") {
    REQUIRE(minerals().size() == 36);
    for (const Mineral& m : minerals()) {
        CAPTURE(m.id);
        REQUIRE(m.indices.size() == m.indices_589.size());
        REQUIRE(m.indices.size() == m.dispersion_bg.size());
        for (std::size_t i = 0; i < m.indices.size(); ++i) {
            const IndexFunction& n = m.indices[i];
            CHECK_THAT(n(589.3), WithinAbs(m.indices_589[i], 0.501e-5));
            CHECK_THAT(n(430.8) - n(686.7), WithinAbs(m.dispersion_bg[i], 0.501e-4));
            CHECK(n.valid());
        }
    }
}

TEST_CASE("a mineral's optic class agrees with its indices", "[mineral]") {
    for (const Mineral& m : minerals()) {
        CAPTURE(m.id);
        const auto& n = m.indices_589;
        if (m.optic == "isotropic") CHECK(n.size() == 1);
        if (m.optic == "uniaxial +") CHECK(n.at(1) > n.at(0));
        if (m.optic == "uniaxial -") CHECK(n.at(1) < n.at(0));
        if (m.optic.starts_with("biaxial")) {
            CHECK(n.at(0) < n.at(1));
            CHECK(n.at(1) < n.at(2));
            // Vz is the half angle about n_gamma between the optic axes; beyond 45 degrees the
            // crystal is negative.
            const auto inverse_square = [&](std::size_t i) { return 1 / (n[i] * n[i]); };
            const double tan2_vz =
                (inverse_square(0) - inverse_square(1)) / (inverse_square(1) - inverse_square(2));
            CHECK(m.optic == (tan2_vz < 1 ? "biaxial +" : "biaxial -"));
        }
    }
}

TEST_CASE("well-known stones have their textbook indices", "[mineral]") {
    const auto n = [](const char* name, std::size_t i) {
        return find_mineral(name)->indices.at(i)(589.3);
    };
    CHECK_THAT(n("diamond", 0), WithinAbs(2.417, 1e-3));
    CHECK_THAT(n("quartz", 0), WithinAbs(1.544, 1e-3));
    CHECK_THAT(n("quartz", 1), WithinAbs(1.553, 1e-3));
    CHECK_THAT(n("calcite", 0), WithinAbs(1.658, 1e-3));
    CHECK_THAT(n("calcite", 1), WithinAbs(1.486, 1e-3));
    CHECK_THAT(n("corundum", 0), WithinAbs(1.768, 1e-3));
    CHECK_THAT(n("corundum", 1), WithinAbs(1.760, 1e-3));
}

TEST_CASE("a mineral is found by id or name, whatever the case", "[mineral]") {
    REQUIRE(find_mineral("calcite"));
    CHECK(find_mineral("Calcite") == find_mineral("calcite"));
    CHECK(find_mineral("CALCITE") == find_mineral("calcite"));
    CHECK(find_mineral("topaz_imperial")->id == "topaz_imperial");
    CHECK(find_mineral(" Topaz imperial")->id == "topaz_imperial");
    CHECK(find_mineral("rutile (synthetic)")->id == "rutile");
    CHECK(find_mineral("garnet, pyrope")->id == "pyrope");
    CHECK(find_mineral("kryptonite") == nullptr);
    CHECK(find_mineral("") == nullptr);
    std::set<std::string> ids;
    for (const Mineral& m : minerals()) {
        CHECK(find_mineral(m.id) == &m);
        ids.insert(m.id);
    }
    CHECK(ids.size() == minerals().size());
}

TEST_CASE("a misspelt mineral has neighbours, and a gem's name its mineral", "[mineral]") {
    CHECK(nearest_minerals("dimond") == std::vector<std::string>{"diamond"});
    CHECK(nearest_minerals("Qartz").front() == "quartz");
    CHECK(nearest_minerals("ruby").front() == "corundum");
    CHECK(nearest_minerals("Amethyst").front() == "quartz");
    CHECK(nearest_minerals("kryptonite").empty());
    CHECK(nearest_minerals("").empty());
}

TEST_CASE("coloured stones have the colours that gemmologists name", "[mineral][colour]") {
    const auto seen = [](const char* mineral, const char* colour, std::size_t axis, double mm) {
        const MineralColour* c = find_colour(*find_mineral(mineral), colour);
        REQUIRE(c);
        return colour_through(c->absorption.at(axis), mm);
    };
    for (const std::size_t wave : {0u, 1u}) {
        const Rgb ruby = seen("corundum", "Ruby", wave, 5),
                  green = seen("emerald", "emerald", wave, 5);
        CHECK(ruby[0] > 2 * ruby[1]);
        CHECK(ruby[0] > 1.5 * ruby[2]);
        CHECK(green[1] > 1.5 * green[0]);
        CHECK(green[1] > green[2]);
    }
    // Tourmaline is far darker along its axis, where there is only the ordinary wave.
    CHECK(seen("tourmaline", "green", 0, 5)[1] < 0.5 * seen("tourmaline", "green", 1, 5)[1]);
    // Iolite: yellowish, violet-blue, blue.
    CHECK(seen("iolite", "blue", 0, 5)[2] < seen("iolite", "blue", 0, 5)[0]);
    CHECK(seen("iolite", "blue", 1, 5)[2] > 1.5 * seen("iolite", "blue", 1, 5)[1]);
    CHECK(seen("iolite", "blue", 2, 5)[2] > 1.5 * seen("iolite", "blue", 2, 5)[0]);
}

TEST_CASE("a named colour is what white light shows through 5 mm", "[mineral][colour]") {
    const Rgb c = colour_through(find_colour(*find_mineral("kyanite"), "blue")->absorption[2], 5);
    const auto linear = [](int v) { return std::pow((v / 255.0 + 0.055) / 1.055, 2.4); };
    CHECK_THAT(c[0], WithinAbs(linear(0x3c), 1e-3));
    CHECK_THAT(c[1], WithinAbs(linear(0x64), 1e-3));
    CHECK_THAT(c[2], WithinAbs(linear(0xc0), 1e-3));
}

TEST_CASE("every colour says where it comes from, and no light is gained", "[mineral][colour]") {
    REQUIRE(mineral_colours().size() > 25);
    for (const MineralColour& c : mineral_colours()) {
        CAPTURE(c.mineral, c.name);
        CHECK(find_colour(*find_mineral(c.mineral), c.name) == &c);
        CHECK(!c.source.empty());
        CHECK((c.confidence == "B" || c.confidence == "C"));
        for (const Spectrum& s : c.absorption) CHECK(s.least() >= 0);
    }
    const std::string heads = "mineral,colour,first,second,third,words,source,confidence\n";
    const auto row = [&](const std::string& text) { return parse_mineral_colours(heads + text); };
    CHECK_THROWS_WITH(row("kryptonite,green,1/1/1,,,w,s,C"), Contains("kryptonite"));
    CHECK_THROWS_WITH(row("diamond,blue,500/80,,,w,s,C"), Contains("line 2") && Contains("500/80"));
    CHECK_THROWS_WITH(row("diamond,blue,#12345,,,w,s,C"), Contains("#rrggbb"));
    CHECK_THROWS_WITH(row("calcite,blue,#123456,,,w,s,C"), Contains("takes 2 spectra"));
}

TEST_CASE("quoted fields of a table keep their commas, quotes and line ends", "[mineral][table]") {
    const auto rows = parse_minerals(heads +
                                     "a,\"A, \"\"the\nfirst\"\"\",X2,cubic,isotropic,1.5,,,0.01,"
                                     "cauchy_AB_um2,1.49 0.0035,,,3.1,B\r\n\n"
                                     "b,B,Y,trigonal,uniaxial -,1.6,1.5,,0/0,"
                                     "cauchy_AB_um2,1.6 0,1.5 0,,,C");
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].name == "A, \"the\nfirst\"");
    CHECK(rows[0].density == 3.1);
    CHECK(rows[0].confidence == "B");
    CHECK(rows[1].indices.size() == 2);
    CHECK(rows[1].confidence == "C");
}

TEST_CASE("a faulty table is refused with the line at fault", "[mineral][table]") {
    const auto row = [](const std::string& text) { return parse_minerals(heads + text); };
    CHECK_THROWS_WITH(parse_minerals("id,name\n"), Contains("line 1") && Contains("'formula'"));
    CHECK_THROWS_WITH(row("a,A\n"), Contains("line 2") && Contains("2 fields"));
    CHECK_THROWS_WITH(row("a,A,X,c,isotropic,1.5x,,,0,cauchy_AB_um2,1 0,,,1,B"), Contains("1.5x"));
    CHECK_THROWS_WITH(row("a,A,X,c,isotropic,1.5,,,0,formula 9,1 0,,,1,B"), Contains("formula 9"));
    CHECK_THROWS_WITH(row("a,A,X,c,uniaxial +,1.5,,,0,cauchy_AB_um2,1.5 0,,,1,B"),
                      Contains("takes 2 indices"));
    CHECK_THROWS_WITH(row("a,A,X,c,isotropic,0.5,,,0,cauchy_AB_um2,0.5 0,,,1,B"),
                      Contains("below 1"));
    CHECK_THROWS_WITH(row("a,\"A,X\n"), Contains("line 2") && Contains("opened"));
    CHECK_THROWS_WITH(row("a,A,X,c,shiny,1.5,,,0,cauchy_AB_um2,1.5 0,,,1,B"), Contains("shiny"));
}

TEST_CASE("a mineral at a wavelength is a medium of its symmetry", "[mineral][medium]") {
    for (const Mineral& m : minerals()) {
        CAPTURE(m.id);
        const Medium yellow = medium_at(m, 589.3), blue = medium_at(m, 450);
        const std::array symmetries{Symmetry::isotropic, Symmetry::uniaxial, Symmetry::biaxial};
        REQUIRE(yellow.symmetry == symmetries.at(m.indices.size() - 1));
        CHECK_THAT(yellow.n_o, WithinAbs(m.indices_589.front(), 6e-6));
        if (m.indices.size() > 1) CHECK_THAT(yellow.n_e, WithinAbs(m.indices_589.back(), 6e-6));
        CHECK(blue.n_o > yellow.n_o);
    }
    // n_alpha, n_beta and n_gamma lie where they are put.
    const Medium topaz = medium_at(*find_mineral("topaz"), 589.3, {{0, 1, 0}, {0, 0, 1}});
    CHECK(std::abs(topaz.principal[0].y) == 1);
    CHECK(std::abs(topaz.principal[1].z) == 1);
    CHECK(std::abs(topaz.principal[2].x) == 1);
    CHECK(medium_at(*find_mineral("quartz"), 589.3, {{0, 1, 0}}).axis == Vec3{0, 1, 0});
}

TEST_CASE("a mineral has no medium where its formula has no index", "[mineral][medium]") {
    CHECK_THROWS_WITH(medium_at(*find_mineral("topaz"), 0), Contains("wavelength"));
    CHECK_THROWS_WITH(medium_at(*find_mineral("diamond"), 174), Contains("no index at 174"));
    CHECK_THROWS_WITH(medium_at(*find_mineral("topaz"), 589.3, {{1, 0, 0}, {1, 0, 0}}),
                      Contains("perpendicular"));
}
