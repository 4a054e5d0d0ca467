// A stone in a parallel view, by exact beams: where all the light that it sends to the viewer came
// from, and how much is not known.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "beams/polygon.hpp"
#include "crystal/medium.hpp"
#include "math/symmetric.hpp"
#include "math/vec3.hpp"
#include "polarisation/mueller.hpp"
#include "polarisation/stokes.hpp"
#include "stone/stone.hpp"

namespace icespar {

/// Lines of sight go along `direction`; `up` is up in the picture. Neither need be of unit length,
/// nor perpendicular to the other.
struct ParallelView {
    Vec3 direction{0, 0, -1}, up{0, 1, 0};
};

/// What a stone takes from light on its way, its waves and facets being those of the clear stone.
struct Absorption {
    /// k0 Im eps, per unit of length: a wave of unit field E loses E . tensor E / (k . ray) of its
    /// power per length of its ray.
    RealTensor tensor{};
    double per_length = 0;  ///< besides, of every wave

    [[nodiscard]] bool none() const;
};

/// From what light loses per length along each principal axis of a clear medium: one number
/// (isotropic), two (uniaxial: across the axis, along it), three (biaxial, by rising index). Throws
/// Error for another number of them, and for what is negative or not finite.
[[nodiscard]] Absorption absorption_of(const Medium& medium, std::span<const double> per_length);

/// What a colour loses per unit of each of its lengths (Colours); those that are not used are 0.
using ColourRates = std::array<double, 4>;

[[nodiscard]] Affine depth_of(const ColourRates& rates, std::span<const Affine> lengths);

/// What is carried along a beam. Averaged: s and p are averaged at every face, as programs do that
/// know no polarisation; isotropic stones only.
enum class Weights { intensity, stokes, averaged };

struct ViewOptions {
    Weights weights = Weights::intensity;
    /// Exact tracing ends when no more than this part of all light is left untraced. Without it,
    /// when a sample of the rest has the `error` asked for and takes about as long as what was
    /// done.
    std::optional<double> bound = 1e-3;
    /// Or when so many beams were followed to their next facets; 0: no bound of this kind.
    std::uint64_t max_beams = 2'000'000;
    double seconds = 0;  ///< or after this time; 0: no bound of this kind
    int max_hits = 0;    ///< interface events of a path, the entry being the first; 0: any number
    /// What is left is then sampled, by beams if outlines are asked for and by the paths of single
    /// rays else, so that radiances from 0 to 1 add up to within about this standard error, but by
    /// no more beams or paths than `sample_effort` times those that were followed exactly, or four
    /// times that where lanes follow paths side by side (clear uniaxial stones, intensity); 0: it
    /// is left.
    double error = 0, sample_effort = 1;
    /// Of light that enters by this facet, too, alone and as a part of its area.
    std::optional<int> error_of{};
    std::uint64_t seed = 0;  ///< of the sample
    double least_power = 0;  ///< fainter light is not followed on from a face where part of it left
    bool symmetry = true;    ///< trace once what images of one another would repeat
    bool outlines = false;   ///< keep the polygons too
    /// How the permittivity changes with colour: keep how directions move with that.
    std::optional<RealTensor> fan{};
    bool turns = false;      ///< keep how directions move with the line of sight
    bool polarised = false;  ///< keep what is seen of polarised light too; without symmetry
    /// Before the viewer, on picture-right and picture-up; without symmetry.
    std::optional<Jones> analyser{};
    /// Asked now and then; tracing ends when it says false. It must not throw.
    std::function<bool()> go_on{};
};

/// Picture coordinates of p: dot(p - centre, right) and dot(p - centre, up).
struct PictureFrame {
    Vec3 centre, right, up, direction;  ///< axes are unit and perpendicular; right = direction x up
};

/// A turn or mirror of the picture that leaves stone, crystal and view as they are. It maps p to
/// centre + turned(p - centre); in space it keeps the line of sight.
struct PictureImage {
    Point2 centre;
    Point2 right{1, 0}, up{0, 1};  ///< where picture-right and picture-up go
    std::vector<int> facets;       ///< number of the facet that each facet becomes

    [[nodiscard]] Point2 turned(const Point2& p) const { return p.x * right + p.y * up; }
    [[nodiscard]] Point2 of(const Point2& p) const { return centre + turned(p - centre); }
    [[nodiscard]] Vec3 of(const Vec3& direction, const PictureFrame& frame) const;
    /// Derivatives with what turns to picture-right and -up.
    [[nodiscard]] std::array<Vec3, 2> of(const std::array<Vec3, 2>& turned,
                                         const PictureFrame& frame) const {
        return {of(right.x * turned[0] + up.x * turned[1], frame),
                of(right.y * turned[0] + up.y * turned[1], frame)};
    }
    /// The number at the point that becomes p.
    [[nodiscard]] Affine of(const Affine& number) const {
        const Point2 slope = turned({number.dx, number.dy});
        return {number(centre) - slope.x * centre.x - slope.y * centre.y, slope.x, slope.y};
    }
    /// Of what the viewer sees, on picture axes.
    [[nodiscard]] Stokes of(const Stokes& s) const;
    [[nodiscard]] bool mirrors() const { return right.x * up.y - right.y * up.x < 0; }
};

/// Beams of light that leave the stone: all of one in one direction, at one weight. Where the view
/// is symmetric each stands for one beam in every image.
struct Exits {
    std::vector<PictureImage> images;  ///< the identity first

    PictureFrame frame;
    std::vector<Vec3> direction;  ///< unit, away from the stone, against the light
    std::vector<Vec3> fan;        ///< if that was asked for: its derivative with colour
    /// If that was asked for: its derivatives as the line of sight turns to picture-right and -up.
    std::vector<std::array<Vec3, 2>> turned;
    /// What the viewer sees of unpolarised radiance 1 from there; the mean over the beam, if the
    /// stone absorbs.
    std::vector<Stokes> weight;
    /// If that was asked for: the same of Stokes vectors S1, S2 and S3 of 1, on the axes `axis` and
    /// axis x direction.
    std::vector<std::array<Stokes, 3>> polarised;
    std::vector<Vec3> axis;    ///< unit, across `direction`
    std::vector<double> area;  ///< in the picture, in the stone's units of length squared
    std::vector<std::int32_t> entry, facet;  ///< where it meets the stone, and where it leaves it
    std::vector<std::int32_t> hits;          ///< interface events, both included
    /// 0: followed exactly. 1 to `groups`: found in that group of the sample; the groups 2 n - 1
    /// and 2 n are alike but for chance, the weights are for all groups together.
    std::vector<std::int32_t> group;
    int groups = 0;  ///< even; 0: the rest was not sampled

    /// In the picture, if they were asked for: beam i has corners outline[i] to outline[i + 1].
    std::vector<std::size_t> outline;
    Polygon corners;
    /// If the stone absorbs, by colour: what it leaves of each over the mean of all, which is in
    /// the weight, one exit's after the other's; their rates; and, if outlines were asked for, the
    /// lengths of each exit. exp(-depth) is left in each point.
    std::vector<double> tint;
    std::vector<ColourRates> rates;
    std::vector<Affine> lengths;

    /// By facet of the stone, for what enters there: its area in the picture, and weight times area
    /// of what was not followed exactly, and of what `max_hits` and `least_power` ended.
    std::vector<double> entry_area, entry_untraced, entry_cut;
    double area_total = 0, untraced = 0, cut = 0;  ///< their sums
    double absorbed = 0;                           ///< weight times area that the stone kept
    /// What is neither in the list nor cut nor absorbed: all that is untraced, or what the sample
    /// left of it.
    double residue = 0;
    std::uint64_t beams = 0;    ///< followed from one facet to the next ones
    std::uint64_t sampled = 0;  ///< of those, for the sample
    /// Area that rounding lost between facets (its light counts as untraced) or gave twice.
    double gaps = 0;

    [[nodiscard]] std::size_t size() const { return area.size(); }
    [[nodiscard]] std::span<const double> tint_of(std::size_t exit) const {
        return {tint.data() + exit * rates.size(), rates.size()};
    }
    [[nodiscard]] Affine depth(std::size_t exit, std::size_t colour) const {
        const std::size_t each = lengths.size() / size();
        return depth_of(rates[colour], {lengths.data() + exit * each, each});
    }
    /// The same with a beam for every image.
    [[nodiscard]] Exits expanded() const;
};

/// A sum over the exits of a view, from those of each group of its sample.
struct Estimate {
    double value = 0;
    double error = 0;  ///< one standard error; 0 without a sample
};
/// `sums` begins with what was traced exactly.
[[nodiscard]] Estimate estimate_of(std::span<const double> sums);

/// Best first by weight times area, so that what is untraced is small soon. The result does not
/// depend on anything but the arguments, unless a time is given. Throws Error for a view without
/// direction, options out of range, and media that absorb, turn polarisation or, where s and p are
/// averaged, are birefringent, as for polarisation where s and p are averaged. A stone's absorption
/// may be that of several colours of equal weight, which share the waves of the medium: sums are
/// then over their mean.
[[nodiscard]] Exits trace_view(const Stone& stone, const Medium& medium, const ParallelView& view,
                               const ViewOptions& options = {},
                               std::span<const Absorption> absorption = {});

}  // namespace icespar
