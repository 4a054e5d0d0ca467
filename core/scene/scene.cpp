// The last look at a scene before light enters it.
#include "scene/scene.hpp"

#include <cmath>
#include <utility>

namespace icespar {
namespace {

bool inside(const Stone& stone, const Vec3& point) {
    for (const Facet& f : stone.facets) {
        if (dot(f.normal, point) >= f.distance) return false;
    }
    return !stone.facets.empty();
}

/// Points of a thing's surface: poles, corners, or points of rims; none of a plane's.
std::vector<Vec3> outermost_points(const Thing& thing) {
    std::vector<Vec3> out;
    const auto add = [&](const Vec3& p) { out.push_back(thing.to_world.point(p)); };
    const auto add_rim = [&](double radius, double y) {
        for (const double side : {-radius, radius}) {
            add({side, y, 0});
            add({0, y, side});
        }
    };
    if (const auto* mesh = std::get_if<MeshShape>(&thing.shape)) {
        for (const Vec3& v : mesh->mesh->vertices) add(v);
    } else if (const auto* cone = std::get_if<ConeShape>(&thing.shape)) {
        add_rim(1, 0);
        add_rim(cone->top, 1);
    } else if (std::holds_alternative<DiscShape>(thing.shape)) {
        add_rim(1, 0);
    } else if (std::holds_alternative<SphereShape>(thing.shape)) {
        add_rim(1, 0);
        add({0, 1, 0});
        add({0, -1, 0});
    } else if (!std::holds_alternative<PlaneShape>(thing.shape)) {
        const bool flat = std::holds_alternative<SquareShape>(thing.shape);
        for (int i = 0; i < (flat ? 4 : 8); ++i) {
            add({i & 1 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0});
        }
    }
    return out;
}

void check_crystal(const Crystal& c, const std::string& name, std::vector<std::string>& out) {
    if (c.indices.empty() || c.indices.size() > 3) {
        out.push_back(name +
                      ": a stone needs one index (isotropic), two (uniaxial) or three (biaxial)");
    }
    for (const IndexFunction& n : c.indices) {
        if (!n.valid()) {
            out.push_back(name +
                          ": a refractive index is below 1 or not finite between 380 and 780 nm");
        }
    }
    if (!(std::abs(length(c.axis) - 1) < 1e-6)) {
        out.push_back(name + ": the optic axis is not a unit vector");
    }
    if (c.indices.size() == 3 && (!(std::abs(length(c.third_axis) - 1) < 1e-6) ||
                                  !(std::abs(dot(c.axis, c.third_axis)) < 1e-6))) {
        out.push_back(name + ": the principal axes are not perpendicular unit vectors");
    }
    if (!c.absorption.empty() && c.absorption.size() != c.indices.size()) {
        out.push_back(name + ": absorption needs one spectrum for each refractive index");
    }
    for (const Spectrum& a : c.absorption) {
        if (!(a.least() >= 0)) out.push_back(name + ": absorption is below 0");
    }
    if (c.fade && (!(c.fade->distance > 0) || !(c.fade->power >= 0) ||
                   !(c.fade->colour.least() >= 0) || !(c.fade->colour.greatest() <= 1))) {
        out.push_back(name +
                      ": attenuation needs a distance above 0, a power of at least 0 and a "
                      "colour between 0 and 1");
    }
    if (c.indices.size() != 2 && (c.rotation.least() != 0 || c.rotation.greatest() != 0)) {
        out.push_back(name + ": optical activity is known for uniaxial stones only");
    }
}

/// Whether part of a sheet lies within a stone: what the stone's planes leave of it has an area.
bool cuts(const Thing& sheet, const Stone& stone) {
    std::vector<Vec3> polygon;
    for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 1}, Vec3{0, 0, 1}}) {
        polygon.push_back(sheet.to_world.point(corner));
    }
    const double size = length(polygon[2] - polygon[0]);
    for (const Facet& f : stone.facets) {
        std::vector<Vec3> left;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double p = f.distance - dot(f.normal, a) - 1e-9 * size;
            const double q = f.distance - dot(f.normal, b) - 1e-9 * size;
            if (p > 0) left.push_back(a);
            if ((p > 0) != (q > 0)) left.push_back(a + (p / (p - q)) * (b - a));
        }
        polygon = std::move(left);
        if (polygon.size() < 3) return false;
    }
    return true;
}

void check_gem(const Gem& gem, std::vector<std::string>& out) {
    if (gem.stone.facets.size() < 4) out.push_back(gem.name + ": this stone is not closed");
    for (const Facet& f : gem.stone.facets) {
        if (!is_finite(f.normal) || !std::isfinite(f.distance)) {
            out.push_back(gem.name + ": facet '" + f.name + "' is not finite");
        }
    }
    check_crystal(gem.crystal, gem.name, out);
}

}  // namespace

Stokes formula_light(const Environment& environment, const Vec3& direction) {
    const auto& f = environment.formulas;
    const Vec3 d = normalised(environment.to_own.vector(direction));
    const double radiance = f[0](d);
    if (!(radiance > 0 && std::isfinite(radiance))) return {};
    if (f.size() < 4) return {radiance, 0, 0, 0};
    Stokes light{radiance, f[1](d), f[2](d), f[3](d)};
    const double polarised = std::hypot(light.s1, light.s2, light.s3);
    if (!std::isfinite(polarised)) return {};
    if (polarised > radiance) {
        const double less = radiance / polarised;
        light = {radiance, less * light.s1, less * light.s2, less * light.s3};
    }
    return light;
}

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
    if (c.kind != Camera::Kind::orthographic && gem != nullptr) {
        out.push_back(gem->name + ": the camera is inside this stone; move it out");
    }
    return out;
}

std::vector<std::string> faults(const Scene& scene) {
    std::vector<std::string> out;
    for (const Disc& disc : scene.environment.discs) {
        constexpr double rounding = 1e-9;
        if (!(std::abs(length(disc.direction) - 1) < rounding) || !std::isfinite(disc.cos_radius)) {
            out.push_back("environment: a disc's direction must be a unit vector, its size finite");
        }
    }
    // Inside a stone only facets are met: what stands there would be passed over in silence.
    for (const Light& light : scene.lights) {
        if (const Gem* gem = gem_around(scene, light.position)) {
            out.push_back(gem->name + ": a light source is inside this stone; move it out");
        }
    }
    for (const Thing& thing : scene.things) {
        if (thing.filter) {
            for (const Gem& gem : scene.gems) {
                if (!cuts(thing, gem.stone)) continue;
                out.push_back(gem.name + ": a sheet runs through this stone; move it out");
            }
            continue;
        }
        for (const Vec3& point : outermost_points(thing)) {
            if (const Gem* gem = gem_around(scene, point)) {
                out.push_back(gem->name + ": an opaque object is inside this stone; move it out");
                break;
            }
        }
    }
    for (std::size_t i = 0; i < scene.gems.size(); ++i) {
        const Gem& gem = scene.gems[i];
        check_gem(gem, out);
        for (std::size_t j = i + 1; j < scene.gems.size(); ++j) {
            Vec3 where;
            if (overlap(gem.stone, scene.gems[j].stone, where)) {
                out.push_back(gem.name + ": this stone overlaps the one at " + scene.gems[j].name +
                              "; move them apart");
            }
        }
    }
    return out;
}

}  // namespace icespar
