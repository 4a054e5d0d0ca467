// Reading a scene for a command: messages of the parser, then faults of the scene as a whole.
#include "cli/scene_file.hpp"

namespace icespar {

ReadScene read_scene(const std::filesystem::path& file, const LoadOptions& options,
                     std::ostream& messages) {
    LoadResult loaded = load_scene_file(file, options);
    ReadScene result;
    for (const Diagnostic& diagnostic : loaded.diagnostics) {
        messages << to_string(diagnostic) << '\n';
        ++(diagnostic.severity == Diagnostic::Severity::error ? result.errors : result.warnings);
    }
    if (!loaded.scene) {
        if (result.errors == 0) ++result.errors;
        return result;
    }
    for (const auto& found : {faults(*loaded.scene), camera_faults(*loaded.scene)})
        for (const std::string& fault : found) {
            messages << file.string() << ": error: " << fault << '\n';
            ++result.errors;
        }
    if (result.errors == 0) result.scene = std::move(loaded.scene);
    return result;
}

}  // namespace icespar
