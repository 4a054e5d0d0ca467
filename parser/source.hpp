// The texts a scene is made of: which files may be read, and where in them a thing stands.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace icespar {

/// A stretch of a source text, and the chain of includes and macro calls by which it was reached.
struct Place {
    std::uint32_t file = 0;
    std::uint32_t begin = 0, end = 0;  ///< bytes
    std::uint32_t route = 0;           ///< index into Sources' routes; 0: the scene file itself
};

/// From the first byte of `a` to the last of `b`, if they are in one file.
[[nodiscard]] Place joined(const Place& a, const Place& b);

struct SourceFile {
    std::string name;  ///< as messages show it
    std::filesystem::path folder;
    std::string text;
    std::vector<std::uint32_t> line_starts;
    bool was_utf8 = true;  ///< `text` is, always
};

/// One step of a route: the call of a macro or an include.
struct RouteStep {
    enum class Kind { include, macro };
    Kind kind = Kind::include;
    std::string_view name;  ///< of the macro
    Place call;
};

struct LineColumn {
    int line = 1, column = 1;  ///< 1-based; columns count characters, not bytes
};

class Sources {
public:
    /// Files are read below `scene_folder` and the folders of `allow`, and nowhere else.
    Sources(const std::filesystem::path& scene_folder,
            const std::vector<std::filesystem::path>& allow);

    /// Index of the new file. What is not UTF-8 is taken for the code page of Windows (1252).
    std::uint32_t add(std::string name, std::filesystem::path folder, std::string text);
    std::uint32_t add_route(const RouteStep& step);

    [[nodiscard]] const SourceFile& file(std::uint32_t index) const { return files_[index]; }
    [[nodiscard]] const RouteStep& route(std::uint32_t index) const { return routes_[index]; }
    [[nodiscard]] LineColumn line_column(std::uint32_t file, std::uint32_t offset) const;
    [[nodiscard]] std::string_view line(std::uint32_t file, int line) const;
    /// "ring.spar:2"
    [[nodiscard]] std::string file_and_line(const Place& place) const;

    struct Found {
        std::optional<std::filesystem::path> path;  ///< the real path of a readable file
        bool forbidden = false;                     ///< there may be one, but out of bounds
    };
    /// Looks for a file named in the scene: beside the file that names it, beside the scene, then
    /// in the allowed folders.
    [[nodiscard]] Found find(std::string_view name, const std::filesystem::path& beside) const;

    /// The whole file; nothing when it cannot be read or is larger than the bound.
    [[nodiscard]] static std::optional<std::string> read(const std::filesystem::path& path);

private:
    [[nodiscard]] bool inside(const std::filesystem::path& real_path) const;

    std::deque<SourceFile> files_;
    std::vector<RouteStep> routes_{RouteStep{}};
    std::vector<std::filesystem::path> roots_;
};

/// An include that is compiled into the program; nothing when there is none of this name.
[[nodiscard]] std::optional<std::string_view> library_file(std::string_view name);
/// The one that declares this name, or nothing.
[[nodiscard]] std::optional<std::string_view> library_file_with(std::string_view name);
/// "colors.inc, shapes.inc"
[[nodiscard]] std::vector<std::string_view> library_names();
/// What the library declares, and where.
struct LibraryName {
    std::string_view name, file;
};
[[nodiscard]] const std::vector<LibraryName>& library_declarations();

}  // namespace icespar
