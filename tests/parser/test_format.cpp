// `icespar format`: lines are indented evenly, and nothing else happens.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "math/error.hpp"
#include "parser/format.hpp"
#include "parser/lexer.hpp"
#include "parser/scene_text.hpp"
#include "support/same_scene.hpp"

using namespace icespar;
namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Every token's text, one after the other.
std::vector<std::string> tokens(const std::string& text) {
    Names names;
    std::vector<std::string> out;
    for (const Token& token : tokenize(0, text, names).tokens)
        out.push_back(text.substr(token.begin, token.end - token.begin));
    return out;
}

/// Tokens and comments without the blanks about them.
std::string ink(std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
    return text;
}

std::vector<fs::path> scenes() {
    std::vector<fs::path> files;
    for (const char* folder : {ICESPAR_SCENES_DIR, ICESPAR_TESTS_DIR}) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const fs::path ending = entry.path().extension();
            if (ending == ".spar" || ending == ".inc" || ending == ".pov")
                files.push_back(entry.path());
        }
    }
    return files;
}

}  // namespace

TEST_CASE("indentation follows braces, brackets and directives", "[format]") {
    const std::string untidy =
        "\n\n#if (1)\n      // why\n  union {  \n#for (I, 0, 3)\nsphere { <0,\n0, I>, 1\n"
        "pigment { rgb 1 } }\n      #end\n}\n\n\n\n#else\n#declare A = 1 +\n2;   // two\n#end";
    const std::string tidy =
        "#if (1)\n  // why\n  union {\n    #for (I, 0, 3)\n      sphere { <0,\n        0, I>, 1\n"
        "        pigment { rgb 1 } }\n    #end\n  }\n\n#else\n  #declare A = 1 +\n    2;   // two\n"
        "#end\n";
    CHECK(formatted(untidy) == tidy);
}

TEST_CASE("a comment of several lines and what stands in strings keep their blanks", "[format]") {
    const std::string text = "/* one\n      two { #if\n   three */ #declare A = \"  a {  b\";\nA\n";
    CHECK(formatted(text) == text);
}

TEST_CASE("branches that open the same brace indent what follows once", "[format]") {
    CHECK(
        formatted("#if (1)\nunion {\n#else\nmerge {\n#end\nsphere { 0, 1 }\n}\nplane { y, 0 }\n") ==
        "#if (1)\n  union {\n#else\n  merge {\n#end\n    sphere { 0, 1 }\n  }\nplane { y, 0 }\n");
}

TEST_CASE("a guard against a second include does not indent the file", "[format]") {
    const std::string text =
        "// A file.\n#ifndef (Here)\n#declare Here = 1;\n#if (1)\n  A\n#end\n#end\n";
    CHECK(formatted(text) == text);
}

TEST_CASE("what cannot be told from text is refused with its line", "[format]") {
    CHECK_THROWS_WITH(formatted("sphere {\n/* never closed"),
                      Catch::Matchers::StartsWith("2: error: this comment is never closed"));
    CHECK_THROWS_AS(formatted("#declare A = \"never closed;\n"), Error);
    CHECK_THROWS_AS(formatted(std::string("a\0b", 3)), Error);
    CHECK(formatted("").empty());
    CHECK(formatted("} ) ] #end #else\n}") == "} ) ] #end #else\n}\n");
}

TEST_CASE("every scene keeps its tokens, its comments and its meaning to the bit", "[format]") {
    const std::vector<fs::path> files = scenes();
    REQUIRE(files.size() > 100);
    for (const fs::path& file : files) {
        const std::string text = contents(file);
        std::string better;
        try {
            better = formatted(text);
        } catch (const Error&) {
            continue;  // golden scenes of unclosed comments and strings
        }
        INFO(file.string());
        CHECK(tokens(better) == tokens(text));
        CHECK(ink(better) == ink(text));
        CHECK(formatted(better) == better);
        if (file.parent_path() != fs::path(ICESPAR_SCENES_DIR)) continue;
        const LoadResult before = load_scene_text(text, "scene", file.parent_path());
        const LoadResult after = load_scene_text(better, "scene", file.parent_path());
        REQUIRE(before.scene.has_value());
        REQUIRE(after.scene.has_value());
        CHECK(same_numbers(*before.scene, *after.scene));
    }
}

TEST_CASE("a scene that is read twice is the same to the bit", "[format]") {
    for (const fs::path& file : scenes()) {
        if (file.parent_path() != fs::path(ICESPAR_SCENES_DIR)) continue;
        const LoadResult once = load_scene_file(file), again = load_scene_file(file);
        INFO(file.string());
        REQUIRE(once.scene.has_value());
        REQUIRE(again.scene.has_value());
        CHECK(same_numbers(*once.scene, *again.scene));
    }
}
