// The formats of GemCad and Gem Cut Studio against one another, through their writers and back, and
// damaged.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>

#include "designs/design.hpp"
#include "math/error.hpp"
#include "stone/stone.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> own_designs() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(ICESPAR_SCENES_DIR "/designs"))
        out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

/// A small design with all that formats disagree about: names, instructions, a culet, an accent.
Design sample() {
    return read_asc(
        "GemCad 5.0\ng -64 3.5\ny 4 n\nI 1.77\nH Caf\xE9 cut\nH by \x93us\x94\n"
        "a -41.3 0.61 2 n P1 18 34 50 G Meet at the centre\na -90 1 2 n G 18 n H 34 50\n"
        "a 33.1 0.73 2 n C 18 34 50\na -0.0 0.55 64 n K\na 0 0.4 64 n T G Table\nF cut it twice\n",
        "sample.asc");
}

void check_same_setting(const Design& a, const Design& b) {
    CHECK(a.gear == b.gear);
    CHECK(a.gear_offset == b.gear_offset);
    CHECK(a.symmetry == b.symmetry);
    CHECK(a.mirror == b.mirror);
    CHECK(a.refractive_index == b.refractive_index);
    CHECK(a.tiers.size() == b.tiers.size());
}

void check_same_design(const Design& a, const Design& b, double rounding) {
    check_same_setting(a, b);
    CHECK(a.headers == b.headers);
    CHECK(a.footnotes == b.footnotes);
    REQUIRE(a.tiers.size() == b.tiers.size());
    for (std::size_t t = 0; t < a.tiers.size(); ++t) {
        CAPTURE(t);
        CHECK(std::signbit(a.tiers[t].angle) == std::signbit(b.tiers[t].angle));
        CHECK(std::abs(a.tiers[t].angle - b.tiers[t].angle) <= 90 * rounding);
        CHECK(std::abs(a.tiers[t].distance - b.tiers[t].distance) <= rounding);
        CHECK(a.tiers[t].instructions == b.tiers[t].instructions);
        REQUIRE(a.tiers[t].cuts.size() == b.tiers[t].cuts.size());
        for (std::size_t i = 0; i < a.tiers[t].cuts.size(); ++i) {
            if (a.tiers[t].angle != 0) CHECK(a.tiers[t].cuts[i].index == b.tiers[t].cuts[i].index);
            CHECK(a.tiers[t].cuts[i].name == b.tiers[t].cuts[i].name);
        }
    }
}

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// Facets and shape, whatever the stone's size and place.
void check_same_shape(const Stone& a, const Stone& b, double rounding) {
    CHECK(a.facets.size() == b.facets.size());
    const auto shape = [](const Stone& s) {
        const GirdleSize size = girdle_size(s);
        return std::array{s.volume / std::pow(size.width, 3), size.length / size.width,
                          size.height / size.width};
    };
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(shape(a)[i] - shape(b)[i]) < rounding);
}

}  // namespace

TEST_CASE("GemCad's .gem and .asc of one design hold the same planes", "[designs][gem]") {
    const fs::path folder = ICESPAR_SHARED_DIR "/designs/gemcad-file-reader";
    if (!fs::exists(folder)) {
        WARN("not run: the published designs are not in this copy");
        return;
    }
    for (const char* name : {"SRB", "Compear125", "CubeIllusionTri", "Turkey"}) {
        CAPTURE(name);
        const Design text = read_design(folder / (std::string(name) + ".asc"));
        const Design binary = read_design(folder / (std::string(name) + ".gem"));
        check_same_setting(binary, text);
        CHECK(binary.headers.front() == text.headers.front());
        std::vector<FacetPlane> a = text.planes(), b = binary.planes();
        REQUIRE(a.size() == b.size());
        // The files list the facets of a tier in different orders; distances have eight decimals.
        for (const FacetPlane& plane : a) {
            const auto same = std::find_if(b.begin(), b.end(), [&](const FacetPlane& other) {
                return length(plane.normal - other.normal) < 1e-8 &&
                       std::abs(plane.distance - other.distance) < 6e-9;
            });
            CHECK(same != b.end());
            if (same != b.end()) CHECK(same->name == plane.name);
        }
    }
}

TEST_CASE("a design comes back from .asc to the last bit", "[designs]") {
    const Design design = sample();
    CHECK(design.headers.front() == "Café cut");
    CHECK(design.headers.back() == "by “us”");
    check_same_design(design, read_asc(asc_text(design), "again.asc"), 0);
    for (const fs::path& file : own_designs()) {
        CAPTURE(file.string());
        const Design own = read_design(file);
        check_same_design(own, read_asc(asc_text(own), "again.asc"), 0);
    }
}

TEST_CASE("a design comes back from .gem to rounding", "[designs][gem]") {
    check_same_design(sample(), read_gem(gem_bytes(sample()), "again.gem"), 4e-15);
    for (const fs::path& file : own_designs()) {
        CAPTURE(file.string());
        const Design own = read_design(file);
        const Design again = read_gem(gem_bytes(own), "again.gem");
        CHECK(again.facet_count() == own.facet_count());
        check_same_shape(Stone::from_planes(again.planes()), Stone::from_planes(own.planes()),
                         1e-9);
    }
}

TEST_CASE("a design comes back from .gcs with its shape, names and indices", "[designs][gcs]") {
    const Design design = sample();
    const Design again = read_gcs(gcs_text(design), "again.gcs");
    REQUIRE(again.facet_count() == design.facet_count());
    const auto a = design.planes(), b = again.planes();
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(length(a[i].normal - b[i].normal) < 1e-15 * 8);
        CHECK(a[i].name == b[i].name);
    }
    CHECK(again.tiers.front().instructions == "Meet at the centre");
    CHECK(again.headers == design.headers);
    for (const fs::path& file : own_designs()) {
        CAPTURE(file.string());
        const Design own = read_design(file);
        check_same_shape(Stone::from_planes(own.planes()),
                         Stone::from_planes(read_gcs(gcs_text(own), "again.gcs").planes()), 1e-9);
    }
}

TEST_CASE("the index angles of Gem Cut Studio run against one another on crown and pavilion",
          "[designs][gcs]") {
    // As its files have it: index 0 at -y, and 45 degrees at (+x, -y) above, (-x, -y) below.
    const auto facet = [](double angle, double index_angle) {
        const std::string text =
            "<GemCutStudio version=\"1000\"><index gear=\"96\"/><tier angle=\"" +
            std::to_string(angle) + "\" depth=\"1\" name=\"A\"><facet index_angle=\"" +
            std::to_string(index_angle) + "\"/></tier></GemCutStudio>";
        return read_gcs(text, "one.gcs").planes().at(0).normal;
    };
    CHECK(length(facet(90, 0) - Vec3{0, 1, 0}) < 1e-12);
    const double s = std::sqrt(0.5);
    CHECK(length(facet(135, 45) - Vec3{0.5, 0.5, -s}) < 1e-12);
    CHECK(length(facet(45, 45) - Vec3{-0.5, 0.5, s}) < 1e-12);
    // What is written says the same by normals and by index angles; a table's has no meaning.
    const std::string whole = gcs_text(sample());
    const std::string bare =
        std::regex_replace(whole, std::regex(R"( n[xyz]="[^"]*")"), std::string());
    REQUIRE(bare.size() < whole.size());
    const auto a = read_gcs(whole, "a.gcs").planes(), b = read_gcs(bare, "b.gcs").planes();
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(length(a[i].normal - b[i].normal) < 1e-14);
}

TEST_CASE("a stone exported as triangles or polygons keeps its volume", "[designs][mesh]") {
    const Design design = read_design(own_designs().front());
    const Stone stone = Stone::from_planes(design.planes());
    const std::string stl = stl_bytes(stone);
    std::uint32_t count = 0;
    std::memcpy(&count, stl.data() + 80, 4);
    REQUIRE(stl.size() == 84 + 50 * std::size_t{count});
    double volume = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> t;
        std::memcpy(t.data(), stl.data() + 84 + 50 * i, sizeof t);
        const auto corner = [&](std::size_t k) { return Vec3{t[k], t[k + 1], t[k + 2]}; };
        volume += dot(corner(3), cross(corner(6), corner(9))) / 6;
    }
    CHECK(volume == Approx(stone.volume).epsilon(1e-6));  // single precision
    std::istringstream obj(obj_text(stone, "x"));
    std::vector<Vec3> points;
    for (std::string line; std::getline(obj, line);) {
        Vec3 p;
        if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p.x, &p.y, &p.z) == 3) points.push_back(p);
    }
    CHECK(Stone::from_points(points).volume == Approx(stone.volume).epsilon(1e-12));
}

TEST_CASE("a damaged .gem or .gcs is an error with its place, or a design", "[designs][hostile]") {
    const std::string gem = gem_bytes(sample()), gcs = gcs_text(sample());
    const auto survives = [](const auto& read, const std::string& text) {
        try {
            for (const FacetPlane& plane : read(text, "broken").planes()) {
                if (!std::isfinite(length(plane.normal)) || !std::isfinite(plane.distance))
                    return false;
            }
        } catch (const Error& error) {
            return std::string(error.what()).starts_with("broken");
        }
        return true;
    };
    bool all = true;
    for (std::size_t n = 0; n < gem.size(); ++n) all = all && survives(read_gem, gem.substr(0, n));
    for (std::size_t n = 0; n < gcs.size(); n += 7)
        all = all && survives(read_gcs, gcs.substr(0, n));
    std::mt19937_64 random(7);
    for (int i = 0; i < 20'000; ++i) {
        std::string a = gem, b = gcs;
        for (int k = 0; k < 3; ++k) a[random() % a.size()] = static_cast<char>(random());
        if (i % 10 == 0)
            for (int k = 0; k < 3; ++k) b[random() % b.size()] = static_cast<char>(random());
        all = all && survives(read_gem, a) && (i % 10 != 0 || survives(read_gcs, b));
    }
    CHECK(all);
    CHECK_THAT(message_of([&] { (void)read_gem(gem.substr(0, gem.size() / 2), "x.gem"); }),
               Contains("x.gem: byte ") && Contains("cut off"));
    CHECK_THAT(message_of([&] { (void)read_gcs("<GemCutStudio>\n<tier", "x.gcs"); }),
               Contains("x.gcs:2: this is not sound XML"));
}

TEST_CASE("a file is written whole in the format its ending names", "[designs]") {
    const ScratchFolder folder;
    for (const char* ending : {".asc", ".gem", ".gcs", ".stl", ".obj"}) {
        CAPTURE(ending);
        const fs::path file = folder / (std::string("stone") + ending);
        CHECK(write_design(sample(), file).empty());
        CHECK(fs::file_size(file) > 200);
    }
    CHECK(read_design(folder / "stone.gem").facet_count() == sample().facet_count());
    CHECK_THAT(message_of([&] { write_design(sample(), folder / "stone.xyz"); }),
               Contains(".asc, .gem or .gcs"));
    Design open = sample();
    open.tiers.resize(2);
    CHECK_THAT(message_of([&] { write_design(open, folder / "open.gem"); }),
               Contains("the stone is not closed"));
    CHECK_FALSE(fs::exists(folder / "open.gem"));
    CHECK(write_design(open, folder / "open.asc").empty());
}

TEST_CASE("a design cut for another index keeps its tangent ratios and critical margin",
          "[designs][retarget]") {
    const Design quartz = read_design(ICESPAR_SCENES_DIR "/designs/srb_quartz.asc");
    const Design corundum = retargeted(quartz, {1.544, 1.765});
    CHECK(corundum.refractive_index == 1.765);
    const auto tangent = [](const Tier& t) { return std::tan(t.angle * M_PI / 180); };
    std::vector<double> crown, pavilion;
    double lowest_old = 90, lowest_new = 90;
    for (std::size_t i = 0; i < quartz.tiers.size(); ++i) {
        const Tier &a = quartz.tiers[i], &b = corundum.tiers[i];
        if (std::abs(std::abs(a.angle) - 90) < 1e-6 || a.angle == 0) continue;
        (a.angle < 0 ? pavilion : crown).push_back(tangent(b) / tangent(a));
        if (a.angle < 0) {
            lowest_old = std::min(lowest_old, -a.angle);
            lowest_new = std::min(lowest_new, -b.angle);
        }
    }
    for (const auto* side : {&crown, &pavilion}) {
        REQUIRE(side->size() > 1);
        for (const double ratio : *side) CHECK(ratio == Approx(side->front()).epsilon(1e-12));
    }
    const auto critical = [](double n) { return std::asin(1 / n) * 180 / M_PI; };
    CHECK(lowest_new - critical(1.765) == Approx(lowest_old - critical(1.544)).epsilon(1e-9));
    // The outline of the girdle does not change, and every facet stays on the stone.
    const Stone before = Stone::from_planes(quartz.planes()),
                after = Stone::from_planes(corundum.planes());
    CHECK(after.facets.size() == before.facets.size());
    CHECK(girdle_size(after).width == Approx(girdle_size(before).width).epsilon(1e-9));
    check_same_shape(before, Stone::from_planes(retargeted(corundum, {1.765, 1.544}).planes()),
                     1e-7);
    CHECK_THAT(message_of([&] {
                   (void)retargeted(quartz, {0.5, 1.7});
               }),
               Contains("refractive index"));
}
