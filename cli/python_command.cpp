// Commands that live in the Python package: the program finds a Python and becomes it.
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "cli/commands.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(file, ignored);
}

/// The package that was built with this program, where that is what runs, comes before any other.
void prefer_package_beside_program() {
    std::error_code fault;
    const fs::path program = fs::read_symlink("/proc/self/exe", fault);
    if (fault) return;
    const fs::path folder = program.parent_path() / "python";
    if (!is_there(folder / "icespar" / "__main__.py")) return;
    const char* const others = std::getenv("PYTHONPATH");
    const std::string path =
        folder.string() + (others && *others ? ":" + std::string(others) : std::string());
    setenv("PYTHONPATH", path.c_str(), 1);
}

std::string python() {
    if (const char* const chosen = std::getenv("ICESPAR_PYTHON"); chosen && *chosen) return chosen;
    // Of the build, as long as it is there.
    const std::string built_with = ICESPAR_BUILD_PYTHON;
    return !built_with.empty() && is_there(built_with) ? built_with : "python3";
}

}  // namespace

int python_command(char** arguments) {
    prefer_package_beside_program();
    const std::string interpreter = python();
    // Nothing is imported from the folder one happens to be in; a package that is missing is said
    // in one line, not by a trace.
    static constexpr const char* start =
        "import sys\n"
        "sys.path[:] = filter(None, sys.path)\n"
        "try:\n"
        "    from icespar.__main__ import main\n"
        "except ImportError as fault:\n"
        "    sys.exit(f'icespar: {sys.executable} cannot import the Python package icespar "
        "({fault}): "
        "run make build, or name another Python in ICESPAR_PYTHON')\n"
        "sys.exit(main(sys.argv[1:]))";
    std::vector<std::string> words{interpreter, "-c", start};
    for (char** word = arguments; *word; ++word) words.emplace_back(*word);
    std::vector<char*> call;
    for (std::string& word : words) call.push_back(word.data());
    call.push_back(nullptr);
    execvp(call[0], call.data());
    throw Error("this command needs Python, and " + interpreter + " does not start (" +
                std::strerror(errno) +
                "): run make build, or name a Python with the package icespar in ICESPAR_PYTHON");
}

}  // namespace icespar
