// From a scene to a picture, or to the Stokes vectors of given rays.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "image/image.hpp"
#include "render/needs.hpp"
#include "scene/scene.hpp"

namespace icespar {

/// What of the pixels' standard errors is the picture's error, over its mean luminance.
enum class ErrorMetric { rms, largest };

struct RenderOptions {
    int width = 640, height = 480;
    int samples = 0;     ///< per pixel; 0: until `error` or `seconds`
    double error = 0;    ///< stop when the picture's estimated relative error is below; 0: ignore
    double seconds = 0;  ///< stop after this time; 0: ignore. All three 0: 64 samples
    int threads = 0;     ///< 0: all. The picture does not depend on it (but for `seconds`)
    std::uint64_t seed = 0;
    int bands = 0;  ///< spectral bands asked for, 0 .. 400
    bool stokes = false;
    Engine engine = Engine::automatic;
    Forced forced{};  ///< kernels that the scene does not need
    ErrorMetric metric = ErrorMetric::rms;
};

struct Progress {
    double done = 0;     ///< 0 .. 1, by whichever bound is nearest
    double seconds = 0;  ///< since the start
    double error = 0;    ///< estimated relative error of the picture so far; 0: not known yet
                         ///< (fewer than 16 samples)
    int samples = 0;     ///< per pixel, finished
};

/// Called from the rendering thread between passes and within them; false stops the render, which
/// keeps what is there.
using ProgressCallback = std::function<bool(const Progress&)>;

/// Relative error of a picture by exact beams for which no bound is given.
inline constexpr double exact_error = 0.004;

struct RenderReport {
    int samples = 0;                      ///< per pixel, on average
    std::uint64_t paths = 0, events = 0;  ///< camera paths; interface events
    double seconds = 0, error = 0;
    double absorbed = 0;            ///< mean power per camera path that ends within stones
    double dropped = 0;             ///< mean power per camera path given up by a depth bound
    std::uint64_t bad_samples = 0;  ///< NaN or infinite, left out of the picture
    bool interrupted = false;
    Engine engine = Engine::rays;  ///< what made the picture
};

struct Rendering {
    Image image;
    RenderReport report;
};

/// What `render` uses of the renderer with these options.
[[nodiscard]] Needs needs_of(const Scene& scene, const RenderOptions& options);

/// Throws Error when the options make no sense (size not in 1 .. 65536 a side, or negative numbers)
/// or the scene has faults.
[[nodiscard]] Rendering render(const Scene& scene, const RenderOptions& options,
                               const ProgressCallback& progress = {});

struct TraceOptions {
    double wavelength_nm = 589.3;
    int max_hits =
        0;  ///< interface events of a path, the entry (or outer reflection) the first; 0: no bound
    double threshold = 0;  ///< a branch of less weight is dropped before it is continued
    int threads = 0;
    Forced forced{};  ///< kernels that the scene does not need
};

/// One ray of `trace`: into the scene, with picture-right.
struct SensorRay {
    Vec3 origin, direction, x_axis;
};

struct Traced {
    std::vector<Stokes> stokes;  ///< in units of the environment's illuminant at that wavelength
    /// What the branches given up by the bounds would have added under unit unpolarised light from
    /// everywhere.
    std::vector<Stokes> dropped;
    /// The same of what the stones absorbed: stokes + dropped + absorbed = (1, 0, 0, 0).
    std::vector<Stokes> absorbed;
};

/// The full tree of every ray at one wavelength, without roulette. With neither bound given, a
/// branch of weight below 1e-16 ends, and a ray ends after 2^16 events, the heaviest branches
/// first. Throws Error when a direction is zero or not finite, or x_axis is along it.
[[nodiscard]] Traced trace(const Scene& scene, std::span<const SensorRay> rays,
                           const TraceOptions& options);

}  // namespace icespar
