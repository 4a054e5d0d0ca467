// The boundary problem in the face's frame. Unknown amplitudes are isolated by the reciprocity
// pairing <A, B> = N . (E_A x H_B + E_B x H_A), which vanishes between different waves of one
// medium with the same tangential wave vector (symmetric permittivity, no conjugation): pairing the
// continuity of tangential E and H with the incoming waves of one medium removes the outgoing waves
// of that medium and leaves two equations for the two amplitudes on the other side. No admittance
// is formed, so that nothing divides by a normal component that vanishes at grazing or critical
// angles.
#include "interface/interface.hpp"

#include "interface/general_solver.hpp"
#include "interface/local_wave.hpp"

namespace icespar {
namespace {

template <class T>
struct Pair2 {
    T first, second;
};

double size(double v) { return std::abs(v); }
double size(const Complex& v) { return std::abs(v.real()) + std::abs(v.imag()); }

/// m x = rhs by Cramer's rule. A determinant that is all rounding (two evanescent waves that merge)
/// is taken as that rounding, so that amplitudes stay finite.
template <class T>
Pair2<T> solved(const T (&m)[2][2], const T& r0, const T& r1) {
    constexpr double rounding = 1e-16;
    const T a = m[0][0] * m[1][1], b = m[0][1] * m[1][0];
    T det = a - b;
    const double least = rounding * (size(a) + size(b));
    if (!(size(det) > least)) det = least > 0 ? least : 1e-300;
    return {(r0 * m[1][1] - m[0][1] * r1) / det, (m[0][0] * r1 - r0 * m[1][0]) / det};
}

}  // namespace

struct FaceSolver {
    template <class T>
    using Waves = std::array<LocalWave<T>, 2>;

    /// Far: real where all the far medium's waves propagate, complex elsewhere.
    template <class Far, class Near>
    static void solve(Interface& face, const FaceMedium& from, const FaceMedium& to,
                      const Waves<Near>& incident) {
        const auto reflected = waves_towards<Near>(from, -1);
        const auto transmitted = waves_towards<Far>(to, +1);
        store(face.reflected_, reflected, -1);
        store(face.transmitted_, transmitted, +1);
        face.flux_in_ = {incident[0].flux, incident[1].flux};
        if constexpr (std::is_same_v<Far, Complex>) {
            if (merging(to, +1)) {
                const MergedPair away(to, +1), probe(to, -1);
                match(face, incident, reflected, Waves<Far>{away.ordinary, away.partner},
                      Waves<Far>{probe.ordinary, probe.partner});
                for (std::size_t m = 0; m < 2; ++m) {
                    auto& t = face.transmit_[m];
                    sum(away, t, face.summed_[m].data() + 12);
                    t = away.unit_amplitudes(t[0], t[1]);
                }
                face.merged_ = true;
                return;
            }
        }
        match(face, incident, reflected, transmitted, waves_towards<Far>(to, -1));
    }

    /// E and H of a pair together, while its amplitudes are still finite.
    static void sum(const MergedPair& pair, const std::array<Complex, 2>& amplitude, double* out) {
        const auto &a = pair.ordinary, &b = pair.partner;
        const CVec3 E = amplitude[0] * a.E + amplitude[1] * b.E;
        const Complex hx = amplitude[0] * a.hx + amplitude[1] * b.hx,
                      hy = amplitude[0] * a.hy + amplitude[1] * b.hy;
        for (const Complex& z : {E.x, E.y, E.z, hx, hy, pair.kt * E.y}) {
            *out++ = z.real();
            *out++ = z.imag();
        }
    }

    /// `probe`: the waves of the far medium that come towards the face.
    template <class Near, class T>
    static void match(Interface& face, const Waves<Near>& incident, const Waves<Near>& reflected,
                      const Waves<T>& transmitted, const Waves<T>& probe) {
        T reflect[2][2], transmit[2][2];
        for (std::size_t j = 0; j < 2; ++j) {
            for (std::size_t i = 0; i < 2; ++i) {
                reflect[j][i] = pairing(probe[j], reflected[i]);
                transmit[j][i] = pairing(incident[j], transmitted[i]);
            }
        }
        for (std::size_t m = 0; m < 2; ++m) {
            const auto r = solved<T>(reflect, T(-pairing(probe[0], incident[m])),
                                     T(-pairing(probe[1], incident[m])));
            const T self = pairing(incident[m], incident[m]);
            const auto t = solved<T>(transmit, m == 0 ? self : T(0), m == 1 ? self : T(0));
            face.reflect_[m] = {r.first, r.second};
            face.transmit_[m] = {t.first, t.second};
        }
    }

    /// Two isotropic media: s and p never mix (Fresnel 1823).
    template <class T>
    static void fresnel(Interface& face, const FaceMedium& from, const FaceMedium& to) {
        store(face.reflected_, waves_towards<double>(from, -1), -1);
        store(face.transmitted_, waves_towards<T>(to, +1), +1);
        const double q1 = std::sqrt(from.q_o2);
        const T q2 = signed_root<T>(to.q_o2, +1);
        face.flux_in_ = {q1, q1};
        const T s = q1 + q2, p = to.eps_o * q1 + from.eps_o * q2;
        const double size = norm2(q2, T(to.kt));
        face.reflect_ = {{{(q1 - q2) / s, 0}, {0, (to.eps_o * q1 - from.eps_o * q2) / p}}};
        face.transmit_ = {{{2 * q1 / s, 0}, {0, 2 * q1 * std::sqrt(from.eps_o) * size / p}}};
    }

    template <class T>
    static void store(Interface::Side& side, const std::array<LocalWave<T>, 2>& waves,
                      double sign) {
        for (int i = 0; i < 2; ++i) {
            side.q[i] = waves[i].q;
            side.E[i] = {waves[i].E.x, waves[i].E.y, waves[i].E.z};
            side.flux[i] = sign * waves[i].flux;
            side.propagating[i] = waves[i].propagating;
        }
    }
};

Interface::Interface(const Medium& from, const Medium& to, const Vec3& normal, const Wave& incident)
    : from_(from), to_(to) {
    const FaceFrame frame(normal, real(incident.k));
    x_ = frame.x;
    y_ = frame.y;
    normal_ = normal;
    kt_ = frame.kt;
    if (!from.plain() || !to.plain()) {
        GeneralSolver::solve(*this, from, to, frame, incident);
        return;
    }
    FaceMedium near(from, frame);
    FaceMedium far(to, frame);
    const bool extraordinary = incident.mode == Mode::extraordinary;
    near.adopt(frame.kn, extraordinary);
    // Index-matched faces stay matched at any grazing angle: q_t^2 - q_i^2 = n_t^2 - n_i^2.
    far.q_o2 = near.q_o2 + (to.n_o - from.n_o) * (to.n_o + from.n_o);
    far.complete();
    if (!from.birefringent && !to.birefringent) {
        if (far.q_o2 > 0) {
            FaceSolver::fresnel<double>(*this, near, far);
        } else {
            FaceSolver::fresnel<Complex>(*this, near, far);
        }
        return;
    }
    const Vec3 E = from.birefringent ? frame.to_face(without_phase(incident.E)) : Vec3{};
    const auto arriving = [&]<class T>(T) {
        return from.birefringent ? incident_waves<T>(near, E, frame.kn, extraordinary)
                                 : waves_towards<T>(near, +1);
    };
    if (!near.all_real()) {
        FaceSolver::solve<Complex>(*this, near, far, arriving(Complex{}));
    } else if (far.all_real()) {
        FaceSolver::solve<double>(*this, near, far, arriving(double{}));
    } else {
        FaceSolver::solve<Complex>(*this, near, far, arriving(double{}));
    }
}

Coefficients Interface::solve(const Wave& incident) const {
    const std::size_t m = mode_index(incident.mode);
    Coefficients out;
    out.reflected = reflect_[m];
    out.transmitted = transmit_[m];
    for (std::size_t i = 0; i < 2; ++i) {
        out.reflected_power[i] = std::norm(out.reflected[i]) * reflected_.flux[i] / flux_in_[m];
        out.transmitted_power[i] =
            std::norm(out.transmitted[i]) * transmitted_.flux[i] / flux_in_[m];
    }
    if (general_) {
        GeneralSolver::add_totals(*this, m, out);
    } else {
        out.reflected_total = out.reflected_power[0] + out.reflected_power[1];
        out.transmitted_total = out.transmitted_power[0] + out.transmitted_power[1];
    }
    return out;
}

SummedFields Interface::summed_fields(const Wave& incident) const {
    const std::size_t m = mode_index(incident.mode);
    if (general_) return GeneralSolver::fields(*this, m);
    const auto sum = [&](const Side& side, const std::array<Complex, 2>& amplitude, CVec3& to_E,
                         CVec3& to_H) {
        CVec3 E, H;
        for (std::size_t i = 0; i < 2; ++i) {
            const CVec3 part = amplitude[i] * side.E[i];
            E += part;
            H += {-side.q[i] * part.y, side.q[i] * part.x - kt_ * part.z, kt_ * part.y};
        }
        to_E = E.x * x_ + E.y * y_ + E.z * normal_;
        to_H = H.x * x_ + H.y * y_ + H.z * normal_;
    };
    SummedFields out;
    sum(reflected_, reflect_[m], out.reflected_E, out.reflected_H);
    sum(transmitted_, transmit_[m], out.transmitted_E, out.transmitted_H);
    if (merged_) {
        const SummedFields exact = GeneralSolver::fields(*this, m);
        out.transmitted_E = exact.transmitted_E;
        out.transmitted_H = exact.transmitted_H;
    }
    return out;
}

Complex Interface::flux_amplitude(std::size_t m, bool transmitted, std::size_t i) const {
    const double flux = (transmitted ? transmitted_ : reflected_).flux[i];
    return std::sqrt(flux / flux_in_[m]) * (transmitted ? transmit_ : reflect_)[m][i];
}

Vec3 Interface::real_ray(const Side& side, const MediumCore& medium, std::size_t i,
                         const Vec3& k) const {
    if (medium.symmetry != Symmetry::biaxial) {
        return medium.birefringent && i == 1 ? extraordinary_ray(medium, k) : normalised(k);
    }
    // E x (k x E).
    const Vec3 E = real(side.E[i]);
    const double along = kt_.real() * E.x + side.q[i].real() * E.z, size2 = dot(E, E);
    const Vec3 flow{size2 * kt_.real() - along * E.x, -along * E.y,
                    size2 * side.q[i].real() - along * E.z};
    const double inverse = 1 / length(flow);
    return (inverse * flow.x) * x_ + (inverse * flow.y) * y_ + (inverse * flow.z) * normal_;
}

Vec3 Interface::evanescent_ray(const Side& side, const MediumCore& medium, std::size_t i) const {
    if (!medium.birefringent) return x_;
    const CVec3& E = side.E[i];
    const Complex q = side.q[i];
    const CVec3 H{-q * E.y, q * E.x - kt_ * E.z, kt_ * E.y};
    const Vec3 flow = real(cross(E, conj(H)));
    const double size = length(flow);
    return size > 0 ? (flow.x / size) * x_ + (flow.y / size) * y_ + (flow.z / size) * normal_ : x_;
}

Vec3 Interface::ray(bool transmitted, std::size_t i) const {
    const Side& side = transmitted ? transmitted_ : reflected_;
    const MediumCore& medium = transmitted ? to_ : from_;
    if (general_) return built(side, medium, i).ray;
    if (!side.propagating[i]) return evanescent_ray(side, medium, i);
    return real_ray(side, medium, i, kt_.real() * x_ + side.q[i].real() * normal_);
}

Wave Interface::built(const Side& side, const MediumCore& medium, std::size_t i) const {
    Wave w;
    w.mode = modes_of(medium)[i];
    w.propagating = side.propagating[i];
    if (w.propagating && !general_) {
        // All real.
        const CVec3& F = side.E[i];
        const Vec3 k = kt_.real() * x_ + side.q[i].real() * normal_,
                   E = F.x.real() * x_ + F.y.real() * y_ + F.z.real() * normal_;
        w.k = complexified(k);
        w.E = complexified(E);
        w.H = complexified(cross(k, E));
        w.n_phase = length(k);
        w.ray = real_ray(side, medium, i, k);
        w.n_ray = dot(k, w.ray);
        return w;
    }
    w.k = kt_ * x_ + side.q[i] * normal_;
    w.E = side.E[i].x * x_ + side.E[i].y * y_ + side.E[i].z * normal_;
    w.H = medium.magnetic_field(w.k, w.E);
    const Vec3 k = real(w.k);
    w.n_phase = length(k);
    if (general_) {
        const Vec3 flow = real(cross(w.E, conj(w.H)));
        const double size = length(flow);
        w.ray = size > 0 ? flow / size : x_;
    } else {
        w.ray = evanescent_ray(side, medium, i);
    }
    w.n_ray = dot(k, w.ray);
    return w;
}

Wave Interface::reflected(std::size_t i) const { return built(reflected_, from_, i); }
Wave Interface::transmitted(std::size_t i) const { return built(transmitted_, to_, i); }

OutgoingWaves Interface::waves() const {
    return {{reflected(0), reflected(1)}, {transmitted(0), transmitted(1)}};
}

}  // namespace icespar
