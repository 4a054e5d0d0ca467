// The parser's front door: a file or a text becomes a scene, or messages that say why not.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace icespar {

/// Where a macro was called, or a file included, on the way to a message.
struct CallSite {
    std::string macro;  ///< empty: an include
    std::string file;
    int line = 0, column = 0;
};

/// One message with its place, in the form of rustc and lexy: file:line:column, the line, a caret.
struct Diagnostic {
    enum class Severity { error, warning };
    Severity severity = Severity::error;
    std::string file;
    /// 1-based, in characters; 0: the message is about the whole file.
    int line = 0, column = 0;
    int end_line = 0, end_column = 0;  ///< just after the last character
    std::string message;
    std::string source_line;
    std::string hint;             ///< the likeliest repair, shown after the caret; may be empty
    std::vector<CallSite> stack;  ///< innermost first; nine at most
};

/// The stack in words, a line for each call; what goes on beyond eight is said to.
[[nodiscard]] std::vector<std::string> notes(const Diagnostic& diagnostic);
/// An array of objects for editors: file, line, column, end {line, column}, severity, message,
/// hint, stack [{macro, file, line, column}].
[[nodiscard]] std::string to_json(const std::vector<Diagnostic>& diagnostics);

/// As the user reads it, without a trailing newline.
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

struct LoadOptions {
    int width = 640, height = 480;  ///< what image_width and image_height say in the scene
    double clock = 0;
    /// What the scene's variables of these names say; a still picture is the first frame of one.
    int frame_number = 1, initial_frame = 1, final_frame = 1;
    double initial_clock = 0, final_clock = 1;
    std::vector<std::filesystem::path> allow;  ///< folders that may be read besides the scene's own
};

struct LoadResult {
    std::optional<Scene> scene;           ///< nothing when there was an error
    std::vector<Diagnostic> diagnostics;  ///< at most 20 errors; warnings once per word
};

[[nodiscard]] LoadResult load_scene_file(const std::filesystem::path& file,
                                         const LoadOptions& = {});
/// `folder` is where relative includes and designs are looked for.
[[nodiscard]] LoadResult load_scene_text(std::string_view text, const std::string& name,
                                         const std::filesystem::path& folder,
                                         const LoadOptions& = {});

}  // namespace icespar
