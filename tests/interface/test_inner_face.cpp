// Faces as tracers meet them from inside a crystal, against the general boundary problem.
#include <algorithm>
#include <catch2/catch.hpp>

#include "interface/inner_face.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

CVec3 times(const Complex& amplitude, const Vec3& v) {
    return {amplitude * v.x, amplitude * v.y, amplitude * v.z};
}

}  // namespace

TEST_CASE("from inside a uniaxial crystal a face sends on what the boundary problem says",
          "[interface][inner]") {
    Random random(21);
    int compared = 0, passed = 0;
    double worst_k = 0, worst_field = 0, worst_energy = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto kind = random.below(4) == 0
                              ? static_cast<Stress>(random.below(static_cast<int>(Stress::count)))
                              : Stress::ordinary;
        const InterfaceCase c = random_case(random, kind);
        if (!c.from.birefringent || c.to.birefringent) continue;
        ++compared;
        const bool extraordinary = c.mode == Mode::extraordinary;
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const Interface truth(c.from, c.to, c.normal, in);
        const InnerFace face(c.from, c.to, c.normal, real(in.k), real(in.E), extraordinary);
        const std::size_t m = extraordinary ? 1 : 0;
        double power = 0;
        for (std::size_t j = 0; j < 2; ++j) {
            REQUIRE(face.reflected.propagates[j] == truth.propagating(false, j));
            if (!face.reflected.propagates[j]) continue;
            power += std::norm(face.amplitude[j]);
            worst_k = std::max(worst_k, length(face.reflected.k[j] - truth.wave_vector(false, j)));
            // E may have either sign, and the amplitude with it.
            worst_field = std::max(
                worst_field,
                length(times(face.amplitude[j], face.reflected.E[j]) -
                       times(truth.flux_amplitude(m, false, j), truth.field_direction(false, j))));
        }
        REQUIRE(face.passes == truth.propagating(true, 0));
        if (face.passes) {
            ++passed;
            power += std::norm(face.out_s) + std::norm(face.out_p);
            worst_k = std::max(worst_k, length(face.k_out - truth.wave_vector(true, 0)));
            const Vec3 s = normalised(face.s), p = cross(face.k_out, s);
            const Vec3& true_s = truth.s_direction();
            worst_field = std::max(
                {worst_field,
                 length(times(face.out_s, s) - times(truth.flux_amplitude(m, true, 0), true_s)),
                 length(times(face.out_p, p) -
                        times(truth.flux_amplitude(m, true, 1), cross(face.k_out, true_s))) /
                     length(face.k_out)});
        }
        worst_energy = std::max(worst_energy, std::abs(power - 1));
    }
    CAPTURE(compared, passed, in_digits(worst_k), in_digits(worst_field), in_digits(worst_energy));
    CHECK(compared > 10000);
    CHECK(passed > 3000);
    CHECK(worst_k < 1e-10);
    CHECK(worst_field < 1e-10);
    CHECK(worst_energy < 1e-10);
}
