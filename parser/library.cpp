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

std::optional<std::string_view> library_file_with(std::string_view name) {
    for (const auto& [file, text] : library_files) {
        for (const std::string_view directive : {"#declare ", "#macro "}) {
            const std::string start = std::string(directive) + std::string(name);
            const std::size_t at = text.find(start);
            if (at == std::string_view::npos || at + start.size() >= text.size()) continue;
            if (std::string_view(" =(\t").find(text[at + start.size()]) != std::string_view::npos) {
                return file;
            }
        }
    }
    return std::nullopt;
}

std::vector<std::string_view> library_names() {
    std::vector<std::string_view> names;
    for (const auto& [file, text] : library_files) names.push_back(file);
    return names;
}

}  // namespace icespar
