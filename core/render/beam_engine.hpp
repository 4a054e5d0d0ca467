// Pixels by beams: stones are followed fragment by fragment, whatever lies around them by rays.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "beams/footprint.hpp"
#include "render/beam_scene.hpp"
#include "render/palette.hpp"
#include "render/sampler.hpp"

namespace icespar {

/// One worker's beams.
class BeamEngine {
public:
    BeamEngine(const BeamScene& scene, const Palette& palette, const WavelengthSampler& wavelengths,
               int bands);
    ~BeamEngine();
    BeamEngine(BeamEngine&&) noexcept;

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
