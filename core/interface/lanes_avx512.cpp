// The batch kernels for AVX-512 processors, with the options that CMake gives this file alone.
#include "interface/lane_native.hpp"

namespace icespar::lanes {

void run_avx512(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin,
                std::size_t end, Symmetry from, Symmetry to, SolveOne solve_one) {
    run_native(faces, wanted, begin, end, from, to, solve_one);
}

}  // namespace icespar::lanes
