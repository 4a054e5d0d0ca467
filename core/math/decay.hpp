// exp(-x) in a form that compilers turn into vector code.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numbers>

namespace icespar {

/// exp(-x) to a few roundings, 1 at 0; for x beyond 700 in size exp(-700) or exp(700).
[[nodiscard]] inline double decay(double x) {
    // 2^y: whole steps go to the exponent, the rest, at most a half, is Taylor's series. Adding
    // `shift` rounds to whole numbers and leaves them in the lowest bits.
    constexpr double shift = 0x1.8p52, ln2_high = 0x1.62e42fefap-1, ln2_low = 0x1.cf79abc9e3b3ap-40;
    const double z = -std::clamp(x, -700.0, 700.0);
    const double shifted = z * std::numbers::log2e + shift, whole = shifted - shift;
    const double f = (z - whole * ln2_high) - whole * ln2_low;
    double sum = 1.0 / 6227020800;
    for (const double n : {479001600.0, 39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0,
                           120.0, 24.0, 6.0, 2.0, 1.0, 1.0}) {
        sum = sum * f + 1 / n;
    }
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) +
                                 (std::bit_cast<std::uint64_t>(shifted) << 52));
}

}  // namespace icespar
