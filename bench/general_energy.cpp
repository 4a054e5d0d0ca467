// Energy balance of faces between any two media, and the worst ten: general_energy [count] [seed].
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "support/general_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

struct Entry {
    double error, excess;
    const char* kind;
    GeneralCase problem;
};

/// R + T (+ what incident and reflected waves carry together) - 1; not a number where a power is
/// negative or none.
double energy_error(const GeneralCase& c) {
    const Wave in = c.incident();
    const Coefficients a = Interface(c.from.medium(), c.to.medium(), c.normal, in).solve(in);
    for (const auto& powers : {a.reflected_power, a.transmitted_power}) {
        for (const double p : powers) {
            if (!(p >= 0) || !std::isfinite(p)) return std::numeric_limits<double>::quiet_NaN();
        }
    }
    return a.reflected_total + a.transmitted_total + a.interference - 1;
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 10000000;
    const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    constexpr int kinds = static_cast<int>(GeneralStress::count);
    std::vector<Entry> worst;
    long invalid = 0, failed = 0;
    std::printf("%-32s %10s %8s %24s\n", "kind", "cases", "invalid", "max |R+T-1| cos / 1e-13");
    for (int kind = 0; kind < kinds; ++kind) {
        const auto stress = static_cast<GeneralStress>(kind);
        Random random(seed * 1000 + static_cast<unsigned long long>(kind));
        double largest = 0;
        long bad = 0;
        for (long i = 0; i < count / kinds; ++i) {
            const GeneralCase c = random_case(random, stress);
            const double error = energy_error(c);
            bad += !std::isfinite(error);
            const double excess = std::isfinite(error) ? std::abs(error) * c.cos_ray / 1e-13
                                                       : std::numeric_limits<double>::infinity();
            failed += excess > 1;
            largest = std::max(largest, excess);
            if (worst.size() == 10 && excess <= worst.back().excess) continue;
            worst.push_back({error, excess, name(stress), c});
            std::sort(worst.begin(), worst.end(),
                      [](const Entry& a, const Entry& b) { return a.excess > b.excess; });
            if (worst.size() > 10) worst.pop_back();
        }
        invalid += bad;
        std::printf("%-32s %10ld %8ld %24.3g\n", name(stress), count / kinds, bad, largest);
        std::fflush(stdout);
    }
    std::printf("\n%ld invalid, %ld beyond 1e-13 over the cosine; the worst:\n", invalid, failed);
    for (const Entry& e : worst) {
        std::printf("%9.2g  R + T - 1 = %.3e, %s, ray at cosine %.3e\n    %s\n", e.excess, e.error,
                    e.kind, e.problem.cos_ray, e.problem.text().c_str());
    }
    return failed == 0 ? 0 : 1;
}
