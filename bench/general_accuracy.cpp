// Error of the general solver against the Maxwell reference, per kind of hard case, and the worst
// ten: general_accuracy [count] [seed] [kind].
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "support/general_cases.hpp"

using namespace icespar::testing;

namespace {

/// An exception, of either solver, is a failure like any other.
GeneralDiscrepancy judged(const GeneralCase& c) {
    try {
        return compare(c);
    } catch (const std::exception& e) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {e.what(), infinity, 0, infinity};
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000;  // of each kind
    const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const std::string only = argc > 3 ? argv[3] : "";
    struct Entry {
        GeneralDiscrepancy found;
        const char* kind;
        GeneralCase problem;
    };
    std::vector<Entry> worst;
    int failures = 0;
    std::printf("%-32s %9s %6s\n", "kind", "excess", "fail");
    for (int kind = 0; kind < static_cast<int>(GeneralStress::count); ++kind) {
        const auto stress = static_cast<GeneralStress>(kind);
        if (!only.empty() && only != name(stress)) continue;
        Random random(seed * 1000 + static_cast<unsigned long long>(kind));
        double largest = 0;
        int failed = 0;
        for (int i = 0; i < count; ++i) {
            const GeneralCase c = random_case(random, stress);
            const GeneralDiscrepancy d = judged(c);
            largest = std::max(largest, d.excess);
            failed += !(d.excess <= 1);
            worst.push_back({d, name(stress), c});
            std::sort(worst.begin(), worst.end(), [](const Entry& a, const Entry& b) {
                return a.found.excess > b.found.excess;
            });
            if (worst.size() > 10) worst.pop_back();
        }
        std::printf("%-32s %9.2g %6d\n", name(stress), largest, failed);
        std::fflush(stdout);
        failures += failed;
    }
    std::printf("\nThe worst, excess = error / (1e-12 + 50 times the change for one ulp):\n");
    for (const Entry& e : worst) {
        std::printf("%9.2g  %s: %s: error %.3e, one ulp changes it by %.3e\n    %s\n",
                    e.found.excess, e.kind, e.found.quantity.c_str(), e.found.error,
                    e.found.conditioning, e.problem.text().c_str());
    }
    return failures == 0 ? 0 : 1;
}
