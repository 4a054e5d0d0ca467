// The evaluated tree to a core scene. Here z is negated, once: the language is left-handed, the
// core is not.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "math/error.hpp"
#include "parser/cursor.hpp"
#include "parser/diagnostic.hpp"
#include "parser/tree.hpp"
#include "scene/scene.hpp"

namespace icespar {

/// A pigment with the space it was given in; `place` takes pattern points to the present
/// coordinates.
struct PigmentLook {
    Pigment::Kind kind = Pigment::Kind::plain;
    std::array<double, 5> first{}, second{};
    double line_width = 0.1;
    Transform place{};
    Place where;
    [[nodiscard]] bool transparent() const { return first[3] + first[4] > 0; }
};

/// In the object's coordinates; the axes may have any length.
struct InteriorLook {
    Crystal crystal{{}, {0, 1, 0}};
    Place where;
    void turn(const Transform& t);
};

/// `emission` of the finish is what these two add up to.
struct FinishLook : Finish {
    std::array<double, 3> own{}, ambient{};
};

struct Look {
    std::optional<PigmentLook> pigment;
    std::optional<FinishLook> finish;
    std::optional<InteriorLook> interior;
    bool at_fault = false;  ///< something of it could not be read: what wears it is left out
};

/// The shape of a stone: half-spaces, or points whose hull it is.
struct Solid {
    std::vector<FacetPlane> planes;
    std::vector<Vec3> points;
    std::optional<double> width{};  ///< what `scale_to width` asks for
    Place where{};
    std::map<std::string, Place> facet_places{};
    std::optional<Stone> stone{};  ///< once built, in the language's coordinates
    bool at_fault = false;
};

/// One thing, stone or lamp on its way through unions; `place` takes it to the present coordinates.
struct Part {
    enum class Kind { plane, box, sphere, stone, lamp };
    Kind kind = Kind::sphere;
    bool gem = false;       ///< said to be one, not merely transparent
    bool inverse = false;   ///< inside out, which no stone can be
    bool of_union = false;  ///< its own texture stays, whatever is said of the whole
    Transform place{};
    Look look{};
    std::shared_ptr<Solid> solid{};
    Light light{};
    Place where;
};
using Parts = std::vector<Part>;

class Builder {
public:
    Builder(const Sources& sources, Diagnostics& diagnostics);

    /// Faults are in the diagnostics; throws Stop.
    Scene build(const Block& scene);
    /// Of each of the scene's gems, in their order.
    [[nodiscard]] const std::vector<Place>& gem_places() const { return gem_places_; }
    /// Of the scene's camera; nothing when there is no such block.
    [[nodiscard]] const std::optional<Place>& camera_place() const { return camera_place_; }

private:
    /// Runs f; a Fault in it is reported and ends it. False when there was one.
    template <class F>
    bool guarded(F&& f) {
        try {
            f();
            return true;
        } catch (const Fault& fault) {
            diagnostics_.error(fault);
        } catch (const Error& error) {
            // From the core, which knows no places: the item that was looked at last is to blame.
            diagnostics_.error(where_, error.what());
        } catch (const Poisoned& poisoned) {
            if (diagnostics_.errors() == 0) diagnostics_.error(poisoned.place, "this has no value");
        }
        return false;
    }
    void step(const Place& place);

    void global_settings(const Block& block);
    void background(const Block& block);
    void sky_sphere(const Block& block);
    void environment(const Block& block);
    void polarised(const Block& block);
    [[nodiscard]] Spectrum illuminant_named(Cursor& cursor, std::string_view word);

    Parts object(const Block& block);
    Parts group(const Block& block);
    Part primitive(const Block& block);
    Part gem(const Block& block);
    Part intersection(const Block& block);
    Part lamp(const Block& block);
    /// A transform, texture, interior ... of an object; false when the item is something else.
    bool modifier(Cursor& cursor, Look& look, Transform& place);
    static void apply(const Transform& t, Look& look);
    void count_objects(std::size_t more, const Place& place);

    Look texture(const Block& block);
    PigmentLook pigment(const Block& block);
    /// A finish amends the one already there, or the default.
    FinishLook finish(const Block& block, const std::optional<FinishLook>& before);
    InteriorLook interior(const Block& block);
    // build_crystal.cpp
    struct CrystalWords;
    void crystal(const Block& block, InteriorLook& look);
    void crystal_item(Cursor& cursor, InteriorLook& look, CrystalWords& words);
    void dispersion(const Block& block, CrystalWords& words);
    void absorption(const Block& block, CrystalWords& words);
    static void crystal_indices(const Block& block, Crystal& crystal, const CrystalWords& words);
    static void crystal_absorption(Crystal& crystal, const CrystalWords& words);

    void shape(const Block& block, Solid& solid);
    void cut(const Block& block, Solid& solid);
    void facet(const Block& block, double gear, double offset, Solid& solid);
    void hull(const Block& block, Solid& solid);
    void box_planes(const Block& block, Solid& solid);
    void intersected(const Block& block, Solid& solid);
    /// Applies the transforms that follow within a shape.
    void transform_shape(const Transform& t, Solid& solid);
    /// Half-spaces instead of points.
    void as_planes(Solid& solid);
    void design(const Place& place, const std::string& file, Solid& solid);
    const Stone* stone_of(Solid& solid);

    void finish_part(const Part& part);
    void finish_thing(const Part& part);
    void finish_stone(const Part& part, Solid& solid);

    const Sources& sources_;
    Diagnostics& diagnostics_;
    Scene scene_;
    Place where_;
    std::vector<Place> gem_places_;
    std::optional<Place> camera_place_;
    Look defaults_;
    std::array<double, 3> ambient_light_{1, 1, 1};
    std::map<const Block*, std::shared_ptr<Solid>> solids_;
    std::shared_ptr<Solid> unit_box_;
    std::size_t objects_ = 0, steps_ = 0;
    bool environment_seen_ = false;
};

[[nodiscard]] double index_value(Cursor& cursor);
/// Reads the transform whose word (or block) the cursor stands at; nothing when there is none.
[[nodiscard]] std::optional<Transform> read_transform(Cursor& cursor);
/// What a `transform { ... }` comes to.
[[nodiscard]] Transform transform_of(const Block& block);
/// POV-Ray's camera after look_at, angle and transforms, in core coordinates.
[[nodiscard]] Camera build_camera(const Block& block);
/// (x, y, z) to (x, y, -z), from the language to the core and back.
[[nodiscard]] inline Vec3 mirrored(const Vec3& v) { return {v.x, v.y, 0.0 - v.z}; }
[[nodiscard]] const Transform& mirror();

}  // namespace icespar
