// The commands of the program, each returning its exit code.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "cli/animation.hpp"
#include "render/render.hpp"

namespace icespar {

/// What a command tells the shell. A render that is interrupted before it has anything to save ends
/// as the shell's own convention has it, with 128 + SIGINT.
enum ExitCode {
    exit_done = 0,
    exit_fault = 1,
    exit_usage = 2,
    exit_interrupted = 3,
    exit_interrupted_unsaved = 130
};

struct RenderArguments {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs, allow;
    RenderOptions options;
    Animation animation;
    bool resume = false;  ///< pictures whose files are all there are left alone
};

/// Renders a scene, or each frame of it, and writes every output. `messages` is stderr.
int render_command(const RenderArguments& arguments, std::ostream& messages);

/// Reads a scene and says what is wrong with it, or what is in it; as JSON, to `out`, for editors.
int check_command(const std::filesystem::path& scene, const LoadOptions& options, bool json,
                  std::ostream& out, std::ostream& messages);

struct PlanArguments {
    std::filesystem::path scene;
    bool stokes = false, full = false;
    Engine engine = Engine::automatic;
};

/// Reads a scene and says how it would be rendered, and why.
int plan_command(const PlanArguments& arguments, const LoadOptions& options, std::ostream& out,
                 std::ostream& messages);

/// Prints the scene evenly indented, or writes it back in place.
int format_command(const std::filesystem::path& scene, bool in_place, std::ostream& out,
                   std::ostream& messages);

struct ConvertArguments {
    std::filesystem::path source, target;
    double index = 0, from = 0, pavilion = 0, crown = 0;  ///< as Retarget; 0 where not given
};

/// Reads a faceting design and writes it in another format, for another index where asked.
int convert_command(const ConvertArguments& arguments, std::ostream& messages);

/// One line for every mineral, or all that is known about one; or the colours of all, as CSV.
int minerals_command(const std::string& name, bool colours, std::ostream& out,
                     std::ostream& messages);

/// Hands a command over to the Python package: `arguments`, ended by a null, start with its name.
/// Returns only by throwing Error, when no Python can be started.
int python_command(char** arguments);

}  // namespace icespar
