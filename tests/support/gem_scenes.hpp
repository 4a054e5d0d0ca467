// Scenes for the tests of light in stones: a stone or a few, built without the scene language.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "designs/design.hpp"
#include "render/render.hpp"
#include "scene/scene.hpp"
#include "support/solids.hpp"

namespace icespar::testing {

inline constexpr double degree = std::numbers::pi / 180;

inline Stone cube_stone() { return Stone::from_points(cube()); }

/// A cleavage rhomb of calcite, edge 1: the obtuse angle of its faces is 101.92 degrees, and three
/// of them meet on the axis z at either blunt corner.
inline Stone rhomb_stone() {
    const double obtuse = 101.92 * degree;
    // Edges at polar angle t: their mutual angle is obtuse, cos = cos^2 t + sin^2 t cos 120.
    const double cos2 = (std::cos(obtuse) + 0.5) / 1.5;
    std::vector<Vec3> edges, points;
    for (int i = 0; i < 3; ++i) {
        const double turn = 2 * std::numbers::pi / 3 * i;
        edges.push_back({std::sqrt(1 - cos2) * std::cos(turn), std::sqrt(1 - cos2) * std::sin(turn),
                         std::sqrt(cos2)});
    }
    const Vec3 half = 0.5 * (edges[0] + edges[1] + edges[2]);
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p = -half;
        for (int i = 0; i < 3; ++i) {
            if ((corner >> i & 1) != 0) p += edges[static_cast<std::size_t>(i)];
        }
        points.push_back(p);
    }
    return Stone::from_points(points);
}

/// Round brilliant of girdle radius 1, table along +z.
inline Stone brilliant_stone() {
    return Stone::from_planes(
        read_design(ICESPAR_SCENES_DIR "/designs/srb_tolkowsky_diamond.asc").planes());
}

inline Stone box_stone(const Vec3& low, const Vec3& high) {
    return Stone::from_planes(box_planes(low, high));
}

inline Crystal glass(double n) { return {{IndexFunction(n)}, {0, 0, 1}}; }
inline Crystal uniaxial(double n_o, double n_e, const Vec3& axis) {
    return {{IndexFunction(n_o), IndexFunction(n_e)}, axis};
}
inline Crystal calcite(const Vec3& axis) { return uniaxial(1.6584, 1.4864, axis); }
inline Crystal zircon(const Vec3& axis) { return uniaxial(1.925, 1.984, axis); }
inline Crystal quartz(const Vec3& axis) { return uniaxial(1.5443, 1.5534, axis); }

/// A biaxial crystal with principal axes in a random attitude.
inline Crystal biaxial(double a, double b, double c, Random& random) {
    Crystal crystal{{IndexFunction(a), IndexFunction(b), IndexFunction(c)}, random.direction()};
    crystal.third_axis = random.perpendicular_to(crystal.axis);
    return crystal;
}
inline Crystal topaz(Random& random) { return biaxial(1.619, 1.621, 1.627, random); }
inline Crystal sphene(Random& random) { return biaxial(1.9, 1.907, 2.034, random); }
/// Quartz that turns light along its axis.
inline Crystal active_quartz(const Vec3& axis, double degrees_per_mm = 21.75) {
    Crystal crystal = quartz(axis);
    crystal.rotation = Spectrum(degrees_per_mm);
    return crystal;
}

/// The same radiance from everywhere: the D65 of value 1.
inline Environment furnace() {
    Environment e;
    e.below = e.above = Spectrum(1.0);
    return e;
}

/// Radiance (1 + height) / 2, from 0 at the foot of `up` to 1 at its head.
inline Environment slope(const Vec3& up) {
    Environment e;
    e.above = Spectrum(1.0);
    e.up = up;
    return e;
}

/// A panorama of a scene, seen from inside: one number a pixel, rows from the top.
inline Pigment panorama(int width, int height, const std::vector<float>& grey) {
    auto picture = std::make_shared<Picture>();
    picture->width = width;
    picture->height = height;
    for (const float v : grey) picture->rgb.insert(picture->rgb.end(), {v, v, v});
    Pigment p;
    p.kind = Pigment::Kind::picture;
    p.projection = Pigment::Projection::panorama;
    p.smooth = true;
    p.picture = picture;
    p.colours = {reflectance_from_rgb({1, 0, 0}), reflectance_from_rgb({0, 1, 0}),
                 reflectance_from_rgb({0, 0, 1})};
    p.to_pattern = Transform::scaling({1, 1, -1});
    return p;
}

/// Radiance 0 everywhere.
inline Environment night() { return {}; }

inline Scene scene_of(Stone stone, Crystal crystal, Environment environment = furnace()) {
    Scene scene;
    scene.gems.push_back({std::move(stone), std::move(crystal), "stone"});
    scene.environment = std::move(environment);
    return scene;
}

/// From a random point at `distance` from `centre` towards one within `aim` of it, with a random
/// picture-right.
inline SensorRay random_ray(Random& random, double distance, double aim, const Vec3& centre = {}) {
    const Vec3 origin = centre + distance * random.direction();
    const Vec3 target = centre + (aim * std::cbrt(random.uniform())) * random.direction();
    const Vec3 direction = normalised(target - origin);
    return {origin, direction, random.perpendicular_to(direction)};
}

inline std::vector<SensorRay> random_rays(Random& random, int count, double distance, double aim) {
    std::vector<SensorRay> rays;
    for (int i = 0; i < count; ++i) rays.push_back(random_ray(random, distance, aim));
    return rays;
}

inline Stokes trace_one(const Scene& scene, const SensorRay& ray,
                        const TraceOptions& options = {}) {
    return trace(scene, std::span(&ray, 1), options).stokes[0];
}

/// The greatest difference of a component.
inline double difference(const Stokes& a, const Stokes& b) {
    double worst = 0;
    for (const double d : {a.s0 - b.s0, a.s1 - b.s1, a.s2 - b.s2, a.s3 - b.s3}) {
        worst = std::isnan(d) ? INFINITY : std::max(worst, std::abs(d));
    }
    return worst;
}

inline double polarised_part(const Stokes& s) { return std::hypot(s.s1, s.s2, s.s3); }

inline std::string text(const Stokes& s) {
    return in_digits(s.s0) + " " + in_digits(s.s1) + " " + in_digits(s.s2) + " " + in_digits(s.s3);
}

/// A camera at (0, 0, 6) that looks down -z on a square of this width about the origin.
inline Camera towards_origin(double width) {
    Camera camera;
    camera.location = {0, 0, 6};
    camera.direction = {0, 0, -6};
    camera.right = {width, 0, 0};
    camera.up = {0, width, 0};
    return camera;
}

inline Scene picture_scene(Crystal crystal, Environment environment) {
    Scene scene = scene_of(brilliant_stone(), std::move(crystal), std::move(environment));
    scene.camera = towards_origin(1.5);
    return scene;
}

inline RenderOptions small(int size, int samples) {
    RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.threads = 1;
    return options;
}

/// Mean of one channel of a picture.
inline double mean_of(const std::vector<float>& values, std::size_t offset, std::size_t stride) {
    double sum = 0;
    for (std::size_t i = offset; i < values.size(); i += stride) sum += values[i];
    return sum / (static_cast<double>(values.size()) / static_cast<double>(stride));
}

}  // namespace icespar::testing
