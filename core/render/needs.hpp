// What a scene asks of the renderer, read from it once: kernels leave out the rest.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace icespar {

/// What follows light through stones: rays sample it, beams follow whole pixels, exact beams whole
/// facets of a lone stone in a parallel view (docs/method.md). automatic: exact beams for an
/// isotropic stone, else beams, where they apply. All make the same picture, within their noise.
enum class Engine { automatic, rays, beams, exact };

/// Parts of the full kernel to be used where a scene does not need them, to compare. The picture
/// stays the same: to rounding, or, where samples fall elsewhere (wavelengths of beams,
/// surroundings, pixels, survivors), within its noise.
struct Forced {
    bool wavelengths = false;   ///< as if every stone treated them differently
    bool stokes = false;        ///< all four components
    bool general = false;       ///< uniaxial stones by the solver for any crystal
    bool absorption = false;    ///< asked of clear stones
    bool tree = false;          ///< Embree, for however few objects
    bool surroundings = false;  ///< what leaves a lonely stone is looked up ray by ray
    bool pixels = false;        ///< beams follow each pixel by itself
    bool survivors = false;     ///< what survives by chance in a crystal stays a beam

    friend bool operator==(const Forced&, const Forced&) = default;
    [[nodiscard]] static Forced everything() {
        return {true, true, true, true, true, true, true, true};
    }
    /// The part of that name; throws Error with the names there are.
    bool& part(std::string_view name);
};

struct StoneNeeds {
    bool beams = false;         ///< beams can follow light through it
    bool birefringent = false;  ///< o and e, or fast and slow
    bool general = false;       ///< its waves are beyond the closed forms: biaxial or active
    bool active = false;
    bool wavelengths = false;        ///< it treats them differently
    bool parts_wavelengths = false;  ///< and sends them different ways
    bool absorption = false;
    bool faint_rays = false;  ///< beams that survive by chance may go on as rays
};

struct Needs {
    std::vector<StoneNeeds> stones;
    bool wavelengths = false, birefringent = false, general = false,
         absorption = false;  ///< of any
    bool stokes = false;
    bool tree = false;  ///< so many objects that Embree finds them sooner
    bool surroundings =
        false;            ///< light that leaves a stone meets more than a smooth sky and lamps
    bool blocks = false;  ///< beams may follow pixels together
    Engine engine = Engine::rays;
    std::string obstacle;        ///< why beams cannot make the picture; empty when they can
    std::string exact_obstacle;  ///< the same of exact beams
    Forced forced;
};

/// `engine` is the wish; beams that were wished for are not chosen where there is an obstacle.
[[nodiscard]] Needs needs_of(const Scene& scene, bool stokes = false,
                             Engine engine = Engine::automatic, const Forced& forced = {});

/// Gems, triangles and things other than planes: what a tree would hold.
[[nodiscard]] std::size_t bounded_objects(const Scene& scene);

/// One line of a plan: "crystals", "uniaxial", "both waves of the stone at line 12 are followed".
struct PlanLine {
    std::string subject, choice, reason;
};

/// What was chosen and why, the engine last.
[[nodiscard]] std::vector<PlanLine> plan(const Scene& scene, const Needs& needs);
/// What the user should know: what converges slowly, and what is left out.
[[nodiscard]] std::vector<std::string> plan_warnings(const Scene& scene);
/// The lines in columns, then the warnings.
[[nodiscard]] std::string plan_text(const Scene& scene, const Needs& needs);
/// The choice in a few words: "beams, spectral, intensity, uniaxial".
[[nodiscard]] std::string plan_summary(const Needs& needs);

}  // namespace icespar
