// Reading a scene for a command: every message the user gets about it.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>

#include "parser/load.hpp"

namespace icespar {

struct ReadScene {
    std::optional<Scene> scene;  ///< nothing when the scene is at fault
    int errors = 0, warnings = 0;
};

/// Reads, checks, and writes the messages.
[[nodiscard]] ReadScene read_scene(const std::filesystem::path& file, const LoadOptions& options,
                                   std::ostream& messages);

}  // namespace icespar
