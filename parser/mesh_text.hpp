// What the readers of triangle files share: lines of words, numbers, and faults with their line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/mesh_file.hpp"

namespace icespar {

class MeshText {
public:
    MeshText(const std::string& name, std::string_view bytes) : name_(name), bytes_(bytes) {}

    /// On to the next line; false at the end.
    bool next_line();
    [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
    /// What follows the line.
    [[nodiscard]] std::string_view rest() const { return bytes_.substr(at_); }
    [[nodiscard]] double number(std::string_view word) const;
    [[noreturn]] void fault(const std::string& what) const;

private:
    const std::string& name_;
    std::string_view bytes_;
    std::vector<std::string_view> words_;
    std::size_t at_ = 0;
    int line_ = 0;
};

/// Triangles of a polygon about its first corner.
void add_fan(MeshFile& mesh, const std::vector<std::uint32_t>& corners);

[[nodiscard]] MeshFile read_ply(const std::string& name, std::string_view bytes);

}  // namespace icespar
