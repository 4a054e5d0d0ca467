// Error of the interface against the Maxwell reference, per kind of hard case: interface_accuracy
// [count] [seed].
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "support/reference_comparison.hpp"

using namespace icespar::testing;

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000;  // of each kind
    const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    std::printf("%-32s %9s %9s %9s %9s %8s %6s\n", "kind", "median", "90 %", "99 %", "largest",
                "> 1e-12", "fail");
    int failures = 0;
    for (int kind = 0; kind < static_cast<int>(Stress::count); ++kind) {
        Random random(seed * 1000 + static_cast<unsigned long long>(kind));
        std::vector<double> errors;
        int conditioned = 0, failed = 0;
        Accuracy worst;
        InterfaceCase worst_case;
        for (int i = 0; i < count; ++i) {
            const InterfaceCase c = random_case(random, static_cast<Stress>(kind));
            const Accuracy a = accuracy(c);
            errors.push_back(a.largest_error);
            conditioned += a.conditioned;
            failed += !(a.worst.excess <= 1);
            if (!(a.worst.excess <= worst.worst.excess)) worst = a, worst_case = c;
        }
        std::sort(errors.begin(), errors.end());
        const auto quantile = [&](double q) {
            return errors[static_cast<std::size_t>(q * static_cast<double>(count - 1))];
        };
        std::printf("%-32s %9.1e %9.1e %9.1e %9.1e %8d %6d\n", name(static_cast<Stress>(kind)),
                    quantile(0.5), quantile(0.9), quantile(0.99), errors.back(), conditioned,
                    failed);
        if (failed > 0)
            std::printf("    %s: error %.3e, one ulp changes it by %.3e\n    %s\n",
                        worst.worst.quantity.c_str(), worst.worst.error, worst.worst.conditioning,
                        worst_case.text().c_str());
        failures += failed;
    }
    return failures == 0 ? 0 : 1;
}
