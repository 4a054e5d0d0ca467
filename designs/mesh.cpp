// The finished stone of a design, and its export as triangles (.stl) and polygons (.obj).
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "designs/solved.hpp"
#include "designs/text.hpp"

namespace icespar {

SolvedDesign::SolvedDesign(const Design& design)
    : planes(design.planes()), stone(Stone::from_planes(planes)), facet_of(planes.size(), -1) {
    // Facets stand in the order of the planes they came from.
    std::size_t facet = 0;
    for (std::size_t i = 0; i < planes.size() && facet < stone.facets.size(); ++i) {
        const Facet& f = stone.facets[facet];
        const double distance = planes[i].distance;
        if (length(f.normal - planes[i].normal) < 1e-8 &&
            std::abs(f.distance - distance) <= 1e-8 * std::abs(distance) + 1e-15) {
            facet_of[i] = static_cast<int>(facet++);
        }
    }
}

std::vector<Vec3> SolvedDesign::polygon(std::size_t plane) const {
    std::vector<Vec3> out;
    if (facet_of[plane] < 0) return out;
    for (const std::uint32_t corner :
         stone.facets[static_cast<std::size_t>(facet_of[plane])].corners)
        out.push_back(stone.vertices[corner]);
    return out;
}

std::string stl_bytes(const Stone& stone) {
    std::string out(80, ' ');
    const std::string title = "binary STL: a faceted stone, millimetres or design units, z up";
    out.replace(0, title.size(), title);
    std::uint32_t count = 0;
    std::string triangles;
    const auto put = [&](const Vec3& v) {
        for (const double c : {v.x, v.y, v.z}) {
            const auto value = static_cast<float>(c);
            std::array<char, sizeof value> raw;
            std::memcpy(raw.data(), &value, sizeof value);
            triangles.append(raw.data(), raw.size());
        }
    };
    for (const Facet& facet : stone.facets) {
        for (std::size_t i = 2; i < facet.corners.size(); ++i) {
            put(facet.normal);
            for (const std::size_t corner : {std::size_t{0}, i - 1, i})
                put(stone.vertices[facet.corners[corner]]);
            triangles.append(2, '\0');
            ++count;
        }
    }
    std::array<char, sizeof count> raw;
    std::memcpy(raw.data(), &count, sizeof count);
    return out.append(raw.data(), raw.size()) + triangles;
}

std::string obj_text(const Stone& stone, const std::string& title) {
    std::string out = "# " + one_word(title) + ": one polygon a facet, z up\n";
    for (const Vec3& v : stone.vertices)
        out += "v " + exact(v.x) + " " + exact(v.y) + " " + exact(v.z) + "\n";
    for (const Facet& facet : stone.facets) {
        if (!facet.name.empty()) out += "g " + one_word(facet.name) + "\n";
        out += "f";
        for (const std::uint32_t corner : facet.corners) out += " " + std::to_string(corner + 1);
        out += "\n";
    }
    return out;
}

}  // namespace icespar
