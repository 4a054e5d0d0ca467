// Random faces, media and incident waves for the tests of the interface, ordinary and nasty.
#pragma once

#include <array>
#include <random>
#include <string>

#include "crystal/medium.hpp"
#include "interface/wave.hpp"

namespace icespar::testing {

/// One boundary problem: a wave of unit wave normal `direction` whose energy goes towards the face.
struct InterfaceCase {
    Medium from, to;
    Vec3 normal, direction;
    Mode mode = Mode::s;
    double cos_ray = 1;  ///< between the ray and the normal, for tolerances

    [[nodiscard]] int mode_index() const {
        return mode == Mode::p || mode == Mode::extraordinary ? 1 : 0;
    }
    [[nodiscard]] std::string text() const;  ///< every input with 17 digits
};

/// What a case is hard for.
enum class Stress {
    ordinary,
    normal_incidence,
    near_normal,
    grazing,
    near_critical,
    near_critical_reflected,
    one_mode_evanescent,
    axis_on_normal,
    axis_near_normal,
    axis_on_refracted,
    axis_on_incident,
    axis_in_face,
    axis_in_plane,
    tiny_birefringence,
    no_birefringence,
    strong_birefringence,
    high_ratio,
    same_medium,
    same_medium_turned,
    matched_index,
    denser_outside,
    crystal_to_crystal,
    backward_wave,
    merging_evanescent,
    critical_along_axis,
    critical_tiny_birefringence,
    count
};

[[nodiscard]] const char* name(Stress stress);

/// What rounding may cost a field in a case of this kind, in units of what it costs elsewhere.
/// Where both evanescent waves merge, and near the axis at that, their polarisations are
/// differences of nearly equal vectors.
[[nodiscard]] inline double field_slack(Stress stress) {
    return stress == Stress::merging_evanescent ? 100 : 1;
}

/// A small number as 1.234e-15: Catch would print 0.0.
[[nodiscard]] std::string in_digits(double value);

/// Reproducible on every platform: std distributions are not.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low = 0, double high = 1);
    double power_of_ten(double low_exponent, double high_exponent);
    double sign() { return uniform() < 0.5 ? -1 : 1; }
    int below(int n) { return static_cast<int>(uniform() * n); }
    Vec3 direction();
    Vec3 perpendicular_to(const Vec3& unit_vector);

private:
    std::mt19937_64 engine_;
};

/// A case of the given kind, with cos_ray at least 1e-9.
[[nodiscard]] InterfaceCase random_case(Random& random, Stress stress);

}  // namespace icespar::testing
