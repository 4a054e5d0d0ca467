// Random faces between any two media, for the tests of the general solver.
#pragma once

#include <string>

#include "interface/interface.hpp"
#include "support/interface_cases.hpp"
#include "support/maxwell_reference.hpp"

namespace icespar::testing {

/// A medium by the numbers a user gives, so that each can be moved by one ulp.
struct MediumRecipe {
    Symmetry symmetry = Symmetry::isotropic;
    std::array<Complex, 3> n{1, 1, 1};  ///< n | n_o, n_e | along first, second, first x second
    Vec3 first{0, 0, 1}, second{1, 0, 0};
    double gyration = 0, gyration_along = 0;  ///< about `first`
    Complex skew = 0;  ///< added to eps between the first two principal axes: no common axes

    [[nodiscard]] bool absorbing() const;
    [[nodiscard]] Medium medium() const;
    [[nodiscard]] reference::Material material() const;
};

struct GeneralCase {
    MediumRecipe from, to;
    Vec3 normal, direction;
    std::size_t mode = 0;
    double cos_ray = 1;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] Wave incident() const;
};

enum class GeneralStress {
    into_biaxial,
    out_of_biaxial,
    biaxial_to_biaxial,
    normal_incidence,
    near_normal,
    grazing,
    near_critical,
    total_reflection,
    optic_axis_refracted,
    optic_axis_incident,
    optic_axis_along_normal,
    principal_plane,
    weak_biaxiality,
    almost_uniaxial,
    no_biaxiality,
    strong_biaxiality,
    same_medium,
    backward_wave,
    absorbing_isotropic,
    absorbing_uniaxial,
    absorbing_biaxial,
    absorbing_triclinic,
    weak_absorption,
    strong_absorption,
    one_lossy_axis,
    near_critical_inside,
    matched_index,
    absorbing_incident,
    absorbing_incident_grazing,
    absorbing_to_absorbing,
    active_second,
    active_first,
    active_both,
    weak_activity,
    active_near_axis,
    active_grazing,
    active_near_critical,
    count
};

[[nodiscard]] const char* name(GeneralStress stress);

/// A case of the given kind, with cos_ray at least 1e-9.
[[nodiscard]] GeneralCase random_case(Random& random, GeneralStress stress);

/// The largest error over quantities: |core - reference| / max(1, |reference|), and its ratio to
/// 1e-12 + 50 times the change of the reference for one ulp in the worst input.
struct GeneralDiscrepancy {
    std::string quantity;
    double error = 0, conditioning = 0, excess = 0;
};
[[nodiscard]] GeneralDiscrepancy compare(const GeneralCase& c);

/// For plots: the largest error over the totals (powers and summed fields of a side), and over
/// everything else, each wave alone; the same of a batch in single precision, where media are
/// plain; and the largest change of the reference from `c` to `moved`.
struct GeneralExtent {
    double error_of_totals = 0, error_of_waves = 0;
    double single_error_of_totals = 0, single_error_of_waves = 0;
    double change_of_totals = 0, change_of_waves = 0;
};
[[nodiscard]] GeneralExtent extent(const GeneralCase& c, const GeneralCase& moved);

}  // namespace icespar::testing
