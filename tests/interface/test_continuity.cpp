// Nothing jumps: across every limit the summed outputs of a face vary smoothly, in Interface and in
// batches alike, whichever of their cases they pass through.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <numbers>
#include <vector>

#include "interface/batch.hpp"
#include "interface/interface.hpp"
#include "support/batch_arrays.hpp"
#include "support/interface_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

/// Total powers and summed fields of both sides. Fields are summed over the incident modes, each
/// times the conjugate incident field, so that nothing depends on how those were chosen.
using Summed = std::vector<double>;
constexpr std::size_t numbers = 2 + 4 * 3 * 3 * 2;

void add(Summed& to, const CVec3& incident, const std::array<double, 2>& powers,
         const std::array<CVec3, 4>& fields) {
    to[0] += powers[0];
    to[1] += powers[1];
    std::size_t at = 2;
    for (const CVec3& field : fields) {
        for (const Complex& in : {incident.x, incident.y, incident.z}) {
            for (const Complex& f : {field.x, field.y, field.z}) {
                const Complex product = std::conj(in) * f;
                to[at++] += product.real();
                to[at++] += product.imag();
            }
        }
    }
}

Summed by_interface(const InterfaceCase& c) {
    Summed all(numbers);
    for (const Mode mode : modes_of(c.from)) {
        const Wave in = plane_wave(c.from, mode, c.direction, By::wave_normal, c.normal);
        const Interface face(c.from, c.to, c.normal, in);
        const Coefficients a = face.solve(in);
        const SummedFields f = face.summed_fields(in);
        add(all, in.E, {a.reflected_total, a.transmitted_total},
            {f.reflected_E, f.reflected_H, f.transmitted_E, f.transmitted_H});
    }
    return all;
}

std::vector<Summed> by_batch(std::vector<InterfaceCase> cases, bool shortcut) {
    std::vector<Summed> all(cases.size(), Summed(numbers));
    for (const Mode mode : modes_of(cases[0].from)) {
        for (InterfaceCase& c : cases) c.mode = mode;
        BatchArrays batch(cases);
        batch.solve(widest_lanes());
        if (shortcut) batch.solve_without_fields(widest_lanes());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const auto r = batch.total(false, i), t = batch.total(true, i);
            add(all[i], batch.incident(i).E, {r.power, t.power}, {r.E, r.H, t.E, t.H});
        }
    }
    return all;
}

/// Largest difference of b from (1 - w) a + w c.
double deviation(const Summed& a, const Summed& b, const Summed& c, double w) {
    double most = 0;
    for (std::size_t i = 0; i < numbers; ++i) {
        const double d = std::abs(b[i] - (1 - w) * a[i] - w * c[i]);
        if (!(d <= most)) most = std::isnan(d) ? 1e300 : d;
    }
    return most;
}

/// How outputs vary with x beside x = 0: smoothly, or as a root does (critical angles).
enum class As { smooth, root };

/// The sweep x = 0, 10^-17 ... 10^-1, and the same below 0. In v = x or its root, each value may
/// differ from the line through its neighbours by `curvature` times the square of their distance,
/// and by what an ulp of x makes of v. Returns the largest difference in units of that.
double worst_jump(const std::function<InterfaceCase(double)>& at, As as, double curvature,
                  bool both_sides = true, double most = 0.1) {
    constexpr double least = 1e-17;
    std::vector<double> x, v;
    std::vector<InterfaceCase> cases;
    const auto place = [&](double value) {
        x.push_back(value);
        v.push_back(as == As::root ? std::copysign(std::sqrt(std::abs(value)), value) : value);
        cases.push_back(at(value));
    };
    const double step = std::pow(10, 1.0 / 32);
    for (double value = most; both_sides && value > least; value /= step) place(-value);
    place(0);
    for (double value = least; value < most; value *= step) place(value);
    std::vector<std::vector<Summed>> ways{{}, by_batch(cases, false), by_batch(cases, true)};
    for (const InterfaceCase& c : cases) ways[0].push_back(by_interface(c));
    constexpr double ulps = 1e-14;
    double worst = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double noise =
            as == As::root ? std::sqrt(std::abs(x[i]) + ulps) - std::sqrt(std::abs(x[i])) : ulps;
        const double span = v[i + 1] - v[i - 1], w = (v[i] - v[i - 1]) / span;
        const bool across = x[i - 1] * x[i + 1] <= 0;  // the root has a kink at 0
        const double allowed =
            curvature * (span * span + (across && as == As::root ? span : 0) + noise);
        for (const auto& way : ways) {
            worst = std::max(worst, deviation(way[i - 1], way[i], way[i + 1], w) / allowed);
            worst = std::max(worst, deviation(ways[0][i], way[i], way[i], 0) / (curvature * noise));
        }
    }
    return worst;
}

const Medium air = Medium::isotropic(1), dense = Medium::isotropic(2.1),
             calcite = Medium::uniaxial(1.6584, 1.4864, {0.36, 0.48, 0.8}),
             rutile = Medium::uniaxial(2.616, 2.903, {-0.6, 0.64, 0.48});

/// Incidence at an angle from the normal, along -x + y.
InterfaceCase inclined(const Medium& from, const Medium& to, double angle) {
    InterfaceCase c;
    c.from = from;
    c.to = to;
    c.normal = {0, 0, 1};
    c.direction = {-0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle)};
    return c;
}

struct Pair {
    const char* name;
    Medium from, to;
};
const std::vector<Pair> pairs{
    {"air to calcite", air, calcite},       {"calcite to air", calcite, air},
    {"dense to calcite", dense, calcite},   {"rutile to calcite", rutile, calcite},
    {"calcite to rutile", calcite, rutile}, {"dense to air", dense, air}};

}  // namespace

TEST_CASE("nothing jumps at normal incidence", "[interface][continuity]") {
    for (const Pair& p : pairs) {
        INFO(p.name);
        const auto at = [&](double x) { return inclined(p.from, p.to, x); };
        CHECK(worst_jump(at, As::smooth, 10) <= 1);
    }
}

TEST_CASE("nothing jumps where light runs along an axis", "[interface][continuity]") {
    for (const Pair& p : pairs) {
        INFO(p.name);
        // At x = 0 the incident or the refracted ordinary wave runs along the axis.
        const double angle = 0.3;
        if (p.from.birefringent) {
            const auto at = [&](double x) {
                InterfaceCase c = inclined(p.from, p.to, angle + x);
                c.from.axis = inclined(p.from, p.to, angle).direction;
                return c;
            };
            CHECK(worst_jump(at, As::smooth, 30) <= 1);
        }
        if (p.to.birefringent) {
            const double refracted = std::asin(p.from.n_o / p.to.n_o * std::sin(angle));
            const auto at = [&](double x) {
                InterfaceCase c = inclined(p.from, p.to, angle + x);
                c.to.axis = inclined(p.from, p.to, refracted).direction;
                return c;
            };
            CHECK(worst_jump(at, As::smooth, 30) <= 1);
        }
    }
}

TEST_CASE("nothing jumps where the axis stands on the face", "[interface][continuity]") {
    for (const Pair& p : pairs) {
        INFO(p.name);
        const auto at = [&](double x) {
            InterfaceCase c = inclined(p.from, p.to, 0.4);
            for (Medium* m : {&c.from, &c.to}) {
                if (m->birefringent) m->axis = {0.8 * std::sin(x), 0.6 * std::sin(x), std::cos(x)};
            }
            return c;
        };
        CHECK(worst_jump(at, As::smooth, 10) <= 1);
    }
}

TEST_CASE("nothing jumps where birefringence vanishes", "[interface][continuity]") {
    for (const Pair& p : pairs) {
        INFO(p.name);
        for (const double angle : {0.4, 1.2}) {
            const auto at = [&](double x) {
                InterfaceCase c = inclined(p.from, p.to, angle);
                for (Medium* m : {&c.from, &c.to}) {
                    if (m->birefringent) m->n_e = m->n_o + x;
                }
                return c;
            };
            CHECK(worst_jump(at, As::smooth, 100) <= 1);
        }
    }
}

TEST_CASE("nothing jumps where light grazes the face", "[interface][continuity]") {
    for (const Pair& p : pairs) {
        INFO(p.name);
        const auto at = [&](double x) {
            return inclined(p.from, p.to, std::numbers::pi / 2 - 2e-9 - x);
        };
        if (!p.from.birefringent) CHECK(worst_jump(at, As::smooth, 100, false) <= 1);
    }
}

TEST_CASE("nothing jumps at critical angles", "[interface][continuity]") {
    for (const Pair& p : pairs) {
        INFO(p.name);
        if (p.from.birefringent || p.from.n_o < p.to.n_o) continue;
        // The ordinary wave turns evanescent at x = 0. With the axis across the plane of incidence
        // so does, at another angle, the extraordinary one.
        for (const double index : {p.to.n_o, p.to.n_e}) {
            const double critical = std::asin(index / p.from.n_o);
            const auto at = [&](double x) {
                InterfaceCase c = inclined(p.from, p.to, critical + x);
                if (c.to.birefringent && index == p.to.n_e) c.to.axis = {0.8, 0.6, 0};
                return c;
            };
            CHECK(worst_jump(at, As::root, 100) <= 1);
        }
    }
}

TEST_CASE("nothing jumps where two evanescent waves become one", "[interface][continuity]") {
    const Medium quartz = Medium::uniaxial(1.5442, 1.5533, {0.8, 0.6, 0});
    for (const double across : {0.0, 0.3}) {
        const auto at = [&](double x) {
            InterfaceCase c = inclined(dense, quartz, 0);
            const double along = quartz.n_o * (1 + x) / dense.n_o;
            c.direction = normalised(along * quartz.axis + across * Vec3{-0.6, 0.8, 0} +
                                     std::sqrt(1 - along * along - across * across) * c.normal);
            return c;
        };
        CHECK(worst_jump(at, across == 0 ? As::root : As::smooth, 100, true, 0.02) <= 1);
    }
}
