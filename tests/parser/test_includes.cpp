// The library's includes: standard cuts are the stones they are meant to be, and names have their
// values.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "parser/scene_text.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The stone a macro makes; not a word of complaint (such as a facet that does not reach it).
Stone stone_of(const std::string& shape) {
    const LoadResult result =
        load_scene_text("#include \"cuts.inc\" gem { " + shape + " interior { ior 1.5 } }",
                        "test.spar", ICESPAR_TESTS_DIR);
    INFO(shape << "\n" << messages(result));
    REQUIRE(result.scene.has_value());
    CHECK(messages(result).empty());
    return result.scene->gems.at(0).stone;
}

/// Euler's formula, every edge shared by two facets, and the volume by the divergence theorem.
void check_closed(const Stone& stone) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0;
    for (const Facet& f : stone.facets) {
        volume += f.distance * f.area / 3;
        for (std::size_t i = 0; i < f.corners.size(); ++i)
            ++edges[{f.corners[i], f.corners[(i + 1) % f.corners.size()]}];
    }
    for (const auto& [edge, count] : edges) {
        CHECK(count == 1);
        CHECK(edges.count({edge.second, edge.first}) == 1);
    }
    CHECK(stone.vertices.size() - edges.size() / 2 + stone.facets.size() == 2);
    CHECK_THAT(volume, WithinRel(stone.volume, 1e-9));
}

double height(const Stone& stone) {
    double low = 0, high = 0;
    for (const Vec3& v : stone.vertices) {
        low = std::min(low, v.y);
        high = std::max(high, v.y);
    }
    return high - low;
}

std::map<std::string, int> counted(const Stone& stone) {
    std::map<std::string, int> counts;
    for (const Facet& f : stone.facets) ++counts[f.name];
    return counts;
}

}  // namespace

TEST_CASE("a round brilliant has 57 facets and a girdle of 16", "[includes]") {
    const double table = GENERATE(0.53, 0.57, 0.62);
    const double crown = GENERATE(31.0, 34.5), pavilion = GENERATE(40.8, 43.0);
    const Stone stone = stone_of("Round_Brilliant(6.5, " + std::to_string(table) + ", " +
                                 std::to_string(crown) + ", " + std::to_string(pavilion) + ")");
    check_closed(stone);
    const std::map<std::string, int> expected{{"table", 1},       {"star", 8},    {"bezel", 8},
                                              {"upper half", 16}, {"girdle", 16}, {"main", 8},
                                              {"lower half", 16}};
    CHECK(counted(stone) == expected);
    // Tolkowsky's sum: crown over the table's reach, girdle, pavilion down to the culet.
    const double r = 3.25;
    CHECK_THAT(height(stone), WithinRel(0.025 * 6.5 + r * (1 - table) * std::tan(crown * degree) +
                                            r * std::tan(pavilion * degree),
                                        1e-9));
    const GirdleSize size = girdle_size(
        stone.transformed(Transform({Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}}, Vec3{})));
    CHECK_THAT(size.width, WithinRel(6.5, 1e-9));
}

TEST_CASE("crystals as they grow have the volumes of solid geometry", "[includes]") {
    const double root3 = std::sqrt(3.0);
    const Stone prism = stone_of("Hexagonal_Prism(2, 3)");
    check_closed(prism);
    CHECK(prism.facets.size() == 8);
    CHECK_THAT(prism.volume, WithinRel(1.5 * root3 * 4 * 3, 1e-9));
    const Stone crystal = stone_of("Hexagonal_Crystal(2, 3, 1.5)");
    check_closed(crystal);
    CHECK(crystal.facets.size() == 18);
    CHECK_THAT(crystal.volume, WithinRel(1.5 * root3 * 4 * (3 + 1.5 * 2 / 3), 1e-9));
    const Stone bipyramid = stone_of("Hexagonal_Bipyramid(2, 1.5)");
    check_closed(bipyramid);
    CHECK(bipyramid.facets.size() == 12);
    CHECK_THAT(bipyramid.volume, WithinRel(1.5 * root3 * 4 * 1.5 * 2 / 3, 1e-9));
    const Stone octahedron = stone_of("Octahedron_Crystal(2)");
    check_closed(octahedron);
    CHECK(octahedron.facets.size() == 8);
    CHECK_THAT(octahedron.volume, WithinRel(std::sqrt(2.0) / 3 * 8, 1e-9));
    const Stone rhomb = stone_of("Rhomb(2, 101.92)");
    check_closed(rhomb);
    const double c = std::cos(101.92 * degree);
    CHECK_THAT(rhomb.volume, WithinRel(8 * std::sqrt(1 - 3 * c * c + 2 * c * c * c), 1e-9));
    const Stone cell = stone_of("Cell_Block(1, 1.5, 2, 80, 105, 97)");
    check_closed(cell);
    CHECK(cell.facets.size() == 6);
    const double a = std::cos(80 * degree), b = std::cos(105 * degree), g = std::cos(97 * degree);
    CHECK_THAT(cell.volume,
               WithinRel(3 * std::sqrt(1 - a * a - b * b - g * g + 2 * a * b * g), 1e-9));
}

TEST_CASE("a step cut is as long and wide as it was ordered, and its steps lie level",
          "[includes]") {
    const Stone stone = stone_of("Step_Cut(9, 7, 1.2, 0.6, 38, 42, 3)");
    check_closed(stone);
    const std::map<std::string, int> counts = counted(stone);
    CHECK(counts.at("table") == 1);
    CHECK(counts.at("girdle long") + counts.at("girdle short") + counts.at("girdle corner") == 8);
    for (const std::string row : {"crown 1", "crown 2", "crown 3", "pavilion 1"}) {
        INFO(row);
        CHECK(counts.at(row + " long") == 2);
        CHECK(counts.at(row + " short") == 2);
        CHECK(counts.at(row + " corner") == 4);
    }
    const GirdleSize size = girdle_size(
        stone.transformed(Transform({Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}}, Vec3{})));
    CHECK_THAT(size.length, WithinRel(9, 1e-9));
    CHECK_THAT(size.width, WithinRel(7, 1e-9));
    double expected = 2 * 0.03 * 3.5;
    for (const double turn : {8.0, 0.0, -8.0}) {
        expected +=
            3.5 / 3 * (0.4 * std::tan((38 + turn) * degree) + std::tan((42 + turn) * degree));
    }
    CHECK_THAT(height(stone), WithinRel(expected, 1e-9));
    // A pyramid on a square, cut off at the table, on a pyramid: one step, no corners.
    const Stone plain = stone_of("Step_Cut(2, 2, 0, 0.5, 45, 45, 1)");
    check_closed(plain);
    CHECK(plain.facets.size() == 13);
    CHECK_THAT(plain.volume, WithinRel(4 * 0.06 + (4.0 / 3) * (1 - 0.125) + 4.0 / 3, 1e-9));
}

TEST_CASE("princess and trilliant keep the symmetry of their outline", "[includes]") {
    const int chevrons = GENERATE(1, 2, 3, 4);
    const Stone princess = stone_of("Princess(5, 0.65, 33, 44, " + std::to_string(chevrons) + ")");
    check_closed(princess);
    CHECK(princess.facets.size() == std::size_t(13 + 4 + 8 * (chevrons - 1)));
    double slope = 0;
    for (int row = 0; row < chevrons; ++row) {
        const double part = chevrons > 1 ? 1 - 2.0 * row / (chevrons - 1) : 0;
        slope += std::tan((44 + 9 * part) * degree) / chevrons;
    }
    CHECK_THAT(height(princess),
               WithinRel(0.2 + 2.5 * 0.35 * std::tan(33 * degree) + 2.5 * slope, 1e-9));
    const Stone trilliant = stone_of("Trilliant(5, 0.6, 31, 41)");
    check_closed(trilliant);
    CHECK(trilliant.facets.size() == 31);
    for (const Stone* stone : {&princess, &trilliant}) {
        const double turn = 2 * std::numbers::pi / (stone == &princess ? 4 : 3);
        const double c = std::cos(turn), s = std::sin(turn);
        for (const Vec3& v : stone->vertices) {
            double nearest = 1;
            for (const Vec3& w : stone->vertices) {
                const Vec3 turned{c * v.x + s * v.z, v.y, c * v.z - s * v.x};
                nearest = std::min(nearest, length(turned - w));
            }
            CHECK_THAT(nearest, WithinAbs(0, 1e-8));
        }
    }
}

TEST_CASE("the other cuts close too", "[includes]") {
    const std::string shape =
        GENERATE("Emerald_Cut(8, 6, 0.62, 38, 44)", "Emerald_Cut(6, 6, 0.62, 38, 44)",
                 "Baguette(5, 2, 0.65, 35, 43)", "Step_Cut(6, 6, 1.5, 0.55, 36, 43, 4)",
                 "Round_Brilliant_Full(1, 0.6, 33, 41, 0.04, 0.55, 0.85)");
    check_closed(stone_of(shape));
}

TEST_CASE("a transform by name moves points as the blocks it stands for", "[includes]") {
    const std::string head = "#include \"transforms.inc\"";
    const auto check = [&](const std::string& expression, const Vec3& expected) {
        const Vec3 v = vector_of(expression, head);
        INFO(expression);
        CHECK_THAT(v.x, WithinAbs(expected.x, 1e-12));
        CHECK_THAT(v.y, WithinAbs(expected.y, 1e-12));
        CHECK_THAT(v.z, WithinAbs(expected.z, 1e-12));
    };
    check("vtransform(<1, 2, 3>, transform { scale 2 translate y })", {2, 5, 6});
    check("vinv_transform(<2, 5, 6>, transform { scale 2 translate y })", {1, 2, 3});
    check("vtransform(x, Axis_Rotate_Trans(y, 90))", {0, 0, -1});
    check("vtransform(<1, 1, 0>, Axial_Scale_Trans(x + y, 3))", {3, 3, 0});
    check("vtransform(2*x, Rotate_Around_Trans(z*90, x))", {1, 1, 0});
    check("vtransform(x, Reorient_Trans(x, -x))", {-1, 0, 0});
    check("vtransform(2*x, Reorient_Trans(x, y + z))", {0, std::sqrt(2.0), std::sqrt(2.0)});
    check("vtransform(y*3, Point_At_Trans(z))", {0, 0, 3});
    CHECK(faulty("#declare V = vtransform(x, y);", "needs a transform here, not a vector of 3"));
    CHECK(
        faulty("#declare V = vtransform(x, transform { matrix <1,0,0,1,0,0,0,0,1,0,0,0> inverse "
               "});",
               "inverse"));
}

TEST_CASE("the includes can be read together, in any number, and hide no name of the language",
          "[includes]") {
    std::string text;
    for (int round = 0; round < 2; ++round) {
        for (const char* name : {"arrays", "colors", "consts", "cuts", "ior", "lights", "math",
                                 "minerals", "shapes", "strings", "studio", "transforms"})
            text += "#include \"" + std::string(name) + ".inc\"\n";
    }
    CHECK(messages(load_scene_text(text, "test.spar", ICESPAR_TESTS_DIR)).empty());
}
