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

/// A colour or a spectrum, where either may stand.
struct Ink {
    Spectrum spectrum{1.0};
    std::array<double, 5> rgb{};  ///< as written; of a spectrum 0
    [[nodiscard]] bool clear() const { return rgb[3] + rgb[4] > 0; }
};

/// A pigment with the space it was given in; `place` takes pattern points to the present
/// coordinates.
struct PigmentLook {
    Pigment pigment{};             ///< but for `to_pattern`
    std::array<double, 5> tint{};  ///< of a plain one, as written
    bool clear = false;            ///< some of it lets light through
    Transform place{};
    Place where;
    [[nodiscard]] Pigment placed() const;
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

/// The shape of a stone: half-spaces, points whose hull it is, or a mesh.
struct Solid {
    std::vector<FacetPlane> planes{};
    std::vector<Vec3> points{};
    std::shared_ptr<const TriangleMesh> mesh{};
    std::string design{};           ///< the file it is, and nothing else
    std::optional<double> width{};  ///< what `scale_to width` asks for
    Place where{};
    std::map<std::string, Place> facet_places{};
    std::optional<Stone> stone{};  ///< once built, in the language's coordinates
    bool at_fault = false;
};

/// One thing, stone or lamp on its way through unions; `place` takes it to the present coordinates.
struct Part {
    enum class Kind { thing, stone, lamp };
    Kind kind = Kind::thing;
    bool gem = false;       ///< said to be one, not merely transparent
    bool inverse = false;   ///< inside out, which no stone can be
    bool of_union = false;  ///< its own texture stays, whatever is said of the whole
    Shape shape{};          ///< of a thing
    Transform place{};
    Look look{};
    std::shared_ptr<Solid> solid{};
    Light light{};
    Vec3 point_at{};                 ///< of a lamp
    std::optional<Filter> filter{};  ///< of a sheet; its axis in the present coordinates
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
    /// What seems to be missing may be what was at fault, and is reported.
    [[nodiscard]] bool excused(const Block& block) const {
        return diagnostics_.errors() > 0 && has_gaps(block);
    }

    // build_settings.cpp
    void global_settings(const Block& block);
    void to_millimetres();

    void background(const Block& block);
    void sky_sphere(const Block& block);
    void environment(const Block& block);
    void polarised(const Block& block);
    /// iso, cosine, sc2, aset or idealscope; false when it is none of them.
    bool named_sky(std::string_view name, double head_degrees);
    void panorama(const std::string& file, const Place& place);
    void lamps(const Block& block);
    void check_formulas(const Place& place);
    /// Turns and tints what surrounds the scene.
    void place_sky(const Transform& place, const std::optional<Ink>& value, const Place& where);
    /// A colour or spectrum of a light, which is not negative.
    [[nodiscard]] Spectrum light(Cursor& cursor, std::string_view what);
    [[nodiscard]] Spectrum illuminant_named(Cursor& cursor, std::string_view word);

    Parts object(const Block& block);
    Parts group(const Block& block);
    Part primitive(const Block& block);
    [[nodiscard]] std::shared_ptr<const TriangleMesh> mesh(const Block& block);
    void warn_of_normals(const Place& place);
    /// The solid of a block, which its instances share, and whether it is new.
    std::pair<std::shared_ptr<Solid>, bool> solid_of(const Block& block);
    Part gem(const Block& block);
    Part intersection(const Block& block);
    Part lamp(const Block& block);
    Part sheet(const Block& block);
    /// A transform, texture, interior ... of an object; false when the item is something else.
    bool modifier(Cursor& cursor, Look& look, Transform& place);
    static void apply(const Transform& t, Look& look);
    void count_objects(std::size_t more, const Place& place);

    Look texture(const Block& block);
    PigmentLook pigment(const Block& block);
    void color_map(const Block& block, PigmentLook& look);
    void image_map(const Block& block, PigmentLook& look);
    [[nodiscard]] std::shared_ptr<const Picture> picture(const std::string& file,
                                                         const Place& place);
    /// A file that the scene names, within bounds.
    [[nodiscard]] std::string file_named(const std::string& file, const Place& place) const;

    // build_spectrum.cpp
    [[nodiscard]] Ink ink(Cursor& cursor, std::string_view what);
    [[nodiscard]] static bool next_is_ink(const Cursor& cursor);
    /// The spectrum or gaussian that stands next, or nothing; values are at least `least`.
    [[nodiscard]] std::optional<Spectrum> spectrum(Cursor& cursor, double least = 0);
    [[nodiscard]] Spectrum read_spectrum(const Block& block, double least);
    [[nodiscard]] Spectrum spectrum_file(const std::string& file, const Place& place,
                                         double least) const;
    /// A finish amends the one already there, or the default.
    FinishLook finish(const Block& block, const std::optional<FinishLook>& before);
    InteriorLook interior(const Block& block);
    // build_crystal.cpp, build_dispersion.cpp, build_absorption.cpp
    struct CrystalWords;
    void crystal(const Block& block, InteriorLook& look);
    void crystal_item(Cursor& cursor, InteriorLook& look, CrystalWords& words);
    void dispersion(const Block& block, CrystalWords& words);
    void absorption(const Block& block, CrystalWords& words);
    static void crystal_indices(const Block& block, Crystal& crystal, const CrystalWords& words);
    static void crystal_absorption(Crystal& crystal, const CrystalWords& words);

    void shape(const Block& block, Solid& solid);
    void hull(const Block& block, Solid& solid);
    void box_planes(const Block& block, Solid& solid);
    void intersected(const Block& block, Solid& solid);
    /// Applies the transforms that follow within a shape.
    void transform_shape(const Transform& t, Solid& solid);
    /// Half-spaces instead of points.
    void as_planes(Solid& solid);
    // build_cut.cpp
    void cut(const Block& block, Solid& solid);
    void facet(const Block& block, double gear, double offset, Solid& solid);
    /// The planes of a design file, and its whole path.
    std::string design(const Place& place, const std::string& file, Solid& solid);

    [[nodiscard]] Stone polyhedron(const Solid& solid);
    const Stone* stone_of(Solid& solid);

    void finish_part(const Part& part);
    void finish_thing(const Part& part);
    void finish_sheet(const Part& part);
    void finish_stone(const Part& part, Solid& solid);

    const Sources& sources_;
    Diagnostics& diagnostics_;
    Scene scene_;
    Place where_;
    Look defaults_;
    std::array<double, 3> ambient_light_{1, 1, 1};
    double unit_mm_ = 1;
    std::map<const Block*, std::shared_ptr<Solid>> solids_;
    std::map<std::string, Stone> designs_;  ///< by file: a stone takes a while to build
    std::shared_ptr<Solid> unit_box_;
    std::map<std::string, std::shared_ptr<const Picture>> pictures_;
    std::vector<Place> gem_places_;
    std::optional<Place> camera_place_;
    std::size_t objects_ = 0, steps_ = 0;
    bool environment_seen_ = false;
};

[[nodiscard]] double index_value(Cursor& cursor);
/// Throws a Fault for a stone of more planes or points than the bound.
void bound_stone(std::size_t count, const Place& place);
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
