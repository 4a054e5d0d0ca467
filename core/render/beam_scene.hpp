// Where in the picture beams may enter which stone.
#pragma once

#include <vector>

#include "beams/footprint.hpp"
#include "render/needs.hpp"
#include "render/visibility.hpp"
#include "render/world.hpp"

namespace icespar {

/// What all workers share: stones laid out for beams, and where each is seen.
class BeamScene {
public:
    BeamScene(const World& world, const Needs& needs, int width, int height);

    /// Along a square of pixels that are best followed together.
    [[nodiscard]] int block_side(int samples) const;

    enum Kind { by_rays = -2, sky = -1 };
    /// Whether a single pass can tell its own error.
    [[nodiscard]] bool tells_error() const;

    /// The stone that beams may enter from this pixel. by_rays: there is none but other things, or
    /// several, or something may stand in front of it.
    [[nodiscard]] int stone_at(int x, int y) const;

    static constexpr int most_across = 4;  ///< pixels of a block

    struct Stones {
        std::vector<FacetSearch> facets;
        std::vector<Footprint> footprints;
        std::vector<Visibility> visibility;
    };

private:
    friend class BeamEngine;
    const World& world_;
    const Needs& needs_;
    int width_, height_;
    Stones stones_;
};

}  // namespace icespar
