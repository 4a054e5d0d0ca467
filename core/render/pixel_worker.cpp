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

void PixelWorker::add(Film& film, int x, int y, std::uint64_t seed, int first, int count,
                      bool ends_pass, Account& account) {
    const std::uint64_t pixel =
        mixed(mixed(seed) + static_cast<std::uint64_t>(y) * 65536u + static_cast<std::uint64_t>(x));
    const auto begin = [&](int number) {
        sampler_.dropped = sampler_.absorbed = 0;
        return mixed(pixel ^ mixed(static_cast<std::uint64_t>(number)));
    };
    const auto end = [&](int weight) {
        if (!film.add(x, y, sampler_.sample, weight)) ++bad_;
        account.dropped += weight * sampler_.dropped;
        account.absorbed += weight * sampler_.absorbed;
        account.paths += static_cast<std::uint64_t>(weight);
    };

    const int stone = beams_ ? prepared_.beams->stone_at(x, y) : BeamScene::by_rays;
    if (stone != BeamScene::by_rays) {
        const double variance = beams_->pixel(x, y, stone, count, begin(first), sampler_);
        end(count);
        film.end_pass(x, y, variance);
        return;
    }
    // A pixel by beams before this one has left its own.
    sampler_.inside_threshold = roulette_weight;
    sampler_.outside_threshold = outside_weight;
    for (int i = first; i < first + count; ++i) {
        const auto number = static_cast<std::uint64_t>(i);
        const CameraSample at = camera_sample(pixel, number);
        sampler_.begin(begin(i));
        sampler_.at_wavelength(at.wavelength);
        const LensSample lens = lens_sample(pixel, number);
        auto branch = camera_branch(prepared_.scene.camera, (x + at.x) / prepared_.width,
                                    (y + at.y) / prepared_.height, lens.a, lens.b);
        if (branch) {
            branch->one_wavelength = prepared_.needs.forced.wavelengths;
            walker_.walk(*branch, sampler_.wavelength_nm(), sampler_);
        }
        end(1);
    }
    if (ends_pass) film.end_pass(x, y);
}

std::uint64_t PixelWorker::events() const {
    return walker_.events() + (beams_ ? beams_->events() : 0);
}

}  // namespace icespar
