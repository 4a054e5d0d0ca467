// Scenes of a floor under lamps and skies, and how bright the floor is.
#pragma once

#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"

namespace icespar::testing {

/// The plane y = 0.
inline Thing floor_of(double diffuse, double reflectance) {
    Thing thing;
    thing.pigment.colours = {Spectrum(reflectance)};
    thing.finish = {diffuse, 0};
    return thing;
}

inline Thing ball(const Vec3& centre, double radius) {
    Thing thing;
    thing.shape = SphereShape{};
    thing.to_world =
        Transform::scaling({radius, radius, radius}).then(Transform::translation(centre));
    thing.finish = {0, 0};
    return thing;
}

inline Light lamp_at(const Vec3& position, double colour = 1) {
    Light light;
    light.position = position;
    light.light = colour * white();
    return light;
}

inline Scene lit_floor(const Light& light, double diffuse = 1, double reflectance = 1) {
    Scene scene;
    scene.environment = night();
    scene.things.push_back(floor_of(diffuse, reflectance));
    scene.lights.push_back(light);
    return scene;
}

/// Radiance of the floor at a point, as seen from above at a slant, in units of D65.
inline double seen_at(const Scene& scene, double x, double z) {
    const Vec3 d = normalised(Vec3{0.001, -1, -0.002});
    const Stokes s = trace_one(scene, {Vec3{x, 0, z} - 20.0 * d, d, {1, 0, 0}});
    CHECK(polarised_part(s) <= 1e-15);
    return s.s0;
}

inline double luminance_of(const Image& image) {
    return xyz_from_rgb(
        {mean_of(image.rgb, 0, 3), mean_of(image.rgb, 1, 3), mean_of(image.rgb, 2, 3)})[1];
}

/// The luminance of a small picture of the floor about a point.
inline double pictured(Scene scene, double x, double z, int samples) {
    scene.camera.location = {x, 30, z};
    scene.camera.direction = {0, -30, 0};
    scene.camera.right = {1e-4, 0, 0};
    scene.camera.up = {0, 0, -1e-4};
    RenderOptions options;
    options.width = options.height = 16;
    options.samples = samples;
    options.threads = 1;
    return luminance_of(render(scene, options).image);
}

}  // namespace icespar::testing
