// Principal axes of a real symmetric tensor by Jacobi's method.
#include "math/symmetric.hpp"

#include <algorithm>
#include <utility>

namespace icespar {

PrincipalAxes principal_axes(const RealTensor& t) {
    double a[3][3] = {{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}};
    std::array<Vec3, 3> v{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    for (int sweep = 0; sweep < 30; ++sweep) {
        if (a[0][1] == 0 && a[0][2] == 0 && a[1][2] == 0) break;
        for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
            if (a[p][q] == 0) continue;
            // The smaller of the two rotations that clear a[p][q] (Golub & Van Loan, 8.5.2).
            const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
            const double tan =
                std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
            const double c = 1 / std::hypot(1.0, tan), s = tan * c;
            for (auto& row : a) {
                const double x = row[p], y = row[q];
                row[p] = c * x - s * y;
                row[q] = s * x + c * y;
            }
            for (int i = 0; i < 3; ++i) {
                const double x = a[p][i], y = a[q][i];
                a[p][i] = c * x - s * y;
                a[q][i] = s * x + c * y;
            }
            a[p][q] = a[q][p] = 0;
            const Vec3 x = v[static_cast<std::size_t>(p)], y = v[static_cast<std::size_t>(q)];
            v[static_cast<std::size_t>(p)] = c * x - s * y;
            v[static_cast<std::size_t>(q)] = s * x + c * y;
        }
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return a[i][i] < a[j][j]; });
    PrincipalAxes out;
    for (std::size_t i = 0; i < 3; ++i) {
        out.values[i] = a[order[i]][order[i]];
        out.axes[i] = normalised(v[order[i]]);
    }
    out.axes[2] = normalised(cross(out.axes[0], out.axes[1]));
    return out;
}

}  // namespace icespar
