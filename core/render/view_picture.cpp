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

/// A picture by all parts of the spectrum that were done.
struct Drawn {
    PaintedPart whole;
    int wavelengths = 0;
    std::vector<double> pixels;
    double error = 0;  ///< relative, of its luminance

    /// The mean of two that know nothing of each other, by how sure they are.
    void add(const Drawn& other) {
        const double mine = 1 / (error * error), others = 1 / (other.error * other.error),
                     share = others / (mine + others);
        const auto mix = [&](double& a, double b) { a += share * (b - a); };
        for (std::size_t i = 0; i < pixels.size(); ++i) mix(pixels[i], other.pixels[i]);
        mix(whole.dropped, other.whole.dropped);
        mix(whole.absorbed, other.whole.absorbed);
        whole.beams += other.whole.beams;
        error = 1 / std::sqrt(mine + others);
    }
};

/// Draws pictures of one scene, as long as its caller wants.
class Drawing {
public:
    Drawing(const Scene& scene, const Palette& palette, const WavelengthSampler& wavelengths,
            const RenderOptions& options, const ProgressCallback& progress, const Film& film)
        : scene_(scene),
          palette_(palette),
          wavelengths_(wavelengths),
          progress_(progress),
          film_(film),
          arena_(options.threads > 0 ? options.threads : tbb::task_arena::automatic) {
        const Crystal& crystal = scene.gems[0].crystal;
        parts_ = crystal.dispersive() && options.samples > 0 ? options.samples : parts_of(crystal);
        batches_ = (parts_ + ViewPainter::batch - 1) / ViewPainter::batch;
        if (options.error > 0 && options.seconds == 0) first_pass_ = 0.9;
    }

    /// What is known between passes towards an error.
    void tell(double error, double wanted) {
        state_.error = error;
        const double share = std::min(1.0, wanted / error * wanted / error);
        state_.done = std::max(state_.done, first_pass_ + (1 - first_pass_) * share);
    }

    [[nodiscard]] bool stopped() const { return stop_; }

    /// Other passes have other samples of the rest.
    Drawn draw(const RenderOptions& options, int pass) {
        const ViewPainter painter(scene_, palette_, wavelengths_, options, film_, pass);
        Raster sum = painter.raster();
        Drawn out;
        const auto go_on = [&] { return this->go_on(); };
        bool begun = false;
        int done = 0;
        while (done < batches_ && go_on()) {
            begun = true;
            if (!add(painter, done, go_on, sum, out)) break;
            ++done;
        }
        if (begun && done == 0) {
            RenderOptions coarse = options;
            coarse.error = 0.05;
            coarse.seconds = 0;
            add({scene_, palette_, wavelengths_, coarse, film_, pass}, 0, {}, sum, out);
        }
        if (out.wavelengths > 0) finish(painter, sum, out);
        return out;
    }

private:
    // Traces may take long: this thread looks at the caller's wish between their beams.
    bool go_on() {
        if (std::this_thread::get_id() != own_thread_) return !stop_;
        state_.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (progress_ && !progress_(state_)) stop_ = true;
        return !stop_;
    }

    bool add(const ViewPainter& by, int b, const std::function<bool()>& asks, Raster& sum,
             Drawn& out) {
        // Parts with `batches` - 1 between them; batches that follow one another are far apart.
        const int first = spread(b, batches_), count = (parts_ - first + batches_ - 1) / batches_;
        std::vector<Raster> rasters(static_cast<std::size_t>(count), by.raster());
        std::vector<PaintedPart> painted(rasters.size());
        arena_.execute([&] {
            tbb::parallel_for(0, count, [&](int i) {
                const auto at = static_cast<std::size_t>(i);
                painted[at] = by.paint(first + i * batches_, parts_, asks, rasters[at]);
            });
        });
        // Some wavelengths of what was stopped lack more light than others.
        if (stop_ && asks && parts_ > 1) return false;
        for (std::size_t i = 0; i < rasters.size(); ++i) {
            sum.add(rasters[i]);
            out.whole.add(painted[i]);
        }
        out.wavelengths += count;
        state_.done = std::max(state_.done, first_pass_ * out.wavelengths / parts_);
        return true;
    }

    /// As bright together as all wavelengths are.
    void finish(const ViewPainter& painter, Raster& sum, Drawn& out) const {
        PaintedPart& whole = out.whole;
        std::vector<double> scale(whole.white.size(), 1.0);
        if (out.wavelengths < parts_) {
            const std::vector<double> white = painter.white();
            for (std::size_t c = 0; c < scale.size(); ++c) {
                constexpr double least = 0.02;  // of the light, for a channel to stand for all
                if (whole.white[c] > least * white[c]) scale[c] = white[c] / whole.white[c];
            }
        }
        const double missing = static_cast<double>(parts_) / out.wavelengths;
        whole.dropped *= missing;
        whole.absorbed *= missing;
        sum.finish();
        double light = 0;
        const auto step = static_cast<std::size_t>(film_.components());
        for (int y = 0; y < film_.height(); ++y) {
            for (int x = 0; x < film_.width(); ++x) {
                const auto pixel = sum.pixel(x, y);
                const std::size_t first = out.pixels.size();
                for (std::size_t v = 0; v < pixel.size(); ++v) {
                    out.pixels.push_back(scale[v / step] * pixel[v]);
                }
                const double* p = &out.pixels[first];
                light += xyz_from_rgb({p[0], p[step], p[2 * step]})[1];
            }
        }
        const double pixels = static_cast<double>(film_.width()) * film_.height();
        if (light > 0) out.error = missing * std::sqrt(whole.variance * pixels) / light;
    }

    const Scene& scene_;
    const Palette& palette_;
    const WavelengthSampler& wavelengths_;
    const ProgressCallback& progress_;
    const Film& film_;
    tbb::task_arena arena_;
    int parts_ = 1, batches_ = 1;
    Progress state_;
    double first_pass_ = 1;  ///< of what is to be done: others may be needed to reach an error
    std::atomic<bool> stop_{false};
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::thread::id own_thread_ = std::this_thread::get_id();
};

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
    Drawing drawing(scene, palette, wavelengths, options, progress, film);
    Drawn drawn = drawing.draw(options, 0);
    ViewPicture out;
    out.wavelengths = drawn.wavelengths;
    // How much error a sample of a size leaves is not known before: what is missing is added.
    constexpr int most_passes = 16;
    const double told = drawn.error / options.error;
    for (int pass = 1; pass < most_passes; ++pass) {
        const bool wanted = options.error > 0 && options.seconds == 0;
        if (!wanted || drawing.stopped() || !(drawn.error > options.error)) break;
        constexpr double margin = 0.95;
        drawing.tell(drawn.error, options.error);
        const double ratio = options.error / drawn.error;
        RenderOptions rest = options;
        rest.error = margin * options.error / std::sqrt(1 - ratio * ratio) / told;
        const Drawn more = drawing.draw(rest, pass);
        if (drawing.stopped()) break;
        drawn.add(more);
    }
    out.interrupted = drawing.stopped();
    out.beams = drawn.whole.beams;
    out.dropped = drawn.whole.dropped;
    out.absorbed = drawn.whole.absorbed;
    out.error = drawn.error;
    if (out.wavelengths == 0) return out;
    const auto values = static_cast<std::size_t>(film.channels() * film.components());
    auto at = drawn.pixels.begin();
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) {
            film.add(x, y, {at, at + static_cast<std::ptrdiff_t>(values)});
            at += static_cast<std::ptrdiff_t>(values);
        }
    }
    return out;
}

}  // namespace icespar
