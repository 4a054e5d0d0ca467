// The kernels of a batch as the rest of the library calls them, one for each instruction set.
#pragma once

#include "interface/batch.hpp"

namespace icespar::lanes {

constexpr bool wanted(const VectorResult& r) { return r.x.data || r.y.data || r.z.data; }
constexpr bool wanted(const ComplexResult& r) { return wanted(r.real) || wanted(r.imag); }
/// Of WaveColumns or TotalColumns: whether E or H is wanted.
template <class Columns>
constexpr bool fields_wanted(const Columns& c) {
    return wanted(c.E) || wanted(c.H);
}

/// Solves a face that lanes leave to Interface.
using SolveOne = void (*)(const FaceBatch&, const BatchResult&, std::size_t);

/// Faces begin .. end - 1 between transparent media of these kinds; not uniaxial to biaxial, nor
/// back.
void run_baseline(const FaceBatch&, const BatchResult& wanted, std::size_t begin, std::size_t end,
                  Symmetry from, Symmetry to, SolveOne);
void run_avx512(const FaceBatch&, const BatchResult& wanted, std::size_t begin, std::size_t end,
                Symmetry from, Symmetry to, SolveOne);

}  // namespace icespar::lanes
