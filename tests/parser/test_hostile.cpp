// Scenes written to harm: each ends in a clear message, by a bound that is small in time and
// memory.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "parser/scene_text.hpp"
#include "support/scratch_folder.hpp"

using namespace icespar;
namespace fs = std::filesystem;

namespace {

std::string repeated(std::string_view text, std::size_t times) {
    std::string out;
    out.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) out += text;
    return out;
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

/// What the user reads.
std::string told(const std::string& text) {
    return messages(load_scene_text(text, "scene.spar", ICESPAR_TESTS_DIR "/golden"));
}

using Catch::Matchers::Contains;

}  // namespace

TEST_CASE("what runs away is stopped by a bound that the message names", "[hostile]") {
    CHECK_THAT(told("#while (1) #end"), Contains("1000000 times, the bound on loops"));
    CHECK_THAT(told("#for (I, 0, 1e300) #end"), Contains("the bound on loops"));
    CHECK_THAT(told("#for (I, 0, 1, 1e-300) #end"), Contains("the bound on loops"));
    CHECK_THAT(told("#for (I, 1, 1e6) #for (J, 1, 1e3) #declare A = I*J; #end #end"),
               Contains("tokens to read, the bound"));
    CHECK_THAT(told("#macro A() A() #end A()"), Contains("200 deep, the bound"));
    CHECK_THAT(told("#macro A() B() #end #macro B() A() #end A()"), Contains("the bound"));
    CHECK_THAT(told("#macro A(N) A(A(N)) #end A(1)"), Contains("bound"));
    CHECK_THAT(told("#declare A = array[1e12];"), Contains("1 to 1000000 elements"));
    CHECK_THAT(told("#declare A = array[10000][10000][10000];"), Contains("the bound"));
    CHECK_THAT(told("#declare S = \"abcdefgh\"; #while (1) #declare S = concat(S, S); #end"),
               Contains("65536 bytes, the bound"));
    CHECK_THAT(told("#declare A = union { #for (I, 1, 1000000) sphere { 0, 1 } #end }"),
               Contains("the bound"));
}

TEST_CASE("stones that differ are bounded, instances of one are not", "[hostile]") {
    CHECK_THAT(told("union { #for (I, 0, 9000) gem { box { 0, 1 } interior { ior 1.5 } } #end }"),
               Contains("different stones and meshes, the bound"));
}

TEST_CASE("names and gears have bounds too", "[hostile]") {
    const std::string name(2'000'000, 'a');
    const std::string said = told("#declare " + name + " = 1;\n" + name + "b");
    CHECK_THAT(said, Contains("longer than 1000 characters, the bound"));
    CHECK(said.size() < 2000);
    const std::string facet = "facet { \"a\" angle 45 distance 1 every 1 from 0 } } } ";
    CHECK_THAT(told("gem { cut { gear 1e300 " + facet), Contains("from -1e+06 to 1e+06"));
    CHECK_THAT(told("gem { cut { gear 1e6 " + facet),
               Contains("10000 planes or points, the bound"));
}

TEST_CASE("text nested a million deep is refused, whatever nests", "[hostile]") {
    constexpr std::size_t deep = 1'000'000;
    for (const char* opener : {"(", "<", "{", "union { ", "#if (1) ", "-", "!", "array { ",
                               "transform { ", "sin(", "a[", "1 ? ", "/*", "#macro A() "}) {
        INFO(opener);
        CHECK_THAT(told("#declare A = " + repeated(opener, deep)), Contains("error"));
        CHECK_THAT(told(repeated(opener, deep)), Contains("error"));
    }
    CHECK_THAT(told("#declare A = 1" + repeated(" + 1", deep) + ";"), Catch::Matchers::Equals(""));
}

TEST_CASE("numbers without end are refused where they arise", "[hostile]") {
    for (const char* bad :
         {"1e308*1e308", "1e999", "<1, 2, 3>*1e308*1e308", "0/0", "-1e308 - 1e308", "sqrt(-1)",
          "exp(1e5)", "pow(-8, 1/3)", "vnormalize(<0, 0, 0>)", "tan(1e308)*1e308*1e308", "acosh(0)",
          "atanh(2)", "val(\"1e999\")", "val(\"nan\")*1"}) {
        INFO(bad);
        CHECK_THAT(told("sphere { <0, 0, 0>, 1 translate " + std::string(bad) + " }"),
                   Contains("error"));
    }
}

TEST_CASE("very many errors are told in short", "[hostile]") {
    const std::string text =
        told(repeated("sphrer { 1/0 } undeclared Unknown_Name_Of_Length\n", 20'000));
    CHECK(text.size() < 20'000);
    CHECK(std::count(text.begin(), text.end(), '|') <= 42);
}

TEST_CASE("a scene reads nothing outside of its folder", "[hostile]") {
    const ScratchFolder scratch;
    const fs::path scene = scratch.path() / "scene", secret = scratch.path() / "secret";
    fs::create_directories(scene);
    fs::create_directories(secret);
    write(secret / "key.inc", "#declare Key = 42;");
    fs::create_symlink(secret / "key.inc", scene / "link.inc");
    fs::create_directory_symlink(secret, scene / "folder");
    fs::create_directories(scratch.path() / "scene_too");
    write(scratch.path() / "scene_too" / "near.inc", "#declare Near = 1;");
    const auto read = [&](const std::string& name, std::vector<fs::path> allow = {}) {
        LoadOptions options;
        options.allow = std::move(allow);
        return messages(load_scene_text("#include \"" + name + "\"", "s.spar", scene, options));
    };
    const std::string absolute = (secret / "key.inc").string();
    for (const std::string& name :
         {std::string("/etc/passwd"), std::string("../secret/key.inc"), std::string("link.inc"),
          std::string("folder/key.inc"), std::string("../scene_too/near.inc"), absolute,
          std::string("./../../../../../../../../etc/passwd"),
          std::string("folder/../../secret/key.inc")}) {
        INFO(name);
        CHECK_THAT(read(name), Contains("lies outside the scene's folder"));
    }
    // The same words whether the file is there or not: a scene must not find out.
    CHECK_THAT(read("../secret/nothing.inc"), Contains("lies outside the scene's folder"));
    CHECK(number_of("file_exists(\"/etc/passwd\")") == 0);
    CHECK(read("key.inc", {secret}).empty());
    CHECK(read("link.inc", {secret}).empty());
    CHECK_THAT(read("/dev/zero", {"/dev"}), Contains("no file"));
}

TEST_CASE("a file need not be tidy to be read: BOM, CR LF, old Macintosh, Windows' letters",
          "[hostile]") {
    CHECK(told("\xef\xbb\xbf// Title\r\nsphere {\r\n  0, 1 pigment { rgb 1 } }\r\n").empty());
    const std::string old = told("// Gr\xf6\xdf\x65\nsphere { 0, 1 pigment { rgb 1 } }");
    CHECK_THAT(old, Contains("warning: this file is not UTF-8: it is read as Windows-1252"));
    CHECK_THAT(old, Contains("Gr\xc3\xb6\xc3\x9f\x65"));
    CHECK_THAT(told("\xed\xa0\x80 \xc0\x80 \xff"), Contains("unexpected character"));
    CHECK_THAT(told("// Title\rsphere { 0, 1\r  pigmnt { rgb 1 } }\r"),
               Contains("scene.spar:3:3: error: unknown word 'pigmnt'"));
}

TEST_CASE("what is no text is refused in one message", "[hostile]") {
    const ScratchFolder scratch;
    const auto load = [&](const std::string& bytes) {
        write(scratch / "scene.spar", bytes);
        return messages(load_scene_file(scratch / "scene.spar"));
    };
    CHECK_THAT(load(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
               Contains("this is not a text"));
    CHECK_THAT(load(std::string("\xff\xfe"
                                "c\0a\0m\0",
                                8)),
               Contains("UTF-16: save it as UTF-8"));
    CHECK(load("").empty());
    CHECK_THAT(messages(load_scene_file(scratch.path())), Contains("this is a folder"));
    CHECK_THAT(messages(load_scene_file("/dev/zero")), Contains("cannot be read"));
    write(scratch / "sound.inc", std::string(5000, '\0'));
    CHECK_THAT(messages(load_scene_text("#include \"sound.inc\"", "s", scratch.path())),
               Contains("cannot be included: this is not a text"));
    std::ofstream(scratch / "huge.inc").close();
    fs::resize_file(scratch / "huge.inc", 1ULL << 30);
    CHECK_THAT(messages(load_scene_text("#include \"huge.inc\"", "s", scratch.path())),
               Contains("64 MiB, the bound"));
}

TEST_CASE("a hundred thousand stones and lamps are compared in short time", "[hostile]") {
    CHECK_THAT(told("#declare G = gem { box { 0, 1 } interior { ior 1.5 } }\n"
                    "#for (I, 0, 20000) object { G translate <I*2, 0, 0> } #end\n"
                    "#for (I, 0, 20000) light_source { <I*2, 5, 0>, rgb 1 } #end\n"
                    "object { G translate <40000.5, 0.5, 0.5> }"),
               Contains("this stone overlaps the one at scene.spar:4"));
    CHECK_THAT(told("#declare G = gem { box { 0, 1 } interior { ior 1.5 } }\n"
                    "#for (I, 0, 20000) object { G } #end"),
               Contains("overlaps"));
}
