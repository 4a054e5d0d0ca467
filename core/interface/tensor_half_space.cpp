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
/// which, for with loss just two waves decay each way. Where K is complex, behind an absorbing
/// medium, they are followed from its real part.
template <class R>
bool directed_factors(const LocalMedium<std::complex<R>>& medium, const std::complex<R>& K,
                      int sign, const Quartic<std::complex<R>>& truth,
                      Factors<std::complex<R>>& out) {
    using C = std::complex<R>;
    const auto quartic = [](const LocalMedium<C>& m, const C& k) {
        const Berreman<C> b(m, k);
        return b.characteristic(product(b.d, b.d));
    };
    const bool real_K = K.imag() == 0;
    const Quartic<C> first = real_K ? truth : quartic(medium, K.real());
    for (const double loss : {1e-4, 1e-6, 1e-2}) {
        LocalMedium<C> lossy = medium;
        lossy.eps = C(1, R(loss)) * lossy.eps;
        auto q = roots(quartic(lossy, K.real()));
        std::sort(q.begin(), q.end(),
                  [&](const C& x, const C& y) { return R(sign) * x.imag() > R(sign) * y.imag(); });
        out = {Quadratic<C>::from_roots(q[0], q[1]), Quadratic<C>::from_roots(q[2], q[3])};
        if (polish(first, out)) break;
    }
    if (real_K) return true;
    constexpr int steps = 32;
    for (int i = 1; i < steps; ++i) {
        const R t = R(i * i) / (steps * steps);
        polish(quartic(medium, C(K.real(), t * K.imag())), out);
    }
    return polish(truth, out);
}

/// Sees to it that `known` is a root of the incoming factor: near grazing in an absorbing crystal
/// continuity can count a wave among the others that carries energy towards the face.
template <class C>
void incoming(const C& known, Factors<C>& f) {
    const auto value = [&](const Quadratic<C>& g) { return std::abs((known + g.b) * known + g.c); };
    if (value(f.second) <= value(f.first)) return;
    auto out = roots(f.first), in = roots(f.second);
    const auto nearer = [&](const std::array<C, 2>& q) {
        return std::abs(q[0] - known) < std::abs(q[1] - known) ? 0 : 1;
    };
    std::swap(out[nearer(out)], in[nearer(in)]);
    f = {Quadratic<C>::from_roots(out[0], out[1]), Quadratic<C>::from_roots(in[0], in[1])};
}

}  // namespace

template <class R>
template <class T>
bool HalfSpace<R>::tensor(const Medium& medium, const FaceAxes<R>& face, const C& K_given, int sign,
                          const Arriving<R>* known) {
    constexpr bool is_real = !is_complex<T>;
    // Lengths of k in units of a mean index, fields in its impedance: all of order 1.
    const SymmetricTensor<C> eps_full = face.permittivity(medium);
    const R scale = std::sqrt(
        std::sqrt((std::norm(eps_full.xx) + std::norm(eps_full.yy) + std::norm(eps_full.zz)) / 3));
    LocalMedium<T> local;
    local.eps = T(1 / (scale * scale)) * cast<T>(eps_full);
    if (medium.active()) {
        local.active = true;
        const R g = R(medium.gyration) / scale, along = R(medium.gyration_along) / scale;
        local.alpha = SymmetricTensor<R>::diagonal(g, g, g) +
                      (along - g) * dyad(face.to_face(normalised(converted<R>(medium.axis))));
    }
    const T K = cast<T>(C(K_given / scale));
    const Berreman<T> b(local, K);
    const Matrix4<T> square = product(b.d, b.d);
    const Quartic<T> f = b.characteristic(square);
    Factors<T> factors;  // first: outgoing, second: incoming
    if constexpr (is_real) {
        if (!real_factors(f, R(0.02), factors)) return false;
        if (sign > 0) std::swap(factors.first, factors.second);
        if (!polish(f, factors)) return false;
    } else {
        if (!directed_factors<R>(local, K, sign, f, factors)) return false;
    }
    if (known) {
        const T exact = cast<T>(C(known->q / scale));
        if constexpr (!is_real) {
            if (medium.absorbing) incoming(exact, factors);
        } else {
            // Four crossings of the outer sheet: the pairs are not the upper and the lower two.
            const auto& in = factors.second;
            if (std::abs((exact + in.b) * exact + in.c) > R(1e-8)) return false;
        }
        adopt(f, exact, factors);
    }
    Plane<T> plane;
    R shift = 0;  // M is D on the plane less shift
    bool weak = false;
    R weak_M[2][2];
    if constexpr (is_real) {
        if (medium.symmetry == Symmetry::biaxial) {
            const SymmetricTensor<R> deviation =
                (1 / (scale * scale)) *
                converted<R>(real(medium.deviation)).in_frame(face.x, face.y, face.z);
            weak = nearly_isotropic<R>(R(medium.mean.real()) / (scale * scale), deviation, K, sign,
                                       plane, weak_M, shift);
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
        return T(R(0.5) * (conjugate(x[0]) * y[3] + conjugate(x[3]) * y[0] -
                           conjugate(x[1]) * y[2] - conjugate(x[2]) * y[1]));
    };
    const auto& B = plane.columns;
    const R s = R(sign);
    const R p = s * std::real(flow(B[0], B[0])), r = s * std::real(flow(B[1], B[1]));
    const T o = s * flow(B[0], B[1]);
    const R det = p * r - size2(o);
    const bool transparent = !medium.absorbing && (is_real || K_given.imag() == 0);
    // Both waves carry energy: positive form. It is Hermitian for D, which makes the modes
    // orthogonal.
    const bool both = transparent && p > 0 && r > 0 && det > (is_real ? R(0) : R(1e-8)) * p * r;
    if constexpr (is_real) {
        if (!both) return false;
    }
    if (separate_grazing(b, square, f, factors, scale, sign, known, !transparent,
                         K_given.imag() != 0)) {
        order_by_sheet(sign, transparent);
        return true;
    }
    Eigen2<C> modes;
    bool solved = false;
    if (both) {
        // basis * L^-H with form = L L^H, L = [l 0; m n].
        const R l = std::sqrt(p), n = std::sqrt(det / p);
        const T m = conjugate(o) / l;
        // H = L^H M L^-H.
        const T h00 = l * M[0][0] + conjugate(m) * M[1][0],
                h01 = l * M[0][1] + conjugate(m) * M[1][1];
        const T h10 = n * M[1][0], h11 = n * M[1][1];
        const T a00 = h00 / l, a10 = h10 / l;
        const T a01 = (h01 - a00 * conjugate(m)) / n, a11 = (h11 - a10 * conjugate(m)) / n;
        const R skew =
            std::abs(a01 - conjugate(a10)) + std::abs(std::imag(a00)) + std::abs(std::imag(a11));
        if (is_real || skew < R(1e-7)) {
            const auto e = hermitian_eigen<T>(std::real(a00), T(R(0.5) * (a01 + conjugate(a10))),
                                              std::real(a11));
            for (std::size_t i = 0; i < two; ++i) {
                // c = L^-H v.
                const T y = e.vector[i][1] / n;
                modes.value[i] = e.value[i];
                modes.vector[i] = {C(T((e.vector[i][0] - conjugate(m) * y) / l)), C(y)};
            }
            solved = true;
        }
    }
    if (!solved) modes = general_eigen<R>(M[0][0], M[0][1], M[1][0], M[1][1]);

    set_basis({Field{B[0][0], B[0][1], scale * B[0][2], scale * B[0][3]},
               Field{B[1][0], B[1][1], scale * B[1][2], scale * B[1][3]}});
    for (std::size_t i = 0; i < two; ++i) {
        Field v;
        C ez = 0;
        for (std::size_t j = 0; j < 4; ++j) {
            v[j] = modes.vector[i][0] * B[0][j] + modes.vector[i][1] * B[1][j];
            ez += b.ez[j] * v[j];
        }
        const R size = std::sqrt(std::norm(v[0]) + std::norm(v[1]) + std::norm(ez));
        q[i] = scale * (modes.value[i] + shift);
        E[i] = {v[0] / size, v[1] / size, ez / size};
        psi[i] = {v[0] / size, v[1] / size, scale / size * v[2], scale / size * v[3]};
        propagating[i] = !transparent || solved || std::abs(q[i].imag()) < R(1e-10) * scale;
        flux[i] = propagating[i] ? std::max(s * normal_flux<R>(psi[i]), R(0)) : R(0);
    }
    // Nearly equal indices: a perturbation keeps its digits, the rest does not; still less where
    // the two fields become one too (evanescent or absorbed waves that merge).
    if (!weak) {
        const R apart = solved ? R(1) : length(cross(E[0], E[1]));
        separation = std::min(separation, 25 * apart * std::abs(q[0] - q[1]) / scale);
    }
    order_by_sheet(sign, transparent);
    return true;
}

template <class R>
void HalfSpace<R>::order_by_sheet(int sign, bool transparent) {
    // Slow: the outer sheet. A line along the normal meets it outside the inner one; where only one
    // wave propagates it is the outer one.
    const auto outer = [&](std::size_t i) {
        if (transparent && propagating[0] && propagating[1]) return R(sign) * q[i].real();
        if (transparent && propagating[0] != propagating[1]) return propagating[i] ? R(1) : R(0);
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

template bool HalfSpace<double>::tensor<double>(const Medium&, const FaceAxes<double>&, const C&,
                                                int, const Arriving<double>*);
template bool HalfSpace<double>::tensor<Complex>(const Medium&, const FaceAxes<double>&, const C&,
                                                 int, const Arriving<double>*);
template bool HalfSpace<long double>::tensor<long double>(const Medium&,
                                                          const FaceAxes<long double>&, const C&,
                                                          int, const Arriving<long double>*);
template bool HalfSpace<long double>::tensor<std::complex<long double>>(
    const Medium&, const FaceAxes<long double>&, const C&, int, const Arriving<long double>*);

}  // namespace icespar
