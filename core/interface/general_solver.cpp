// Matching at a face for any pair of media: each side's rows annihilate the waves that leave on it,
// which leaves two equations for the waves that leave on the other.
#include "interface/general_solver.hpp"

#include <utility>

#include "interface/half_space.hpp"

namespace icespar {
namespace {

Complex applied(const Field4& row, const Field4& f) {
    return row[0] * f[0] + row[1] * f[1] + row[2] * f[2] + row[3] * f[3];
}

/// Coefficients in `outgoing` of the field whose image under `rows` is that of `source`.
std::array<Complex, 2> matched(const std::array<Field4, 2>& rows,
                               const std::array<Field4, 2>& outgoing, const Field4& source,
                               double sign) {
    const Complex a = applied(rows[0], outgoing[0]), b = applied(rows[0], outgoing[1]),
                  c = applied(rows[1], outgoing[0]), d = applied(rows[1], outgoing[1]);
    const Complex x = sign * applied(rows[0], source), y = sign * applied(rows[1], source);
    const Complex det = a * d - b * c;
    return {(x * d - b * y) / det, (a * y - x * c) / det};
}

/// E and H in the face's frame, the z components from Maxwell's equations: Dz = -K Hy, Bz = K Ey.
std::array<CVec3, 2> completed(const Field4& f, const Medium& medium, const FaceFrame& frame,
                               const Complex& K) {
    const ComplexTensor eps = medium.permittivity().in_frame(frame.x, frame.y, frame.z);
    const Vec3 c = frame.to_face(medium.axis);
    const double across = medium.gyration, more = medium.gyration_along - medium.gyration;
    const double axz = more * c.x * c.z, ayz = more * c.y * c.z, azz = across + more * c.z * c.z;
    const Complex i(0, 1);
    const Complex b = K * f[1] + i * (axz * f[0] + ayz * f[1]);
    const Complex d = -K * f[3] - eps.xz * f[0] - eps.yz * f[1] - i * (axz * f[2] + ayz * f[3]);
    const Complex ez = (d - i * azz * b) / (eps.zz - azz * azz);
    return {CVec3{f[0], f[1], ez}, CVec3{f[2], f[3], b + i * azz * ez}};
}

}  // namespace

void GeneralSolver::solve(Interface& out, const Medium& from, const Medium& to,
                          const FaceFrame& frame, const Wave& incident) {
    out.general_ = true;
    // The incident wave of an absorbing medium has a complex tangential part.
    const Complex K = dot(incident.k, frame.x);
    out.kt_ = out.from_.absorbing ? K : Complex(frame.kt);
    const Complex kn = dot(incident.k, frame.z);
    const std::size_t given = mode_index(incident.mode);
    const auto tangential = [&](const CVec3& E, const CVec3& H) {
        return Field4{dot(E, frame.x), dot(E, frame.y), dot(H, frame.x), dot(H, frame.y)};
    };
    std::array<Field4, 2> source{};
    source[given] = tangential(incident.E, incident.H);
    const Arriving known{kn, given, source[given]};
    const HalfSpace near(from, frame, out.kt_, -1, &known);
    const HalfSpace far(to, frame, out.kt_, +1, nullptr);
    if (near.incident_field) {
        // In the phase of the field given.
        Complex overlap = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            overlap += std::conj((*near.incident_field)[i]) * source[given][i];
        }
        const double size = std::abs(overlap);
        for (std::size_t i = 0; i < 4 && size > 0; ++i) {
            source[given][i] = overlap / size * (*near.incident_field)[i];
        }
    }
    const bool isotropic = out.from_.symmetry == Symmetry::isotropic && !out.from_.active();
    if (isotropic) {
        const Complex size = std::sqrt(std::norm(kn) + std::norm(out.kt_));
        const Complex eps = kn * kn + out.kt_ * out.kt_;
        source[0] = {Complex(0), Complex(1), -kn, Complex(0)};
        source[1] = {-kn / size, Complex(0), Complex(0), -eps / size};
    }
    const auto store = [](Interface::Side& side, const HalfSpace& h) {
        side.q = h.q;
        side.E = h.E;
        side.flux = h.flux;
        side.propagating = h.propagating;
    };
    store(out.reflected_, near);
    store(out.transmitted_, far);
    for (std::size_t m = 0; m < 2; ++m) {
        if (m != given && !isotropic) continue;
        out.flux_in_[m] =
            near.incident_flux > 0 && m == given ? near.incident_flux : normal_flux(source[m]);
        const auto r = matched(far.rows, near.basis, source[m], -1);
        const auto t = matched(near.rows, far.basis, source[m], 1);
        out.reflect_[m] = near.amplitudes(r);
        out.transmit_[m] = far.amplitudes(t);
        const Field4 reflected = near.field(r), transmitted = far.field(t);
        out.reflected_flux_[m] = -normal_flux(reflected) / out.flux_in_[m];
        out.transmitted_flux_[m] = normal_flux(transmitted) / out.flux_in_[m];
        auto place = out.summed_[m].begin();
        for (const auto& [field, medium] : {std::pair{&reflected, &from}, {&transmitted, &to}}) {
            for (const CVec3& v : completed(*field, *medium, frame, out.kt_)) {
                for (const Complex& z : {v.x, v.y, v.z}) {
                    *place++ = z.real();
                    *place++ = z.imag();
                }
            }
        }
    }
}

void GeneralSolver::add_totals(const Interface& face, std::size_t m, Coefficients& out) {
    // The waves of a transparent medium carry their energy independently.
    out.reflected_total = face.from_.absorbing ? face.reflected_flux_[m]
                                               : out.reflected_power[0] + out.reflected_power[1];
    out.transmitted_total = face.to_.absorbing
                                ? face.transmitted_flux_[m]
                                : out.transmitted_power[0] + out.transmitted_power[1];
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
