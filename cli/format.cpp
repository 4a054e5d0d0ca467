// `icespar format SCENE`: the same scene, evenly indented.
#include "parser/format.hpp"

#include "cli/commands.hpp"
#include "image/image.hpp"
#include "math/error.hpp"
#include "parser/source.hpp"

namespace icespar {

int format_command(const std::filesystem::path& scene, bool in_place, std::ostream& out,
                   std::ostream& messages) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(scene, ignored)) {
        messages << scene.string() << ": error: there is no such file\n";
        return exit_fault;
    }
    const auto text = Sources::read(scene);
    if (!text) {
        messages << scene.string()
                 << ": error: cannot be read as a scene, or is larger than 64 MiB\n";
        return exit_fault;
    }
    std::string better;
    try {
        better = formatted(*text);
    } catch (const Error& error) {
        messages << scene.string() << ':' << error.what() << '\n';
        return exit_fault;
    }
    if (!in_place) {
        out << better;
    } else if (better != *text) {
        write_whole(scene.string(), better);
    }
    return exit_done;
}

}  // namespace icespar
