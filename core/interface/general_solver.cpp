// Matching at a face for any pair of media: each side's rows annihilate the waves that leave on it,
// which leaves two equations for the waves that leave on the other.
#include "interface/general_solver.hpp"

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

}  // namespace

void GeneralSolver::solve(Interface& out, const FaceFrame& frame, const Wave& incident) {
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
    const HalfSpace near(out.from_, frame, out.kt_, -1, &known);
    const HalfSpace far(out.to_, frame, out.kt_, +1, nullptr);
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
        out.reflected_field_[m] = near.field(r);
        out.transmitted_field_[m] = far.field(t);
        out.reflected_flux_[m] = -normal_flux(out.reflected_field_[m]) / out.flux_in_[m];
        out.transmitted_flux_[m] = normal_flux(out.transmitted_field_[m]) / out.flux_in_[m];
    }
}

void GeneralSolver::add_totals(const Interface& face, std::size_t m, Coefficients& out) {
    // The waves of a transparent medium carry their energy independently.
    out.reflected_total = face.from_.absorbing ? face.reflected_flux_[m]
                                               : out.reflected_power[0] + out.reflected_power[1];
    out.transmitted_total = face.to_.absorbing
                                ? face.transmitted_flux_[m]
                                : out.transmitted_power[0] + out.transmitted_power[1];
    // The z components from Maxwell's equations: n . D = -K Hy and n . B = K Ey.
    const auto field = [&](const std::array<Complex, 4>& f, const Medium& medium, CVec3& E,
                           CVec3& H) {
        const Vec3 n = face.normal_;
        const CVec3 e = f[0] * face.x_ + f[1] * face.y_, h = f[2] * face.x_ + f[3] * face.y_;
        const ComplexTensor eps = medium.permittivity();
        const Complex i(0, 1);
        const auto alpha = [&](const CVec3& v) {
            return medium.gyration * v +
                   ((medium.gyration_along - medium.gyration) * dot(medium.axis, v)) *
                       complexified(medium.axis);
        };
        const CVec3 z = complexified(n);
        const Complex a = dot(alpha(z), n), b = face.kt_ * f[1] + i * dot(alpha(e), n),
                      d = -face.kt_ * f[3] - dot(eps * e, n) - i * dot(alpha(h), n);
        const Complex ez = (d - i * a * b) / (dot(eps * z, n) - a * a);
        E = e + ez * z;
        H = h + (b + i * a * ez) * z;
    };
    field(face.reflected_field_[m], face.from_, out.reflected_E, out.reflected_H);
    field(face.transmitted_field_[m], face.to_, out.transmitted_E, out.transmitted_H);
}

}  // namespace icespar
