// Sensor responses at the far end of a branch.
#include "render/branch.hpp"

namespace icespar {

Stokes Branch::unpolarised() const {
    const auto& [x, y] = amplitude;
    const double xx = std::norm(x[0]) + std::norm(x[1]), yy = std::norm(y[0]) + std::norm(y[1]);
    const Complex xy = x[0] * std::conj(y[0]) + x[1] * std::conj(y[1]);
    const Stokes seen{0.5 * (xx + yy), 0.5 * (xx - yy), xy.real(), xy.imag()};
    return diffused ? seen.s0 * response : seen;
}

Stokes Branch::polarised(const Stokes& light, const Vec3& x, const Vec3& y) const {
    // Coherency of the light in (x, y), and the two launched fields on the same axes.
    const double xx = 0.5 * (light.s0 + light.s1), yy = 0.5 * (light.s0 - light.s1);
    const Complex xy{0.5 * light.s2, 0.5 * light.s3};
    std::array<std::array<Complex, 2>, 2> u;
    for (std::size_t s = 0; s < 2; ++s) {
        const auto& a = amplitude[s];
        u[s] = {a[0] * dot(basis[0], x) + a[1] * dot(basis[1], x),
                a[0] * dot(basis[0], y) + a[1] * dot(basis[1], y)};
    }
    const auto coherency = [&](std::size_t a, std::size_t b) {
        return xx * u[a][0] * std::conj(u[b][0]) + yy * u[a][1] * std::conj(u[b][1]) +
               xy * u[a][0] * std::conj(u[b][1]) + std::conj(xy) * u[a][1] * std::conj(u[b][0]);
    };
    const double sx = coherency(0, 0).real(), sy = coherency(1, 1).real();
    const Complex sxy = coherency(0, 1);
    const Stokes seen{sx + sy, sx - sy, 2 * sxy.real(), 2 * sxy.imag()};
    return diffused ? seen.s0 * response : seen;
}

Branch Branch::from_sensor(const Vec3& origin, const Vec3& direction, const Vec3& right) {
    Branch b;
    b.position = origin;
    b.ray = b.k = direction;
    // x is picture-right made perpendicular to the ray; the light travels against it, and y = z x
    // x.
    const Vec3 x = normalised(right - dot(right, direction) * direction);
    b.basis = {x, cross(-direction, x)};
    b.amplitude = {{{1, 0}, {0, 1}}};
    return b;
}

}  // namespace icespar
