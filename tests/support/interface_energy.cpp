// Energy balance and reversal of single faces, and the list of the worst.
#include "support/interface_energy.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "interface/interface.hpp"

namespace icespar::testing {

double energy_error(const InterfaceCase& c) {
    const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
    const Coefficients a = Interface(c.from, c.to, c.normal, in).solve(in);
    double sum = -1;
    for (const double p : {a.reflected_power[0], a.reflected_power[1], a.transmitted_power[0],
                           a.transmitted_power[1]}) {
        if (!(p >= 0) || !std::isfinite(p)) return std::numeric_limits<double>::quiet_NaN();
        sum += p;
    }
    return sum;
}

namespace {

/// Time reversal: E -> E*, H -> -H*, k -> -k*.
Wave reversed(const Wave& w) {
    Wave r = w;
    r.k = -conj(w.k);
    r.E = conj(w.E);
    r.H = -conj(w.H);
    r.ray = -w.ray;
    return r;
}

/// Sine of the angle between the wave normal and what defines its polarisation.
double sharpness(const Medium& m, const Wave& w, const Vec3& normal) {
    return length(cross(m.birefringent ? m.axis : normal, real(w.k))) / w.n_phase;
}

/// How far the face is from the critical angle of any outgoing wave: rounding of the wave vector
/// moves powers by its inverse.
double distance_from_critical(const OutgoingWaves& out, const Vec3& normal) {
    double least = 1;
    for (const auto& side : {out.reflected, out.transmitted})
        for (const Wave& w : side)
            least = std::min(least, w.propagating
                                        ? std::abs(dot(w.ray, normal))
                                        : std::abs(std::imag(dot(w.k, complexified(normal)))));
    return least;
}

}  // namespace

double reciprocity_error(const InterfaceCase& c) {
    const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
    const Interface face(c.from, c.to, c.normal, in);
    const Coefficients there = face.solve(in);
    const OutgoingWaves out = face.waves();
    const double in_sharpness = sharpness(c.from, in, c.normal);
    const double depth = c.cos_ray * distance_from_critical(out, c.normal);
    const int a = c.mode_index();
    double worst = 0;
    for (int b = 0; b < 2; ++b)
        for (const bool reflected : {true, false}) {
            const Wave& w = reflected ? out.reflected[b] : out.transmitted[b];
            const Medium& medium = reflected ? c.from : c.to;
            const double sharp = std::min(in_sharpness, sharpness(medium, w, c.normal));
            if (!w.propagating || sharp < 1e-7) continue;
            const Wave back_in = reversed(w);
            double there_power, back_power;
            if (reflected) {
                there_power = there.reflected_power[b];
                back_power =
                    Interface(c.from, c.to, c.normal, back_in).solve(back_in).reflected_power[a];
            } else {
                there_power = there.transmitted_power[b];
                back_power =
                    Interface(c.to, c.from, -c.normal, back_in).solve(back_in).transmitted_power[a];
            }
            const double error = std::min(depth, sharp) * std::abs(there_power - back_power);
            worst = error <= worst ? worst : error;
        }
    return worst;
}

void EnergyTally::add(const InterfaceCase& c) {
    ++count_;
    const double error = energy_error(c);
    double excess = std::abs(error) * c.cos_ray / 1e-13;
    if (std::isnan(error)) ++invalid_, excess = std::numeric_limits<double>::infinity();
    if (worst_.size() == 10 && excess <= worst_.back().excess) return;
    if (worst_.size() == 10) worst_.pop_back();
    const auto place = std::find_if(worst_.begin(), worst_.end(),
                                    [&](const Entry& e) { return e.excess < excess; });
    worst_.insert(place, {error, excess, c});
}

double EnergyTally::worst_excess() const { return worst_.empty() ? 0 : worst_.front().excess; }

std::string EnergyTally::report() const {
    std::ostringstream out;
    out << count_ << " cases, " << invalid_ << " with NaN, infinity or negative power\n";
    for (const Entry& e : worst_)
        out << "R + T - 1 = " << e.error << ", ray at cosine " << e.problem.cos_ray << " ("
            << e.excess << " of the tolerance): " << e.problem.text() << "\n";
    return out.str();
}

}  // namespace icespar::testing
