// Energy balance and reversibility of the interface core, for tests and benches alike.
#pragma once

#include <string>
#include <vector>

#include "support/interface_cases.hpp"

namespace icespar::testing {

/// Reflected + transmitted power minus 1; NaN when any power is not finite or is negative.
[[nodiscard]] double energy_error(const InterfaceCase& c);

/// Largest difference between the power of a passage from the incident wave a to an outgoing wave b
/// and that from b reversed to a reversed, weighted with what rounding of the wave vectors costs:
/// the cosine of the incident ray, times the least cosine (normal decay if evanescent) of an
/// outgoing one, or the sine that defines the polarisation of a or b if that is less (below 1e-7 it
/// is a matter of choice: then 0).
[[nodiscard]] double reciprocity_error(const InterfaceCase& c);

/// Keeps the worst cases of a long run.
class EnergyTally {
public:
    void add(const InterfaceCase& c);
    /// Largest |R + T - 1| cos_ray in units of 1e-13; infinite when some power is invalid.
    [[nodiscard]] double worst_excess() const;
    [[nodiscard]] long invalid() const {
        return invalid_;
    }  ///< with NaN, infinity or negative power
    [[nodiscard]] long count() const { return count_; }
    [[nodiscard]] std::string report() const;

private:
    struct Entry {
        double error, excess;
        InterfaceCase problem;
    };
    long count_ = 0, invalid_ = 0;
    std::vector<Entry> worst_;  ///< at most ten, worst first; invalid ones have infinite excess
};

}  // namespace icespar::testing
