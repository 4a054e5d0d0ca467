// The command that says what a faceting design is once it is cut.
#pragma once

#include <filesystem>
#include <ostream>

namespace icespar {

/// Reads the design, builds the stone, and prints tiers, facets and sizes to `out`. Throws Error
/// when the file or the stone is at fault; nothing has been printed then.
void stone_command(const std::filesystem::path& file, std::ostream& out);

}  // namespace icespar
