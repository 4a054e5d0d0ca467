// Random numbers that are a function of their seed alone.
#pragma once

#include <cstdint>

namespace icespar {

/// SplitMix64's finaliser (Steele, Lea and Flood 2014): neighbouring inputs give unrelated outputs.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    /// Uniform in [0, 1).
    double uniform() {
        state_ += 0x9e3779b97f4a7c15u;
        return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

}  // namespace icespar
