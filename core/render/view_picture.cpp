// One trace of the view, or one a wavelength; each exit's light is looked up once and its polygon
// drawn with exact coverage.
#include "render/view_picture.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>

#include "render/sampler.hpp"
#include "render/sky_light.hpp"
#include "render/stone_optics.hpp"
#include "views/raster.hpp"
#include "views/view.hpp"

namespace icespar {
namespace {

constexpr int default_wavelengths = 64;
/// Traced at once, whatever the number of threads, and added in order.
constexpr int batch = 8;

/// From the picture of a view, in the stone's units, to pixels from the top left.
class PixelMap {
public:
    PixelMap(const Camera& camera, int width, int height, const PictureFrame& frame) {
        const double volume = dot(camera.direction, cross(camera.right, camera.up));
        const Vec3 u = (width / volume) * cross(camera.up, camera.direction),
                   v = (-height / volume) * cross(camera.direction, camera.right);
        const Vec3 middle = frame.centre - camera.location;
        x_ = {dot(middle, u) + 0.5 * width, dot(frame.right, u), dot(frame.up, u)};
        y_ = {dot(middle, v) + 0.5 * height, dot(frame.right, v), dot(frame.up, v)};
    }
    [[nodiscard]] Point2 of(const Point2& p) const { return {x_(p), y_(p)}; }
    /// Pixels per unit of area.
    [[nodiscard]] double scale() const { return std::abs(x_.dx * y_.dy - x_.dy * y_.dx); }

private:
    Affine x_, y_;
};

/// The same lights, with the colour of what they have between two of the sampler's wavelengths: it
/// is exact however few there are.
Palette between(Palette palette, double u0, double u1, const WavelengthSampler& wavelengths,
                const Bands& bands) {
    constexpr int draws = 32;
    const double share = (u1 - u0) / draws;
    std::vector<WavelengthSampler::Draw> at;
    for (int i = 0; i < draws; ++i) at.push_back(wavelengths.draw(u0 + (i + 0.5) * share));
    const auto restricted = [&](Emitter& e) {
        e.rgb = {};
        std::fill(e.bands.begin(), e.bands.end(), 0.0);
        for (const WavelengthSampler::Draw& d : at) {
            const double value = share * e.radiance(d.wavelength_nm);
            for (std::size_t c = 0; c < 3; ++c) e.rgb[c] += value * d.rgb[c];
            if (bands.count == 0) continue;
            e.bands[static_cast<std::size_t>(bands.of(d.wavelength_nm))] +=
                value * d.per_density / bands.width();
        }
    };
    for (Emitter* e : {&palette.below, &palette.above, &palette.illuminant}) restricted(*e);
    for (Emitter& e : palette.sky) restricted(e);
    for (Emitter& e : palette.discs) restricted(e);
    return palette;
}

class ViewPainter {
public:
    ViewPainter(const Scene& scene, const Palette& palette, const WavelengthSampler& wavelengths,
                const RenderOptions& options, const Film& film)
        : scene_(scene),
          palette_(palette),
          wavelengths_(wavelengths),
          options_(options),
          film_(film),
          values_(film.channels() * film.components()) {
        const Camera& camera = scene.camera;
        const Vec3 d = normalised(camera.direction);
        view_ = {d, cross(camera.right - dot(camera.right, d) * d, d)};
    }

    [[nodiscard]] Raster raster() const { return {film_.width(), film_.height(), values_}; }

    /// What light of part `i` of `parts` of the spectrum makes of the picture: all of it travels as
    /// that of the part's middle.
    ViewPicture paint(int i, int parts, const std::function<bool()>& go_on, Raster& raster) const {
        const double share = 1.0 / parts;
        Sampler sampler(film_, wavelengths_, 0);
        sampler.at_wavelength((i + 0.5) * share);
        const Palette colours =
            parts == 1 ? palette_
                       : between(palette_, i * share, (i + 1) * share, wavelengths_, film_.bands());
        ViewOptions options;
        options.bound = options_.error > 0     ? 0.25 * options_.error
                        : options_.seconds > 0 ? 1e-5
                                               : 1e-3;
        options.max_beams = 8'000'000;
        options.seconds = options_.seconds * share;
        options.max_hits = scene_.max_trace_level;
        options.outlines = true;
        options.weights = film_.components() == 4 ? Weights::stokes : Weights::intensity;
        options.go_on = go_on;
        const Gem& gem = scene_.gems[0];
        const StoneOptics optics(gem.crystal, sampler.wavelength_nm());
        const Exits part = trace_view(gem.stone, optics.medium(), view_, options);
        const Exits exits = part.expanded();
        const PixelMap map(scene_.camera, film_.width(), film_.height(), exits.frame);

        const auto light = [&](const Vec3& direction, const Stokes& weight) {
            sampler.begin(0);
            sky_light(scene_.environment, colours, direction,
                      [&](const Emitter& emitter, double strength) {
                          sampler.see(emitter, strength * weight, false);
                      });
        };
        light(exits.frame.direction, {1, 0, 0, 0});
        const std::vector<double> background = sampler.sample;
        const double right = film_.width(), bottom = film_.height();
        const Point2 corners[] = {{0, 0}, {right, 0}, {right, bottom}, {0, bottom}};
        raster.add(corners, background);
        Polygon polygon;
        for (std::size_t e = 0; e < exits.size(); ++e) {
            light(exits.direction[e], exits.weight[e]);
            // What the stone's outside mirrors stands before the background.
            if (exits.hits[e] == 1) {
                for (std::size_t v = 0; v < background.size(); ++v) {
                    sampler.sample[v] -= background[v];
                }
            }
            polygon.clear();
            for (std::size_t c = exits.outline[e]; c < exits.outline[e + 1]; ++c) {
                polygon.push_back(map.of(exits.corners[c]));
            }
            raster.add(polygon, sampler.sample);
        }
        ViewPicture out;
        out.untraced = share * exits.untraced * map.scale() / (right * bottom);
        out.beams = exits.beams;
        return out;
    }

private:
    const Scene& scene_;
    const Palette& palette_;
    const WavelengthSampler& wavelengths_;
    const RenderOptions& options_;
    const Film& film_;
    int values_;
    ParallelView view_;
};

}  // namespace

std::string view_obstacle(const Scene& scene) {
    const Environment& sky = scene.environment;
    if (scene.camera.kind != Camera::Kind::orthographic) return "the camera is not orthographic";
    if (scene.camera.lens_radius > 0 || scene.camera.analyser)
        return "the camera has a lens or an analyser";
    if (scene.gems.size() != 1 || !scene.things.empty())
        return "there is more than one stone alone";
    if (scene.gems[0].crystal.absorbs()) return "the stone absorbs";
    if (scene.gems[0].crystal.active()) return "the stone turns polarisation";
    if (sky.state != Stokes{1, 0, 0, 0} || sky.formulas.size() > 1) return "the sky is polarised";
    return {};
}

ViewPicture add_view(const Scene& scene, const Palette& palette,
                     const WavelengthSampler& wavelengths, const RenderOptions& options,
                     const ProgressCallback& progress, Film& film) {
    const auto start = std::chrono::steady_clock::now();
    const ViewPainter painter(scene, palette, wavelengths, options, film);
    Progress state;
    ViewPicture out;
    const auto report = [&] {
        state.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (progress && !progress(state)) out.interrupted = true;
        return !out.interrupted;
    };
    Raster sum = painter.raster();
    if (!scene.gems[0].crystal.dispersive()) {
        const ViewPicture all = painter.paint(0, 1, report, sum);
        out.untraced = all.untraced;
        out.beams = all.beams;
    } else {
        out.wavelengths = options.samples > 0 ? options.samples : default_wavelengths;
        tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
        std::vector<Raster> rasters(batch, painter.raster());
        std::vector<ViewPicture> parts(batch);
        for (int done = 0; done < out.wavelengths && report(); done += batch) {
            const int count = std::min(batch, out.wavelengths - done);
            arena.execute([&] {
                tbb::parallel_for(0, count, [&](int i) {
                    const auto at = static_cast<std::size_t>(i);
                    rasters[at] = painter.raster();
                    parts[at] = painter.paint(done + i, out.wavelengths, {}, rasters[at]);
                });
            });
            for (int i = 0; i < count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                sum.add(rasters[at]);
                out.untraced += parts[at].untraced;
                out.beams += parts[at].beams;
            }
            state.done = static_cast<double>(done + count) / out.wavelengths;
        }
    }
    if (out.interrupted) return out;
    sum.finish();
    std::vector<double> sample;
    for (int y = 0; y < film.height(); ++y) {
        for (int x = 0; x < film.width(); ++x) {
            const auto pixel = sum.pixel(x, y);
            sample.assign(pixel.begin(), pixel.end());
            film.add(x, y, sample);
        }
    }
    return out;
}

}  // namespace icespar
