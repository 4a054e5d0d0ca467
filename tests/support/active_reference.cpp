// The active boundary problem: Maxwell's six equations for k = K x + q z, with the z components
// eliminated by solving for them, then eigenvectors and matching.
#include "support/active_reference.hpp"

#include <algorithm>
#include <stdexcept>

namespace reference {

namespace {

struct Eigen {
    Cplx q;
    Vector4 psi;
    Real flow;
};

}  // namespace

ActiveSolution into_active(const ActiveCrystal& crystal, const Double3& normal,
                           const Double3& direction, int mode) {
    const RealVector n = unit(normal), k = unit(direction), c = unit(crystal.axis);
    const Real kn = dot(k, n);
    RealVector x{k[0] - kn * n[0], k[1] - kn * n[1], k[2] - kn * n[2]};
    const Real K = sqrt(dot(x, x));
    for (auto& v : x) v /= K;
    const RealVector y{n[1] * x[2] - n[2] * x[1], n[2] * x[0] - n[0] * x[2],
                       n[0] * x[1] - n[1] * x[0]};
    const RealVector local{dot(c, x), dot(c, y), dot(c, n)};
    std::array<std::array<Real, 3>, 3> eps, alpha;
    const Real eo = Real(crystal.n_o) * Real(crystal.n_o),
               ee = Real(crystal.n_e) * Real(crystal.n_e);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const Real cc = local[i] * local[j];
            eps[i][j] = (i == j ? eo : Real(0)) + (ee - eo) * cc;
            alpha[i][j] = (i == j ? Real(crystal.across) : Real(0)) +
                          (Real(crystal.along) - Real(crystal.across)) * cc;
        }
    }
    // Unknown z components from (k x E)_z = K Ey = Bz and (k x H)_z = K Hy = -Dz, column by column.
    Matrix4 d{};
    const Cplx i1(Real(0), Real(1));
    for (std::size_t column = 0; column < 4; ++column) {
        std::array<Cplx, 3> E{}, H{};
        (column < 2 ? E[column] : H[column - 2]) = 1;
        Cplx b0 = 0, d0 = 0;
        for (std::size_t j = 0; j < 2; ++j) {
            b0 += H[j] * (j == 2 ? 1 : 0) - i1 * alpha[2][j] * E[j];
            d0 += eps[2][j] * E[j] + i1 * alpha[2][j] * H[j];
        }
        // Hz - i a Ez = K Ey - b0;  e Ez + i a Hz = -K Hy - d0.
        const Cplx r1 = K * E[1] - b0, r2 = -K * H[1] - d0, a = alpha[2][2], e = eps[2][2];
        E[2] = (r2 - i1 * a * r1) / (e - a * a);
        H[2] = r1 + i1 * a * E[2];
        std::array<Cplx, 3> B{}, D{};
        for (std::size_t i = 0; i < 3; ++i) {
            B[i] = H[i];
            for (std::size_t j = 0; j < 3; ++j) {
                B[i] -= i1 * alpha[i][j] * E[j];
                D[i] += eps[i][j] * E[j] + i1 * alpha[i][j] * H[j];
            }
        }
        // k x E = (-q Ey, q Ex - K Ez, K Ey), likewise H.
        d[0][column] = B[1] + K * E[2];
        d[1][column] = -B[0];
        d[2][column] = -D[1] + K * H[2];
        d[3][column] = D[0];
    }
    const auto flow = [](const Vector4& v) {
        return re(v[0] * conjugate(v[3]) - v[1] * conjugate(v[2]));
    };
    std::vector<Eigen> waves;
    for (const Cplx& q : eigenvalues(d)) {
        Matrix4 shifted = d;
        for (std::size_t i = 0; i < 4; ++i) shifted[i][i] -= q;
        const Vector4 psi = null_space(shifted)[0];
        waves.push_back({q, psi, abs(im(q)) > Real("1e-25") ? im(q) : flow(psi)});
    }
    std::sort(waves.begin(), waves.end(),
              [](const Eigen& a, const Eigen& b) { return a.flow > b.flow; });
    if (waves[1].flow < 0 || waves[2].flow > 0) throw std::runtime_error("not two outgoing waves");
    if (re(waves[0].q * waves[0].q) > re(waves[1].q * waves[1].q)) std::swap(waves[0], waves[1]);

    // s: E = y; p: E = k x y = (-kn, 0, K), both with |E| = 1 in air.
    const Vector4 in =
        mode == 0 ? Vector4{0, 1, Cplx(Real(-kn)), 0} : Vector4{Cplx(Real(-kn)), 0, 0, -1};
    const Vector4 s{0, 1, Cplx(kn), 0}, p{Cplx(kn), 0, 0, -1};
    Matrix4 a;
    for (std::size_t i = 0; i < 4; ++i) a[i] = {-s[i], -p[i], waves[0].psi[i], waves[1].psi[i]};
    const Vector4 t = solve_linear(a, in);
    ActiveSolution out;
    out.q = {waves[0].q, waves[1].q};
    for (std::size_t i = 0; i < 2; ++i) out.power[i] = norm2(t[2 + i]) * flow(waves[i].psi) / kn;
    out.reflected_s = norm2(t[0]);
    out.reflected_p = norm2(t[1]);
    return out;
}

}  // namespace reference
