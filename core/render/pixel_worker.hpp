// One worker's way from a pixel to the film, by the kernels that the scene needs.
#pragma once

#include <optional>

#include "render/beam_engine.hpp"
#include "render/needs.hpp"
#include "render/walker.hpp"

namespace icespar {

/// A scene made ready; all workers share it.
struct PreparedScene {
    PreparedScene(const Scene& scene, const Needs& needs, int width, int height, int bands);

    const Scene& scene;
    Needs needs;
    int width, height;
    World world;
    Palette palette;
    WavelengthSampler wavelengths;
    std::optional<BeamScene> beams;
};

class PixelWorker {
public:
    PixelWorker(const PreparedScene& prepared, const Film& film);

    /// What a run of samples lost, to be added in an order that no thread decides.
    struct Account {
        double dropped = 0, absorbed = 0;
        std::uint64_t paths = 0;
    };
    /// Adds samples `first` to first + count of these few pixels, which are the same whoever makes
    /// them; `ends_pass`: together with what came before they cover pixel and spectrum evenly.
    void add(Film& film, const Frame& pixels, std::uint64_t seed, int first, int count,
             bool ends_pass, Account& account);

    [[nodiscard]] std::uint64_t events() const;
    /// Samples that were not finite.
    [[nodiscard]] std::uint64_t bad() const { return bad_; }

private:
    void add_rays(Film& film, int x, int y, std::uint64_t pixel, int first, int count,
                  bool ends_pass, Account& account);

    const PreparedScene& prepared_;
    Sampler sampler_;
    Walker<Sampler> walker_;
    std::optional<BeamEngine> beams_;
    std::uint64_t bad_ = 0;
};

}  // namespace icespar
