// One trace of the view, or one a wavelength, in batches that each span the spectrum.
#include "render/view_picture.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <thread>

#include "render/view_painter.hpp"

namespace icespar {
namespace {

/// Numbers from 0 to `count` - 1 in an order in which neighbours are far apart.
int spread(int i, int count) {
    int step = std::max(1, static_cast<int>(0.618 * count));
    while (std::gcd(step, count) > 1) ++step;
    return static_cast<int>((count / 2 + static_cast<long long>(i) * step) % count);
}

}  // namespace

std::string view_obstacle(const Scene& scene) {
    if (scene.camera.kind != Camera::Kind::orthographic) return "the camera is not orthographic";
    if (scene.camera.lens_radius > 0) return "the camera has a lens";
    if (scene.gems.size() != 1 || !scene.things.empty())
        return "there is more than one stone alone";
    const auto& fade = scene.gems[0].crystal.fade;
    if (fade && !fade->exponential()) return "the stone's attenuation is not exponential";
    if (scene.gems[0].crystal.active()) return "the stone turns polarisation";
    return {};
}

ViewPicture add_view(const Scene& scene, const Palette& palette,
                     const WavelengthSampler& wavelengths, const RenderOptions& options,
                     const ProgressCallback& progress, Film& film) {
    const auto start = std::chrono::steady_clock::now();
    const ViewPainter painter(scene, palette, wavelengths, options, film);
    const Crystal& crystal = scene.gems[0].crystal;
    const int parts =
        crystal.dispersive() && options.samples > 0 ? options.samples : parts_of(crystal);
    Progress state;
    ViewPicture out;
    // Traces may take long: this thread looks at the caller's wish between their beams.
    std::atomic<bool> stop{false};
    const auto own_thread = std::this_thread::get_id();
    const auto go_on = [&] {
        if (std::this_thread::get_id() != own_thread) return !stop;
        state.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (progress && !progress(state)) stop = true;
        return !stop;
    };
    Raster sum = painter.raster();
    PaintedPart whole;
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    const int batches = (parts + ViewPainter::batch - 1) / ViewPainter::batch;
    const auto add = [&](const ViewPainter& by, int b, const std::function<bool()>& asks) {
        // Parts with `batches` - 1 between them; batches that follow one another are far apart.
        const int first = spread(b, batches), count = (parts - first + batches - 1) / batches;
        std::vector<Raster> rasters(static_cast<std::size_t>(count), by.raster());
        std::vector<PaintedPart> painted(rasters.size());
        arena.execute([&] {
            tbb::parallel_for(0, count, [&](int i) {
                const auto at = static_cast<std::size_t>(i);
                painted[at] = by.paint(first + i * batches, parts, asks, rasters[at]);
            });
        });
        // Some wavelengths of what was stopped lack more light than others.
        if (stop && asks && parts > 1) return false;
        for (std::size_t i = 0; i < rasters.size(); ++i) {
            sum.add(rasters[i]);
            whole.add(painted[i]);
        }
        out.wavelengths += count;
        state.done = static_cast<double>(out.wavelengths) / parts;
        return true;
    };
    int done = 0;
    bool begun = false;
    while (done < batches && go_on()) {
        begun = true;
        if (!add(painter, done, go_on)) break;
        ++done;
    }
    if (begun && done == 0) {
        RenderOptions coarse = options;
        coarse.error = 0.05;
        coarse.seconds = 0;
        add({scene, palette, wavelengths, coarse, film}, 0, {});
    }
    out.interrupted = stop;
    out.beams = whole.beams;
    if (out.wavelengths == 0) return out;
    std::vector<double> scale(whole.white.size(), 1.0);
    if (out.wavelengths < parts) {
        const std::vector<double> white = painter.white();
        for (std::size_t c = 0; c < scale.size(); ++c) {
            constexpr double least = 0.02;  // of the light, for a channel to stand for all of it
            if (whole.white[c] > least * white[c]) scale[c] = white[c] / whole.white[c];
        }
    }
    const double missing = static_cast<double>(parts) / out.wavelengths;
    out.dropped = missing * whole.dropped;
    out.absorbed = missing * whole.absorbed;
    sum.finish();
    std::vector<double> sample;
    double light = 0;
    const auto step = static_cast<std::size_t>(film.components());
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) {
            const auto pixel = sum.pixel(x, y);
            sample.assign(pixel.begin(), pixel.end());
            for (std::size_t v = 0; v < sample.size(); ++v) sample[v] *= scale[v / step];
            light += xyz_from_rgb({sample[0], sample[step], sample[2 * step]})[1];
            film.add(x, y, sample);
        }
    }
    const double pixels = static_cast<double>(film.width()) * film.height();
    if (light > 0) out.error = missing * std::sqrt(whole.variance * pixels) / light;
    return out;
}

}  // namespace icespar
