// A batch of interface cases with arrays for every result.
#pragma once

#include <memory>
#include <vector>

#include "interface/batch.hpp"
#include "support/interface_cases.hpp"

namespace icespar::testing {

/// All cases share a mode. Inputs lie as arrays of vectors, results as separate columns.
class BatchArrays {
public:
    explicit BatchArrays(const std::vector<InterfaceCase>& cases);

    void solve(Lanes lanes);
    /// Overwrites all but E and H.
    void solve_without_fields(Lanes lanes);

    struct Found {
        CVec3 k, E, H;
        Vec3 ray;
        Complex amplitude;
        double power, n_phase, n_ray;
        bool propagating;
    };
    [[nodiscard]] Found incident(std::size_t i) const { return found(0, i); }
    [[nodiscard]] Found reflected(std::size_t i, std::size_t mode) const {
        return found(1 + mode, i);
    }
    [[nodiscard]] Found transmitted(std::size_t i, std::size_t mode) const {
        return found(3 + mode, i);
    }

    struct Total {
        double power;
        CVec3 E, H;
    };
    [[nodiscard]] Total total(bool transmitted, std::size_t i) const;

    FaceBatch faces;
    BatchResult wanted;

private:
    [[nodiscard]] Found found(std::size_t wave, std::size_t i) const;
    /// From consecutive columns, `at` being this face's entry of a first one.
    [[nodiscard]] Vec3 vector(const double* at, std::size_t first) const;
    [[nodiscard]] CVec3 field(const double* at, std::size_t first) const;

    static constexpr std::size_t columns = 26, total_columns = 13;
    std::vector<Medium> from_, to_;
    std::vector<Vec3> normal_, direction_;
    std::vector<double> numbers_;
    std::unique_ptr<bool[]> propagating_;
};

}  // namespace icespar::testing
