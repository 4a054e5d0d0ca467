// Many faces in one call: the boundary problem over columns of numbers, several faces at a time.
#pragma once

#include <array>
#include <cstddef>

#include "interface/wave.hpp"

namespace icespar {

/// One number for each face, `stride` apart; stride 0: the same for all. Columns of an array of
/// vectors are three with stride 3.
struct Column {
    const double* data = nullptr;
    std::ptrdiff_t stride = 1;
};
struct VectorColumn {
    Column x, y, z;
};

/// A medium for each face, or one for all (stride 0).
struct MediumColumn {
    const Medium* data = nullptr;
    std::ptrdiff_t stride = 0;
};

/// What is wanted of each face; without data it is neither computed nor stored.
struct ResultColumn {
    double* data = nullptr;
    std::ptrdiff_t stride = 1;
};
struct VectorResult {
    ResultColumn x, y, z;
};
struct ComplexResult {
    VectorResult real, imag;
};

/// Of the numbers in lanes. Single precision is good to 1e-6 or so where nothing is
/// ill-conditioned, in about half the time; faces of biaxial crystals and what lanes leave to
/// Interface are in double precision all the same.
enum class Precision { full, single };

/// One incident wave of unit amplitude for each face, as `plane_wave` makes it.
struct FaceBatch {
    std::size_t count = 0;
    MediumColumn from, to;
    VectorColumn normal;     ///< unit, from medium `from` to medium `to`
    VectorColumn direction;  ///< unit wave normal, or ray
    Mode mode = Mode::s;
    By by = By::wave_normal;
    Precision precision = Precision::full;
    std::size_t first = 0;  ///< what errors call face 0
};

/// One wave of each face, as in Wave; the incident one has amplitude and power 1.
struct WaveColumns {
    ResultColumn power, amplitude_real, amplitude_imag;
    VectorResult ray;
    ComplexResult k, E, H;
    ResultColumn n_phase, n_ray;
    bool* propagating = nullptr;  ///< may be null
    std::ptrdiff_t propagating_stride = 1;
};

/// Both waves of one side together, as in Coefficients and SummedFields.
struct TotalColumns {
    ResultColumn power;
    ComplexResult E, H;
};

struct BatchResult {
    WaveColumns incident;
    std::array<WaveColumns, 2> reflected, transmitted;
    TotalColumns reflected_total, transmitted_total;
};

/// The code that a batch runs in. `scalar` is Interface, face by face.
enum class Lanes { scalar, baseline, avx512 };

/// The widest that this processor has.
[[nodiscard]] Lanes widest_lanes();

/// Solves the faces begin .. end - 1, so that threads can share a batch. Faces between transparent
/// isotropic or uniaxial media, and of transparent biaxial crystals with each other or with
/// isotropic media, are solved several at once and agree with Interface to rounding, but for the
/// phase of a biaxial crystal's outgoing E (and of the amplitude that goes with it), which is free.
/// All others, biaxial crystals by ray, and whatever is delicate (waves about to merge, biaxial
/// crystals' waves that are evanescent, near grazing or near an optic axis) are solved by Interface
/// itself. Throws Error, naming the face as direction[i], where there is no such wave or it does
/// not carry energy towards the face; results are then incomplete.
void solve_batch(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin,
                 std::size_t end, Lanes width = widest_lanes());

}  // namespace icespar
