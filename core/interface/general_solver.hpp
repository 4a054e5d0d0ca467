// The boundary problem for any pair of media; Interface calls it where no closed form applies.
#pragma once

#include "interface/face_frame.hpp"
#include "interface/interface.hpp"

namespace icespar {

struct GeneralSolver {
    static void solve(Interface& out, const Medium& from, const Medium& to, const FaceFrame& frame,
                      const Wave& incident);
    static void add_totals(const Interface& face, std::size_t mode, Coefficients& out);
    static SummedFields fields(const Interface& face, std::size_t mode);

private:
    /// Transparent media where all goes well; false elsewhere, with nothing of worth in `out`.
    static bool solve_quickly(Interface& out, const Medium& from, const Medium& to,
                              const FaceFrame& frame, const Wave& incident);
    /// Solves with numbers of type R; false when they lost too many digits.
    template <class R>
    static bool solve_in(Interface& out, const Medium& from, const Medium& to,
                         const FaceFrame& frame, const Wave& incident);
};

}  // namespace icespar
