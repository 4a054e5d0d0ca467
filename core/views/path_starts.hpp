// On which of the beams that exact tracing leaves in the queue paths of light begin, for all of
// them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/random.hpp"

namespace icespar {

/// A systematic sample of beams by their weights: these are added up from a random start, and every
/// whole multiple of the spacing that is passed is a path that carries so much. So no light is
/// lost, to rounding, and each beam's is expected to go on. Neighbours begin on beams that have
/// much in common: of each two in a row one belongs to the first group of a pair and one to the
/// second.
class PathStarts {
public:
    static constexpr int groups = 128;              ///< even
    static constexpr double fewest = 4.0 * groups;  ///< that tell how they differ

    /// About so many paths for so much light.
    PathStarts(double light, double paths, Random& random)
        : random_(&random),
          spacing_(light / std::max(1.0, std::ceil(paths))),
          reached_(random.uniform()) {}

    /// What each path carries.
    [[nodiscard]] double spacing() const { return spacing_; }
    /// Paths on the next beam.
    [[nodiscard]] int of(double weight) {
        reached_ += weight / spacing_;
        const double whole = std::floor(reached_);
        reached_ -= whole;
        return static_cast<int>(whole);
    }
    /// Of the next path, from 1 to `groups`; those of a pair are 2 n - 1 and 2 n.
    [[nodiscard]] int group() {
        if (count_ % 2 == 0) first_ = static_cast<int>(groups * random_->uniform());
        return 1 + (count_++ % 2 == 0 ? first_ : first_ ^ 1);
    }

private:
    Random* random_;
    double spacing_, reached_;
    std::uint64_t count_ = 0;
    int first_ = 0;
};

}  // namespace icespar
