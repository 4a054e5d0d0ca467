// The includes that are compiled into the program.
#include <algorithm>
#include <span>
#include <utility>

#include "parser/source.hpp"

namespace icespar {

/// Made by CMake from scenes/include: names and texts.
extern const std::span<const std::pair<std::string_view, std::string_view>> library_files;

std::optional<std::string_view> library_file(std::string_view name) {
    for (const auto& [file, text] : library_files) {
        if (file == name) return text;
    }
    return std::nullopt;
}

std::vector<std::string_view> library_names() {
    std::vector<std::string_view> names;
    for (const auto& [file, text] : library_files) names.push_back(file);
    return names;
}

std::vector<LibraryName> library_declarations() {
    std::vector<LibraryName> names;
    for (const auto& [file, text] : library_files) {
        for (const std::string_view directive : {"#declare ", "#macro "}) {
            for (std::size_t at = 0; (at = text.find(directive, at)) != std::string_view::npos;) {
                at += directive.size();
                const std::size_t end = std::min(text.find_first_of(" =([\n", at), text.size());
                names.push_back({text.substr(at, end - at), file});
            }
        }
    }
    return names;
}

}  // namespace icespar
