// Which beams are worth following: systematic roulette, the same for any number of threads.
#pragma once

#include <array>
#include <cstdint>

#include "math/random.hpp"

namespace icespar {

/// A beam of less than the threshold survives with a probability proportional to its weight. Beams
/// of one depth share their chances like a systematic sample: their probabilities are added up from
/// a random start, and whoever takes the sum past 1 survives. Each depth has a start of its own, so
/// the mean is untouched, and neighbouring beams, which see much the same, are never all kept or
/// all dropped.
class Roulette {
public:
    void begin(std::uint64_t seed, double threshold) {
        threshold_ = threshold;
        random_ = Random(seed);
        for (double& s : sums_) s = random_.uniform();
    }

    /// 0 for a beam that ends, else the gain in weight of one that survives.
    [[nodiscard]] double gain(double weight, int hits) {
        double survival = weight >= threshold_ ? 1 : weight / threshold_;
        if (hits >= static_cast<int>(sums_.size())) {
            // Light that is all but caught in the stone.
            if (survival > patience) survival = patience;
            return random_.uniform() < survival ? 1 / survival : 0;
        }
        if (survival == 1) return 1;
        double& sum = sums_[static_cast<std::size_t>(hits)];
        sum += survival;
        if (sum < 1) return 0;
        sum -= 1;
        return 1 / survival;
    }

    [[nodiscard]] double threshold() const { return threshold_; }

private:
    static constexpr double patience = 0.9;
    double threshold_ = 0;
    Random random_{0};
    std::array<double, 128> sums_{};
};

}  // namespace icespar
