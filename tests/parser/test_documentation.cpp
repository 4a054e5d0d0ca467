// Every example of the manuals, and every scene that ships, does what it says.
//
// A fence says what it holds. `pov`: a scene, which loads without a word. `pov expression`: a line
// for each expression, with its value after `//`. `pov wrong`: a scene at fault; the next fence,
// `text`, is what its user reads.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "parser/scene_text.hpp"
#include "parser/words.hpp"

using namespace icespar;
namespace fs = std::filesystem;

namespace {

const fs::path docs = fs::path(ICESPAR_TESTS_DIR) / "../docs";
constexpr const char* manuals[] = {"language.md", "pov_cheat_sheet.md"};

struct Fence {
    std::string info, text;
};

std::vector<Fence> fences(const fs::path& page) {
    std::ifstream stream(page);
    std::vector<Fence> found;
    bool within = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("```")) {
            within = !within;
            if (within) found.push_back({line.substr(3), {}});
        } else if (within) {
            found.back().text += line + "\n";
        }
    }
    return found;
}

/// Numbers, vectors and colours by their difference; the rest by comparing strings.
void check_value(const std::string& line) {
    const std::size_t comment = line.find("//");
    REQUIRE(comment != std::string::npos);
    const std::string left = line.substr(0, comment), right = line.substr(comment + 2);
    INFO(line);
    if (right.find('"') != std::string::npos) {
        CHECK(number_of("strcmp(" + left + ", " + right + ")") == 0);
    } else {
        CHECK(length(vector_of("0*x + (" + left + ") - (" + right + ")")) < 1e-6);
    }
}

/// Words within backticks in the first column of the tables below this heading.
std::vector<std::string> words_below(const fs::path& page, const std::string& heading) {
    std::ifstream stream(page);
    std::vector<std::string> words;
    bool below = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("## ")) below = line == heading;
        if (!below || !line.starts_with("| `")) continue;
        std::istringstream cell(line.substr(1, line.find('|', 1) - 1));
        for (std::string word; cell >> word;) words.push_back(word.substr(1, word.size() - 2));
    }
    return words;
}

}  // namespace

TEST_CASE("the examples of the manuals load", "[documentation]") {
    for (const char* manual : manuals) {
        const auto found = fences(docs / manual);
        REQUIRE(found.size() >= 2);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto& [info, text] = found[i];
            INFO(manual << ": " << text);
            if (info == "pov expression") {
                std::istringstream lines(text);
                for (std::string line; std::getline(lines, line);) check_value(line);
                continue;
            }
            const LoadResult result = load_scene_text(text, "ring.spar", ICESPAR_SCENES_DIR);
            if (info == "pov") {
                CHECK(messages(result) == "");
                CHECK(result.scene.has_value());
            } else if (info == "pov wrong") {
                REQUIRE(i + 1 < found.size());
                REQUIRE(found[i + 1].info == "text");
                CHECK(messages(result) == found[i + 1].text);
            } else {
                CHECK(info == "text");
                REQUIRE(i > 0);
                CHECK(found[i - 1].info == "pov wrong");
            }
        }
    }
}

TEST_CASE("the words that the cheat sheet calls left out or refused are", "[documentation]") {
    for (const auto& [heading, kind] : {std::pair{"## Left out", WordKind::skipped},
                                        std::pair{"## Not there", WordKind::refused}}) {
        const auto words = words_below(docs / "pov_cheat_sheet.md", heading);
        CHECK(words.size() > 5);
        for (const std::string& word : words) {
            INFO(word);
            CHECK(word_info(word).kind == kind);
        }
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
