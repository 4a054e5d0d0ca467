// The outgoing waves of one side of a face: the media with closed forms.
#include "interface/half_space.hpp"

#include <algorithm>

#include "interface/local_wave.hpp"
#include "interface/plane.hpp"

namespace icespar {
namespace {

Field4 dual(const Field4& f) { return {f[3], -f[2], -f[1], f[0]}; }

Field4 as_field(const LocalWave<Complex>& w) { return {w.E.x, w.E.y, w.hx, w.hy}; }

}  // namespace

HalfSpace::HalfSpace(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                     const Arriving* known) {
    if (medium.plain() && K.imag() == 0) {
        plain(medium, face, sign, known);
    } else if (medium.symmetry == Symmetry::isotropic && !medium.active()) {
        isotropic(medium.eps_o(), K, sign, known);
    } else if (medium.symmetry == Symmetry::uniaxial && !medium.active()) {
        uniaxial(medium, face, K, sign, known);
    } else if (medium.absorbing || medium.active() || K.imag() != 0 ||
               !tensor<double>(medium, face, K, sign, known)) {
        tensor<Complex>(medium, face, K, sign, known);
    }
}

void HalfSpace::set_mode(std::size_t i, const Complex& K, const Complex& normal_component,
                         const CVec3& field, double sign) {
    q[i] = normal_component;
    E[i] = field / length(field);
    psi[i] = {E[i].x, E[i].y, -q[i] * E[i].y, q[i] * E[i].x - K * E[i].z};
    flux[i] = propagating[i] ? std::max(sign * normal_flux(psi[i]), 0.0) : 0;
}

void HalfSpace::set_basis(std::array<Field4, 2> columns) {
    const Plane<Complex> plane(columns);
    basis = plane.columns;
    pivot = plane.pivot;
    std::size_t row = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == pivot[0] || i == pivot[1]) continue;
        rows[row] = {};
        rows[row][i] = 1;
        rows[row][pivot[0]] = -basis[0][i];
        rows[row][pivot[1]] = -basis[1][i];
        ++row;
    }
}

void HalfSpace::plain(const Medium& medium, const FaceFrame& face, int sign,
                      const Arriving* known) {
    FaceMedium m(medium, face);
    if (known) m.adopt(known->q.real(), medium.birefringent && known->mode == 1);
    auto out = waves_towards<Complex>(m, sign), in = waves_towards<Complex>(m, -sign);
    for (std::size_t i = 0; i < 2; ++i) {
        q[i] = out[i].q;
        E[i] = out[i].E;
        psi[i] = as_field(out[i]);
        flux[i] = sign * out[i].flux;
        propagating[i] = out[i].propagating;
    }
    incident_flux = known ? std::abs(in[known->mode].flux) : 0;
    if (merging(m, sign)) {
        const MergedPair away(m, sign), towards(m, -sign);
        out = {away.ordinary, away.partner};
        in = {towards.ordinary, towards.partner};
    }
    set_basis({as_field(out[0]), as_field(out[1])});
    rows = {dual(as_field(in[0])), dual(as_field(in[1]))};
}

void HalfSpace::isotropic(const Complex& eps, const Complex& K, int sign, const Arriving* known) {
    const double s = sign;
    Complex qs;
    if (known) {
        qs = -known->q;
    } else {
        const Complex n = std::sqrt(eps);
        qs = std::sqrt(n - K) * std::sqrt(n + K);
        // Decay decides; where K is complex, the branch that a real K of the same size would take.
        const Complex at_real = std::sqrt(n - K.real()) * std::sqrt(n + K.real());
        if (std::norm(qs - at_real) > std::norm(qs + at_real)) qs = -qs;
        if (at_real.imag() < 0 || (at_real.imag() == 0 && at_real.real() < 0)) qs = -qs;
        qs = s * qs;
    }
    propagating = {true, true};
    set_mode(0, K, qs, {Complex(0), Complex(1), Complex(0)}, s);
    set_mode(1, K, qs, {-qs, Complex(0), K}, s);
    set_basis(psi);
    rows = {dual({Complex(0), Complex(1), qs, Complex(0)}),
            dual({qs, Complex(0), Complex(0), -eps})};
}

void HalfSpace::uniaxial(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                         const Arriving* known) {
    const Vec3 c = face.to_face(medium.axis);
    const CrystalFrame crystal(c);
    const Complex eo = medium.eps_o(), ee = medium.eps_e();
    const Complex delta = Complex(medium.n_e - medium.n_o, medium.kappa_e - medium.kappa_o) *
                          Complex(medium.n_e + medium.n_o, medium.kappa_e + medium.kappa_o);
    const double s = sign;
    // Ordinary: q = +-root(eo - K^2). Extraordinary: eg q^2 + 2 X q + C = 0.
    const Complex n_o(medium.n_o, medium.kappa_o);
    const auto decaying = [&](const Complex& root, const Complex& centre, const Complex& scale) {
        // Of (centre +- root) / scale the one that decays along sign; for tiny loss the real part
        // of the root, which has the sign of the energy flow, breaks the tie.
        const auto score = [&](const Complex& r) {
            return s * (((centre + r) / scale).imag() + 1e-3 * r.real());
        };
        return score(root) >= score(-root) ? root : -root;
    };
    const Complex qo_root = decaying(std::sqrt(n_o - K) * std::sqrt(n_o + K), 0.0, 1.0);
    const Complex eg = eo + delta * (c.z * c.z);
    const Complex X = delta * (c.z * c.x) * K;
    const Complex w2 = eo * (eg * (ee - K * K) - delta * (c.x * c.x) * K * K);
    const Complex w = decaying(std::sqrt(w2), -X, eg);
    Complex o_out = qo_root, o_in = -qo_root, e_out = (w - X) / eg, e_in = (-w - X) / eg;
    if (known && known->mode == 0) o_in = known->q, o_out = -known->q;
    if (known && known->mode == 1) e_in = known->q, e_out = -2.0 * X / eg - known->q;

    propagating = {true, true};
    const auto across = [&](const Complex& kn, const Vec3& a) { return K * a.x + kn * a.z; };
    set_mode(0, K, o_out, crystal.ordinary(across(o_out, crystal.a), across(o_out, crystal.b)), s);
    const Complex ka = across(e_out, crystal.a), kb = across(e_out, crystal.b),
                  kc = across(e_out, crystal.c);
    const double m = norm2(ka, kb);
    const CVec3 e_field = m == 0 ? complexified(crystal.a)
                                 : (-kc / eo * (ka / m)) * crystal.a +
                                       (-kc / eo * (kb / m)) * crystal.b +
                                       ((ka * ka + kb * kb) / (m * ee)) * crystal.c;
    set_mode(1, K, e_out, e_field, s);

    const LocalMedium<Complex> local{
        medium.permittivity().in_frame(face.x, face.y, face.z), {}, false};
    const Berreman<Complex> b(local, K);
    const auto square = product(b.d, b.d);
    const auto in = Quadratic<Complex>::from_roots(o_in, e_in);
    set_basis(spanning_columns(evaluate(in, b.d, square)));
}

std::array<Complex, 2> HalfSpace::amplitudes(const std::array<Complex, 2>& coefficients) const {
    const Complex a = psi[0][pivot[0]], b = psi[1][pivot[0]], c = psi[0][pivot[1]],
                  d = psi[1][pivot[1]];
    const Complex det = a * d - b * c;
    return {(coefficients[0] * d - b * coefficients[1]) / det,
            (a * coefficients[1] - coefficients[0] * c) / det};
}

Field4 HalfSpace::field(const std::array<Complex, 2>& c) const {
    Field4 out;
    for (std::size_t i = 0; i < 4; ++i) out[i] = c[0] * basis[0][i] + c[1] * basis[1][i];
    return out;
}

}  // namespace icespar
