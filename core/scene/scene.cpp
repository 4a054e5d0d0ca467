// The last look at a scene before light enters it.
#include "scene/scene.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <limits>

namespace icespar {
namespace {

namespace geometry = boost::geometry;
using Corner = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Bounds = geometry::model::box<Corner>;
using Tree = geometry::index::rtree<std::pair<Bounds, std::size_t>, geometry::index::rstar<16>>;

constexpr std::size_t enough_faults = 20;
constexpr std::size_t most_pairs = 2'000'000;  ///< of stones whose bounds meet

Bounds bounds_of(const Stone& stone) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 low{far, far, far}, high = -low;
    for (const Vec3& v : stone.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return {Corner(low.x, low.y, low.z), Corner(high.x, high.y, high.z)};
}

/// The stones by place, so that a scene of very many is searched in short time.
class Gems {
public:
    explicit Gems(const Scene& scene) : scene_(scene) {
        std::vector<std::pair<Bounds, std::size_t>> boxes;
        for (std::size_t i = 0; i < scene.gems.size(); ++i) {
            if (!scene.gems[i].stone.vertices.empty())
                boxes.emplace_back(bounds_of(scene.gems[i].stone), i);
        }
        tree_ = Tree(boxes);
    }
    /// The gem that holds the point in its interior.
    [[nodiscard]] std::optional<std::size_t> around(const Vec3& point) const;
    /// Calls found(i) for every gem whose bounds meet those of the stone, until it returns false.
    template <class F>
    void near(const Stone& stone, F&& found) const {
        const auto end = tree_.qend();
        for (auto i = tree_.qbegin(geometry::index::intersects(bounds_of(stone))); i != end; ++i) {
            if (!found(i->second)) return;
        }
    }

private:
    const Scene& scene_;
    Tree tree_;
};

bool inside(const Stone& stone, const Vec3& point) {
    for (const Facet& f : stone.facets) {
        if (dot(f.normal, point) >= f.distance) return false;
    }
    return !stone.facets.empty();
}

std::optional<std::size_t> Gems::around(const Vec3& point) const {
    const Corner corner(point.x, point.y, point.z);
    const auto end = tree_.qend();
    for (auto i = tree_.qbegin(geometry::index::intersects(corner)); i != end; ++i) {
        if (inside(scene_.gems[i->second].stone, point)) return i->second;
    }
    return std::nullopt;
}

/// Points of a thing's surface: a sphere's six poles, a box's corners; none of a plane's.
std::vector<Vec3> outermost_points(const Thing& thing) {
    std::vector<Vec3> out;
    if (std::holds_alternative<PlaneShape>(thing.shape)) return out;
    const bool sphere = std::holds_alternative<SphereShape>(thing.shape);
    for (int i = 0; i < (sphere ? 6 : 8); ++i) {
        const double sign = i % 2 == 0 ? 1 : -1;
        const Vec3 pole = i < 2 ? Vec3{sign, 0, 0} : i < 4 ? Vec3{0, sign, 0} : Vec3{0, 0, sign};
        const Vec3 corner{i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0};
        out.push_back(thing.to_world.point(sphere ? pole : corner));
    }
    return out;
}

template <class Add>
void check_crystal(const Crystal& c, Add&& add) {
    if (c.indices.empty() || c.indices.size() > 3) {
        add("a stone needs one index (isotropic), two (uniaxial) or three (biaxial)");
    }
    for (const IndexFunction& n : c.indices) {
        if (!n.valid()) {
            add("a refractive index is below 1 or not finite between 380 and 780 nm");
        }
    }
    if (!(std::abs(length(c.axis) - 1) < 1e-6)) {
        add("the optic axis is not a unit vector");
    }
    if (c.indices.size() == 3 && (!(std::abs(length(c.third_axis) - 1) < 1e-6) ||
                                  !(std::abs(dot(c.axis, c.third_axis)) < 1e-6))) {
        add("the principal axes are not perpendicular unit vectors");
    }
    if (!c.absorption.empty() && c.absorption.size() != c.indices.size()) {
        add("absorption needs one spectrum for each refractive index");
    }
    for (const Spectrum& a : c.absorption) {
        if (!(a.least() >= 0)) add("absorption is below 0");
    }
    if (c.fade && (!(c.fade->distance > 0) || !(c.fade->power >= 0) ||
                   !(c.fade->colour.least() >= 0) || !(c.fade->colour.greatest() <= 1))) {
        add("attenuation needs a distance above 0, a power of at least 0 and a "
            "colour between 0 and 1");
    }
    if (c.indices.size() != 2 && (c.rotation.least() != 0 || c.rotation.greatest() != 0)) {
        add("optical activity is known for uniaxial stones only");
    }
}

/// What is wrong with one gem by itself.
void check_gem(const Gem& gem, std::size_t number, std::vector<SceneFault>& out) {
    const auto add = [&](std::string message) { out.push_back({number, std::move(message)}); };

    if (gem.stone.facets.size() < 4) add("this stone is not closed");
    for (const Facet& f : gem.stone.facets) {
        if (!is_finite(f.normal) || !std::isfinite(f.distance)) {
            add("facet '" + f.name + "' is not finite");
        }
    }
    check_crystal(gem.crystal, add);
}

}  // namespace

const Gem* gem_around(const Scene& scene, const Vec3& point) {
    for (const Gem& gem : scene.gems) {
        if (inside(gem.stone, point)) return &gem;
    }
    return nullptr;
}

std::vector<std::string> camera_faults(const Scene& scene) {
    std::vector<std::string> out;
    const Camera& c = scene.camera;
    if (!is_finite(c.location) || !is_finite(c.direction) || !is_finite(c.right) ||
        !is_finite(c.up) || !(std::abs(dot(c.direction, cross(c.right, c.up))) > 0)) {
        out.push_back("camera: direction, right and up must be finite and not in one plane");
    }
    const Gem* gem = gem_around(scene, c.location);
    if (c.kind == Camera::Kind::perspective && gem != nullptr) {
        out.push_back("the camera is inside the stone at " + gem->name + "; move it out");
    }
    return out;
}

std::vector<SceneFault> scene_faults(const Scene& scene) {
    std::vector<SceneFault> out;
    const Gems gems(scene);
    const auto enough = [&] { return out.size() >= enough_faults; };
    for (const Disc& disc : scene.environment.discs) {
        constexpr double rounding = 1e-9;
        if (!(std::abs(length(disc.direction) - 1) < rounding) || !std::isfinite(disc.cos_radius)) {
            out.push_back(
                {std::nullopt, "a disc's direction must be a unit vector, its size finite"});
        }
    }
    // Inside a stone only facets are met: what stands there would be passed over in silence.
    for (const Light& light : scene.lights) {
        if (const auto gem = gems.around(light.position); gem && !enough()) {
            out.push_back({*gem, "a light source is inside this stone; move it out"});
        }
    }
    for (const Thing& thing : scene.things) {
        for (const Vec3& point : outermost_points(thing)) {
            if (const auto gem = gems.around(point); gem && !enough()) {
                out.push_back({*gem, "an opaque object is inside this stone; move it out"});
                break;
            }
        }
    }
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < scene.gems.size() && !enough(); ++i) {
        const Gem& gem = scene.gems[i];
        check_gem(gem, i, out);
        if (gem.stone.vertices.empty()) continue;
        std::vector<std::size_t> others;
        gems.near(gem.stone, [&](std::size_t j) {
            if (j > i && ++pairs <= most_pairs) others.push_back(j);
            return pairs <= most_pairs;
        });
        std::sort(others.begin(), others.end());
        for (const std::size_t j : others) {
            Vec3 where;
            if (!enough() && overlap(gem.stone, scene.gems[j].stone, where)) {
                out.push_back({i, "this stone overlaps the one at " + scene.gems[j].name +
                                      "; move them apart"});
            }
        }
        if (pairs > most_pairs) {
            out.push_back(
                {i, "too many stones stand as close as this one to be compared: the bound is " +
                        std::to_string(most_pairs) + " pairs"});
            break;
        }
    }
    return out;
}

std::vector<std::string> faults(const Scene& scene) {
    std::vector<std::string> out;
    for (const SceneFault& fault : scene_faults(scene)) {
        out.push_back((fault.gem ? scene.gems[*fault.gem].name : "environment") + ": " +
                      fault.message);
    }
    return out;
}

}  // namespace icespar
