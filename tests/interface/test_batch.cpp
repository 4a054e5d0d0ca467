// Batches agree with Interface, face by face, in every code that the processor can run.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "interface/batch.hpp"
#include "interface/interface.hpp"
#include "math/error.hpp"
#include "support/batch_arrays.hpp"
#include "support/general_cases.hpp"
#include "support/interface_cases.hpp"
#include "support/reference_comparison.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

std::vector<Lanes> available() {
    std::vector<Lanes> all{Lanes::baseline};
    if (widest_lanes() != Lanes::baseline) all.push_back(widest_lanes());
    return all;
}

/// All that a batch says of one wave.
using Found = BatchArrays::Found;

using Total = BatchArrays::Total;

/// The five waves of a face and the totals of both sides.
struct Answer {
    std::array<Found, 5> waves;
    std::array<Total, 2> totals;
};

Answer in_batch(const BatchArrays& batch, std::size_t i) {
    return {{batch.incident(i), batch.reflected(i, 0), batch.reflected(i, 1),
             batch.transmitted(i, 0), batch.transmitted(i, 1)},
            {batch.total(false, i), batch.total(true, i)}};
}

Answer alone(const InterfaceCase& c) {
    const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
    const Interface face(c.from, c.to, c.normal, in);
    const Coefficients a = face.solve(in);
    const SummedFields sum = face.summed_fields(in);
    const auto found = [](const Wave& w, const Complex& amplitude, double power) {
        return Found{w.k, w.E, w.H, w.ray, amplitude, power, w.n_phase, w.n_ray, w.propagating};
    };
    return {{found(in, 1, 1), found(face.reflected(0), a.reflected[0], a.reflected_power[0]),
             found(face.reflected(1), a.reflected[1], a.reflected_power[1]),
             found(face.transmitted(0), a.transmitted[0], a.transmitted_power[0]),
             found(face.transmitted(1), a.transmitted[1], a.transmitted_power[1])},
            {Total{a.reflected_total, sum.reflected_E, sum.reflected_H},
             Total{a.transmitted_total, sum.transmitted_E, sum.transmitted_H}}};
}

/// Largest difference between two answers; fields relative to the amplitudes that make them.
double difference(const Answer& x, const Answer& y) {
    double error = 0;
    const auto add = [&](double d) {
        if (!(d <= error)) error = std::isnan(d) ? 1e300 : d;
    };
    double amplitudes = 1, index = 1;
    for (std::size_t i = 0; i < 5; ++i) {
        const Found &a = x.waves[i], &b = y.waves[i];
        amplitudes += std::abs(b.amplitude);
        index += length(b.k);
        const double size = 1 + std::abs(b.amplitude);
        for (const double d :
             {length(a.k - b.k), length(a.E - b.E), length(a.H - b.H) / (1 + length(b.k)),
              length(a.ray - b.ray), std::abs(a.amplitude - b.amplitude) / size,
              std::abs(a.power - b.power), std::abs(a.n_phase - b.n_phase),
              std::abs(a.n_ray - b.n_ray)}) {
            add(d);
        }
    }
    for (std::size_t side = 0; side < 2; ++side) {
        const Total &a = x.totals[side], &b = y.totals[side];
        add(std::abs(a.power - b.power));
        add(length(a.E - b.E) / amplitudes);
        add(length(a.H - b.H) / (amplitudes * index));
    }
    return error;
}

/// `x` with the fields of its outgoing waves in the phases of `y`, which a biaxial crystal leaves
/// open.
Answer in_phase(Answer x, const Answer& y) {
    for (std::size_t i = 1; i < 5; ++i) {
        const Complex overlap = dot(conj(x.waves[i].E), y.waves[i].E);
        const Complex phase = std::abs(overlap) > 0.5 ? overlap / std::abs(overlap) : 1;
        x.waves[i].E = phase * x.waves[i].E;
        x.waves[i].H = phase * x.waves[i].H;
        x.waves[i].amplitude /= phase;
    }
    return x;
}

/// What rounding of the inputs by so many ulps each may change.
double conditioning(const InterfaceCase& c, double size = 1) {
    const Answer here = alone(c);
    const bool biaxial = !c.from.plain() || !c.to.plain();
    double most = 0;
    for (const double ulps : {size, -size}) {
        double sum = 0;
        for (const InterfaceCase& d : moved(c, ulps)) {
            const Answer there = alone(d);
            sum += difference(biaxial ? in_phase(there, here) : there, here);
        }
        most = std::max(most, sum);
    }
    return most;
}

}  // namespace

TEST_CASE("a batch of faces gives what each face gives alone", "[interface][batch]") {
    // Without fields, faces that do not mix s and p are solved by a shortcut.
    const bool fields_unasked = GENERATE(false, true);
    Random random(61);
    double worst = 0;
    std::string where;
    for (int kind = 0; kind < static_cast<int>(Stress::count); ++kind) {
        for (const Mode mode : {Mode::s, Mode::p, Mode::ordinary, Mode::extraordinary}) {
            std::vector<InterfaceCase> cases;
            for (int tries = 0; tries < 800 && cases.size() < 103; ++tries) {
                const InterfaceCase c = random_case(random, static_cast<Stress>(kind));
                if (c.mode == mode) cases.push_back(c);
            }
            if (cases.empty()) continue;
            for (const Lanes lanes : available()) {
                BatchArrays batch(cases);
                batch.solve(lanes);
                if (fields_unasked) batch.solve_without_fields(lanes);
                for (std::size_t i = 0; i < cases.size(); ++i) {
                    double excess = difference(in_batch(batch, i), alone(cases[i])) / 1e-12;
                    if (!(excess <= 1)) excess /= 1 + 50 * conditioning(cases[i]) / 1e-12;
                    if (excess <= worst) continue;
                    worst = excess;
                    where = std::string(name(static_cast<Stress>(kind))) + ": " + cases[i].text();
                }
            }
        }
    }
    INFO(where);
    CHECK(worst <= 1);
}

TEST_CASE("a batch of biaxial faces gives what each face gives alone", "[interface][batch]") {
    Random random(65);
    double worst = 0;
    std::string where;
    for (const GeneralStress stress :
         {GeneralStress::into_biaxial, GeneralStress::out_of_biaxial,
          GeneralStress::biaxial_to_biaxial, GeneralStress::normal_incidence,
          GeneralStress::near_normal, GeneralStress::grazing, GeneralStress::near_critical_inside,
          GeneralStress::total_reflection, GeneralStress::optic_axis_refracted,
          GeneralStress::optic_axis_incident, GeneralStress::principal_plane,
          GeneralStress::weak_biaxiality, GeneralStress::no_biaxiality,
          GeneralStress::strong_biaxiality, GeneralStress::same_medium}) {
        int solved = 0, left = 0;
        std::array<std::vector<InterfaceCase>, 6> of_mode;
        std::array<std::vector<std::string>, 6> texts;
        for (int i = 0; i < 120; ++i) {
            const GeneralCase c = random_case(random, stress);
            const Medium from = c.from.medium();
            const auto mode = static_cast<std::size_t>(modes_of(from)[c.mode]);
            of_mode[mode].push_back(
                {from, c.to.medium(), c.normal, c.direction, static_cast<Mode>(mode)});
            texts[mode].push_back(c.text());
        }
        for (std::size_t mode = 0; mode < of_mode.size(); ++mode) {
            const auto& cases = of_mode[mode];
            if (cases.empty()) continue;
            for (const Lanes lanes : available()) {
                BatchArrays batch(cases), one_by_one(cases);
                batch.solve(lanes);
                one_by_one.solve(Lanes::scalar);
                for (std::size_t i = 0; i < cases.size(); ++i) {
                    const auto right = alone(cases[i]), found = in_batch(batch, i);
                    double excess = difference(in_phase(found, right), right) / 1e-12;
                    if (!(excess <= 1)) excess /= 1 + 50 * conditioning(cases[i]) / 1e-12;
                    ++solved;
                    left += difference(found, in_batch(one_by_one, i)) == 0;  // to the bit
                    if (excess <= worst) continue;
                    worst = excess;
                    where = std::string(name(stress)) + ": " + texts[mode][i];
                }
            }
        }
        const bool lanes_decline = stress == GeneralStress::grazing ||
                                   stress == GeneralStress::near_critical_inside ||
                                   stress == GeneralStress::total_reflection ||  // by a crystal
                                   stress == GeneralStress::optic_axis_refracted ||
                                   stress == GeneralStress::optic_axis_incident ||
                                   stress == GeneralStress::strong_biaxiality;
        if (lanes_decline) continue;
        INFO(name(stress) << ": " << left << " of " << solved << " left to Interface");
        CHECK(2 * left < solved);
    }
    INFO(where);
    CHECK(worst <= 1);
}

TEST_CASE("a batch in single precision gives what its inputs allow", "[interface][batch]") {
    constexpr double epsilon = std::numeric_limits<float>::epsilon(),
                     ulp = epsilon / std::numeric_limits<double>::epsilon();
    Random random(63);
    int solved = 0, exact = 0;
    for (const Stress stress :
         {Stress::ordinary, Stress::grazing, Stress::axis_in_face, Stress::strong_birefringence,
          Stress::crystal_to_crystal, Stress::near_critical, Stress::one_mode_evanescent}) {
        for (const Mode mode : {Mode::p, Mode::extraordinary}) {
            std::vector<InterfaceCase> cases;
            for (int tries = 0; tries < 800 && cases.size() < 100; ++tries) {
                const InterfaceCase c = random_case(random, stress);
                if (c.mode == mode) cases.push_back(c);
            }
            if (cases.empty()) continue;
            for (const Lanes lanes : available()) {
                BatchArrays batch(cases);
                batch.faces.precision = Precision::single;
                batch.solve(lanes);
                double worst = 0;
                for (std::size_t i = 0; i < cases.size(); ++i) {
                    const double error = difference(in_batch(batch, i), alone(cases[i]));
                    worst =
                        std::max(worst, error / (50 * epsilon + 50 * conditioning(cases[i], ulp)));
                    exact += error < epsilon / 1000;
                    ++solved;
                }
                INFO(name(stress) << ", worst " << worst);
                CHECK(worst <= 1);
            }
        }
    }
    CHECK(4 * exact < solved);  // lanes did it, not Interface
}

TEST_CASE("faces of a batch may have media of every kind side by side", "[interface][batch]") {
    Random random(62);
    std::vector<InterfaceCase> cases;
    while (cases.size() < 200) {
        InterfaceCase c = random_case(random, Stress::ordinary);
        if (c.mode != Mode::p) continue;
        if (random.uniform() < 0.2) {
            c.to = Medium::biaxial({1.606, 1.609, 1.616}, {1, 0, 0}, {0, 1, 0});
        }
        cases.push_back(c);
    }
    BatchArrays batch(cases);
    for (const Lanes lanes : available()) {
        batch.solve(lanes);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            CHECK(difference(in_batch(batch, i), alone(cases[i])) < 1e-12);
        }
    }
}

TEST_CASE("what all faces of a batch share is given once", "[interface][batch]") {
    Random random(63);
    std::vector<InterfaceCase> cases;
    InterfaceCase c = random_case(random, Stress::crystal_to_crystal);
    for (int i = 0; i < 50; ++i) {
        const Vec3 d = random.direction();
        c.direction = dot(d, c.normal) < 0 ? -d : d;
        c.mode = Mode::ordinary;
        cases.push_back(c);
    }
    BatchArrays each(cases), shared(cases);
    shared.faces.from = {&c.from, 0};
    shared.faces.to = {&c.to, 0};
    shared.faces.normal = {{&c.normal.x, 0}, {&c.normal.y, 0}, {&c.normal.z, 0}};
    each.solve(widest_lanes());
    shared.solve(widest_lanes());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        CHECK(difference(in_batch(each, i), in_batch(shared, i)) == 0);
    }
}

TEST_CASE("a wave that leaves its face stops the batch by name", "[interface][batch]") {
    Random random(64);
    std::vector<InterfaceCase> cases(20, random_case(random, Stress::ordinary));
    if (GENERATE(false, true)) {
        for (InterfaceCase& c : cases) {
            c.from = Medium::isotropic(1);
            c.to = Medium::biaxial({1.606, 1.609, 1.616}, {1, 0, 0}, {0, 1, 0});
            c.mode = Mode::p;
        }
    }
    cases[13].direction = -cases[13].direction;
    BatchArrays batch(cases);
    for (const Lanes lanes : available()) {
        CHECK_THROWS_WITH(batch.solve(lanes), Catch::Contains("direction[13]"));
    }
    cases[13].direction = {std::nan(""), 0, 1};
    BatchArrays broken(cases);
    CHECK_THROWS_AS(broken.solve(widest_lanes()), Error);
}
