// Every example of docs/language.md, and every scene that ships, loads without a word of complaint.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "parser/scene_text.hpp"

using namespace icespar;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> examples(const fs::path& page) {
    std::ifstream stream(page);
    std::vector<std::string> found;
    bool within = false;
    for (std::string line; std::getline(stream, line);) {
        if (line == "```pov") {
            within = true;
            found.emplace_back();
        } else if (line == "```") {
            within = false;
        } else if (within) {
            found.back() += line + "\n";
        }
    }
    return found;
}

}  // namespace

TEST_CASE("the examples of the language's manual load", "[documentation]") {
    const auto found = examples(fs::path(ICESPAR_TESTS_DIR) / "../docs/language.md");
    REQUIRE(found.size() >= 10);
    for (const std::string& text : found) {
        const LoadResult result = load_scene_text(text, "language.md", ICESPAR_SCENES_DIR);
        INFO(text);
        CHECK(messages(result).empty());
        CHECK(result.scene.has_value());
    }
}

TEST_CASE("the scenes that ship load, and their first line says what they show",
          "[documentation]") {
    for (const auto& entry : fs::directory_iterator(ICESPAR_SCENES_DIR)) {
        if (entry.path().extension() != ".spar") continue;
        const LoadResult result = load_scene_file(entry.path());
        INFO(messages(result));
        REQUIRE(result.scene.has_value());
        CHECK(messages(result).empty());
        CHECK_FALSE(result.scene->title.empty());
    }
}
