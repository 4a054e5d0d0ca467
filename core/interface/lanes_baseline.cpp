// The batch kernels for the baseline of the build.
#include "interface/lane_kernel.hpp"

namespace icespar::lanes {

void run_baseline(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin,
                  std::size_t end, bool from_uniaxial, bool to_uniaxial, SolveOne solve_one) {
    run_native(faces, wanted, begin, end, from_uniaxial, to_uniaxial, solve_one);
}

}  // namespace icespar::lanes
