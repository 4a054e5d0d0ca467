// Finding stones by their bounds.
#include "scene/nearby.hpp"

#include <algorithm>

namespace icespar {

NearbyGems::NearbyGems(const Scene& scene) : scene_(scene) {
    std::vector<std::pair<Bounds, std::size_t>> boxes;
    for (std::size_t i = 0; i < scene.gems.size(); ++i) {
        const std::vector<Vec3>& vertices = scene.gems[i].stone.vertices;
        if (!vertices.empty()) boxes.emplace_back(bounds_of(vertices), i);
    }
    tree_ = decltype(tree_)(boxes);
}

NearbyGems::Bounds NearbyGems::bounds_of(const std::vector<Vec3>& points) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 low{far, far, far}, high = -low;
    for (const Vec3& v : points) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return {Corner(low.x, low.y, low.z), Corner(high.x, high.y, high.z)};
}

std::optional<std::size_t> NearbyGems::around(const Vec3& point) const {
    const Corner corner(point.x, point.y, point.z);
    const auto end = tree_.qend();
    for (auto i = tree_.qbegin(boost::geometry::index::intersects(corner)); i != end; ++i) {
        if (inside(scene_.gems[i->second].stone, point)) return i->second;
    }
    return std::nullopt;
}

bool inside(const Stone& stone, const Vec3& point) {
    for (const Facet& f : stone.facets) {
        if (dot(f.normal, point) >= f.distance) return false;
    }
    return !stone.facets.empty();
}

}  // namespace icespar
