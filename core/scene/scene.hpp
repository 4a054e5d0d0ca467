// A scene as the renderer sees it: right-handed, everything in world coordinates.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "math/transform.hpp"
#include "polarisation/mueller.hpp"
#include "polarisation/stokes.hpp"
#include "scene/crystal.hpp"
#include "scene/formula.hpp"
#include "scene/pigment.hpp"
#include "scene/shape.hpp"
#include "spectrum/spectrum.hpp"
#include "stone/stone.hpp"

namespace icespar {

/// Where a pixel's ray starts and goes, as POV-Ray's camera after look_at, with picture coordinates
/// u right and v up, both from -1/2 to 1/2:
///   perspective:   from location along direction + u right + v up
///   orthographic:  from location + u right + v up along direction
///   fisheye:       from location, at angles from `direction` that grow evenly with the distance
///                  from the picture's middle, half of fisheye_angle at |v| = 1/2
struct Camera {
    enum class Kind { perspective, orthographic, fisheye };
    Kind kind = Kind::perspective;
    Vec3 location{0, 0, 0};
    Vec3 direction{0, 0, -1};
    Vec3 right{4.0 / 3, 0, 0};
    Vec3 up{0, 1, 0};
    double fisheye_angle = std::numbers::pi;
    double lens_radius = 0, focal_distance = 1;  ///< the latter along `direction`
    std::optional<Jones> analyser{};             ///< before the sensor, on its x and y
};

struct Gem {
    Stone stone;  ///< in world coordinates
    Crystal crystal;
    std::string name;  ///< where it stands in the scene file, for messages
};

/// Radiance = emission tint pigment D65 + diffuse pigment (what falls on it, POV-Ray's scale: a
/// light of colour 1 straight above a diffuse 1 surface gives 1).
struct Finish {
    double diffuse = 0.6, emission = 0;
    Spectrum tint{1.0};
};

/// An ideal thin sheet: light goes on unbent and unreflected, whatever the angle.
struct Filter {
    enum class Kind { polariser, waveplate, neutral };
    Kind kind = Kind::neutral;
    Vec3 axis{1, 0, 0};        ///< unit, in the sheet: what a polariser passes; a plate's fast axis
    double retardance_nm = 0;  ///< waveplate: by how much its slow wave lies behind
    double transmission = 1;   ///< neutral: of power
};

struct Thing {
    Shape shape;
    Transform to_world{};
    Pigment pigment;
    Finish finish;
    std::optional<Filter> filter{};  ///< of a sheet, which has no other looks
};

/// `light` is its colour at full strength as a spectrum (D65 times the scene's rgb, or an
/// illuminant).
struct Light {
    enum class Kind { point, spot, cylinder };
    Kind kind = Kind::point;
    Vec3 position;
    Vec3 direction{0, -1, 0};  ///< unit, of spots, cylinders and parallel lights
    /// POV-Ray's: within `radius` full, from `falloff` on dark; angles of a spot, lengths of a
    /// cylinder; times cosine (or nearness to the axis) to the power of `tightness`.
    double radius = 0, falloff = 0, tightness = 0;
    bool parallel = false, shadowless = false;
    bool circular = false,
         orient = false;  ///< of an area light: an ellipse; turned to what it lights
    Vec3 edge_u{},
        edge_v{};  ///< an area light spans position +- edge/2; both zero for a point light
    Spectrum light = white();
    double fade_distance = 0, fade_power = 0;  ///< POV-Ray's attenuation 2/(1+(d/fd)^fp); 0: none
};

/// A round lamp at infinity with a sharp edge: it adds to the radiance of the directions whose
/// cosine with `direction` is at least `cos_radius`.
struct Disc {
    Vec3 direction;  ///< unit, away from the scene
    double cos_radius = 1;
    Spectrum radiance{0.0};  ///< coloured value, times the illuminant
};

/// What surrounds the scene. Radiance from direction d (pointing away from the scene) is a linear
/// blend over d's height along `up`: `below` at -1, `above` at +1, or a pattern's, or formulas';
/// discs add to it.
struct Environment {
    Spectrum illuminant = white();    ///< radiance of value 1
    Spectrum below{0.0}, above{0.0};  ///< coloured values, times the illuminant
    Vec3 up{0, 1, 0};
    std::vector<Disc> discs{};
    /// Takes the place of `below` and `above` where it is given; its points are unit directions.
    std::optional<Pigment> pattern{};
    /// One, for the radiance, or four, for a Stokes vector: of the direction in a space of its
    /// own, left-handed as scenes are; take the place of all but discs.
    std::vector<Formula> formulas{};
    Transform to_own{};
    /// Polarisation for one who looks at the source, x right, y (world up) up; s0 = 1.
    Stokes state{1, 0, 0, 0};
};

struct Scene {
    Camera camera;
    std::vector<Gem> gems;
    std::vector<Thing> things;
    std::vector<Light> lights;
    Environment environment;
    int max_trace_level = 0;  ///< 0: no bound on a path's interface events
    std::string title;        ///< first comment line of the file
};

/// What would make a wrong picture, and the gem that is to blame: its number in scene.gems, or
/// nothing for the environment.
struct SceneFault {
    std::optional<std::size_t> gem;
    std::string message;
};

/// Faults of a finished scene that would make a wrong picture: overlapping gems, lights inside a
/// gem, opaque objects inside a gem or through it, an index below 1, numbers that are not finite.
/// Empty when all is well; the first twenty or so when much is wrong.
[[nodiscard]] std::vector<SceneFault> scene_faults(const Scene& scene);
/// The same, each with its gem's name before it.
[[nodiscard]] std::vector<std::string> faults(const Scene& scene);

/// The same for its camera, which must not stand inside a gem.
[[nodiscard]] std::vector<std::string> camera_faults(const Scene& scene);

/// The Stokes vector that the formulas give for a direction, y up in their own space, times the
/// illuminant. What a formula leaves undefined or negative is dark.
[[nodiscard]] Stokes formula_light(const Environment& environment, const Vec3& direction);

/// Whether any surface is diffuse.
[[nodiscard]] bool scatters(const Scene& scene);

/// The gem that holds this point in its interior, or nothing.
[[nodiscard]] const Gem* gem_around(const Scene& scene, const Vec3& point);

}  // namespace icespar
