// GemCad's text format, with the habits of its versions and what is said about broken files.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>

#include "designs/design.hpp"
#include "math/error.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::string head = "GemCad 5.0\ng 96 0.0\ny 8 y\nI 1.54\n";

Design read(const std::string& text) { return read_asc(text, "test.asc"); }

std::vector<std::string> names(const Design& design) {
    std::vector<std::string> out;
    for (const FacetPlane& plane : design.planes()) out.push_back(plane.name);
    return out;
}

std::string message_of(const std::string& text) {
    try {
        (void)read(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

std::string contents(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void check_same_planes(const Design& a, const Design& b) {
    REQUIRE(a.planes().size() == b.planes().size());
    for (std::size_t i = 0; i < a.planes().size(); ++i) {
        CHECK(a.planes()[i].normal == b.planes()[i].normal);
        CHECK(a.planes()[i].distance == b.planes()[i].distance);
        CHECK(a.planes()[i].name == b.planes()[i].name);
    }
}

}  // namespace

TEST_CASE("a design says its gear, symmetry, index, headers and footnotes", "[gemcad]") {
    const Design design = read(
        "GemCad 5.0\ng -96 48.0\ny 3 y\nI 1.76\nH Cube\nH  \nH by R. S.\na -46.0 0.5 96 n 1\n"
        "F Based on\nF an idea\n");
    CHECK(design.gear == -96);
    CHECK(design.gear_offset == 48);
    CHECK(design.symmetry == 3);
    CHECK(design.mirror);
    CHECK(design.refractive_index == 1.76);
    CHECK(design.headers == std::vector<std::string>{"Cube", "", "by R. S."});
    CHECK(design.footnotes == std::vector<std::string>{"Based on", "an idea"});
    CHECK(design.planes().size() == 1);
    CHECK(read("g 64\na 0 1 64\n").refractive_index == 0);
}

TEST_CASE("every index of a tier is a facet at its angle and distance", "[gemcad]") {
    const Design design = read(head + "a -41.5 0.61701256 96 n 2 24 48\n");
    REQUIRE(design.planes().size() == 3);
    for (const FacetPlane& plane : design.planes()) {
        CHECK(plane.distance == 0.61701256);
        CHECK(plane.normal.z == Approx(-std::cos(41.5 * M_PI / 180)).epsilon(1e-15));
    }
    CHECK(design.planes()[1].normal.x == Approx(std::sin(41.5 * M_PI / 180)).epsilon(1e-15));
    CHECK(design.planes()[1].normal.y == 0);
}

TEST_CASE("the gear's sign and offset turn the facets", "[gemcad]") {
    const auto normal = [](const std::string& gear) {
        return read("g " + gear + "\na 90 1 24\n").planes().at(0).normal;
    };
    CHECK(normal("96 0.0") == Vec3{1, 0, 0});
    CHECK(normal("96 96.0") == Vec3{1, 0, 0});
    CHECK(normal("96 24.0") == Vec3{0, 1, 0});
    CHECK(normal("-96 48.0") == Vec3{1, 0, 0});
    CHECK(normal("-96") == Vec3{-1, 0, 0});
}

TEST_CASE("names belong to the index before them and to those that follow", "[gemcad]") {
    CHECK(names(read(head + "a 40 1 96 n A 24 48 n B 72\n")) ==
          std::vector<std::string>{"A", "A", "B", "B"});
    CHECK(names(read(head + "a 40 1 96 24 n A 48\n")) == std::vector<std::string>{"A", "A", "A"});
    CHECK(names(read(head + "a 40 1 96 24\n")) == std::vector<std::string>{"", ""});
    // A name may be a number, or the letter that begins the instructions.
    CHECK(names(read(head + "a 40 1 96 n 2 24\n")) == std::vector<std::string>{"2", "2"});
    CHECK(names(read(head + "a 90 1 93 n G 87 G Level girdle 5 4 3\n")) ==
          std::vector<std::string>{"G", "G"});
}

TEST_CASE("tiers go on over wrapped lines", "[gemcad]") {
    const Design whole = read(head + "a -53 0.8 93 87 81 75 n 4 69 G Meet it\na 0 1 96\n");
    check_same_planes(whole, read(head + "a -53 0.8 93 87\n 81 75\n n 4 69 G Meet it\na 0 1 96\n"));
    check_same_planes(whole, read(head + "a -53 0.8 93 87 81 75 n\n 4 69\n G Meet it\na 0 1 96"));
    check_same_planes(whole,
                      read(head + "a -53\n 0.8\n93 87\n81 75\nn 4 69\nG Meet it\na 0 1 96\n"));
    check_same_planes(whole, read(head + "a -53 0.8 93 87\n\n 81 75 n 4 69\n\n\na 0 1 96\n"));
    // Instructions wrap too; numbers in them are no indices.
    check_same_planes(whole,
                      read(head + "a -53 0.8 93 87 81 75 n 4 69 G Meet\n 12 it\na 0 1 96\n"));
    CHECK(read(head + "H a long\n title\na 0 1 96\n").headers ==
          std::vector<std::string>{"a long", "title"});
}

TEST_CASE("lines end in LF, CR LF or CR, and DOS files in control-Z", "[gemcad]") {
    const std::string file = ICESPAR_SCENES_DIR "/designs/srb_quartz.asc";
    const std::string text = contents(file);
    const Design design = read_design(file);
    CHECK(design.planes().size() == 74);
    for (const std::string ending : {"\r\n", "\r"}) {
        std::string other;
        for (const char c : text) other += c == '\n' ? ending : std::string(1, c);
        check_same_planes(design, read(other));
        check_same_planes(design, read(other + "\x1A\0\0garbage"));
        check_same_planes(design, read("\xEF\xBB\xBF" + other));
    }
    CHECK_THAT(message_of("g 96\r\n\r\na 0 x 96\r\n"), StartsWith("test.asc:3:"));
    CHECK_THAT(message_of("g 96\r\ra 0 x 96\r"), StartsWith("test.asc:3:"));
}

TEST_CASE("text in the code page of Windows becomes UTF-8, and UTF-8 stays", "[gemcad]") {
    const auto header = [](const std::string& text) {
        return read(head + "H " + text + "\na 0 1 96\n").headers.front();
    };
    CHECK(header("J\xFCrgen, 42\xB0 \x96 \x80") == "Jürgen, 42° – €");
    CHECK(header("Jürgen, 42° – €") == "Jürgen, 42° – €");
    CHECK(header("\x81\xC3") == "\xEF\xBF\xBD\xC3\x83");
}

TEST_CASE("a negative distance at angle 0, or the angle -0, is a culet", "[gemcad]") {
    for (const std::string tier : {"a 0.00 -0.60635 0\n", "a -0.00 0.60635 0\n"}) {
        const FacetPlane culet = read(head + tier).planes().at(0);
        CHECK(culet.normal == Vec3{0, 0, -1});
        CHECK(culet.distance == 0.60635);
    }
}

TEST_CASE("a broken design says where it is broken and what to do", "[gemcad][error]") {
    const auto message = [](const std::string& line) { return message_of(head + line); };
    CHECK_THAT(message("a\n"), StartsWith("test.asc:5: ") && Contains("angle is missing"));
    CHECK_THAT(message("a 40\n"), StartsWith("test.asc:5: ") && Contains("distance is missing"));
    CHECK_THAT(message("a 40 1\na 0 1 96\n"), StartsWith("test.asc:5: ") && Contains("no index"));
    CHECK_THAT(message("a forty 1 96\n"), Contains("'forty' is not the facet's angle"));
    CHECK_THAT(message("a 40 0,5 96\n"), Contains("'0,5'") && Contains("point for decimals"));
    CHECK_THAT(message("a 40 1 96 x12\n"), Contains("'x12' is not an index"));
    CHECK_THAT(message("a 40 1 96\n 12 1e999\n"),
               StartsWith("test.asc:6: ") && Contains("'1e999'"));
    for (const std::string number : {"nan", "inf", "-inf", "0x10", "1.5.2", "--3", "+-3", "1e"}) {
        CHECK_THAT(message("a 40 " + number + " 96\n"), Contains("'" + number + "'"));
    }
    CHECK_THAT(message("a 95 1 96\n"), StartsWith("test.asc:5: ") && Contains("beyond 90 degrees"));
    CHECK_THAT(message("a 40 1 n P1\n"), Contains("'n' names no index"));
    CHECK_THAT(message("a 40 1 96 n\n"), Contains("not followed by a name"));
    CHECK_THAT(message("polygon 1 2\n"), Contains("'polygon'") && Contains("GemCad .asc"));
    CHECK_THAT(message(""), Contains("no facets"));
    CHECK_THAT(message_of(""), Contains("no facets"));
    CHECK_THAT(message_of("a 40 1 96\n"), Contains("before the gear"));
    CHECK_THAT(message_of("g 0 0\n"), StartsWith("test.asc:1: ") && Contains("gear is 0"));
    CHECK_THAT(message_of("g\n"), Contains("the gear is missing"));
    CHECK_THAT(message_of("g 96 x\n"), Contains("'x' is not the gear's offset"));
    CHECK_THAT(message_of("y 2.5 n\n"), Contains("'2.5'") && Contains("not a count"));
    CHECK_THAT(message_of("I 0.7\n"), Contains("below 1"));
    CHECK_THAT(message_of(std::string("g 96 0\0\0\x01", 9)), Contains("not a text file"));
    CHECK_THAT(message_of(" 1 2 3\n"), Contains("'1'"));
    CHECK_THAT(message("a 40 1 " + std::string(60, '\xFF') + "\n"),
               Contains("'????????????????????????...'"));
}

TEST_CASE("a file that is no design is refused by name", "[gemcad][error]") {
    const ScratchFolder folder;
    const auto message = [](const std::string& file) -> std::string {
        try {
            (void)read_design(file);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    CHECK_THAT(message(folder / "absent.asc"), Contains("absent.asc") && Contains("no such file"));
    CHECK_THAT(message(folder / "design.dxf"), Contains("designs end in .asc"));
    std::filesystem::create_directory(folder / "folder.asc");
    CHECK_THAT(message(folder / "folder.asc"), Contains("no such file"));
    std::ofstream(folder / "LOUD.ASC") << head << "a 0 1 96\n";
    CHECK(read_design(folder / "LOUD.ASC").planes().size() == 1);
}

TEST_CASE("a damaged file gives a design or a message, never anything else", "[gemcad][fuzz]") {
    const std::string whole = contents(ICESPAR_SCENES_DIR "/designs/srb_quartz.asc");
    const std::string letters = "0123456789 .-+ngyIHFaG\r\n\t\x1A\xE4";
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) { return random() % n; };
    for (int trial = 0; trial < 3000; ++trial) {
        std::string text = whole.substr(0, trial % 4 == 0 ? below(whole.size()) : whole.size());
        for (std::size_t k = below(8); k > 0 && !text.empty(); --k) {
            const std::size_t at = below(text.size());
            text[at] = trial % 2 ? static_cast<char>(random()) : letters[below(letters.size())];
        }
        try {
            for (const FacetPlane& plane : read(text).planes()) {
                REQUIRE(is_finite(plane.normal));
                REQUIRE(std::isfinite(plane.distance));
            }
        } catch (const Error& error) {
            REQUIRE_THAT(error.what(), StartsWith("test.asc:"));
        }
    }
}
