// Reading a scene for a command: every message the user gets about it.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "parser/load.hpp"

namespace icespar {

struct ReadScene {
    std::optional<Scene> scene;  ///< nothing when the scene is at fault
    int errors = 0, warnings = 0;
    std::vector<Diagnostic> diagnostics;
};

/// Reads, and looks whether the scene can be rendered.
[[nodiscard]] ReadScene read_scene(const std::filesystem::path& file, const LoadOptions& options);
/// The same, and writes the messages, but those in `told`, where they are noted.
[[nodiscard]] ReadScene read_scene(const std::filesystem::path& file, const LoadOptions& options,
                                   std::ostream& messages, std::set<std::string>* told = nullptr);

}  // namespace icespar
