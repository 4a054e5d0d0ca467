// Readers of .obj and .stl. Our own, since files come from strangers: every count is bounded by
// what is there, and a fault has its line.
#include "parser/mesh_file.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "math/error.hpp"
#include "parser/mesh_text.hpp"
#include "parser/source.hpp"

namespace icespar {

void add_fan(MeshFile& mesh, const std::vector<std::uint32_t>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
}

namespace {

/// "3", "3/1", "3//2"; negative numbers count back from the last vertex.
std::uint32_t obj_corner(std::string_view word, const MeshFile& mesh, const MeshText& text) {
    const double number = text.number(word.substr(0, word.find('/')));
    const auto count = static_cast<double>(mesh.vertices.size());
    const double index = number < 0 ? count + number : number - 1;
    if (!(index >= 0 && index < count && index == std::floor(index))) {
        text.fault("a face has the vertex " + std::string(word) + ", and there are " +
                   std::to_string(mesh.vertices.size()) + " before it");
    }
    return static_cast<std::uint32_t>(index);
}

MeshFile read_obj(const std::string& name, std::string_view bytes) {
    MeshFile mesh;
    MeshText text(name, bytes);
    while (text.next_line()) {
        const auto& words = text.words();
        if (words.empty() || words[0][0] == '#') continue;
        if (words[0] == "v") {
            if (words.size() < 4) text.fault("a vertex has three coordinates");
            mesh.vertices.push_back(
                {text.number(words[1]), text.number(words[2]), text.number(words[3])});
        } else if (words[0] == "f") {
            if (words.size() < 4) text.fault("a face has three corners or more");
            std::vector<std::uint32_t> corners;
            for (std::size_t i = 1; i < words.size(); ++i) {
                corners.push_back(obj_corner(words[i], mesh, text));
            }
            add_fan(mesh, corners);
        }
    }
    return mesh;
}

MeshFile read_text_stl(const std::string& name, std::string_view bytes) {
    MeshFile mesh;
    MeshText text(name, bytes);
    std::vector<std::uint32_t> corners;
    while (text.next_line()) {
        const auto& words = text.words();
        if (words.empty()) continue;
        if (words[0] == "vertex") {
            if (words.size() != 4) text.fault("a vertex has three coordinates");
            corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(
                {text.number(words[1]), text.number(words[2]), text.number(words[3])});
        } else if (words[0] == "endloop") {
            if (corners.size() < 3) text.fault("a face has three corners or more");
            add_fan(mesh, corners);
            corners.clear();
        }
    }
    return mesh;
}

constexpr std::size_t stl_header = 84, stl_facet = 50;

std::size_t stl_facets(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    return count;
}

MeshFile read_binary_stl(std::string_view bytes) {
    MeshFile mesh;
    const std::size_t count = stl_facets(bytes);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 9> c{};
        std::memcpy(c.data(), bytes.data() + stl_header + i * stl_facet + 12, sizeof c);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t k = 0; k < 9; k += 3) mesh.vertices.push_back({c[k], c[k + 1], c[k + 2]});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

MeshFile read_stl(const std::string& name, std::string_view bytes) {
    static_assert(std::endian::native == std::endian::little);
    // Some binary files start with "solid" too: their size tells them apart.
    const bool binary =
        bytes.size() >= stl_header && bytes.size() == stl_header + stl_facets(bytes) * stl_facet;
    if (binary) return read_binary_stl(bytes);
    if (bytes.substr(0, 5) != "solid") {
        throw Error("'" + name +
                    "' is no STL file: neither 'solid' stands first, nor is it as long as its "
                    "number of facets says");
    }
    return read_text_stl(name, bytes);
}

}  // namespace

MeshFile read_mesh(const std::string& name, std::string_view bytes) {
    std::string ending = std::filesystem::path(name).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    MeshFile mesh;
    if (ending == ".obj") {
        mesh = read_obj(name, bytes);
    } else if (ending == ".stl") {
        mesh = read_stl(name, bytes);
    } else if (ending == ".ply") {
        mesh = read_ply(name, bytes);
    } else {
        throw Error("'" + name + "' is neither .obj, .ply nor .stl");
    }
    for (const Vec3& v : mesh.vertices) {
        if (!(std::abs(v.x) < 1e30 && std::abs(v.y) < 1e30 && std::abs(v.z) < 1e30)) {
            throw Error("'" + name +
                        "' has a vertex that is not finite, or farther away than 1e30");
        }
    }
    if (mesh.triangles.empty()) throw Error("'" + name + "' has no triangles");
    return mesh;
}

MeshFile read_mesh_file(const std::string& path) {
    const auto bytes = Sources::read(path);
    const std::string name = std::filesystem::path(path).filename().string();
    if (!bytes) throw Error("'" + name + "' cannot be read, or is larger than 64 MiB");
    return read_mesh(name, *bytes);
}

}  // namespace icespar
