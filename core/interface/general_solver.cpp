// Matching at a face for any pair of media: each side's rows annihilate the waves that leave on it,
// which leaves two equations for the waves that leave on the other.
#include "interface/general_solver.hpp"

#include <utility>

#include "interface/half_space.hpp"
#include "interface/incident_wave.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

template <class R>
std::complex<R> applied(const Field4<R>& row, const Field4<R>& f) {
    return row[0] * f[0] + row[1] * f[1] + row[2] * f[2] + row[3] * f[3];
}

/// Coefficients in `outgoing` of the field whose image under `rows` is that of `source`.
template <class R>
std::array<std::complex<R>, 2> matched(const std::array<Field4<R>, 2>& rows,
                                       const std::array<Field4<R>, 2>& outgoing,
                                       const Field4<R>& source, R sign) {
    using C = std::complex<R>;
    const C a = applied(rows[0], outgoing[0]), b = applied(rows[0], outgoing[1]),
            c = applied(rows[1], outgoing[0]), d = applied(rows[1], outgoing[1]);
    const C x = sign * applied(rows[0], source), y = sign * applied(rows[1], source);
    const C det = a * d - b * c;
    return {(x * d - b * y) / det, (a * y - x * c) / det};
}

/// E and H in the face's frame, the z components from Maxwell's equations: Dz = -K Hy, Bz = K Ey.
template <class R>
std::array<Vector3<std::complex<R>>, 2> completed(const Field4<R>& f, const Medium& medium,
                                                  const FaceAxes<R>& axes,
                                                  const std::complex<R>& K) {
    using C = std::complex<R>;
    const auto eps = axes.permittivity(medium);
    const Vector3<R> c = axes.to_face(converted<R>(medium.axis));
    const R across(medium.gyration), more = R(medium.gyration_along) - across;
    const R axz = more * c.x * c.z, ayz = more * c.y * c.z, azz = across + more * c.z * c.z;
    const C i(0, 1);
    const C b = K * f[1] + i * (axz * f[0] + ayz * f[1]);
    const C d = -K * f[3] - eps.xz * f[0] - eps.yz * f[1] - i * (axz * f[2] + ayz * f[3]);
    const C ez = (d - i * azz * b) / (eps.zz - azz * azz);
    return {Vector3<C>{f[0], f[1], ez}, Vector3<C>{f[2], f[3], b + i * azz * ez}};
}

/// The field f in the phase of `model`.
template <class R>
Field4<R> in_phase(Field4<R> f, const Field4<R>& model) {
    std::complex<R> overlap = 0;
    for (std::size_t i = 0; i < 4; ++i) overlap += std::conj(f[i]) * model[i];
    const R size = std::abs(overlap);
    if (size == 0) return f;
    for (auto& x : f) x *= overlap / size;
    return f;
}

/// Energy that two fields carry along the normal only together.
template <class R>
R mixed_flux(const Field4<R>& a, const Field4<R>& b) {
    return (a[0] * std::conj(b[3]) - a[1] * std::conj(b[2]) + b[0] * std::conj(a[3]) -
            b[1] * std::conj(a[2]))
        .real();
}

}  // namespace

template <class R>
bool GeneralSolver::solve_in(Interface& out, const Medium& from, const Medium& to,
                             const FaceFrame& frame, const Wave& incident) {
    using C = std::complex<R>;
    constexpr bool is_double = std::is_same_v<R, double>;
    IncidentWave<R> in(frame, incident);
    if constexpr (!is_double) in = IncidentWave<R>::refined(from, frame, incident);
    // The incident wave of an absorbing medium has a complex tangential part, which must be a
    // multiple of a real vector: then there are s and p.
    if (!from.absorbing) {
        in.K = in.K.real();
    } else if (const C skew = dot(converted<C>(incident.k), in.axes.y);
               std::abs(skew) > R(1e-10) * (std::abs(in.K) + std::abs(in.kn))) {
        throw Error(
            "an incident wave of an absorbing medium must fade along its wave normal or "
            "within its plane of incidence; this one fades across it");
    }
    const std::size_t given = mode_index(incident.mode);
    std::array<Field4<R>, 2> source{};
    source[given] = in.field;
    const Arriving<R> known{in.kn, given, in.field};
    const HalfSpace<R> near(from, in.axes, in.K, -1, &known), far(to, in.axes, in.K, +1, nullptr);
    if (is_double && std::min(near.separation, far.separation) < R(0.05)) return false;
    if (near.incident_field) source[given] = in_phase<R>(*near.incident_field, in.field);
    const bool isotropic = from.symmetry == Symmetry::isotropic && !from.active();
    if (isotropic) {
        const C size = std::sqrt(std::norm(in.kn) + std::norm(in.K));
        const C eps = in.kn * in.kn + in.K * in.K;
        source[0] = {C(0), C(1), -in.kn, C(0)};
        source[1] = {-in.kn / size, C(0), C(0), -eps / size};
        source[given] = in_phase<R>(source[given], in.field);
    }
    out.kt_ = Complex(in.K);
    const auto store = [](Interface::Side& side, const HalfSpace<R>& h) {
        for (std::size_t i = 0; i < 2; ++i) {
            side.q[i] = Complex(h.q[i]);
            side.E[i] = converted<Complex>(h.E[i]);
            side.flux[i] = static_cast<double>(h.flux[i]);
        }
        side.propagating = h.propagating;
    };
    store(out.reflected_, near);
    store(out.transmitted_, far);
    for (std::size_t m = 0; m < 2; ++m) {
        if (m != given && !isotropic) continue;
        const R flux =
            near.incident_flux > 0 && m == given ? near.incident_flux : normal_flux<R>(source[m]);
        const auto r = matched<R>(far.rows, near.basis, source[m], -1);
        const auto t = matched<R>(near.rows, far.basis, source[m], 1);
        const auto r_modes = near.amplitudes(r), t_modes = far.amplitudes(t);
        const Field4<R> reflected = near.field(r), transmitted = far.field(t);
        const R r_flux = -normal_flux<R>(reflected) / flux,
                t_flux = normal_flux<R>(transmitted) / flux,
                mixed = from.absorbing ? -mixed_flux<R>(source[m], reflected) / flux : R(0);
        R balance = mixed - 1, jump = 0;
        balance +=
            from.absorbing
                ? r_flux
                : (std::norm(r_modes[0]) * near.flux[0] + std::norm(r_modes[1]) * near.flux[1]) /
                      flux;
        balance +=
            to.absorbing
                ? t_flux
                : (std::norm(t_modes[0]) * far.flux[0] + std::norm(t_modes[1]) * far.flux[1]) /
                      flux;
        for (std::size_t i = 0; i < 4; ++i) {
            jump = std::max(jump, size1<C>(source[m][i] + reflected[i] - transmitted[i]));
        }
        if (is_double && !(std::abs(balance) < R(2e-14) && jump < R(2e-14))) return false;
        out.flux_in_[m] = static_cast<double>(flux);
        for (std::size_t i = 0; i < 2; ++i) {
            out.reflect_[m][i] = Complex(r_modes[i]);
            out.transmit_[m][i] = Complex(t_modes[i]);
        }
        out.reflected_flux_[m] = static_cast<double>(r_flux);
        out.transmitted_flux_[m] = static_cast<double>(t_flux);
        out.interference_[m] = static_cast<double>(mixed);
        auto place = out.summed_[m].begin();
        for (const auto& [field, medium] : {std::pair{&reflected, &from}, {&transmitted, &to}}) {
            for (const Vector3<C>& v : completed<R>(*field, *medium, in.axes, in.K)) {
                for (const C& z : {v.x, v.y, v.z}) {
                    *place++ = static_cast<double>(z.real());
                    *place++ = static_cast<double>(z.imag());
                }
            }
        }
    }
    return true;
}

void GeneralSolver::solve(Interface& out, const Medium& from, const Medium& to,
                          const FaceFrame& frame, const Wave& incident) {
    if (solve_quickly(out, from, to, frame, incident)) return;
    out.general_ = true;
    if (!solve_in<double>(out, from, to, frame, incident)) {
        solve_in<long double>(out, from, to, frame, incident);
    }
}

void GeneralSolver::add_totals(const Interface& face, std::size_t m, Coefficients& out) {
    // The waves of a transparent medium carry their energy independently, if K is real.
    out.reflected_total = face.from_.absorbing ? face.reflected_flux_[m]
                                               : out.reflected_power[0] + out.reflected_power[1];
    out.transmitted_total = face.to_.absorbing || face.from_.absorbing
                                ? face.transmitted_flux_[m]
                                : out.transmitted_power[0] + out.transmitted_power[1];
    out.interference = face.interference_[m];
}

SummedFields GeneralSolver::fields(const Interface& face, std::size_t m) {
    const auto& parts = face.summed_[m];
    const auto vector = [&](std::size_t at) {
        const Complex x(parts[at], parts[at + 1]), y(parts[at + 2], parts[at + 3]),
            z(parts[at + 4], parts[at + 5]);
        return x * face.x_ + y * face.y_ + z * face.normal_;
    };
    return {vector(0), vector(6), vector(12), vector(18)};
}

}  // namespace icespar
