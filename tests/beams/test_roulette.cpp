// Which beams go on: by their weight alone, and without loss on average.
#include <catch2/catch.hpp>

#include "beams/roulette.hpp"

using namespace icespar;

TEST_CASE("however deep in a stone, no survivor outweighs a beam that takes no chance",
          "[beams][roulette]") {
    constexpr double threshold = 0.1;
    Roulette roulette;
    roulette.begin(3, threshold);
    for (const int hits : {1, 2, 127, 128, 500, 1000}) {
        CAPTURE(hits);
        CHECK(roulette.gain(0.3, hits) == 1);
        for (const double weight : {0.09, 0.03, 1e-3, 1e-6}) {
            const double gain = roulette.gain(weight, hits);
            CHECK((gain == 0 || gain * weight == Approx(threshold)));
        }
    }
}

TEST_CASE("roulette keeps the light of many beams to less than one threshold",
          "[beams][roulette]") {
    constexpr double threshold = 0.1, weight = 0.007;
    const int hits = GENERATE(1, 40, 700);
    Roulette roulette;
    roulette.begin(static_cast<std::uint64_t>(hits), threshold);
    double kept = 0;
    constexpr int beams = 1000;
    for (int i = 0; i < beams; ++i) kept += weight * roulette.gain(weight, hits);
    CHECK(std::abs(kept - beams * weight) <= threshold * (1 + 1e-9));
}
