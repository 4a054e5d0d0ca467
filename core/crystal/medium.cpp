// Media and their checks.
#include "crystal/medium.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>

#include "math/error.hpp"

namespace icespar {
namespace {

void require_index(Complex n, const char* which) {
    if (!std::isfinite(n.real()) || n.real() <= 0) {
        throw Error(std::string(which) + " must be a finite positive number, not " +
                    std::to_string(n.real()));
    }
    if (!std::isfinite(n.imag()) || n.imag() < 0) {
        throw Error(std::string(which) + " must have a finite kappa >= 0 (n + i kappa), not " +
                    std::to_string(n.imag()));
    }
}

Vec3 unit_axis(const Vec3& axis, const char* which) {
    const double size = length(axis);
    if (!is_finite(axis) || !std::isfinite(size) || size == 0) {
        throw Error(std::string(which) + " must be a finite vector that is not zero");
    }
    return axis / size;
}

/// Symmetry of a medium from the real and imaginary parts of its tensor.
struct Classified {
    Symmetry symmetry;
    Vec3 axis;
};

/// The axis about which a tensor is round; `any` when it is a multiple of the identity.
struct Roundness {
    bool any, round;
    Vec3 axis;
};

Roundness roundness(const RealTensor& t, double tolerance) {
    const PrincipalAxes p = principal_axes(t);
    const double low = p.values[1] - p.values[0], high = p.values[2] - p.values[1];
    if (std::max(low, high) <= tolerance) return {true, true, {0, 0, 1}};
    if (low <= tolerance) return {false, true, p.axes[2]};
    if (high <= tolerance) return {false, true, p.axes[0]};
    return {false, false, {}};
}

Classified classified(const ComplexTensor& eps, double tolerance) {
    const Roundness re = roundness(real(eps), tolerance), im = roundness(imag(eps), tolerance);
    if (re.any && im.any) return {Symmetry::isotropic, {0, 0, 1}};
    if (!re.round || !im.round) return {Symmetry::biaxial, {}};
    if (re.any) return {Symmetry::uniaxial, im.axis};
    if (im.any) return {Symmetry::uniaxial, re.axis};
    const double size = std::abs(dot(re.axis, im.axis));
    const Vec3 across = cross(re.axis, im.axis);
    return length(across) <= 1e-12 && size > 0.5 ? Classified{Symmetry::uniaxial, re.axis}
                                                 : Classified{Symmetry::biaxial, {}};
}

double largest(const ComplexTensor& t) {
    double size = 0;
    for (const Complex& z : {t.xx, t.yy, t.zz, t.yz, t.xz, t.xy}) {
        size = std::max({size, std::abs(z.real()), std::abs(z.imag())});
    }
    return size;
}

std::string element(std::size_t row, std::size_t column) {
    return "eps[" + std::to_string(row) + "][" + std::to_string(column) + "]";
}

Medium biaxial_from(const ComplexTensor& eps, bool absorbing) {
    Medium m;
    m.birefringent = true;
    m.symmetry = Symmetry::biaxial;
    m.absorbing = absorbing;
    m.mean = eps.yy;
    m.deviation = eps + ComplexTensor::diagonal(-eps.yy, -eps.yy, -eps.yy);
    const PrincipalAxes p = principal_axes(real(m.deviation));
    m.principal = p.axes;
    for (std::size_t i = 0; i < 3; ++i) {
        m.n_principal[i] = std::sqrt(std::max(m.mean.real() + p.values[i], 0.0));
    }
    m.n_o = m.n_principal[0];
    m.n_e = m.n_principal[2];
    return m;
}

}  // namespace

Medium Medium::isotropic(double n) { return isotropic(Complex(n)); }

Medium Medium::isotropic(Complex n) {
    require_index(n, "n");
    Medium m;
    m.n_o = m.n_e = n.real();
    m.kappa_o = m.kappa_e = n.imag();
    m.absorbing = n.imag() > 0;
    return m;
}

Medium Medium::uniaxial(double n_o, double n_e, const Vec3& axis) {
    return uniaxial(Complex(n_o), Complex(n_e), axis);
}

Medium Medium::uniaxial(Complex n_o, Complex n_e, const Vec3& axis) {
    require_index(n_o, "n_o");
    require_index(n_e, "n_e");
    Medium m;
    m.n_o = n_o.real();
    m.n_e = n_e.real();
    m.kappa_o = n_o.imag();
    m.kappa_e = n_e.imag();
    m.absorbing = n_o.imag() > 0 || n_e.imag() > 0;
    m.axis = unit_axis(axis, "axis");
    m.birefringent = true;
    m.symmetry = Symmetry::uniaxial;
    return m;
}

Medium Medium::biaxial(const std::array<Complex, 3>& n, const Vec3& first, const Vec3& second) {
    for (std::size_t i = 0; i < 3; ++i)
        require_index(n[i], ("n[" + std::to_string(i) + "]").c_str());
    const Vec3 x = unit_axis(first, "axes[0]");
    Vec3 y = unit_axis(second, "axes[1]");
    if (std::abs(dot(x, y)) > 1e-6) {
        throw Error("axes[0] and axes[1] must be perpendicular; the third axis follows from them");
    }
    y = normalised(y - dot(x, y) * x);
    const std::array<Vec3, 3> axes{x, y, cross(x, y)};
    // The index in the middle times the identity, and the differences to it, which stay exact.
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return n[i].real() < n[j].real(); });
    const Complex middle = n[order[1]];
    Medium m;
    m.mean = middle * middle;
    for (const std::size_t i : {order[0], order[2]}) {
        const Complex difference = (n[i] - middle) * (n[i] + middle);
        m.deviation = m.deviation + difference * complexified(dyad(axes[i]));
    }
    m.birefringent = true;
    m.symmetry = Symmetry::biaxial;
    for (const Complex& index : n) m.absorbing = m.absorbing || index.imag() > 0;
    for (std::size_t i = 0; i < 3; ++i) {
        m.n_principal[i] = n[order[i]].real();
        m.principal[i] = axes[order[i]];
    }
    m.n_o = m.n_principal[0];
    m.n_e = m.n_principal[2];
    return m;
}

Medium Medium::active(double n_o, double n_e, const Vec3& axis, double rotation_deg_per_mm,
                      double wavelength_nm, double g_ratio) {
    if (!std::isfinite(rotation_deg_per_mm) || !std::isfinite(wavelength_nm) ||
        wavelength_nm <= 0 || !std::isfinite(g_ratio)) {
        throw Error("the rotary power must be finite and the wavelength finite and positive");
    }
    const double gyration = rotation_deg_per_mm * wavelength_nm * 1e-6 / 360;
    return gyrotropic(n_o, n_e, axis, gyration, (2 * g_ratio - 1) * gyration);
}

Medium Medium::gyrotropic(double n_o, double n_e, const Vec3& axis, double gyration,
                          double gyration_along) {
    Medium m = uniaxial(n_o, n_e, axis);
    m.gyration = gyration;
    m.gyration_along = gyration_along;
    if (!(std::max(std::abs(gyration), std::abs(gyration_along)) < std::min(n_o, n_e))) {
        throw Error("the rotary power is too large: the gyration must stay below the indices");
    }
    return m;
}

Medium Medium::from_tensor(const std::array<std::array<Complex, 3>, 3>& eps) {
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const Complex& z = eps[i][j];
            if (!std::isfinite(z.real()) || !std::isfinite(z.imag())) {
                throw Error(element(i, j) + " is not finite; a dielectric tensor must be");
            }
            size = std::max(size, std::abs(z));
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (std::abs(eps[i][j] - eps[j][i]) > 1e-12 * size) {
                throw Error(element(i, j) + " and " + element(j, i) +
                            " differ; a dielectric tensor must be symmetric");
            }
        }
    }
    const auto mean = [&](std::size_t i, std::size_t j) { return 0.5 * (eps[i][j] + eps[j][i]); };
    const ComplexTensor t{eps[0][0], eps[1][1], eps[2][2], mean(1, 2), mean(0, 2), mean(0, 1)};
    const double loss_tolerance = 8 * rounding * largest(complexified(imag(t)));
    const double loss = principal_axes(imag(t)).values[0];
    if (loss < -loss_tolerance) {
        throw Error("eps gives energy to light; no eigenvalue of Im eps may be negative");
    }
    // Where eps does not absorb it must be positive; a large multiple of the loss hides the rest.
    const RealTensor guard = real(t) + 1e6 * imag(t);
    if (!(principal_axes(guard).values[0] > 0)) {
        throw Error("eps is not positive definite; where it does not absorb it must be");
    }
    const bool absorbing = !(imag(t) == RealTensor{});
    const Classified kind = classified(t, 16 * rounding * size);
    if (kind.symmetry == Symmetry::biaxial) return biaxial_from(t, absorbing);
    const Complex trace = t.xx + t.yy + t.zz;
    const Complex along = dot(kind.axis, t * kind.axis);
    const auto index = [](Complex e) {
        const Complex n = std::sqrt(e);
        return Complex(n.real(), std::max(n.imag(), 0.0));
    };
    if (kind.symmetry == Symmetry::isotropic) return isotropic(index(trace / 3.0));
    return uniaxial(index((trace - along) / 2.0), index(along), kind.axis);
}

ComplexTensor Medium::permittivity() const {
    if (symmetry == Symmetry::biaxial) {
        return ComplexTensor::diagonal(mean, mean, mean) + deviation;
    }
    const Complex o = eps_o();
    const Complex difference =
        Complex(n_e - n_o, kappa_e - kappa_o) * Complex(n_e + n_o, kappa_e + kappa_o);
    return ComplexTensor::diagonal(o, o, o) + difference * complexified(dyad(axis));
}

bool operator==(const Medium& a, const Medium& b) {
    if (a.symmetry != b.symmetry) return false;
    if (a.symmetry == Symmetry::biaxial) return a.mean == b.mean && a.deviation == b.deviation;
    const bool same_axis =
        a.symmetry == Symmetry::isotropic || a.axis == b.axis || a.axis == -b.axis;
    return same_axis && a.n_o == b.n_o && a.n_e == b.n_e && a.kappa_o == b.kappa_o &&
           a.kappa_e == b.kappa_e && a.gyration == b.gyration &&
           a.gyration_along == b.gyration_along;
}

std::array<Complex, 3> principal_indices(const Medium& m) {
    std::array<Complex, 3> n;
    double size = 0, across = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const CVec3 image = m.deviation * m.principal[i];
        const Complex eps = m.mean + dot(m.principal[i], image);
        const double loss = eps.imag() > 1e-15 * std::abs(eps) ? eps.imag() : 0;
        n[i] = std::sqrt(Complex(eps.real(), loss));
        size = std::max(size, std::abs(eps));
        across = std::max(across, length(cross(m.principal[i], image)));
    }
    // Where the loss has axes of its own, a complex index would describe another medium.
    if (!m.absorbing || across > 1e-12 * size)
        n = {m.n_principal[0], m.n_principal[1], m.n_principal[2]};
    return n;
}

CVec3 MediumCore::magnetic_field(const CVec3& k, const CVec3& E) const {
    CVec3 H = cross(k, E);
    if (active()) {
        const CVec3 turned =
            gyration * E + ((gyration_along - gyration) * dot(axis, E)) * complexified(axis);
        H += Complex(0, 1) * turned;
    }
    return H;
}

OpticAxes optic_axes(const Medium& m) {
    if (m.symmetry == Symmetry::isotropic) throw Error("an isotropic medium has no optic axes");
    if (m.symmetry == Symmetry::uniaxial)
        return {m.axis, m.axis, m.n_e >= m.n_o ? 0 : std::numbers::pi};
    // sin^2 V : cos^2 V = (1/na^2 - 1/nb^2) : (1/nb^2 - 1/nc^2) about the axis of n_gamma.
    const auto [a, b, c] = m.n_principal;
    const double s = c * std::sqrt((b - a) * (b + a)), t = a * std::sqrt((c - b) * (c + b));
    const double V = s == 0 && t == 0 ? 0 : std::atan2(s, t);
    const Vec3 x = std::sin(V) * m.principal[0], z = std::cos(V) * m.principal[2];
    return {z + x, z - x, 2 * V};
}

}  // namespace icespar
