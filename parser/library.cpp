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

const std::vector<LibraryName>& library_declarations() {
    static const std::vector<LibraryName> all = [] {
        std::vector<LibraryName> names;
        for (const auto& [file, text] : library_files) {
            for (const std::string_view directive : {"#declare ", "#macro "}) {
                for (std::size_t at = 0;
                     (at = text.find(directive, at)) != std::string_view::npos;) {
                    at += directive.size();
                    const std::size_t end = std::min(text.find_first_of(" =([\n", at), text.size());
                    names.push_back({text.substr(at, end - at), file});
                }
            }
        }
        return names;
    }();
    return all;
}

}  // namespace icespar
