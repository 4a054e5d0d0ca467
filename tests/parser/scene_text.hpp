// Loading scenes from text, and the values of expressions as a scene sees them.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "parser/load.hpp"

namespace icespar {

/// Every message, one after the other.
inline std::string messages(const LoadResult& result) {
    std::string text;
    for (const Diagnostic& d : result.diagnostics) text += to_string(d) + "\n";
    return text;
}

/// The scene; the test fails with its messages when there is none.
inline Scene scene_of(const std::string& text, const LoadOptions& options = {}) {
    const LoadResult result =
        load_scene_text(text, "test.spar", ICESPAR_TESTS_DIR "/golden", options);
    INFO(text);
    INFO(messages(result));
    REQUIRE(result.scene.has_value());
    return *result.scene;
}

/// A vector in the language's own coordinates, where z has the other sign.
inline Vec3 vector_of(const std::string& expression, const std::string& before = {}) {
    const Vec3 v = scene_of(before + "\ncamera { location " + expression + " }").camera.location;
    return {v.x, v.y, 0.0 - v.z};
}

inline double number_of(const std::string& expression, const std::string& before = {}) {
    return vector_of("<0, (" + expression + "), 0>", before).y;
}

/// True when a fault is found whose message holds `part`.
inline bool faulty(const std::string& text, const std::string& part) {
    const LoadResult result = load_scene_text(text, "test.spar", ICESPAR_TESTS_DIR "/golden");
    INFO(messages(result));
    CHECK_THAT(messages(result), Catch::Matchers::Contains(part));
    return !result.scene;
}

}  // namespace icespar
