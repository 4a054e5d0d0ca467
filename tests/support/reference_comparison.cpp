// Flattens the answers of core and reference to like lists of numbers and measures their distance.
#include "support/reference_comparison.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "interface/interface.hpp"
#include "support/maxwell_reference.hpp"

namespace icespar::testing {

namespace {

void push(std::vector<double>& out, const CVec3& v) {
    for (const Complex& z : {v.x, v.y, v.z}) out.insert(out.end(), {z.real(), z.imag()});
}

std::vector<double> flat(const CVec3& v) {
    std::vector<double> out;
    push(out, v);
    return out;
}

CVec3 to_double(const reference::Vector& v) {
    const auto z = [](const reference::Cplx& a) {
        return Complex(static_cast<double>(a.real()), static_cast<double>(a.imag()));
    };
    return {z(v[0]), z(v[1]), z(v[2])};
}

reference::Double3 array(const Vec3& v) { return {v.x, v.y, v.z}; }

reference::Material material(const Medium& m) {
    return m.birefringent ? reference::Material::uniaxial(m.n_o, m.n_e, array(m.axis))
                          : reference::Material::isotropic(m.n_o);
}

/// True where the incident polarisation is, or is nearly, a matter of choice.
bool undetermined(const InterfaceCase& c) {
    const Vec3& special = c.from.birefringent ? c.from.axis : c.normal;
    return length(cross(special, c.direction)) < 1e-3;
}

Mode other(Mode mode) {
    switch (mode) {
        case Mode::s:
            return Mode::p;
        case Mode::p:
            return Mode::s;
        case Mode::ordinary:
            return Mode::extraordinary;
        default:
            return Mode::ordinary;
    }
}

/// One wave of either solver in plain numbers.
struct PlainWave {
    CVec3 k, E, H;
    Vec3 ray;
    Complex amplitude = 1;
    double power = 1;
};

/// Incident, two reflected, two transmitted.
using PlainWaves = std::array<PlainWave, 5>;

PlainWaves core_waves(const InterfaceCase& c) {
    const Wave incident = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
    const Interface face(c.from, c.to, c.normal, incident);
    const Coefficients a = face.solve(incident);
    const auto plain = [](const Wave& w, const Complex& amplitude, double power) {
        return PlainWave{w.k, w.E, w.H, w.ray, amplitude, power};
    };
    const auto& [reflected, transmitted] = face.waves();
    return {plain(incident, 1, 1), plain(reflected[0], a.reflected[0], a.reflected_power[0]),
            plain(reflected[1], a.reflected[1], a.reflected_power[1]),
            plain(transmitted[0], a.transmitted[0], a.transmitted_power[0]),
            plain(transmitted[1], a.transmitted[1], a.transmitted_power[1])};
}

PlainWaves reference_waves(const InterfaceCase& c) {
    const reference::Solution s = reference::solve(
        material(c.from), material(c.to), array(c.normal), array(c.direction), c.mode_index());
    const auto plain = [](const reference::PlaneWave& w) {
        const auto ray = w.ray();
        return PlainWave{
            to_double(w.k),
            to_double(w.E),
            to_double(w.H),
            {static_cast<double>(ray[0]), static_cast<double>(ray[1]), static_cast<double>(ray[2])},
            Complex(static_cast<double>(w.amplitude.real()),
                    static_cast<double>(w.amplitude.imag())),
            static_cast<double>(w.power)};
    };
    return {plain(s.incident), plain(s.reflected[0]), plain(s.reflected[1]),
            plain(s.transmitted[0]), plain(s.transmitted[1])};
}

double size(const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum);
}

Quantity quantity(std::string name, std::vector<double> values, double terms = 0) {
    const double scale = std::max({1.0, size(values), terms});
    return {std::move(name), std::move(values), scale};
}

/// Total power and fields of both sides. Of two incidences of one wave normal: summed over them,
/// the fields times the conjugate incident field.
void add_totals(Answer& result, const std::vector<PlainWaves>& incidences) {
    for (int side = 0; side < 2; ++side) {
        const std::string who = side == 0 ? "total reflected " : "total transmitted ";
        double power = 0;
        std::array<std::vector<double>, 2> terms;  // of E and H
        std::array<std::array<CVec3, 3>, 2> field{};
        for (const PlainWaves& w : incidences) {
            const CVec3 in = incidences.size() > 1 ? conj(w[0].E) : CVec3{1, 0, 0};
            for (const PlainWave& v : {w[1 + 2 * side], w[2 + 2 * side]}) {
                power += v.power;
                for (int f = 0; f < 2; ++f) {
                    const CVec3 part = v.amplitude * (f == 0 ? v.E : v.H);
                    terms[f].push_back(length(part));
                    field[f][0] += in.x * part;
                    field[f][1] += in.y * part;
                    field[f][2] += in.z * part;
                }
            }
        }
        result.push_back(quantity(who + "power", {power}));
        for (int f = 0; f < 2; ++f) {
            std::vector<double> values;
            for (const CVec3& v : field[f]) push(values, v);
            result.push_back(quantity(who + (f == 0 ? "E" : "H"), values, size(terms[f])));
        }
    }
}

template <class Solver>
Answer answer(const InterfaceCase& c, Solver solver) {
    static constexpr std::array<const char*, 5> names{"incident", "reflected 0", "reflected 1",
                                                      "transmitted 0", "transmitted 1"};
    const PlainWaves w = solver(c);
    Answer result;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const std::string who = names[i];
        result.push_back(quantity(who + " k", flat(w[i].k)));
        result.push_back(quantity(who + " E", flat(w[i].E)));
        result.push_back(quantity(who + " ray", {w[i].ray.x, w[i].ray.y, w[i].ray.z}));
        if (i == 0) continue;
        result.push_back(quantity(who + " power", {w[i].power}));
        result.push_back(quantity(who + " field", flat(w[i].amplitude * w[i].E)));
    }
    std::vector<PlainWaves> incidences{w};
    if (undetermined(c)) {
        InterfaceCase d = c;
        d.mode = other(c.mode);
        incidences.push_back(solver(d));
    }
    add_totals(result, incidences);
    return result;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

}  // namespace

std::vector<InterfaceCase> moved(const InterfaceCase& c, double ulps) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    std::vector<InterfaceCase> cases;
    const auto move = [&](auto member, double by) {
        cases.push_back(c);
        double& value = member(cases.back());
        value += by == 0 ? ulps * epsilon * value : ulps * by;
    };
    const auto move_vector = [&](auto member) {
        for (double Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z})
            move([&](InterfaceCase& d) -> double& { return member(d).*component; }, epsilon / 2);
    };
    move_vector([](InterfaceCase& d) -> Vec3& { return d.normal; });
    move_vector([](InterfaceCase& d) -> Vec3& { return d.direction; });
    for (Medium InterfaceCase::*side : {&InterfaceCase::from, &InterfaceCase::to}) {
        move([&](InterfaceCase& d) -> double& { return (d.*side).n_o; }, 0);
        if (!(c.*side).birefringent) continue;
        move([&](InterfaceCase& d) -> double& { return (d.*side).n_e; }, 0);
        move_vector([&](InterfaceCase& d) -> Vec3& { return (d.*side).axis; });
    }
    return cases;
}

/// Every number moved at once by an ulp, up or down, in some ways: beside a critical angle one
/// number alone may leave a wave evanescent that all together let propagate.
std::vector<InterfaceCase> moved_together(const InterfaceCase& c) {
    Random random(1);
    const auto move = [&] { return random.sign() * std::numeric_limits<double>::epsilon(); };
    const auto turn = [&](Vec3& v) { v += 0.5 * Vec3{move(), move(), move()}; };
    std::vector<InterfaceCase> cases(24, c);
    for (InterfaceCase& d : cases) {
        turn(d.normal);
        turn(d.direction);
        for (Medium* m : {&d.from, &d.to}) {
            m->n_o *= 1 + move();
            m->n_e = m->birefringent ? m->n_e * (1 + move()) : m->n_o;
            if (m->birefringent) turn(m->axis);
        }
    }
    return cases;
}

Answer core_answer(const InterfaceCase& c) { return answer(c, core_waves); }
Answer reference_answer(const InterfaceCase& c) { return answer(c, reference_waves); }

Accuracy accuracy(const InterfaceCase& c) {
    const Answer truth = reference_answer(c), found = core_answer(c);
    const std::size_t count = truth.size();
    std::vector<double> error(count), conditioning(count);
    Accuracy result;
    for (std::size_t i = 0; i < count; ++i) {
        error[i] = distance(truth[i].values, found[i].values) / truth[i].scale;
        if (!std::isfinite(error[i])) error[i] = std::numeric_limits<double>::infinity();
        result.largest_error = std::max(result.largest_error, error[i]);
    }
    const auto judge = [&] {
        result.worst = {};
        for (std::size_t i = 0; i < count; ++i) {
            const double excess = error[i] / (1e-12 + 50 * conditioning[i]);
            if (excess >= result.worst.excess)
                result.worst = {truth[i].name, error[i], conditioning[i], excess};
        }
        return result.worst.excess <= 1;
    };
    if (judge()) return result;
    result.conditioned = true;
    const auto change = [&](const Answer& changed, std::size_t i) {
        return distance(truth[i].values, changed[i].values) / truth[i].scale;
    };
    // Steps are tried, upward ones first, until they explain the error.
    for (const double ulps : {1.0, -1.0}) {
        std::vector<double> sum(count);
        for (const InterfaceCase& d : moved(c, ulps)) {
            const Answer changed = reference_answer(d);
            for (std::size_t i = 0; i < count; ++i) {
                sum[i] += change(changed, i);
                conditioning[i] = std::max(conditioning[i], sum[i]);
            }
            if (judge()) return result;
        }
    }
    for (const InterfaceCase& d : moved_together(c)) {
        const Answer changed = reference_answer(d);
        for (std::size_t i = 0; i < count; ++i) {
            conditioning[i] = std::max(conditioning[i], change(changed, i));
        }
        if (judge()) return result;
    }
    return result;
}

Discrepancy compare(const InterfaceCase& c) { return accuracy(c).worst; }

}  // namespace icespar::testing
