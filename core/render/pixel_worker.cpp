// A pixel by beams where they apply to it, otherwise sample by sample.
#include "render/pixel_worker.hpp"

#include "render/camera.hpp"

namespace icespar {

PreparedScene::PreparedScene(const Scene& s, const Needs& n, int w, int h, int bands)
    : scene(s),
      needs(n),
      width(w),
      height(h),
      world(s, n.tree),
      palette(s, bands),
      wavelengths(bands > 0) {
    if (needs.engine == Engine::beams) beams.emplace(world, needs, width, height);
}

PixelWorker::PixelWorker(const PreparedScene& p, const Film& film)
    : prepared_(p),
      sampler_(film, p.wavelengths, p.scene.max_trace_level),
      walker_(p.world, p.palette, p.needs, false) {
    if (p.beams) beams_.emplace(*p.beams, p.palette, p.wavelengths, film.bands().count);
}

void PixelWorker::add(Film& film, const Frame& pixels, std::uint64_t seed, int first, int count,
                      bool ends_pass, Account& account) {
    const auto stone_at = [&](int x, int y) {
        return beams_ ? prepared_.beams->stone_at(x, y) : BeamScene::by_rays;
    };
    const int stone = stone_at(pixels.x0, pixels.y0);
    bool alike = stone != BeamScene::by_rays;
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        for (int x = pixels.x0; x < pixels.x1; ++x) alike = alike && stone_at(x, y) == stone;
    }
    const auto own_seed = [&](int x, int y) {
        return mixed(mixed(seed) + static_cast<std::uint64_t>(y) * 65536u +
                     static_cast<std::uint64_t>(x));
    };
    const auto by_beams = [&](const Frame& some, int which) {
        sampler_.dropped = sampler_.absorbed = 0;
        const std::uint64_t own =
            mixed(own_seed(some.x0, some.y0) ^ mixed(static_cast<std::uint64_t>(first)));
        beams_->block(some, which, count, own, sampler_, [&](int x, int y, double variance) {
            if (!film.add(x, y, sampler_.sample, count)) ++bad_;
            film.end_pass(x, y, variance);
        });
        account.dropped += count * sampler_.dropped;
        account.absorbed += count * sampler_.absorbed;
        account.paths +=
            static_cast<std::uint64_t>(some.count()) * static_cast<std::uint64_t>(count);
    };
    if (alike) return by_beams(pixels, stone);
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        for (int x = pixels.x0; x < pixels.x1; ++x) {
            const int own = stone_at(x, y);
            if (own != BeamScene::by_rays) {
                by_beams({x, y, x + 1, y + 1}, own);
            } else {
                add_rays(film, x, y, own_seed(x, y), first, count, ends_pass, account);
            }
        }
    }
}

void PixelWorker::add_rays(Film& film, int x, int y, std::uint64_t pixel, int first, int count,
                           bool ends_pass, Account& account) {
    // A pixel by beams before this one has left its own.
    sampler_.inside_threshold = roulette_weight;
    sampler_.outside_threshold = outside_weight;
    for (int i = first; i < first + count; ++i) {
        const auto number = static_cast<std::uint64_t>(i);
        const CameraSample at = camera_sample(pixel, number);
        sampler_.dropped = sampler_.absorbed = 0;
        sampler_.begin(mixed(pixel ^ mixed(number)));
        sampler_.at_wavelength(at.wavelength);
        const LensSample lens = lens_sample(pixel, number);
        auto branch = camera_branch(prepared_.scene.camera, (x + at.x) / prepared_.width,
                                    (y + at.y) / prepared_.height, lens.a, lens.b);
        if (branch) {
            branch->one_wavelength = prepared_.needs.forced.wavelengths;
            walker_.walk(*branch, sampler_.wavelength_nm(), sampler_);
        }
        if (!film.add(x, y, sampler_.sample, 1)) ++bad_;
        account.dropped += sampler_.dropped;
        account.absorbed += sampler_.absorbed;
        ++account.paths;
    }
    if (ends_pass) film.end_pass(x, y);
}

std::uint64_t PixelWorker::events() const {
    return walker_.events() + (beams_ ? beams_->events() : 0);
}

}  // namespace icespar
