// Golden messages: every scene of tests/golden against what its user is told, word for word.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "parser/load.hpp"

using namespace icespar;
namespace fs = std::filesystem;

namespace {

const fs::path golden = fs::path(ICESPAR_TESTS_DIR) / "golden";

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> scenes() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(golden)) {
        if (entry.path().extension() == ".spar") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string told(const fs::path& scene) {
    const LoadResult result = load_scene_text(contents(scene), scene.filename().string(), golden);
    std::string text;
    for (const Diagnostic& d : result.diagnostics) text += to_string(d) + "\n";
    if (result.scene) text += "(loaded)\n";
    return text;
}

}  // namespace

// With ICESPAR_WRITE_GOLDEN set the expectations are written anew, to be read before they are
// committed.
TEST_CASE("every fault in a scene is told as it was agreed", "[messages][golden]") {
    const std::vector<fs::path> files = scenes();
    REQUIRE(files.size() >= 30);
    for (const fs::path& scene : files) {
        fs::path expected = scene;
        expected.replace_extension(".txt");
        const std::string got = told(scene);
        if (std::getenv("ICESPAR_WRITE_GOLDEN")) {
            std::ofstream(expected, std::ios::binary) << got;
        }
        INFO(scene.filename().string());
        CHECK(got == contents(expected));
    }
}

TEST_CASE("a scene at fault yields no scene, and a message in place of it", "[messages]") {
    for (const fs::path& scene : scenes()) {
        const LoadResult result =
            load_scene_text(contents(scene), scene.filename().string(), golden);
        const auto errors =
            std::count_if(result.diagnostics.begin(), result.diagnostics.end(),
                          [](const auto& d) { return d.severity == Diagnostic::Severity::error; });
        INFO(scene.filename().string());
        CHECK(result.scene.has_value() == (errors == 0));
        CHECK(errors <= 20);
    }
}

TEST_CASE("a scene file that is not there is an error about the whole file", "[messages]") {
    const LoadResult result = load_scene_file(golden / "nowhere.spar");
    REQUIRE_FALSE(result.scene);
    REQUIRE(result.diagnostics.size() == 1);
    CHECK_THAT(to_string(result.diagnostics[0]),
               Catch::Matchers::EndsWith("nowhere.spar: error: there is no such file"));
}
