// Weidlich & Wilkie's closed forms for light that enters a uniaxial crystal, with the errata
// applied.
#pragma once

#include <array>
#include <cmath>

namespace paper {

/// Everything of section 4 for one incidence: interface z = 0, z into the crystal, plane of
/// incidence xz, optic axis (al, be, ga). Scalar is double or a wider real type. s is along +y;
/// incident p is (cos, 0, -sin), reflected p (cos, 0, sin).
template <class Scalar>
struct Entry {
    using Vector = std::array<Scalar, 3>;
    Scalar q_o, q_e;
    Vector E_o, E_e, ray_o, ray_e;
    Scalar r_ss, r_sp, r_pp, r_ps, t_so, t_se, t_po, t_pe;
    /// Powers of (12): n_ray cos(ray) / (n_i cos) per unit |t|^2.
    Scalar flux_o, flux_e;
    Scalar n_phase_e;  ///< (2), from the angle between wave normal and axis

    Entry(Scalar n_i, Scalar n_o, Scalar n_e, const Vector& axis, Scalar sin_i, Scalar cos_i) {
        using std::sqrt;
        const Scalar al = axis[0], be = axis[1], ga = axis[2];
        const Scalar eo = n_o * n_o, ee = n_e * n_e, K = n_i * sin_i, q1 = n_i * cos_i;
        const Scalar tan_i = sin_i / cos_i, eg = eo + ga * ga * (ee - eo);
        q_o = sqrt(eo - K * K);
        q_e =
            (sqrt(eo * (ee * eg - (ee - be * be * (ee - eo)) * K * K)) - al * ga * K * (ee - eo)) /
            eg;
        E_o = unit({-be * q_o, al * q_o - ga * K, be * K});
        E_e = unit({al * q_o * q_o - ga * q_e * K, be * eo, ga * (eo - q_e * q_e) - al * q_e * K});

        // (3) - (10) with the corrected C.
        const Scalar A = (q_o + q1 + K * tan_i) * E_o[0] - K * E_o[2];
        const Scalar B = (q_e + q1 + K * tan_i) * E_e[0] - K * E_e[2];
        const Scalar C = (q1 + q_e) * A * E_e[1] - (q1 + q_o) * B * E_o[1];
        r_ss = ((q1 - q_e) * A * E_e[1] - (q1 - q_o) * B * E_o[1]) / C;
        r_sp = 2 * n_i * (A * E_e[0] - B * E_o[0]) / C;
        t_so = -2 * q1 * B / C;
        t_se = 2 * q1 * A / C;
        r_pp =
            2 * n_i / (cos_i * C) * ((q1 + q_e) * E_o[0] * E_e[1] - (q1 + q_o) * E_e[0] * E_o[1]) -
            1;
        r_ps = 2 * n_i * (q_e - q_o) * E_o[1] * E_e[1] / C;
        t_po = 2 * n_i * (q1 + q_e) * E_e[1] / C;
        t_pe = -2 * n_i * (q1 + q_o) * E_o[1] / C;

        // The extraordinary ray from the ordinary one, for any plane of incidence.
        ray_o = {K / n_o, Scalar(0), q_o / n_o};
        const Scalar w = al * ray_o[0] + be * ray_o[1], N = eo - ee;
        const Scalar gamma = ee + N * (1 - ga * ga);
        const Scalar delta = sqrt(gamma * (ee - eo * (1 - ray_o[2] * ray_o[2])) + eo * N * w * w);
        const Scalar pull = eo * w + ga * delta;
        const Scalar size = n_e * sqrt(eo * gamma * gamma - N * pull * pull);
        ray_e = {(eo * gamma * ray_o[0] - N * al * pull) / size,
                 (eo * gamma * ray_o[1] - N * be * pull) / size, gamma * delta / size};

        // (2) is fed the wave normal; n_ray = n_phase cos(walk-off) from the ray.
        const Scalar k2 = K * K + q_e * q_e, k_axis = al * K + ga * q_e;
        const Scalar cos2 = k_axis * k_axis / k2;
        n_phase_e = sqrt(1 / (cos2 / eo + (1 - cos2) / ee));
        const Scalar along = al * ray_e[0] + be * ray_e[1] + ga * ray_e[2];
        const Scalar n_ray = sqrt(eo * along * along + ee * (1 - along * along));
        flux_o = q_o / q1;
        flux_e = n_ray * ray_e[2] / q1;
    }

private:
    static Vector unit(const Vector& v) {
        using std::sqrt;
        const Scalar length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        return {v[0] / length, v[1] / length, v[2] / length};
    }
};

}  // namespace paper
