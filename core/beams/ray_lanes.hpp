// Rays through a stone side by side, as the code for each instruction set takes them on by a face.
#pragma once

namespace icespar {

/// Of each ray a column. Plain arrays: nothing here may be compiled twice.
struct RayLanes {
    static constexpr int size = 8;
    using Row = double[size];

    alignas(64) Row position[3];
    alignas(64) Row k[3], field[3];       ///< of the mode it is, the field of unit length
    alignas(64) Row fan[3];               ///< dk/dc, where colours part
    alignas(64) Row extraordinary, left;  ///< 1 or 0; the number of the facet just left
    alignas(64) Row weight, chance;       ///< `chance`: uniform in [0, 1)
    alignas(64) Row most;                 ///< the greatest probability of going on

    // What came of them at the face.
    alignas(64) Row passed, out[3];  ///< the weight that left the stone, and its wave vector
    alignas(64) Row out_fan[3];
    alignas(64) Row out_s, out_p;  ///< in proportion to its amplitudes, s being normal x k
    alignas(64) Row alive;         ///< 1 or 0: whether it goes on, as one of both modes
    alignas(64) Row solved;        ///< 0: it has come to the face, the rest is left to others
};

/// A uniaxial crystal in air, and the planes of its facets, padded with some that are never met.
struct RayStone {
    const double *x, *y, *z, *distance;
    int planes;
    double eps_o, eps_e, axis[3];
    double delicate;          ///< of what is of order 1 (a square, mostly), less is left to others
    bool spectral;            ///< fans are carried
    double swell_o, swell_e;  ///< half the derivatives of eps_o and eps_e with colour
};

/// Takes each ray to the face ahead, where what stays inside goes on as one mode: survivors of less
/// than `threshold` weigh as much. `left` is -1 where no face is ahead.
void step_baseline(const RayStone&, double threshold, RayLanes&);
void step_avx512(const RayStone&, double threshold, RayLanes&);

}  // namespace icespar
