// Pictures: samples per pixel until a bound is reached, the same bits for any number of threads.
#include "render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "math/error.hpp"
#include "render/camera.hpp"
#include "render/film.hpp"
#include "render/walker.hpp"

namespace icespar {
namespace {

/// A branch that carries less of the pixel's light than this plays roulette (docs/method.md).
constexpr double roulette_weight = 0.1;
/// Outside a stone it costs one look at the surroundings, so it is followed for less.
constexpr double outside_weight = 0.01;
/// Light that is all but caught in a stone, or in a white room, ends by chance, too.
constexpr int patient_hits = 256, patient_bounces = 8;
constexpr double patience = 0.9;

constexpr int tile = 16;
constexpr int samples_per_pass = 8;
constexpr int default_samples = 64;

/// Follows branches by roulette and adds what they see to one sample of a pixel.
class Sampler {
public:
    Sampler(const Film& film, const WavelengthSampler& wavelengths, int max_hits)
        : bands_(film.bands()),
          components_(film.components()),
          max_hits_(max_hits),
          wavelengths_(wavelengths),
          sample(static_cast<std::size_t>(film.channels() * film.components())) {}

    void begin(std::uint64_t seed, double u) {
        random_ = Random(seed);
        draw_ = wavelengths_.draw(u);
        std::fill(sample.begin(), sample.end(), 0.0);
    }
    [[nodiscard]] double wavelength_nm() const { return draw_.wavelength_nm; }

    bool admit(Branch& b) {
        double survival = std::min(1.0, b.weight / (b.gem < 0 ? outside_weight : roulette_weight));
        if (b.hits > patient_hits || b.bounces > patient_bounces)
            survival = std::min(survival, patience);
        if (survival >= 1) return true;
        if (!(random_.uniform() < survival)) return false;
        if (b.diffused) {
            b.response = (1 / survival) * b.response;
            b.weight /= survival;
        } else {
            b.scale(1 / survival);
        }
        return true;
    }
    [[nodiscard]] bool may_meet(const Branch& b) const {
        return max_hits_ == 0 || b.hits < max_hits_;
    }
    void lose(const Stokes& response) { dropped += response.s0; }
    void absorb(const Stokes& response) { absorbed += response.s0; }

    void see(const Emitter& light, const Stokes& seen, bool one_wavelength) {
        if (one_wavelength) return see_at_wavelength(light.radiance(draw_.wavelength_nm), seen);
        for (int c = 0; c < 3; ++c) add(c, light.rgb[static_cast<std::size_t>(c)], seen);
        for (int b = 0; b < bands_.count; ++b) {
            add(3 + b, light.bands[static_cast<std::size_t>(b)], seen);
        }
    }
    void see_at_wavelength(double radiance, const Stokes& seen) {
        for (int c = 0; c < 3; ++c) add(c, radiance * draw_.rgb[static_cast<std::size_t>(c)], seen);
        if (bands_.count > 0) {
            add(3 + bands_.of(draw_.wavelength_nm), radiance * draw_.per_density / bands_.width(),
                seen);
        }
    }
    [[nodiscard]] int diffuse_rays(const Branch&) const { return 1; }
    std::pair<double, double> light_point() { return diffuse_point(0); }
    std::pair<double, double> diffuse_point(int) {
        const double u = random_.uniform();
        return {u, random_.uniform()};
    }

private:
    void add(int channel, double value, const Stokes& seen) {
        double* at = &sample[static_cast<std::size_t>(channel * components_)];
        at[0] += value * seen.s0;
        if (components_ == 4) {
            at[1] += value * seen.s1;
            at[2] += value * seen.s2;
            at[3] += value * seen.s3;
        }
    }

    Bands bands_;
    int components_, max_hits_;
    const WavelengthSampler& wavelengths_;
    WavelengthSampler::Draw draw_{};
    Random random_{0};

public:
    std::vector<double> sample;
    double dropped = 0, absorbed = 0;
};

struct Worker {
    Sampler sampler;
    Walker<Sampler> walker;
    std::uint64_t bad = 0;
};

void check(const Scene& scene, const RenderOptions& o) {
    constexpr int largest = 65536, most_bands = 400;
    const auto in = [](int v, int low, int high) { return v >= low && v <= high; };
    if (!in(o.width, 1, largest) || !in(o.height, 1, largest)) {
        throw Error("the picture's size must be between 1x1 and 65536x65536 pixels");
    }
    if (o.samples < 0 || o.threads < 0) throw Error("samples and threads must not be negative");
    if (!(o.error >= 0) || !(o.seconds >= 0) || !std::isfinite(o.error) ||
        !std::isfinite(o.seconds)) {
        throw Error("error and time must be finite and not negative");
    }
    if (!in(o.bands, 0, most_bands)) throw Error("the number of bands must be between 0 and 400");
    for (const auto& problems : {faults(scene), camera_faults(scene)}) {
        if (!problems.empty()) throw Error(problems.front());
    }
}

}  // namespace

Rendering render(const Scene& scene, const RenderOptions& options,
                 const ProgressCallback& progress) {
    check(scene, options);
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const int samples = options.samples == 0 && options.error == 0 && options.seconds == 0
                            ? default_samples
                            : options.samples;

    const World world(scene);
    const Palette palette(scene, options.bands);
    const WavelengthSampler wavelengths(options.bands > 0);
    Film film(options.width, options.height, options.bands, options.stokes);
    tbb::enumerable_thread_specific<Worker> workers([&] {
        return Worker{Sampler(film, wavelengths, scene.max_trace_level),
                      Walker<Sampler>(world, palette, false)};
    });
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);

    const int across = (options.width + tile - 1) / tile, down = (options.height + tile - 1) / tile;
    const int tiles = across * down;
    // Per tile, so that sums do not depend on the threads.
    std::vector<double> dropped(static_cast<std::size_t>(tiles), 0.0), absorbed = dropped;
    std::vector<std::uint64_t> paths(static_cast<std::size_t>(tiles), 0);

    const auto render_tile = [&](int index, int first_sample, int count) {
        Worker& w = workers.local();
        const int x0 = index % across * tile, y0 = index / across * tile;
        for (int y = y0; y < std::min(y0 + tile, options.height); ++y) {
            for (int x = x0; x < std::min(x0 + tile, options.width); ++x) {
                const std::uint64_t pixel =
                    mixed(mixed(options.seed) + static_cast<std::uint64_t>(y) * 65536u +
                          static_cast<std::uint64_t>(x));
                for (int i = first_sample; i < first_sample + count; ++i) {
                    const auto number = static_cast<std::uint64_t>(i);
                    const CameraSample at = camera_sample(pixel, number);
                    w.sampler.begin(mixed(pixel ^ mixed(number)), at.wavelength);
                    w.sampler.dropped = w.sampler.absorbed = 0;
                    const LensSample lens = lens_sample(pixel, number);
                    const auto branch = camera_branch(scene.camera, (x + at.x) / options.width,
                                                      (y + at.y) / options.height, lens.a, lens.b);
                    if (branch) w.walker.walk(*branch, w.sampler.wavelength_nm(), w.sampler);
                    if (!film.add(x, y, w.sampler.sample)) ++w.bad;
                    dropped[static_cast<std::size_t>(index)] += w.sampler.dropped;
                    absorbed[static_cast<std::size_t>(index)] += w.sampler.absorbed;
                    ++paths[static_cast<std::size_t>(index)];
                }
                if ((first_sample + count) % samples_per_pass == 0) film.end_pass(x, y);
            }
        }
    };

    RenderReport report;
    Progress state;
    // Tiles go out in batches so that the caller hears from us a few times a second.
    int batch = 4 * arena.max_concurrency();
    bool enough = false;
    while (!report.interrupted && !enough) {
        // Against the clock the first pass goes by single samples, to have a whole picture soon.
        int count = options.seconds > 0 && report.samples < samples_per_pass ? 1 : samples_per_pass;
        if (samples > 0) count = std::min(count, samples - report.samples);
        int end = 0;
        for (int begin = 0; begin < tiles && !report.interrupted; begin = end) {
            end = std::min(begin + batch, tiles);
            const double before = seconds();
            arena.execute([&] {
                tbb::parallel_for(
                    begin, end, [&](int t) { render_tile(t, report.samples, count); },
                    tbb::simple_partitioner());
            });
            const double took = seconds() - before;
            state.seconds = seconds();
            double done = 0;
            const double passes = report.samples + count * static_cast<double>(end) / tiles;
            if (samples > 0) done = passes / samples;
            if (options.seconds > 0) done = std::max(done, state.seconds / options.seconds);
            if (options.error > 0 && state.error > 0) {
                done = std::max(done, std::min(1.0, options.error * options.error /
                                                        (state.error * state.error)) *
                                          passes / std::max(1, report.samples));
            }
            state.done = std::min(1.0, done);
            if (progress && !progress(state)) report.interrupted = true;
            if (options.seconds > 0 && state.seconds >= options.seconds && report.samples > 0)
                break;
            if (took < 0.1) batch = std::min(2 * batch, tiles);
        }
        if (end == tiles) report.samples += count;
        report.error = state.error = film.error();
        state.samples = report.samples;
        enough = (samples > 0 && report.samples >= samples) ||
                 (options.seconds > 0 && seconds() >= options.seconds) ||
                 (options.error > 0 && report.error <= options.error &&
                  report.samples >= 2 * samples_per_pass);
    }

    for (const double d : dropped) report.dropped += d;
    for (const double a : absorbed) report.absorbed += a;
    for (const std::uint64_t n : paths) report.paths += n;
    if (report.paths > 0) {
        report.dropped /= static_cast<double>(report.paths);
        report.absorbed /= static_cast<double>(report.paths);
    }
    for (const Worker& w : workers) {
        report.events += w.walker.events();
        report.bad_samples += w.bad;
    }
    report.seconds = seconds();
    Rendering out{film.image(), report};
    auto& m = out.image.metadata;
    m["scene"] = scene.title;
    m["seed"] = std::to_string(options.seed);
    m["samples"] = std::to_string(report.samples);
    const auto number = [](double v) {
        std::ostringstream text;
        text << v;
        return text.str();
    };
    m["error estimate"] = report.error > 0 ? number(report.error) : "unknown";
    m["dropped energy"] = number(report.dropped);
    if (report.absorbed > 0) m["absorbed energy"] = number(report.absorbed);
    m["samples left out"] = std::to_string(report.bad_samples);
    m["version"] = ICESPAR_VERSION;
    return out;
}

}  // namespace icespar
