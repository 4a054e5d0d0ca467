// The closed forms of Weidlich & Wilkie, misprints corrected, for light that enters a uniaxial
// crystal.
#include <algorithm>
#include <catch2/catch.hpp>

#include "interface/interface.hpp"
#include "support/interface_cases.hpp"
#include "support/maxwell_reference.hpp"
#include "support/paper.hpp"

using namespace icespar;
using icespar::testing::Random;

namespace {

/// An entry from n_i into a crystal, drawn so that both waves propagate and no closed form is 0/0.
struct Draw {
    double n_i, n_o, n_e, angle;
    Vec3 axis;

    explicit Draw(Random& random)
        : n_i(random.uniform(1, 1.4)),
          n_o(random.uniform(1.4, 2.7)),
          n_e(std::max(1.4, n_o + random.uniform(-0.4, 0.7))),
          angle(random.uniform(0.02, 1.5)),
          axis(random.direction()) {}
};

double distance(const CVec3& a, const std::array<double, 3>& b) {
    return length(a - complexified(Vec3{b[0], b[1], b[2]}));
}

}  // namespace

TEST_CASE("the interface gives the paper's amplitudes, rays and powers of entry",
          "[interface][paper]") {
    Random random(31);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Draw d(random);
        const double sin_i = std::sin(d.angle), cos_i = std::cos(d.angle);
        const paper::Entry<double> e(d.n_i, d.n_o, d.n_e, {d.axis.x, d.axis.y, d.axis.z}, sin_i,
                                     cos_i);
        const Medium outside = Medium::isotropic(d.n_i);
        const Medium crystal = Medium::uniaxial(d.n_o, d.n_e, d.axis);
        const Vec3 normal{0, 0, 1}, direction = normalised(Vec3{sin_i, 0, cos_i});
        const Wave s = plane_wave(outside, Mode::s, direction, By::wave_normal, normal);
        const Wave p = plane_wave(outside, Mode::p, direction, By::wave_normal, normal);
        const Interface face(outside, crystal, normal, s);
        const Coefficients from_s = face.solve(s), from_p = face.solve(p);
        const OutgoingWaves out = face.waves();

        // Incident p here is k x s = (-cos, 0, sin): the paper's with the other sign.
        double error = std::max(
            {std::abs(from_s.reflected[0] - e.r_ss), std::abs(from_s.reflected[1] - e.r_sp),
             std::abs(from_s.transmitted[0] - e.t_so), std::abs(from_s.transmitted[1] - e.t_se),
             std::abs(from_p.reflected[1] + e.r_pp), std::abs(from_p.reflected[0] + e.r_ps),
             std::abs(from_p.transmitted[0] + e.t_po), std::abs(from_p.transmitted[1] + e.t_pe)});
        error = std::max(
            {error, distance(out.transmitted[0].E, e.E_o), distance(out.transmitted[1].E, e.E_e),
             distance(complexified(out.transmitted[0].ray), e.ray_o),
             distance(complexified(out.transmitted[1].ray), e.ray_e),
             std::abs(out.transmitted[0].k.z - e.q_o), std::abs(out.transmitted[1].k.z - e.q_e),
             std::abs(out.transmitted[1].n_phase - e.n_phase_e)});
        error = std::max({error, std::abs(from_s.reflected_power[0] - e.r_ss * e.r_ss),
                          std::abs(from_s.reflected_power[1] - e.r_sp * e.r_sp),
                          std::abs(from_s.transmitted_power[0] - e.flux_o * e.t_so * e.t_so),
                          std::abs(from_s.transmitted_power[1] - e.flux_e * e.t_se * e.t_se),
                          std::abs(from_p.transmitted_power[0] - e.flux_o * e.t_po * e.t_po),
                          std::abs(from_p.transmitted_power[1] - e.flux_e * e.t_pe * e.t_pe)});
        // The closed forms lose digits where o or e is nearly along the axis, and at grazing
        // incidence.
        const auto sine_to_axis = [&](double q) {
            const Vec3 k = normalised(Vec3{d.n_i * sin_i, 0, q});
            return length(cross(k, d.axis));
        };
        const double margin = std::min({sine_to_axis(e.q_o), sine_to_axis(e.q_e), cos_i});
        worst = std::max(worst, error * margin * margin);
    }
    CHECK(worst < 1e-13);
}

TEST_CASE("the corrected closed forms of the paper are exact", "[interface][paper]") {
    using reference::Real;
    Random random(32);
    Real worst = 0;
    for (int i = 0; i < 60; ++i) {
        const Draw d(random);
        const reference::Double3 direction{std::sin(d.angle), 0, std::cos(d.angle)};
        const reference::RealVector u = reference::unit(direction);
        const reference::Double3 axis{d.axis.x, d.axis.y, d.axis.z};
        const paper::Entry<Real> e(d.n_i, d.n_o, d.n_e, reference::unit(axis), u[0], u[2]);
        const auto outside = reference::Material::isotropic(d.n_i);
        const auto crystal = reference::Material::uniaxial(d.n_o, d.n_e, axis);
        const auto from_s = reference::solve(outside, crystal, {0, 0, 1}, direction, 0);
        const auto from_p = reference::solve(outside, crystal, {0, 0, 1}, direction, 1);
        const auto check = [&](const auto& found, const Real& expected) {
            worst = std::max(
                worst, reference::magnitude(reference::Cplx(found) - reference::Cplx(expected)));
        };
        check(from_s.reflected[0].amplitude, e.r_ss);
        check(from_s.reflected[1].amplitude, e.r_sp);
        check(from_s.transmitted[0].amplitude, e.t_so);
        check(from_s.transmitted[1].amplitude, e.t_se);
        check(from_p.reflected[0].amplitude, -e.r_ps);
        check(from_p.reflected[1].amplitude, -e.r_pp);
        check(from_p.transmitted[0].amplitude, -e.t_po);
        check(from_p.transmitted[1].amplitude, -e.t_pe);
        check(from_s.transmitted[0].power, e.flux_o * e.t_so * e.t_so);
        check(from_s.transmitted[1].power, e.flux_e * e.t_se * e.t_se);
        for (int j = 0; j < 3; ++j) check(from_s.transmitted[1].ray()[j], e.ray_e[j]);
        const auto& k = from_s.transmitted[1].k;
        check(reference::dot(k, k), e.n_phase_e * e.n_phase_e);
    }
    CHECK(worst < Real("1e-50"));
}

TEST_CASE("a wave asked for by its ray has the paper's index and wave normal",
          "[interface][paper]") {
    Random random(33);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double n_o = random.uniform(1.3, 2.7), n_e = random.uniform(1.3, 2.7);
        const Vec3 axis = random.direction(), ray = random.direction();
        const Medium m = Medium::uniaxial(n_o, n_e, axis);
        const Wave w = plane_wave(m, Mode::extraordinary, ray, By::ray, {0, 0, 1});
        // Section 7 feeds (2) with the ray's angle to the axis; these are the forms that take it.
        const double c = dot(ray, axis), c2 = c * c, s2 = 1 - c2;
        const double eo = n_o * n_o, ee = n_e * n_e;
        const double n_ray = std::sqrt(eo * c2 + ee * s2);
        const double n_phase = std::sqrt((eo * eo * c2 + ee * ee * s2) / (eo * c2 + ee * s2));
        const Vec3 across = ray - c * axis;
        const Vec3 normal = normalised(c * axis + (ee / eo) * across);
        worst = std::max({worst, std::abs(w.n_ray - n_ray), std::abs(w.n_phase - n_phase),
                          length(w.ray - ray), length(real(w.k) - n_phase * normal)});
    }
    CHECK(worst < 1e-14);
}
