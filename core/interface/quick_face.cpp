// Faces of transparent crystals, one of them biaxial, where all waves propagate and nothing is
// delicate: in real numbers, matched by the pairings of interface.cpp.
#include <algorithm>

#include "interface/general_solver.hpp"
#include "interface/real_waves.hpp"

namespace icespar {
namespace {

bool transparent(const MediumCore& m) { return !m.absorbing && !m.active(); }

template <class T>
struct Matched {
    std::array<T, 2> r, t;
};

/// The amplitudes that `source` sends into the waves of both sides.
template <class T, class Far>
struct Matching {
    const RealWaves& near;
    const Far& far;
    T a, b, c, d, det;
    std::array<T, 2> own;

    Matching(const RealWaves& near_side, const Far& far_side)
        : near(near_side),
          far(far_side),
          a(pairing(far.down[0], near.down[0])),
          b(pairing(far.down[0], near.down[1])),
          c(pairing(far.down[1], near.down[0])),
          d(pairing(far.down[1], near.down[1])),
          det(a * d - b * c),
          own{pairing(far.up[0], far.up[0]), pairing(far.up[1], far.up[1])} {}

    [[nodiscard]] Matched<T> operator()(const QuickWave<double>& source) const {
        const T x = -pairing(far.down[0], source), y = -pairing(far.down[1], source);
        const T r0 = (x * d - b * y) / det, r1 = (a * y - x * c) / det;
        const auto transmitted = [&](std::size_t j) {
            return (pairing(far.up[j], source) + r0 * pairing(far.up[j], near.down[0]) +
                    r1 * pairing(far.up[j], near.down[1])) /
                   own[j];
        };
        return {{r0, r1}, {transmitted(0), transmitted(1)}};
    }
};

double size2(double x) { return x * x; }
double size2(const Complex& x) { return std::norm(x); }

}  // namespace

bool GeneralSolver::solve_quickly(Interface& out, const Medium& from, const Medium& to,
                                  const FaceFrame& frame, const Wave& incident) {
    if (!transparent(from) || !transparent(to)) return false;
    RealWaves near;
    if (!near.find(from, frame)) return false;
    const bool isotropic = from.symmetry == Symmetry::isotropic;
    const std::size_t given = mode_index(incident.mode);
    std::array<QuickWave<double>, 2> source = near.up;
    if (!isotropic) {
        // As given: it may be any combination where both waves agree.
        const CVec3& E = incident.E;
        if (E.x.imag() != 0 || E.y.imag() != 0 || E.z.imag() != 0) return false;
        const Vec3 H = real(incident.H);
        source[given] = {frame.kn, frame.to_face(real(E)), dot(H, frame.x), dot(H, frame.y)};
    }
    const auto store = [](Interface::Side& side, const auto& waves, double sign) {
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& w = waves[i];
            constexpr bool carries = std::is_same_v<decltype(w.q), double>;
            side.q[i] = w.q;
            side.E[i] = {w.E.x, w.E.y, w.E.z};
            side.propagating[i] = carries;
            side.flux[i] = 0;
            if constexpr (carries) side.flux[i] = sign * w.flux();
        }
    };
    const auto solve = [&]<class T, class Far>(T, const Far& far) {
        store(out.reflected_, near.down, -1);
        store(out.transmitted_, far.up, 1);
        const Matching<T, Far> match(near, far);
        for (std::size_t m = 0; m < 2; ++m) {
            if (m != given && !isotropic) continue;
            const auto [r, t] = match(source[m]);
            const double flux = source[m].flux();
            const double carried =
                size2(r[0]) * out.reflected_.flux[0] + size2(r[1]) * out.reflected_.flux[1] +
                size2(t[0]) * out.transmitted_.flux[0] + size2(t[1]) * out.transmitted_.flux[1];
            if (!(std::abs(carried / flux - 1) < 1e-14)) return false;
            out.reflect_[m] = {r[0], r[1]};
            out.transmit_[m] = {t[0], t[1]};
            out.flux_in_[m] = flux;
        }
        return true;
    };
    RealWaves far;
    if (far.find(to, frame)) return solve(0.0, far);
    EvanescentWaves beyond;
    return beyond.find(to, frame) && solve(Complex(), beyond);
}

}  // namespace icespar
