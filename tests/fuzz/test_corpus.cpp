// What the fuzzers once found is read again; under the sanitizers too, this program is built so.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "fuzz/targets.hpp"

using namespace icespar;
namespace fs = std::filesystem;

TEST_CASE("what a fuzzer found is read without harm", "[fuzz]") {
    const fs::path corpus = fs::path(ICESPAR_TESTS_DIR) / "fuzz" / "corpus";
    int read = 0;
    for (const fuzz::Target& target : fuzz::targets) {
        if (!fs::exists(corpus / target.name)) continue;
        for (const auto& entry : fs::directory_iterator(corpus / target.name)) {
            std::ifstream stream(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(stream),
                                    std::istreambuf_iterator<char>()};
            INFO(entry.path().string());
            target.read(bytes);
            ++read;
        }
    }
    CHECK(read > 0);
}
