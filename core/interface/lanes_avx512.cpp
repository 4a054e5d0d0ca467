// The batch kernels for AVX-512 processors, with the options that CMake gives this file alone.
#include "interface/lane_kernel.hpp"

namespace icespar::lanes {

void run_avx512(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin,
                std::size_t end, bool from_uniaxial, bool to_uniaxial, SolveOne solve_one) {
    run_native(faces, wanted, begin, end, from_uniaxial, to_uniaxial, solve_one);
}

}  // namespace icespar::lanes
