// Where in the picture something may stand between the camera and a stone.
#pragma once

#include <vector>

#include "beams/footprint.hpp"
#include "render/world.hpp"

namespace icespar {

class Visibility {
public:
    Visibility(const World& world, int gem, int width, int height);

    /// False: nothing hides any of the stone in this pixel. True: something may.
    [[nodiscard]] bool doubtful(int x, int y) const {
        for (const Frame& frame : before_) {
            if (frame.holds(x, y)) return true;
        }
        return false;
    }

private:
    std::vector<Frame> before_;
};

}  // namespace icespar
