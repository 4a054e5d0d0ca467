// `icespar check SCENE`: every message, in words or as JSON, and a line that says what the scene
// holds.
#include "cli/commands.hpp"
#include "cli/scene_file.hpp"

namespace icespar {

namespace {
std::string count(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}
}  // namespace

int check_command(const std::filesystem::path& scene, const LoadOptions& options, bool json,
                  std::ostream& out, std::ostream& messages) {
    if (json) {
        const ReadScene read = read_scene(scene, options);
        out << to_json(read.diagnostics) << '\n';
        return read.scene ? exit_done : exit_fault;
    }
    const ReadScene read = read_scene(scene, options, messages);
    const std::string warnings = count(static_cast<std::size_t>(read.warnings), "warning");
    if (!read.scene) {
        messages << scene.string() << ": " << count(static_cast<std::size_t>(read.errors), "error")
                 << ", " << warnings << '\n';
        return exit_fault;
    }
    out << scene.string() << ": " << count(read.scene->gems.size(), "gem") << ", "
        << count(read.scene->things.size(), "thing") << ", "
        << count(read.scene->lights.size(), "light") << "; no errors, " << warnings << '\n';
    return exit_done;
}

}  // namespace icespar
