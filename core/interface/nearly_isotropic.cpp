// The outgoing waves of a crystal that is almost isotropic, as a perturbation.
#include "interface/nearly_isotropic.hpp"

namespace icespar {

template <class R>
bool nearly_isotropic(R mean, const SymmetricTensor<R>& dev, R K, int sign, Plane<R>& plane,
                      R (&M)[2][2], R& q) {
    const R q2 = mean - K * K;
    const R size = std::max({std::abs(dev.xx), std::abs(dev.yy), std::abs(dev.zz), std::abs(dev.yz),
                             std::abs(dev.xz), std::abs(dev.xy)});
    if (!(q2 > R(0.04)) || !(size < R(1e-3) * q2)) return false;
    q = R(sign) * std::sqrt(q2);
    const R zz = mean + dev.zz;
    const R ez[4] = {-dev.xz / zz, -dev.yz / zz, 0, -K / zz};
    // Berreman's matrix less the isotropic one, in 2 x 2 blocks of E (p) and H (r).
    const R pp[2][2] = {{K * ez[0], K * ez[1]}, {0, 0}};
    const R pr[2][2] = {{0, K * K * dev.zz / (mean * zz)}, {0, 0}};
    const R rp[2][2] = {{-dev.yz * ez[0] - dev.xy, -dev.yz * ez[1] - dev.yy},
                        {dev.xz * ez[0] + dev.xx, dev.xz * ez[1] + dev.xy}};
    const R rr[2][2] = {{0, -dev.yz * ez[3]}, {0, dev.xz * ez[3]}};
    const R pr0[2][2] = {{0, 1 - K * K / mean}, {-1, 0}};
    const R X0[2][2] = {{0, -q}, {mean / q, 0}};
    using Block = std::array<std::array<R, 2>, 2>;
    const auto times = [](const auto& a, const auto& b) {
        Block out{};
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
        }
        return out;
    };
    Block X{}, step{};
    for (int i = 0; i < 2; ++i) X[static_cast<std::size_t>(i)] = {X0[i][0], X0[i][1]};
    Block m{};
    for (int iteration = 0; iteration < 12; ++iteration) {
        // M = pp + pr X + pr0 dX.
        const Block prX = times(pr, X), pr0dX = times(pr0, step);
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) m[i][j] = pp[i][j] + prX[i][j] + pr0dX[i][j];
        }
        // rp + rr X = X0 M + q dX + dX M with X0 pr0 = q.
        const Block rrX = times(rr, X), stepM = times(step, m);
        Block known{};
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) known[i][j] = pp[i][j] + prX[i][j];
        }
        const Block X0known = times(X0, known);
        Block next{};
        R change = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
                next[i][j] = (rp[i][j] + rrX[i][j] - X0known[i][j] - stepM[i][j]) / (2 * q);
                change = std::max(change, std::abs(next[i][j] - step[i][j]));
            }
        }
        step = next;
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) X[i][j] = X0[i][j] + step[i][j];
        }
        if (change <= rounding<R> * size) break;
    }
    const Block prX = times(pr, X), pr0dX = times(pr0, step);
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) M[i][j] = pp[i][j] + prX[i][j] + pr0dX[i][j];
    }
    plane.columns = {{{1, 0, X[0][0], X[1][0]}, {0, 1, X[0][1], X[1][1]}}};
    plane.pivot = {0, 1};
    return true;
}

template bool nearly_isotropic<double>(double, const SymmetricTensor<double>&, double, int,
                                       Plane<double>&, double (&)[2][2], double&);
template bool nearly_isotropic<long double>(long double, const SymmetricTensor<long double>&,
                                            long double, int, Plane<long double>&,
                                            long double (&)[2][2], long double&);

}  // namespace icespar
