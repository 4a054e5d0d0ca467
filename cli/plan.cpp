// `icespar plan SCENE`: which kernels a render would use, with the reason for each.
#include "cli/commands.hpp"
#include "cli/scene_file.hpp"

namespace icespar {

int plan_command(const PlanArguments& arguments, const LoadOptions& options, std::ostream& out,
                 std::ostream& messages) {
    const ReadScene read = read_scene(arguments.scene, options, messages);
    if (!read.scene) return exit_fault;
    const Forced forced = arguments.full ? Forced::everything() : Forced{};
    out << plan_text(*read.scene,
                     needs_of(*read.scene, arguments.stokes, arguments.engine, forced));
    return exit_done;
}

}  // namespace icespar
