// Meshes: triangles one by one, mesh2's lists of vertices and faces, and files of triangles.
#include <cmath>
#include <unordered_map>

#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/limits.hpp"
#include "parser/mesh_file.hpp"

namespace icespar {
namespace {

/// Corners at one place are one vertex.
class Welder {
public:
    explicit Welder(TriangleMesh& mesh) : mesh_(mesh) {}

    std::uint32_t vertex(const Vec3& v) {
        // 0 and -0 are the same place.
        const std::array<double, 3> key{v.x + 0.0, v.y + 0.0, v.z + 0.0};
        const auto [at, is_new] =
            known_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back(v);
        return at->second;
    }
    /// One without area is left out.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto& v = mesh_.vertices;
        const Vec3 area = cross(v[b] - v[a], v[c] - v[a]);
        if (a != b && b != c && c != a && area != Vec3{}) mesh_.triangles.push_back({a, b, c});
    }

private:
    struct Hash {
        std::size_t operator()(const std::array<double, 3>& p) const {
            std::size_t h = 0;
            for (const double c : p) h = h * 0x9e3779b97f4a7c15 + std::hash<double>{}(c);
            return h ^ (h >> 29);
        }
    };
    TriangleMesh& mesh_;
    std::unordered_map<std::array<double, 3>, std::uint32_t, Hash> known_;
};

void bounded(std::size_t triangles, const Place& place) {
    if (triangles > limits::mesh_triangles) {
        throw Fault{place,
                    "a mesh of more than " + std::to_string(limits::mesh_triangles) +
                        " triangles, the bound",
                    {}};
    }
}

/// `vertex_vectors { N, <...>, ... }`: what stands after the count, which must be right.
void check_count(double said, std::size_t found, const Block& block, std::string_view what) {
    if (said == static_cast<double>(found)) return;
    throw Fault{block.place,
                "'" + std::string(block.word) + "' has " + std::to_string(found) + " " +
                    std::string(what) + ", but says " +
                    std::to_string(static_cast<long long>(said)),
                {}};
}

std::vector<Vec3> vertex_vectors(const Block& block) {
    Cursor cursor(block);
    const double count = cursor.number("the number of vertices", 0, 1e9);
    std::vector<Vec3> out;
    while (cursor.more()) out.push_back(cursor.vector("a vertex"));
    check_count(count, out.size(), block, "vertices");
    return out;
}

void face_indices(const Block& block, const std::vector<Vec3>& vertices, Welder& welder) {
    Cursor cursor(block);
    const double count = cursor.number("the number of faces", 0, 1e9);
    bounded(static_cast<std::size_t>(count), block.place);
    std::size_t faces = 0;
    while (cursor.more()) {
        const Vec3 face = cursor.vector("three numbers of vertices");
        std::array<std::uint32_t, 3> corners{};
        const double numbers[3] = {face.x, face.y, face.z};
        for (std::size_t i = 0; i < 3; ++i) {
            if (!(numbers[i] >= 0 && numbers[i] < static_cast<double>(vertices.size()) &&
                  numbers[i] == std::floor(numbers[i]))) {
                throw Fault{cursor.place(),
                            "there is no such vertex: they are counted from 0 to " +
                                std::to_string(vertices.size() - 1),
                            {}};
            }
            corners[i] = welder.vertex(vertices[static_cast<std::size_t>(numbers[i])]);
        }
        welder.triangle(corners[0], corners[1], corners[2]);
        ++faces;
    }
    check_count(count, faces, block, "faces");
}

void flat_triangle(const Block& block, Welder& welder) {
    const bool smooth = block.word == "smooth_triangle";
    Cursor cursor(block);
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
        corner = welder.vertex(cursor.vector("a corner"));
        if (smooth) (void)cursor.vector("a normal");
    }
    if (cursor.more()) {
        throw Fault{
            cursor.peek().place, "a triangle of a mesh has three corners and nothing else", {}};
    }
    welder.triangle(corners[0], corners[1], corners[2]);
}

}  // namespace

void Builder::warn_of_normals(const Place& place) {
    diagnostics_.warning(place, "triangles are seen flat: normals at their corners are left out",
                         {}, "normals of triangles");
}

std::shared_ptr<const TriangleMesh> Builder::mesh(const Block& block) {
    auto mesh = std::make_shared<TriangleMesh>();
    Welder welder(*mesh);
    std::vector<Vec3> vertices;
    bool listed = false;
    for (const Item& item : block.items) {
        step(item.place);
        if (item.kind == Item::Kind::value && item.value.empty()) throw Poisoned{item.place};
        if (item.kind == Item::Kind::value && item.value.text()) {
            const std::string& file = *item.value.text();
            try {
                const MeshFile read = read_mesh_file(file_named(file, item.place));
                std::vector<std::uint32_t> numbers;
                for (const Vec3& v : read.vertices) numbers.push_back(welder.vertex(v));
                for (const auto& [a, b, c] : read.triangles) {
                    welder.triangle(numbers[a], numbers[b], numbers[c]);
                }
            } catch (const Error& error) {
                throw Fault{item.place, error.what(), {}};
            }
        }
        if (item.kind != Item::Kind::block) continue;
        const Block& inner = *item.block;
        if (inner.broken) throw Poisoned{inner.place};
        if (item.word == "triangle" || item.word == "smooth_triangle") {
            if (item.word == "smooth_triangle") warn_of_normals(item.place);
            flat_triangle(inner, welder);
        } else if (item.word == "vertex_vectors") {
            vertices = vertex_vectors(inner);
            listed = true;
        } else if (item.word == "face_indices") {
            if (!listed) {
                throw Fault{item.place, "'face_indices' stands before 'vertex_vectors'", {}};
            }
            face_indices(inner, vertices, welder);
        } else if (item.word == "normal_vectors") {
            warn_of_normals(item.place);
        }
        bounded(mesh->triangles.size(), item.place);
    }
    if (mesh->triangles.empty()) {
        throw Fault{
            block.place, "this mesh has no triangles with an area",
            "write mesh { triangle { <...>, <...>, <...> } ... }, or mesh { \"ring.obj\" }"};
    }
    return mesh;
}

}  // namespace icespar
