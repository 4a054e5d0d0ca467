// Given rays, one wavelength, the whole tree: no chance is left anywhere.
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <numbers>

#include "math/error.hpp"
#include "render/render.hpp"
#include "render/walker.hpp"

namespace icespar {
namespace {

constexpr int unbounded_events = 1 << 16;
constexpr double negligible = 1e-16;

/// A diffuse surface asks this many fixed directions, once: surfaces lit by surfaces end there.
constexpr int hemisphere_rays = 64;

class Collector {
public:
    Collector(const TraceOptions& options, double white_radiance)
        : options_(options),
          white_(white_radiance),
          bounded_(options.max_hits > 0 || options.threshold > 0) {}

    void begin() {
        seen = {};
        dropped = {};
        absorbed = {};
        meetings_ = 0;
    }
    bool admit(const Branch&) const { return true; }
    bool may_meet(const Branch& b) {
        if (options_.max_hits > 0 && b.hits >= options_.max_hits) return false;
        if (b.weight < (bounded_ ? options_.threshold : negligible)) return false;
        return bounded_ || ++meetings_ <= unbounded_events;
    }
    void lose(const Stokes& response) { dropped += response; }
    void absorb(const Stokes& response) { absorbed += response; }
    void see(const Emitter& light, const Stokes& s, bool) {
        see_at_wavelength(light.radiance(options_.wavelength_nm), s);
    }
    void see_at_wavelength(double radiance, const Stokes& s) { seen += (radiance / white_) * s; }
    [[nodiscard]] int diffuse_rays(const Branch& b) const {
        return b.diffused ? 0 : hemisphere_rays;
    }
    /// An area light answers for its centre.
    [[nodiscard]] std::pair<double, double> light_point() const { return {0.5, 0.5}; }
    [[nodiscard]] std::pair<double, double> diffuse_point(int ray, int) const {
        // Fibonacci's lattice over the square.
        const double v = ray / std::numbers::phi;
        return {(ray + 0.5) / hemisphere_rays, v - std::floor(v)};
    }

    Stokes seen;
    Stokes dropped, absorbed;

private:
    TraceOptions options_;
    double white_;
    bool bounded_;
    int meetings_ = 0;
};

}  // namespace

Traced trace(const Scene& scene, std::span<const SensorRay> rays, const TraceOptions& options) {
    if (!(options.wavelength_nm >= shortest_nm && options.wavelength_nm <= longest_nm)) {
        throw Error("wavelength_nm must be between 380 and 780");
    }
    if (options.max_hits < 0) throw Error("max_hits must not be negative");
    if (!(options.threshold >= 0)) throw Error("threshold must not be negative");
    std::vector<Branch> first;
    first.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SensorRay& r = rays[i];
        const std::string place = "[" + std::to_string(i) + "]";
        const double size = length(r.direction);
        if (!is_finite(r.origin)) throw Error("origins" + place + " is not finite");
        if (!is_finite(r.direction) || !(size > 0) || !std::isfinite(size)) {
            throw Error("directions" + place + " must be finite and not zero");
        }
        if (gem_around(scene, r.origin) != nullptr) {
            throw Error("origins" + place + " lies inside a stone; start the ray outside");
        }
        const Vec3 d = r.direction / size;
        const double x_size = length(r.x_axis);
        if (!is_finite(r.x_axis) || !(length(cross(d, r.x_axis)) > 1e-12 * x_size)) {
            throw Error("x_axis" + place + " must be finite, not zero and not along the direction");
        }
        first.push_back(Branch::from_sensor(r.origin, d, r.x_axis / x_size));
    }
    const auto problems = faults(scene);
    if (!problems.empty()) throw Error(problems.front());

    const Needs needs = needs_of(scene, true, Engine::rays, options.forced);
    const World world(scene, needs.tree);
    const Palette palette(scene, 0);
    const double white_radiance = scene.environment.illuminant(options.wavelength_nm);
    if (!(white_radiance > 0)) throw Error("the environment's illuminant is 0 at this wavelength");
    struct Worker {
        Collector collector;
        Walker<Collector> walker;
    };
    const bool bounded = options.max_hits > 0 || options.threshold > 0;
    tbb::enumerable_thread_specific<Worker> workers([&] {
        return Worker{Collector(options, white_radiance),
                      Walker<Collector>(world, palette, needs, !bounded)};
    });
    Traced out;
    out.stokes.resize(rays.size());
    out.dropped.resize(rays.size());
    out.absorbed.resize(rays.size());
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, rays.size(), [&](std::size_t i) {
            Worker& w = workers.local();
            w.collector.begin();
            w.walker.walk(first[i], options.wavelength_nm, w.collector);
            out.stokes[i] = w.collector.seen;
            out.dropped[i] = w.collector.dropped;
            out.absorbed[i] = w.collector.absorbed;
        });
    });
    return out;
}

}  // namespace icespar
