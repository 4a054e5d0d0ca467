// A medium seen from a face: the normal components of its waves, kept exact relative to each other.
#pragma once

#include "interface/crystal_frame.hpp"
#include "interface/face_frame.hpp"

namespace icespar {

/// A medium seen from a face, for a fixed tangential wave number.
struct FaceMedium {
    bool birefringent;
    double kt, eps_o, eps_e;
    CrystalFrame crystal;
    double q_o2;  ///< squared normal component of the ordinary (or isotropic) wave
    double w2;    ///< squared normal energy flow W = N . eps k of the extraordinary wave

    FaceMedium(const Medium& m, const FaceFrame& face)
        : birefringent(m.birefringent),
          kt(face.kt),
          eps_o(m.n_o * m.n_o),
          eps_e(m.n_e * m.n_e),
          crystal(m.birefringent ? face.to_face(m.axis) : Vec3{0, 0, 1}),
          q_o2((m.n_o - kt) * (m.n_o + kt)),
          w2(1) {
        complete();
    }

    /// The flow of the extraordinary wave, once q_o2 is known.
    void complete() {
        if (!birefringent) return;
        if (q_o2 > 0) {
            w2 = flow_squared(std::sqrt(q_o2));
        } else {
            // eg (ee - kt^2) - de ct^2 without its differences: with kt near n_o and the axis near
            // kt all of it is small.
            const Vec3& c = crystal.c;
            const double tilt = c.y * c.y + c.z * c.z;
            w2 = eps_o * (q_o2 * (eps_o + delta() * (c.x * c.x + c.z * c.z)) +
                          delta() * (eps_o * tilt + delta() * c.z * c.z));
        }
    }

    [[nodiscard]] double delta() const { return eps_e - eps_o; }
    [[nodiscard]] double eps_g() const { return eps_o + delta() * crystal.c.z * crystal.c.z; }
    [[nodiscard]] double cross_term() const { return delta() * crystal.c.z * kt * crystal.c.x; }
    [[nodiscard]] bool all_real() const { return q_o2 > 0 && w2 > 0; }
    [[nodiscard]] bool all_evanescent() const { return q_o2 <= 0 && w2 <= 0; }

    /// Squared |k across the axis| for a real normal component q.
    [[nodiscard]] double across_squared(double q) const {
        const double ka = kt * crystal.a.x + q * crystal.a.z,
                     kb = kt * crystal.b.x + q * crystal.b.z;
        return ka * ka + kb * kb;
    }

    /// W^2 from the ordinary wave's q. The e-wave's quadratic is eg q^2 + 2 X q + C = 0 with
    /// X = de cn ct, and W = eg q_e + X its root; at q_o it leaves -de |k_o across axis|^2. So the
    /// two waves stay at their true distance where both are grazing and nearly touch.
    [[nodiscard]] double flow_squared(double q_o) const {
        const double w = eps_g() * q_o + cross_term();
        return w * w + eps_g() * delta() * across_squared(q_o);
    }

    /// The incident wave knows its own normal component better than its tangential one does.
    void adopt(double kn, bool extraordinary) {
        if (!extraordinary) {
            q_o2 = kn * kn;
            if (birefringent) w2 = flow_squared(kn);
        } else {
            const double w = eps_g() * kn + cross_term();
            w2 = w * w;
            // k_e . k_e = eo + |k_e across axis|^2 (1 - eo / ee).
            q_o2 = kn * kn - across_squared(kn) * delta() / eps_e;
        }
    }
};

}  // namespace icespar
