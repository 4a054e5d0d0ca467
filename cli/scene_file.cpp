// Reading a scene for a command: messages of the parser, then faults of the scene as a whole.
#include "cli/scene_file.hpp"

namespace icespar {

ReadScene read_scene(const std::filesystem::path& file, const LoadOptions& options) {
    LoadResult loaded = load_scene_file(file, options);
    ReadScene result;
    result.diagnostics = std::move(loaded.diagnostics);
    if (loaded.scene) {
        // Of a camera that is written in the scene the parser has spoken already.
        for (const std::string& fault : camera_faults(*loaded.scene)) {
            Diagnostic d;
            d.file = file.string();
            d.message = fault;
            d.hint = "without a camera block it stands at the origin";
            result.diagnostics.push_back(std::move(d));
        }
    }
    for (const Diagnostic& d : result.diagnostics)
        ++(d.severity == Diagnostic::Severity::error ? result.errors : result.warnings);
    if (result.errors == 0) result.scene = std::move(loaded.scene);
    return result;
}

ReadScene read_scene(const std::filesystem::path& file, const LoadOptions& options,
                     std::ostream& messages, std::set<std::string>* told) {
    ReadScene result = read_scene(file, options);
    for (const Diagnostic& diagnostic : result.diagnostics) {
        const std::string text = to_string(diagnostic);
        if (!told || told->insert(text).second) messages << text << '\n';
    }
    return result;
}

}  // namespace icespar
