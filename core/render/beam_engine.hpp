// Pixels by beams: stones are followed fragment by fragment, whatever lies around them by rays.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "beams/footprint.hpp"
#include "render/needs.hpp"
#include "render/palette.hpp"
#include "render/sampler.hpp"
#include "render/world.hpp"

namespace icespar {

/// What all workers share: stones laid out for beams, and where each is seen.
class BeamScene {
public:
    BeamScene(const World& world, const Needs& needs, int width, int height);
    ~BeamScene();

    /// Along a square of pixels that are best followed together.
    [[nodiscard]] int block_side(int samples) const;

    enum Kind { by_rays = -2, sky = -1 };
    /// Whether a single pass can tell its own error.
    [[nodiscard]] bool tells_error() const;

    /// The stone that beams may enter from this pixel. by_rays: there is none but other things, or
    /// several, or something may stand in front of it.
    [[nodiscard]] int stone_at(int x, int y) const;

    struct Stones;

private:
    friend class BeamEngine;
    const World& world_;
    const Needs& needs_;
    int width_, height_;
    std::unique_ptr<Stones> stones_;
};

/// One worker's beams.
class BeamEngine {
public:
    BeamEngine(const BeamScene& scene, const Palette& palette, const WavelengthSampler& wavelengths,
               int bands);
    ~BeamEngine();
    BeamEngine(BeamEngine&&) noexcept;

    static constexpr int most_across = 4;  ///< pixels of a block

    /// Called with a pixel and the estimated variance of its luminance, or -1 where only other
    /// passes can tell, when the sampler holds what the pixel sees.
    using Seen = std::function<void(int x, int y, double variance)>;
    /// Follows the beams of these pixels, whose `stone_at` is `stone`, together, as far as they are
    /// worth at least 1 / samples of a pixel's light.
    void block(const Frame& pixels, int stone, int samples, std::uint64_t seed, Sampler& sampler,
               const Seen& seen);

    [[nodiscard]] std::uint64_t events() const;

    struct Kernels;

private:
    std::unique_ptr<Kernels> kernels_;
};

}  // namespace icespar
