// What is fuzzed: every reader of files that strangers write. A row here is a reader's whole entry.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "designs/design.hpp"
#include "math/error.hpp"
#include "parser/load.hpp"

namespace icespar::fuzz {

/// From the text to the core scene; nothing is rendered.
inline void scene(std::string_view text) {
    (void)load_scene_text(text, "fuzz.spar", ICESPAR_SCENES_DIR);
}

template <class Reader>
void design(Reader read, std::string_view bytes, const char* name) {
    try {
        (void)read(bytes, name).planes();
    } catch (const Error&) {
    }
}
inline void asc(std::string_view text) { design(read_asc, text, "fuzz.asc"); }
inline void gem(std::string_view bytes) { design(read_gem, bytes, "fuzz.gem"); }
inline void gcs(std::string_view text) { design(read_gcs, text, "fuzz.gcs"); }

struct Target {
    std::string_view name;  ///< also the folder of its corpus, and of CMake's list
    void (*read)(std::string_view);
};

inline constexpr std::array targets{Target{"scene", scene}, Target{"asc", asc}, Target{"gem", gem},
                                    Target{"gcs", gcs}};

}  // namespace icespar::fuzz
