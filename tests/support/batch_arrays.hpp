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

    FaceBatch faces;
    BatchResult wanted;

private:
    [[nodiscard]] Found found(std::size_t wave, std::size_t i) const;

    static constexpr std::size_t columns = 26;
    std::vector<Medium> from_, to_;
    std::vector<Vec3> normal_, direction_;
    std::vector<double> numbers_;
    std::unique_ptr<bool[]> propagating_;
};

}  // namespace icespar::testing
