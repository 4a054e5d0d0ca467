// The outgoing waves of a biaxial or active medium, absorbing or not.
//
// Of Berreman's matrix D only the two quadratic factors of its characteristic polynomial are
// needed, out(q) of the outgoing and in(q) of the incoming pair: the columns of in(D) span the
// outgoing fields. They are smooth functions of symmetric functions of the pair, and so know
// nothing of optic axes and of exceptional points (waves that merge). The modes are found
// afterwards inside the plane.
#include <algorithm>
#include <utility>

#include "interface/half_space.hpp"
#include "interface/nearly_isotropic.hpp"

namespace icespar {
namespace {

/// out(q) and in(q), with energy towards sign * normal going out: the limit of small loss tells
/// which, for with loss just two waves decay each way.
bool directed_factors(const LocalMedium<Complex>& medium, const Complex& K, int sign,
                      const Quartic<Complex>& truth, Factors<Complex>& out) {
    for (const double loss : {1e-4, 1e-6, 1e-2}) {
        LocalMedium<Complex> lossy = medium;
        lossy.eps = Complex(1, loss) * lossy.eps;
        const Berreman<Complex> b(lossy, K.real());
        auto q = roots(b.characteristic(product(b.d, b.d)));
        std::sort(q.begin(), q.end(), [&](const Complex& x, const Complex& y) {
            return sign * x.imag() > sign * y.imag();
        });
        out = {Quadratic<Complex>::from_roots(q[0], q[1]),
               Quadratic<Complex>::from_roots(q[2], q[3])};
        if (polish(truth, out)) return true;
    }
    return true;
}

}  // namespace

template <class T>
bool HalfSpace::tensor(const Medium& medium, const FaceFrame& face, const Complex& K_given,
                       int sign, const Arriving* known) {
    constexpr bool is_real = std::is_same_v<T, double>;
    // Lengths of k in units of a mean index, fields in its impedance: all of order 1.
    const ComplexTensor eps_full = medium.permittivity().in_frame(face.x, face.y, face.z);
    const double scale = std::sqrt(
        std::sqrt((std::norm(eps_full.xx) + std::norm(eps_full.yy) + std::norm(eps_full.zz)) / 3));
    LocalMedium<T> local;
    local.eps = T(1 / (scale * scale)) * cast<T>(eps_full);
    if (medium.active()) {
        local.active = true;
        const double g = medium.gyration / scale, along = medium.gyration_along / scale;
        local.alpha = RealTensor::diagonal(g, g, g) + (along - g) * dyad(face.to_face(medium.axis));
    }
    const T K = cast<T>(Complex(K_given / scale));
    const Berreman<T> b(local, K);
    const Matrix4<T> square = product(b.d, b.d);
    const Quartic<T> f = b.characteristic(square);
    Factors<T> factors;  // first: outgoing, second: incoming
    if constexpr (is_real) {
        if (!real_factors(f, 0.02, factors)) return false;
        if (sign > 0) std::swap(factors.first, factors.second);
        if (!polish(f, factors)) return false;
    } else {
        LocalMedium<Complex> start = local;
        if (!directed_factors(start, K, sign, f, factors)) return false;
    }
    if (known) {
        const T exact = cast<T>(Complex(known->q / scale));
        if constexpr (is_real) {
            // Four crossings of the outer sheet: the pairs are not the upper and the lower two.
            const auto& in = factors.second;
            if (std::abs((exact + in.b) * exact + in.c) > 1e-8) return false;
        }
        adopt(f, exact, factors);
    }
    Plane<T> plane;
    double shift = 0;  // M is D on the plane less shift
    bool weak = false;
    double weak_M[2][2];
    if constexpr (is_real) {
        if (medium.symmetry == Symmetry::biaxial) {
            const RealTensor deviation =
                (1 / (scale * scale)) * real(medium.deviation).in_frame(face.x, face.y, face.z);
            weak = nearly_isotropic(medium.mean.real() / (scale * scale), deviation, K, sign, plane,
                                    weak_M, shift);
        }
    }
    if (!weak) plane = Plane<T>(spanning_columns(evaluate(factors.second, b.d, square)));

    // D on the subspace, in the basis that is the identity on the pivots.
    std::array<std::array<T, 2>, 2> M;
    for (std::size_t i = 0; i < two; ++i) {
        for (std::size_t j = 0; j < two; ++j) {
            M[i][j] = weak ? T(weak_M[i][j]) : dot4(b.d[plane.pivot[i]], plane.columns[j]);
        }
    }
    // Energy flow as a Hermitian form on the subspace.
    const auto flow = [&](const Vector4<T>& x, const Vector4<T>& y) {
        return T(0.5 * (conjugate(x[0]) * y[3] + conjugate(x[3]) * y[0] - conjugate(x[1]) * y[2] -
                        conjugate(x[2]) * y[1]));
    };
    const auto& B = plane.columns;
    const double s = sign;
    const double p = s * real_part(flow(B[0], B[0])), r = s * real_part(flow(B[1], B[1]));
    const T o = s * flow(B[0], B[1]);
    const double det = p * r - size2(o);
    const bool transparent = !medium.absorbing && (is_real || K_given.imag() == 0);
    // Both waves carry energy: positive form. It is Hermitian for D, which makes the modes
    // orthogonal.
    const bool both = transparent && p > 0 && r > 0 && det > (is_real ? 0 : 1e-8) * p * r;
    if constexpr (is_real) {
        if (!both) return false;
    }
    if (separate_grazing(b, square, f, factors, scale, sign, known, medium.absorbing)) {
        order_by_sheet(sign, !medium.absorbing);
        return true;
    }
    Eigen2<Complex> modes;
    bool solved = false;
    if (both) {
        // basis * L^-H with form = L L^H, L = [l 0; m n].
        const double l = std::sqrt(p), n = std::sqrt(det / p);
        const T m = conjugate(o) / l;
        // H = L^H M L^-H.
        const T h00 = l * M[0][0] + conjugate(m) * M[1][0],
                h01 = l * M[0][1] + conjugate(m) * M[1][1];
        const T h10 = n * M[1][0], h11 = n * M[1][1];
        const T a00 = h00 / l, a10 = h10 / l;
        const T a01 = (h01 - a00 * conjugate(m)) / n, a11 = (h11 - a10 * conjugate(m)) / n;
        const double skew =
            std::abs(a01 - conjugate(a10)) + std::abs(std::imag(a00)) + std::abs(std::imag(a11));
        if (is_real || skew < 1e-7) {
            const auto e =
                hermitian_eigen<T>(real_part(a00), T(0.5 * (a01 + conjugate(a10))), real_part(a11));
            for (std::size_t i = 0; i < two; ++i) {
                // c = L^-H v.
                const T y = e.vector[i][1] / n;
                modes.value[i] = e.value[i];
                modes.vector[i] = {Complex(T((e.vector[i][0] - conjugate(m) * y) / l)), Complex(y)};
            }
            solved = true;
        }
    }
    if (!solved) modes = general_eigen(M[0][0], M[0][1], M[1][0], M[1][1]);

    set_basis({Field4{B[0][0], B[0][1], scale * B[0][2], scale * B[0][3]},
               Field4{B[1][0], B[1][1], scale * B[1][2], scale * B[1][3]}});
    for (std::size_t i = 0; i < two; ++i) {
        Vector4<Complex> v;
        Complex ez = 0;
        for (std::size_t j = 0; j < 4; ++j) {
            v[j] = modes.vector[i][0] * B[0][j] + modes.vector[i][1] * B[1][j];
            ez += b.ez[j] * v[j];
        }
        const double size = std::sqrt(std::norm(v[0]) + std::norm(v[1]) + std::norm(ez));
        q[i] = scale * (modes.value[i] + shift);
        E[i] = {v[0] / size, v[1] / size, ez / size};
        psi[i] = {v[0] / size, v[1] / size, scale / size * v[2], scale / size * v[3]};
        propagating[i] = !transparent || solved || std::abs(q[i].imag()) < 1e-10 * scale;
        flux[i] = propagating[i] ? std::max(s * normal_flux(psi[i]), 0.0) : 0;
    }
    order_by_sheet(sign, transparent);
    return true;
}

void HalfSpace::order_by_sheet(int sign, bool transparent) {
    // Slow: the outer sheet. A line along the normal meets it outside the inner one; where only one
    // wave propagates it is the outer one.
    const auto outer = [&](std::size_t i) {
        if (transparent && propagating[0] && propagating[1]) return sign * q[i].real();
        if (transparent && propagating[0] != propagating[1]) return propagating[i] ? 1.0 : 0.0;
        return (q[i] * q[i]).real();
    };
    if (outer(0) > outer(1)) {
        std::swap(q[0], q[1]);
        std::swap(E[0], E[1]);
        std::swap(psi[0], psi[1]);
        std::swap(flux[0], flux[1]);
        const bool first = propagating[0];
        propagating[0] = propagating[1];
        propagating[1] = first;
    }
}

template bool HalfSpace::tensor<double>(const Medium&, const FaceFrame&, const Complex&, int,
                                        const Arriving*);
template bool HalfSpace::tensor<Complex>(const Medium&, const FaceFrame&, const Complex&, int,
                                         const Arriving*);

}  // namespace icespar
