// Which beams are worth following: systematic roulette, the same for any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "math/random.hpp"

namespace icespar {

/// A beam of less than the threshold survives with a probability proportional to its weight. Beams
/// of one depth share their chances like a systematic sample: their probabilities are added up from
/// a random start, and whoever takes the sum past 1 survives. Each depth has a start of its own, so
/// the mean is untouched, and neighbouring beams, which see much the same, are never all kept or
/// all dropped.
class Roulette {
public:
    static constexpr std::size_t most_pixels = 16;
    /// Light that is all but caught in the stone, after so many faces, goes on with no greater
    /// probability. What comes out this late is a few parts in a million, and gains weight on the
    /// way.
    static constexpr int patient = 1024;
    static constexpr double patience = 0.9;

    void begin(std::uint64_t seed, double threshold) {
        threshold_ = threshold;
        random_ = Random(seed);
        reached_ = 0;
    }

    [[nodiscard]] double threshold() const { return threshold_; }
    [[nodiscard]] double uniform() { return random_.uniform(); }

    /// 0 for a beam that ends, else the gain in weight of one that survives.
    [[nodiscard]] double gain(double weight, int hits) {
        double survival = weight >= threshold_ ? 1 : weight / threshold_;
        if (hits >= patient) {
            if (survival > patience) survival = patience;
            return random_.uniform() < survival ? 1 / survival : 0;
        }
        if (survival == 1) return 1;
        Depth& d = depth(hits);
        d.expected += survival;
        d.chance += survival;
        if (d.chance < 1) return 0;
        d.chance -= 1;
        return 1 / survival;
    }

    /// Of two beams of so much weight together, `part` of it the second's: -1 where both are worth
    /// following, else the one that stands for both, 0 or 1, chosen by its part. Chances are added
    /// up as for survival.
    [[nodiscard]] int stand_in(double weight, double part, int hits) {
        // A survivor weighs as much as the threshold, give or take rounding.
        if (weight > (1 + 1e-6) * threshold_ || hits >= patient) return -1;
        Depth& d = depth(hits);
        d.second += part;
        if (d.second < 1) return 0;
        d.second -= 1;
        return 1;
    }

    /// What came of a survivor among beams that owe nothing to earlier chance, in each pixel.
    void saw(int hits, std::span<const double> light) {
        if (hits >= patient) return;
        Depth& d = depth(hits);
        for (std::size_t i = 0; i < light.size(); ++i) {
            Seen& s = d.seen[i];
            const double change = light[i] - s.last;
            if (d.survivors > 0) s.differences += change * change;
            s.last = light[i];
            s.sum += light[i];
        }
        ++d.survivors;
    }

    /// Estimated variance of a pixel's sum over all survivors: in each depth by successive
    /// differences, as for any systematic sample (Cochran 1977, 8.11), and by how much the number
    /// of survivors varies.
    [[nodiscard]] double variance(std::size_t pixel) const {
        double sum = 0;
        for (int hits = 0; hits < reached_; ++hits) {
            const Depth& d = depths_[static_cast<std::size_t>(hits)];
            if (d.survivors == 0) continue;
            const Seen& s = d.seen[pixel];
            const double m = d.survivors, mean = s.sum / m;
            if (d.survivors > 1) sum += 0.5 * s.differences * m / (m - 1);
            const double rest = d.expected - std::floor(d.expected);
            sum += mean * mean * rest * (1 - rest) / std::min(1.0, d.expected);
        }
        return sum;
    }

private:
    struct Seen {
        double last = 0, sum = 0, differences = 0;
    };
    struct Depth {
        double chance = 0;  ///< the sum, from its random start
        double second = 0;  ///< the same of beams that stand in for pairs
        double expected = 0;
        int survivors = 0;
        std::array<Seen, most_pixels> seen{};
    };

    /// Most pixels reach few depths: they are begun when they are reached.
    [[nodiscard]] Depth& depth(int hits) {
        for (; reached_ <= hits; ++reached_) {
            Depth& d = depths_[static_cast<std::size_t>(reached_)];
            d = {};
            d.chance = random_.uniform();
            d.second = random_.uniform();
        }
        return depths_[static_cast<std::size_t>(hits)];
    }

    double threshold_ = 0;
    Random random_{0};
    int reached_ = 0;
    std::array<Depth, patient> depths_{};
};

}  // namespace icespar
