// Triangles from files: Wavefront .obj, Stanford .ply and .stl, in text or binary.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec3.hpp"

namespace icespar {

struct MeshFile {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< faces of more corners as fans
};

/// By the file's ending. Throws Error with the file's name, and the line where there are lines.
[[nodiscard]] MeshFile read_mesh_file(const std::string& path);
/// The same from memory; `name` serves its ending, and messages.
[[nodiscard]] MeshFile read_mesh(const std::string& name, std::string_view bytes);

}  // namespace icespar
