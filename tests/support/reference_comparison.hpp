// The interface core against the Maxwell reference, with the conditioning of each case as the
// yardstick.
#pragma once

#include <string>
#include <vector>

#include "support/interface_cases.hpp"

namespace icespar::testing {

/// A named part of the answer, compared by its Euclidean norm.
struct Quantity {
    std::string name;
    std::vector<double> values;
    double scale =
        1;  ///< errors are relative to it: the largest of 1, the values, and what they add up
};

using Answer = std::vector<Quantity>;

/// Of all waves: k, E, ray, power and field at the face; and the totals. Where the polarisation of
/// the incident wave is undetermined (s and p at normal incidence, o and e along the axis) the
/// totals are summed over both incident modes, which does not depend on the choice.
[[nodiscard]] Answer core_answer(const InterfaceCase& c);
[[nodiscard]] Answer reference_answer(const InterfaceCase& c);

/// The case with one input double at a time moved by `ulps`: indices by their own ulp, components
/// of unit vectors by that of 1.
[[nodiscard]] std::vector<InterfaceCase> moved(const InterfaceCase& c, double ulps);

struct Discrepancy {
    std::string quantity;
    double error = 0;         ///< |core - reference| / the reference's scale
    double conditioning = 0;  ///< change of the reference for one ulp in each input tried, likewise
    double excess = 0;        ///< error / (1e-12 + 50 conditioning); above 1 the core is at fault
};

/// The quantity of largest excess. Inputs are moved only when some error is above 1e-12, and only
/// until that is explained.
[[nodiscard]] Discrepancy compare(const InterfaceCase& c);

/// compare, and the largest error of all quantities whatever their conditioning.
struct Accuracy {
    Discrepancy worst;
    double largest_error = 0;
    bool conditioned = false;  ///< some error was above 1e-12
};
[[nodiscard]] Accuracy accuracy(const InterfaceCase& c);

}  // namespace icespar::testing
