// The general solver against the sixty-digit reference, with the conditioning of each case as
// yardstick.
#include <algorithm>
#include <limits>

#include "support/batch_arrays.hpp"
#include "support/general_cases.hpp"

namespace icespar::testing {

namespace {

struct Quantity {
    std::string name;
    std::vector<double> values;
};

struct Mode2 {
    CVec3 k, field;
    Vec3 ray;
    double power = 0;
    bool carries = true;
};

struct Solved {
    CVec3 incident_k, incident_E;
    std::array<std::array<Mode2, 2>, 2> modes;  ///< [side][mode]
    std::array<CVec3, 2> E, H;                  ///< summed, by side
    std::array<double, 2> total{};
    double interference = 0;
};

Solved core(const GeneralCase& c) {
    const Medium from = c.from.medium(), to = c.to.medium();
    const Wave in = c.incident();
    const Interface face(from, to, c.normal, in);
    const Coefficients a = face.solve(in);
    const OutgoingWaves out = face.waves();
    Solved s;
    s.incident_k = in.k;
    s.incident_E = in.E;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto mode = [](const Wave& w, const Complex& amplitude, double power) {
            return Mode2{w.k, amplitude * w.E, w.ray, power, w.propagating};
        };
        s.modes[0][i] = mode(out.reflected[i], a.reflected[i], a.reflected_power[i]);
        s.modes[1][i] = mode(out.transmitted[i], a.transmitted[i], a.transmitted_power[i]);
    }
    const auto sum = [](const Complex& x, const CVec3& v, const Complex& y, const CVec3& w) {
        return x * v + y * w;
    };
    if (from.plain() && to.plain()) {
        s.E = {sum(a.reflected[0], out.reflected[0].E, a.reflected[1], out.reflected[1].E),
               sum(a.transmitted[0], out.transmitted[0].E, a.transmitted[1], out.transmitted[1].E)};
        s.H = {sum(a.reflected[0], out.reflected[0].H, a.reflected[1], out.reflected[1].H),
               sum(a.transmitted[0], out.transmitted[0].H, a.transmitted[1], out.transmitted[1].H)};
    } else {
        const SummedFields sum_of = face.summed_fields(in);
        s.E = {sum_of.reflected_E, sum_of.transmitted_E};
        s.H = {sum_of.reflected_H, sum_of.transmitted_H};
    }
    s.total = {a.reflected_total, a.transmitted_total};
    s.interference = a.interference;
    return s;
}

/// By a batch of one in single precision, for plain media.
Solved in_single_precision(const GeneralCase& c) {
    const Medium from = c.from.medium();
    BatchArrays batch({{from, c.to.medium(), c.normal, c.direction, modes_of(from)[c.mode]}});
    batch.faces.precision = Precision::single;
    batch.solve(widest_lanes());
    Solved s;
    s.incident_k = batch.incident(0).k;
    s.incident_E = batch.incident(0).E;
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < 2; ++i) {
            const auto w = side == 0 ? batch.reflected(0, i) : batch.transmitted(0, i);
            s.modes[side][i] = {w.k, w.amplitude * w.E, w.ray, w.power, w.propagating};
        }
        const auto sum = batch.total(side == 1, 0);
        s.E[side] = sum.E;
        s.H[side] = sum.H;
        s.total[side] = sum.power;
    }
    return s;
}

CVec3 to_double(const reference::Vector& v) {
    const auto z = [](const reference::Cplx& a) {
        return Complex(static_cast<double>(a.real()), static_cast<double>(a.imag()));
    };
    return {z(v[0]), z(v[1]), z(v[2])};
}

Solved truth(const GeneralCase& c) {
    using namespace reference;
    const Double3 normal{c.normal.x, c.normal.y, c.normal.z};
    const Double3 direction{c.direction.x, c.direction.y, c.direction.z};
    const Solution r = reference::solve(c.from.material(), c.to.material(), normal, direction,
                                        static_cast<int>(c.mode));
    Solved s;
    s.incident_k = to_double(r.incident.k);
    s.incident_E = to_double(r.incident.E);
    const RealVector n = unit(normal);
    for (std::size_t side = 0; side < 2; ++side) {
        const auto& waves = side == 0 ? r.reflected : r.transmitted;
        const bool lossy = c.from.absorbing() || (side == 1 && c.to.absorbing());
        Vector E{}, H{};
        for (std::size_t i = 0; i < 2; ++i) {
            const PlaneWave& w = waves[i];
            const Vector field = combine(w.amplitude, w.E, Cplx(0), w.E);
            const auto ray = w.ray();
            const bool carries = w.propagating || lossy;
            const Real flow = (side == 0 ? -1 : 1) * reference::dot(w.flow, n);
            const Real power = flow > 0 ? Real(norm2(w.amplitude) * flow / r.normal_flux) : Real(0);
            s.modes[side][i] = {to_double(w.k),
                                to_double(field),
                                {static_cast<double>(ray[0]), static_cast<double>(ray[1]),
                                 static_cast<double>(ray[2])},
                                carries ? static_cast<double>(power) : 0,
                                carries};
            E = combine(Cplx(1), E, w.amplitude, w.E);
            H = combine(Cplx(1), H, w.amplitude, w.H);
        }
        s.E[side] = to_double(E);
        s.H[side] = to_double(H);
        const auto along = [&](const Vector& e, const Vector& h) {
            const Vector flow =
                reference::cross(e, Vector{conjugate(h[0]), conjugate(h[1]), conjugate(h[2])});
            return Real(reference::dot(RealVector{re(flow[0]), re(flow[1]), re(flow[2])}, n) /
                        r.normal_flux);
        };
        s.total[side] = static_cast<double>(Real((side == 0 ? -1 : 1) * along(E, H)));
        if (side == 0 && c.from.absorbing()) {
            s.interference =
                static_cast<double>(Real(-along(r.incident.E, H) - along(E, r.incident.H)));
        }
    }
    return s;
}

double distance(const CVec3& a, const CVec3& b) { return length(a - b); }

/// Turns the phase of `s` to that of `model`'s incident field and puts its modes in `model`'s
/// order.
void align(Solved& s, const Solved& model) {
    const Complex overlap = dot(conj(s.incident_E), model.incident_E);
    const double size = std::abs(overlap);
    const Complex phase = size > 0 ? overlap / size : Complex(1);
    s.incident_E = phase * s.incident_E;
    for (std::size_t side = 0; side < 2; ++side) {
        s.E[side] = phase * s.E[side];
        s.H[side] = phase * s.H[side];
        auto& m = s.modes[side];
        for (auto& mode : m) mode.field = phase * mode.field;
        const auto& to = model.modes[side];
        const auto cost = [&](std::size_t a, std::size_t b) {
            return distance(m[a].k, to[0].k) + distance(m[b].k, to[1].k) +
                   length(m[a].ray - to[0].ray) + length(m[b].ray - to[1].ray) +
                   1e-9 * (distance(m[a].field, to[0].field) + distance(m[b].field, to[1].field));
        };
        if (cost(1, 0) < cost(0, 1)) std::swap(m[0], m[1]);
    }
}

std::vector<Quantity> quantities(const Solved& s, const Solved& model) {
    std::vector<Quantity> out;
    const auto add = [&](const std::string& label, const CVec3& v) {
        out.push_back(
            {label, {v.x.real(), v.x.imag(), v.y.real(), v.y.imag(), v.z.real(), v.z.imag()}});
    };
    add("incident k", s.incident_k);
    add("incident E", s.incident_E);
    out.push_back({"interference", {s.interference}});
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string who = side == 0 ? "reflected " : "transmitted ";
        add(who + "total E", s.E[side]);
        add(who + "total H", s.H[side]);
        out.push_back({who + "total power", {s.total[side]}});
        for (std::size_t i = 0; i < 2; ++i) {
            const Mode2& m = s.modes[side][i];
            const std::string label = who + std::to_string(i);
            add(label + " k", m.k);
            add(label + " field", m.field);
            out.push_back({label + " power", {m.power}});
            const bool both = m.carries && model.modes[side][i].carries;
            out.push_back(
                {label + " ray", {both ? m.ray.x : 0, both ? m.ray.y : 0, both ? m.ray.z : 0}});
        }
    }
    return out;
}

double distance(const Quantity& a, const Quantity& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        sum += (a.values[i] - b.values[i]) * (a.values[i] - b.values[i]);
    }
    return std::sqrt(sum);
}

double scale(const Quantity& a) {
    double sum = 0;
    for (const double x : a.values) sum += x * x;
    return std::max(1.0, std::sqrt(sum));
}

std::vector<GeneralCase> moved(const GeneralCase& c, double ulps) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    std::vector<GeneralCase> cases;
    const auto move_vector = [&](auto member) {
        for (double Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            cases.push_back(c);
            member(cases.back()).*component += ulps * epsilon / 2;
        }
    };
    for (MediumRecipe GeneralCase::*side : {&GeneralCase::from, &GeneralCase::to}) {
        for (std::size_t i = 0; i < 3; ++i) {
            cases.push_back(c);
            (cases.back().*side).n[i] *= 1 + ulps * epsilon;
            if ((c.*side).n[i].imag() > 0) {
                cases.push_back(c);
                Complex& n = (cases.back().*side).n[i];
                n = {n.real() * (1 + ulps * epsilon), n.imag()};
            }
        }
        for (double MediumRecipe::*g : {&MediumRecipe::gyration, &MediumRecipe::gyration_along}) {
            if ((c.*side).*g == 0) continue;
            cases.push_back(c);
            (cases.back().*side).*g *= 1 + ulps * epsilon;
        }
        if ((c.*side).skew != Complex(0)) {
            cases.push_back(c);
            (cases.back().*side).skew *= 1 + ulps * epsilon;
        }
        if ((c.*side).symmetry == Symmetry::isotropic) continue;
        move_vector([&](GeneralCase& d) -> Vec3& { return (d.*side).first; });
        move_vector([&](GeneralCase& d) -> Vec3& { return (d.*side).second; });
    }
    move_vector([](GeneralCase& d) -> Vec3& { return d.normal; });
    move_vector([](GeneralCase& d) -> Vec3& { return d.direction; });
    return cases;
}

/// Every number moved at once, by up to so many ulps, in a few ways. Where an answer depends on the
/// direction of a vanishing difference (s and p at normal incidence), no number alone shows it.
std::vector<GeneralCase> moved_together(const GeneralCase& c, double ulps) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Random random(1);
    const auto move = [&] { return random.uniform(-1, 1) * ulps * epsilon; };
    std::vector<GeneralCase> cases(12, c);
    for (GeneralCase& d : cases) {
        for (MediumRecipe* m : {&d.from, &d.to}) {
            for (Complex& n : m->n) n = {n.real() * (1 + move()), n.imag() * (1 + move())};
            for (Vec3* v : {&m->first, &m->second}) *v += 0.5 * Vec3{move(), move(), move()};
        }
        for (Vec3* v : {&d.normal, &d.direction}) *v += 0.5 * Vec3{move(), move(), move()};
    }
    return cases;
}

}  // namespace

GeneralDiscrepancy compare(const GeneralCase& c) {
    const Solved right = truth(c);
    Solved found = core(c);
    align(found, right);
    const auto a = quantities(right, found), b = quantities(found, right);
    std::vector<double> error(a.size()), conditioning(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        error[i] = distance(a[i], b[i]) / scale(a[i]);
        if (!std::isfinite(error[i])) error[i] = std::numeric_limits<double>::infinity();
    }
    GeneralDiscrepancy worst;
    const auto judge = [&] {
        worst = {};
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double excess = error[i] / (1e-12 + 50 * conditioning[i]);
            if (excess >= worst.excess) worst = {a[i].name, error[i], conditioning[i], excess};
        }
        return worst.excess <= 1;
    };
    // Nothing more is tried once an error is ten times explained.
    constexpr double plain_enough = 0.1;
    judge();
    for (const double ulps : {1.0, -1.0}) {
        if (worst.excess <= 1) break;
        std::vector<GeneralCase> all = moved_together(c, ulps), single = moved(c, ulps);
        all.insert(all.end(), single.begin(), single.end());
        for (const GeneralCase& d : all) {
            if (worst.excess <= plain_enough) break;
            Solved changed = truth(d);
            align(changed, right);
            const auto q = quantities(changed, found);
            for (std::size_t i = 0; i < a.size(); ++i) {
                conditioning[i] = std::max(conditioning[i], distance(a[i], q[i]) / scale(a[i]));
            }
            judge();
        }
    }
    return worst;
}

GeneralExtent extent(const GeneralCase& c, const GeneralCase& moved) {
    const Solved right = truth(c);
    Solved found = core(c), changed = truth(moved);
    align(found, right);
    align(changed, right);
    GeneralExtent out;
    const auto largest = [&](const Solved& other, double& of_totals, double& of_waves) {
        const auto a = quantities(right, other), b = quantities(other, right);
        for (std::size_t i = 0; i < a.size(); ++i) {
            double& place = a[i].name.find("total") != std::string::npos ? of_totals : of_waves;
            place = std::max(place, distance(a[i], b[i]) / scale(a[i]));
        }
    };
    largest(found, out.error_of_totals, out.error_of_waves);
    largest(changed, out.change_of_totals, out.change_of_waves);
    if (c.from.medium().plain() && c.to.medium().plain()) {
        Solved roughly = in_single_precision(c);
        align(roughly, right);
        largest(roughly, out.single_error_of_totals, out.single_error_of_waves);
    }
    return out;
}

}  // namespace icespar::testing
