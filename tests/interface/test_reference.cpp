// The interface core agrees with Maxwell's equations solved in sixty digits, as far as its inputs
// allow.
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "support/reference_comparison.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

struct Finding {
    Discrepancy worst;
    InterfaceCase problem;
};

/// Compares `count` cases of one kind; the failure shows the ten worst.
void check_kind(Stress stress, int count, std::uint64_t seed) {
    Random random(seed + 1000 * static_cast<std::uint64_t>(stress));
    std::vector<Finding> findings;
    for (int i = 0; i < count; ++i) {
        const InterfaceCase c = random_case(random, stress);
        const Discrepancy worst = compare(c);
        if (!(worst.excess <= 1)) findings.push_back({worst, c});
    }
    const auto shown = std::min<std::size_t>(findings.size(), 10);
    std::partial_sort(
        findings.begin(), findings.begin() + static_cast<std::ptrdiff_t>(shown), findings.end(),
        [](const Finding& a, const Finding& b) { return a.worst.excess > b.worst.excess; });
    std::ostringstream report;
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& [worst, problem] = findings[i];
        report << worst.quantity << ": error " << worst.error
               << ", one ulp in the inputs changes it by " << worst.conditioning << "\n  "
               << problem.text() << "\n";
    }
    INFO(name(stress) << ": " << findings.size() << " of " << count << "\n" << report.str());
    CHECK(findings.empty());
}

}  // namespace

TEST_CASE("the interface agrees with Maxwell in sixty digits for ordinary cases",
          "[interface][reference]") {
    check_kind(Stress::ordinary, 1000, 1);
}

TEST_CASE("the interface agrees with Maxwell in sixty digits in hard cases",
          "[interface][reference]") {
    for (int stress = 1; stress < static_cast<int>(Stress::count); ++stress)
        check_kind(static_cast<Stress>(stress), 100, 2);
}
