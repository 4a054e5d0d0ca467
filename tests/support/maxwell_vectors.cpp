// Sixty-digit vector algebra and the materials of the Maxwell reference.
#include "support/maxwell_reference.hpp"

namespace reference {

RealVector unit(const Double3& v) {
    const Real x = v[0], y = v[1], z = v[2], length = sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}

Real dot(const RealVector& a, const RealVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Cplx dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector complexified(const RealVector& v) { return {Cplx(v[0]), Cplx(v[1]), Cplx(v[2])}; }

Vector times(const Tensor& t, const Vector& v) {
    Vector result{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result[i] += t[i][j] * v[j];
    return result;
}

Vector combine(const Cplx& a, const Vector& x, const Cplx& b, const Vector& y) {
    return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

Real hermitian_norm(const Vector& v) { return sqrt(norm2(v[0]) + norm2(v[1]) + norm2(v[2])); }

Material Material::isotropic(double n) {
    Material m;
    m.epsilon_o = Cplx(Real(n) * Real(n));
    for (int i = 0; i < 3; ++i) m.epsilon[i][i] = m.epsilon_o;
    return m;
}

Material Material::uniaxial(double n_o, double n_e, const Double3& axis) {
    Material m = isotropic(n_o);
    m.modes = Modes::o_e;
    m.axis = unit(axis);
    const Real difference = Real(n_e) * Real(n_e) - Real(n_o) * Real(n_o);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            m.epsilon[i][j] += Cplx(Real(difference * m.axis[i] * m.axis[j]));
    return m;
}

Material Material::general(const std::array<std::array<std::complex<double>, 3>, 3>& epsilon) {
    Material m;
    m.modes = Modes::fast_slow;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            m.epsilon[i][j] = Cplx(Real(epsilon[i][j].real()), Real(epsilon[i][j].imag()));
    return m;
}

RealVector PlaneWave::ray() const {
    const Real length = sqrt(dot(flow, flow));
    return {flow[0] / length, flow[1] / length, flow[2] / length};
}

}  // namespace reference
