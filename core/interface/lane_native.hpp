// Picks the kernel for the media of a batch, in lanes as wide as the options of the including file
// allow.
#pragma once

#include "interface/lane_biaxial_kernel.hpp"

namespace icespar::lanes {

template <class V>
void run_plain(const Kernel<V>& kernel, std::size_t begin, std::size_t end, bool from_uniaxial,
               bool to_uniaxial) {
    if (from_uniaxial && to_uniaxial) {
        kernel.template run<true, true>(begin, end);
    } else if (from_uniaxial) {
        kernel.template run<true, false>(begin, end);
    } else if (to_uniaxial) {
        kernel.template run<false, true>(begin, end);
    } else {
        kernel.template run<false, false>(begin, end);
    }
}

/// V: lanes of double precision; S: of single precision, where the media are plain and it is asked
/// for.
template <class V, class S>
void run(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin, std::size_t end,
         Symmetry from, Symmetry to, SolveOne solve_one) {
    const bool from_biaxial = from == Symmetry::biaxial, to_biaxial = to == Symmetry::biaxial;
    if (from_biaxial || to_biaxial) {
        const BiaxialKernel<V> kernel{{faces, wanted, solve_one}};
        if (!from_biaxial) {
            kernel.template run<false, true>(begin, end);
        } else if (to_biaxial) {
            kernel.template run<true, true>(begin, end);
        } else {
            kernel.template run<true, false>(begin, end);
        }
        return;
    }
    const bool o = from == Symmetry::uniaxial, e = to == Symmetry::uniaxial;
    if (faces.precision == Precision::single) {
        run_plain(Kernel<S>{faces, wanted, solve_one}, begin, end, o, e);
    } else {
        run_plain(Kernel<V>{faces, wanted, solve_one}, begin, end, o, e);
    }
}

template <class... Arguments>
void run_native(const Arguments&... arguments) {
    namespace stdx = std::experimental;
    run<stdx::native_simd<double>, stdx::native_simd<float>>(arguments...);
}

}  // namespace icespar::lanes
