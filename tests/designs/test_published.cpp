// Whole designs against facet counts, volumes and proportions from an independent half-space
// intersection (qhull).
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "designs/design.hpp"
#include "stone/stone.hpp"
#include "support/solids.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) out.push_back(cell);
    return out;
}

std::vector<Row> table(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> columns = cells(line);
    std::vector<Row> rows;
    while (std::getline(stream, line)) {
        const std::vector<std::string> values = cells(line);
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = values.at(i);
    }
    return rows;
}

/// Half a unit of the last of `digits` decimals, and a little for the rounding of the table itself.
void check_digits(double value, const std::string& expected, int digits) {
    CAPTURE(value, expected);
    CHECK(std::abs(value - std::stod(expected)) <= 0.501 * std::pow(10, -digits));
}

void check_row(const std::filesystem::path& folder, const Row& row) {
    CAPTURE(row.at("file"));
    const Design design = read_design(folder / row.at("file"));
    const Stone stone = Stone::from_planes(design.planes());
    CHECK(fault_of(stone) == "");
    CHECK(stone.facets.size() == std::stoul(row.at("distinct_facets")));
    check_digits(stone.volume, row.at("volume"), 5);
    const GirdleSize size = girdle_size(stone);
    check_digits(size.length / size.width, row.at("L_over_W"), 4);
    check_digits(size.height / size.width, row.at("H_over_W"), 4);
    if (row.contains("planes")) CHECK(design.planes().size() == std::stoul(row.at("planes")));
    if (row.contains("ri")) CHECK(design.refractive_index == std::stod(row.at("ri")));
}

}  // namespace

TEST_CASE("the project's own designs have the facets, volume and proportions of qhull",
          "[designs]") {
    const std::vector<Row> rows = table(ICESPAR_TESTS_DIR "/designs/designs.csv");
    REQUIRE(rows.size() == 6);
    for (const Row& row : rows) check_row(ICESPAR_SCENES_DIR "/designs", row);
}

TEST_CASE("published designs have the facets, volume and proportions of qhull", "[designs]") {
    const std::filesystem::path folder = ICESPAR_SHARED_DIR "/designs";
    if (!std::filesystem::exists(folder / "expected.csv")) {
        WARN("not run: the published designs are not in this copy");
        return;
    }
    const std::vector<Row> rows = table(folder / "expected.csv");
    REQUIRE(rows.size() == 14);
    for (const Row& row : rows) check_row(folder, row);
}

TEST_CASE("planes that duplicate, touch or miss the stone are told apart", "[designs]") {
    const Design design = read_design(ICESPAR_SCENES_DIR "/designs/redundant_planes.asc");
    const Stone stone = Stone::from_planes(design.planes());
    // The girdle and X graze edges by the eighth decimal; the second P is the first again.
    const std::vector<std::string> unreached{"G", "G", "G", "G", "X", "X", "X",
                                             "X", "Y", "Y", "Y", "Y", "T0"};
    CHECK(stone.unreached == unreached);
}

TEST_CASE("meshes with six decimals have the facets of the design they were made from",
          "[designs]") {
    const std::filesystem::path folder = ICESPAR_SHARED_DIR "/designs";
    if (!std::filesystem::exists(folder / "pov/pc01043.inc")) {
        WARN("not run: the published designs are not in this copy");
        return;
    }
    std::ifstream stream(folder / "pov/pc01043.inc");
    std::vector<Vec3> points;
    for (std::string line; std::getline(stream, line);) {
        for (std::size_t at = line.find('<'); at != std::string::npos;
             at = line.find('<', at + 1)) {
            Vec3 p;
            if (std::sscanf(line.c_str() + at, "<%lf,%lf,%lf>", &p.x, &p.y, &p.z) == 3) {
                points.push_back(p);
            }
        }
    }
    const Stone mesh = Stone::from_points(points);
    const Stone design =
        Stone::from_planes(read_design(folder / "facethound/pc01043.asc").planes());
    CHECK(fault_of(mesh) == "");
    CHECK(mesh.facets.size() == design.facets.size());
    const auto shape = [](const Stone& s) { return s.volume / std::pow(girdle_size(s).width, 3); };
    CHECK(shape(mesh) == Approx(shape(design)).epsilon(1e-5));
}
