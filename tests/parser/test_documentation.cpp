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

TEST_CASE("the examples of the manuals of language and includes load", "[documentation]") {
    const std::string page = GENERATE("language.md", "includes.md");
    const auto found = examples(fs::path(ICESPAR_TESTS_DIR) / "../docs" / page);
    REQUIRE(found.size() >= 7);
    for (const std::string& text : found) {
        const LoadResult result = load_scene_text(text, page, ICESPAR_SCENES_DIR);
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
