// Energy balance of the interface over many random lossless faces: interface_energy [count] [seed].
#include "support/interface_energy.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace icespar::testing;

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 10000000;
    const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const auto start = std::chrono::steady_clock::now();
    EnergyTally all;
    std::printf("%-32s %10s %8s %22s\n", "kind", "cases", "invalid", "max |R+T-1| cos / 1e-13");
    constexpr int kinds = static_cast<int>(Stress::count);
    for (int kind = 0; kind < kinds; ++kind) {
        // Half of all cases are ordinary, the rest is shared by the hard kinds.
        const long share = kind == 0 ? count / 2 : count / 2 / (kinds - 1);
        Random random(seed * 1000 + static_cast<unsigned long long>(kind));
        EnergyTally tally;
        for (long i = 0; i < share; ++i) {
            const InterfaceCase c = random_case(random, static_cast<Stress>(kind));
            tally.add(c);
            all.add(c);
        }
        std::printf("%-32s %10ld %8ld %22.4g\n", name(static_cast<Stress>(kind)), tally.count(),
                    tally.invalid(), tally.worst_excess());
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("\n%.1f s\n%s", seconds.count(), all.report().c_str());
    return all.worst_excess() <= 1 ? 0 : 1;
}
