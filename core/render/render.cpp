// Pictures: samples per pixel until a bound is reached, the same bits for any number of threads.
#include "render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <sstream>
#include <thread>

#include "math/error.hpp"
#include "render/effort.hpp"
#include "render/film.hpp"
#include "render/pixel_worker.hpp"
#include "render/view_picture.hpp"

namespace icespar {
namespace {

constexpr int samples_per_pass = 8;
constexpr int default_samples = 64;
/// Before that a tile's own error is no reason to leave it alone.
constexpr int least_samples = 4 * samples_per_pass;

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

/// Samples in the next pass by rays: eight; against the clock the first pass goes by single
/// samples, to have a whole picture soon.
int next_ray_pass(const RenderOptions& o, int done) {
    return o.seconds > 0 && done < samples_per_pass ? 1 : samples_per_pass;
}

/// The length of the next pass over that of all before, so that the error of both together is so
/// much less. Passes of n samples err by n^-slope, and count as n in the mean.
double longer_pass(double less, double slope) {
    constexpr double margin = 1.05, longest = 16;
    const auto left = [&](double length) {
        return std::sqrt(1 + std::pow(length, 2 - 2 * slope)) / (1 + length);
    };
    double length = 0.5;
    while (length < longest && left(length) * less * margin > 1) length *= 1.05;
    return length;
}

/// Error falls faster with one long pass of beams than with several short ones. Where a pass cannot
/// tell its own error, the first is a short one, and the difference tells.
int next_beam_pass(const RenderOptions& o, int done, int wanted, double error, bool tells_error) {
    constexpr double slope = 0.8;  // error falls as samples^-slope (bench/beams.cpp)
    if (done == 0) {
        if (wanted > 0 && tells_error) return wanted;
        return wanted > 0 ? std::max(1, wanted / 4) : samples_per_pass;
    }
    if (wanted > 0) return wanted;
    double factor = 2;
    if (o.error > 0 && error > 0) factor = longer_pass(error / o.error, slope);
    constexpr double most = 1 << 16;  // so that no pixel takes long
    return static_cast<int>(
        std::min(most, done * (o.seconds > 0 ? std::min(2.0, factor) : factor)));
}

}  // namespace

Needs needs_of(const Scene& scene, const RenderOptions& o) {
    Needs n = needs_of(scene, o.stokes, o.engine, o.forced);
    if (n.engine == Engine::exact && o.error > 0 && o.metric == ErrorMetric::largest) {
        n.exact_obstacle = "they tell the root mean square of the pixels' errors alone";
        n.engine = n.obstacle.empty() ? Engine::beams : Engine::rays;
    }
    return n;
}

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

    const Needs needs = needs_of(scene, options);
    if (options.engine == Engine::beams && !needs.obstacle.empty()) {
        throw Error("beams cannot make this picture: " + needs.obstacle +
                    "; choose the engine rays");
    }
    if (options.engine == Engine::exact && !needs.exact_obstacle.empty()) {
        throw Error("exact beams cannot make this picture: " + needs.exact_obstacle +
                    "; choose another engine");
    }
    const PreparedScene prepared(scene, needs, options.width, options.height, options.bands);
    const bool by_beams = needs.engine == Engine::beams;
    Film film(options.width, options.height, options.bands, needs.stokes);
    tbb::enumerable_thread_specific<PixelWorker> workers(
        [&] { return PixelWorker(prepared, film); });
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);

    const Tiles tiles{options.width, options.height};
    // Per tile, so that sums do not depend on the threads.
    std::vector<PixelWorker::Account> accounts(static_cast<std::size_t>(tiles.count()));
    std::vector<int> done(accounts.size());  // samples a pixel
    std::vector<int> active(done.size());
    std::iota(active.begin(), active.end(), 0);

    RenderReport report;
    Progress state;
    int most = 0, count = 0;  // samples a pixel of any tile: before this pass, and in it
    int side = 1;             // pixels along a block, in this pass
    std::atomic<int> tiles_done{0};
    const auto tell = [&] {
        state.seconds = seconds();
        const double passes =
            most + count * static_cast<double>(tiles_done) / static_cast<double>(active.size());
        state.done = samples > 0 ? passes / samples : 0;
        if (options.seconds > 0) {
            state.done = std::max(state.done, state.seconds / options.seconds);
        }
        if (options.error > 0 && state.error > 0) {
            const double ratio = options.error / state.error;
            state.done =
                std::max(state.done, std::min(1.0, ratio * ratio) * passes / std::max(1, most));
        }
        state.done = std::min(1.0, state.done);
        if (progress && !progress(state)) report.interrupted = true;
    };
    // Pixels may take long: bounds and interruption are looked at between them, by this thread.
    // The caller hears of its first tile, and then ten times a second.
    std::atomic<bool> stop{false};
    const auto own_thread = std::this_thread::get_id();
    double looked = 0;
    const auto look = [&](bool after_tile) {
        if (std::this_thread::get_id() != own_thread) return;
        if (seconds() - looked < (after_tile && looked == 0 ? 0 : 0.1)) return;
        tell();
        looked = state.seconds;
        const bool late = options.seconds > 0 && looked >= options.seconds && report.samples > 0;
        if (report.interrupted || late) stop = true;
    };

    const auto render_tile = [&](int tile) {
        PixelWorker& worker = workers.local();
        PixelWorker::Account& account = accounts[static_cast<std::size_t>(tile)];
        int& first = done[static_cast<std::size_t>(tile)];
        const bool ends_pass = by_beams || (first + count) % samples_per_pass == 0;
        tiles.visit(tile, side, [&](const Frame& pixels) {
            look(false);
            if (!stop) worker.add(film, pixels, options.seed, first, count, ends_pass, account);
            return !stop;
        });
        if (stop) return;
        first += count;
        ++tiles_done;
        look(true);
    };

    bool enough = false;
    if (needs.engine == Engine::exact) {
        const ViewPicture view =
            add_view(scene, prepared.palette, prepared.wavelengths, options, progress, film);
        enough = true;
        report.interrupted = view.interrupted;
        report.events = view.beams;
        report.samples = view.wavelengths;
        const double pixels = static_cast<double>(options.width) * options.height;
        report.paths = view.wavelengths > 0 ? static_cast<std::uint64_t>(pixels) : 0;
        report.dropped = view.dropped * pixels;
        report.absorbed = view.absorbed * pixels;
        report.error = view.error;
    }
    std::vector<double> variances;
    while (!report.interrupted && !enough) {
        count = by_beams ? next_beam_pass(options, most, samples, report.error,
                                          prepared.beams->tells_error())
                         : next_ray_pass(options, most);
        if (samples > 0) count = std::min(count, samples - most);
        tiles_done = 0;
        side = by_beams ? prepared.beams->block_side(count) : 1;
        arena.execute([&] {
            tbb::parallel_for(
                0, static_cast<int>(active.size()),
                [&](int i) { render_tile(active[static_cast<std::size_t>(i)]); },
                tbb::simple_partitioner());
        });
        tell();
        if (report.interrupted) stop = true;
        if (!stop) most += count;
        double sampled = 0;
        for (int t = 0; t < tiles.count(); ++t) {
            sampled += double(tiles.pixels(t)) * done[static_cast<std::size_t>(t)];
        }
        report.samples = state.samples =
            static_cast<int>(sampled / options.width / options.height + 0.5);
        variances = film.variances();
        const double mean = film.mean_luminance();
        report.error = state.error = relative_error(variances, mean, options.metric);
        constexpr int most_samples = 1 << 30;
        enough =
            (samples > 0 && most >= samples) || most >= most_samples ||
            (options.seconds > 0 && seconds() >= options.seconds) ||
            (options.error > 0 && report.error <= options.error && most >= 2 * samples_per_pass);
        if (options.error > 0 && report.error > 0 && most >= least_samples) {
            std::vector<int> rest =
                unfinished(tiles, variances, mean, done, options.error, options.metric);
            if (!rest.empty()) active = std::move(rest);
        }
    }

    for (const PixelWorker::Account& a : accounts) {
        report.dropped += a.dropped;
        report.absorbed += a.absorbed;
        report.paths += a.paths;
    }
    if (report.paths > 0) {
        report.dropped /= static_cast<double>(report.paths);
        report.absorbed /= static_cast<double>(report.paths);
    }
    for (const PixelWorker& w : workers) {
        report.events += w.events();
        report.bad_samples += w.bad();
    }
    report.seconds = seconds();
    report.engine = needs.engine;
    Rendering out{film.image(variances), report};
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
