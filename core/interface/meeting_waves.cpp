// Where an outgoing and an incoming wave nearly meet: at grazing incidence, beside critical angles,
// and where the normal's line touches the cone of an optic axis.
#include <algorithm>
#include <utility>

#include "interface/half_space.hpp"
#include "interface/plane.hpp"

namespace icespar {

template <class R>
template <class T>
bool HalfSpace<R>::separate_grazing(const Berreman<T>& b, const Matrix4<T>& square,
                                    const Quartic<T>& f, const Factors<T>& factors, R scale,
                                    int sign, const Arriving<R>* known, bool lossy, bool followed) {
    auto out = roots(factors.first), in = roots(factors.second);
    std::size_t a = 0, c = 0;
    for (std::size_t i = 0; i < two; ++i) {
        for (std::size_t j = 0; j < two; ++j) {
            if (std::abs(out[i] - in[j]) < std::abs(out[a] - in[c])) a = i, c = j;
        }
    }
    // out[1] and in[1] are the pair that meets.
    if (a == 0) std::swap(out[0], out[1]);
    if (c == 0) std::swap(in[0], in[1]);
    const C leaving_root = out[1];
    const R gap = std::abs(out[1] - in[1]);
    const R others = std::min({std::abs(out[0] - out[1]), std::abs(out[0] - in[1]),
                               std::abs(in[0] - out[1]), std::abs(in[0] - in[1])});
    separation = gap;
    if (gap > R(0.2) * others) return false;

    const auto nearest = [](std::array<C, 2> found, C& x, C& y) {
        if (std::abs(found[0] - x) + std::abs(found[1] - y) >
            std::abs(found[1] - x) + std::abs(found[0] - y)) {
            std::swap(found[0], found[1]);
        }
        x = found[0];
        y = found[1];
    };
    const auto refine = [&](auto type) {
        using S = decltype(type);
        const Quartic<S> g{cast<S>(C(f.c3)), cast<S>(C(f.c2)), cast<S>(C(f.c1)), cast<S>(C(f.c0))};
        Factors<S> pairs{{cast<S>(-(out[0] + in[0])), cast<S>(out[0] * in[0])},
                         {cast<S>(-(out[1] + in[1])), cast<S>(out[1] * in[1])}};
        if (!polish(g, pairs)) return;
        nearest(roots(pairs.first), out[0], in[0]);
        nearest(roots(pairs.second), out[1], in[1]);
    };
    if (known) {
        const C exact = known->q / scale;
        if (std::abs(in[0] - exact) < std::abs(in[1] - exact)) {
            in[0] = exact;
        } else {
            in[1] = exact;
        }
    } else if (lossy) {
        refine(C{});
    } else {
        refine(R{});
    }

    using Matrix = Matrix4<C>;
    Matrix d, d2;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            d[i][j] = b.d[i][j];
            d2[i][j] = square[i][j];
        }
    }
    const auto outer = Quadratic<C>::from_roots(out[0], in[0]),
               inner = Quadratic<C>::from_roots(out[1], in[1]);
    // The eigenvector of `root`, alone; `rest` is the root beside it in the outer pair.
    const auto alone = [&](const Matrix& m, const Matrix& m2, const C& rest) {
        Matrix shifted = m;
        for (std::size_t i = 0; i < 4; ++i) shifted[i][i] -= rest;
        const Matrix w = product(shifted, evaluate(inner, m, m2));
        Field best{};
        R most = -1;
        for (std::size_t j = 0; j < 4; ++j) {
            R size = 0;
            for (std::size_t i = 0; i < 4; ++i) size += std::norm(w[i][j]);
            if (size > most) {
                most = size;
                best = {w[0][j], w[1][j], w[2][j], w[3][j]};
            }
        }
        return best;
    };
    // The pair that meets, in the plane of both: (M - q_other) e is the eigenvector of q, and stays
    // so where the two become one. Beside an optic axis M, not the quartic, knows their distance.
    const Plane<C> plane(spanning_columns(evaluate(outer, d, d2)));
    const auto& B = plane.columns;
    C M[2][2];
    for (std::size_t i = 0; i < two; ++i) {
        for (std::size_t j = 0; j < two; ++j) M[i][j] = dot4(d[plane.pivot[i]], B[j]);
    }
    const auto flow = [&](const Field& x, const Field& y) {
        return R(0.5) * (std::conj(x[0]) * y[3] + std::conj(x[3]) * y[0] - std::conj(x[1]) * y[2] -
                         std::conj(x[2]) * y[1]);
    };
    // M = middle + N; without loss the flow's form times N is Hermitian, which rounding must not
    // spoil where N itself is but rounding.
    C middle = R(0.5) * (M[0][0] + M[1][1]);
    if (!lossy) middle = middle.real();
    C N[2][2] = {{M[0][0] - middle, M[0][1]}, {M[1][0], M[1][1] - middle}};
    const R p = flow(B[0], B[0]).real(), r = flow(B[1], B[1]).real();
    const C o = flow(B[0], B[1]);
    const R form = p * r - std::norm(o);
    if (!lossy) {
        const R w0 = (p * N[0][0] + o * N[1][0]).real(),
                w1 = (std::conj(o) * N[0][1] + r * N[1][1]).real();
        const C w =
            R(0.5) * (p * N[0][1] + o * N[1][1] + std::conj(std::conj(o) * N[0][0] + r * N[1][0]));
        N[0][0] = (r * w0 - o * std::conj(w)) / form;
        N[0][1] = (r * w - o * w1) / form;
        N[1][0] = (p * std::conj(w) - std::conj(o) * w0) / form;
        N[1][1] = (p * w1 - std::conj(o) * w) / form;
        const C rest = R(0.5) * (N[0][0] + N[1][1]);
        N[0][0] -= rest;
        N[1][1] -= rest;
    }
    const bool exact = known && in[1] == known->q / scale;
    C root;  // q_out - middle
    if (exact) {
        root = middle - in[1];
        if (!lossy) root = root.real();
    } else {
        const C half = R(0.5) * (N[0][0] - N[1][1]), square_root = half * half + N[0][1] * N[1][0];
        root = std::sqrt(lossy ? square_root : C(square_root.real()));
        in[1] = middle - root;
    }
    out[1] = middle + root;
    const std::size_t j = std::norm(N[0][0] + root) + std::norm(N[1][0]) >=
                                  std::norm(N[0][1]) + std::norm(N[1][1] + root)
                              ? 0
                              : 1;
    const auto column = [&](const C& shift) {
        const C x = N[0][j] + (j == 0 ? shift : C(0)), y = N[1][j] + (j == 1 ? shift : C(0));
        Field v;
        for (std::size_t i = 0; i < 4; ++i) v[i] = x * B[0][i] + y * B[1][i];
        return std::norm(x) + std::norm(y) > 0 ? v : B[j];
    };
    Field leaving = column(root), arriving = column(-root);
    R incident = 0, returned = 0;  // energy flows of `arriving` and `leaving`
    if (exact && !lossy) {
        // What leaves beside the given wave is orthogonal to it in the energy flow, an indefinite
        // form on this plane; its own flow is that of the given wave times the determinant.
        const C x = known->field[plane.pivot[0]] / (plane.pivot[0] < 2 ? R(1) : scale),
                y = known->field[plane.pivot[1]] / (plane.pivot[1] < 2 ? R(1) : scale);
        const C fx = p * x + o * y, fy = std::conj(o) * x + r * y;
        for (std::size_t i = 0; i < 4; ++i) {
            arriving[i] = x * B[0][i] + y * B[1][i];
            leaving[i] = -std::conj(fy) * B[0][i] + std::conj(fx) * B[1][i];
        }
        incident = std::abs((std::conj(x) * fx + std::conj(y) * fy).real());
        returned = std::abs(form) * incident;
    } else if (!exact) {
        // Decay and energy flow have the same sign; which of the two shows depends on the case.
        const auto outward = [&](const Field& v, const C& kn) {
            const R size = std::norm(v[0]) + std::norm(v[1]) + std::norm(v[2]) + std::norm(v[3]);
            return R(sign) * (kn.imag() + flow(v, v).real() / size);
        };
        // Behind an absorbing medium neither decides, but the factor the root was found in.
        const bool backwards =
            followed ? std::abs(out[1] - leaving_root) > std::abs(in[1] - leaving_root)
                     : outward(leaving, out[1]) < outward(arriving, in[1]);
        if (backwards) {
            std::swap(leaving, arriving);
            std::swap(out[1], in[1]);
        }
    }
    std::array<Field, 2> columns{alone(d, d2, in[0]), leaving};
    const auto z_component = [&](const Field& v) {
        C ez = 0;
        for (std::size_t i = 0; i < 4; ++i) ez += b.ez[i] * v[i];
        return ez;
    };
    const auto size2_of = [&](const Field& v) {
        return std::norm(v[0]) + std::norm(v[1]) + std::norm(z_component(v));
    };
    q = {scale * out[0], scale * out[1]};
    for (std::size_t i = 0; i < two; ++i) {
        const Field& v = columns[i];
        const R size = std::sqrt(size2_of(v));
        E[i] = {v[0] / size, v[1] / size, z_component(v) / size};
        psi[i] = {v[0] / size, v[1] / size, scale / size * v[2], scale / size * v[3]};
        propagating[i] =
            lossy || (i == 1 && !exact ? root.imag() == 0 : std::abs(out[i].imag()) < R(1e-13));
        flux[i] = propagating[i] ? std::max(R(sign) * normal_flux<R>(psi[i]), R(0)) : R(0);
    }
    if (exact && !lossy) {
        flux[1] = scale * returned / size2_of(leaving);
        incident_flux = scale * incident / size2_of(arriving);
    }
    if (exact && !lossy) {
        const R size = std::sqrt(size2_of(arriving));
        incident_field = Field{arriving[0] / size, arriving[1] / size, scale / size * arriving[2],
                               scale / size * arriving[3]};
    }
    for (Field& v : columns) {
        v[2] *= scale;
        v[3] *= scale;
    }
    set_basis(columns);
    return true;
}

template bool HalfSpace<double>::separate_grazing<double>(const Berreman<double>&,
                                                          const Matrix4<double>&,
                                                          const Quartic<double>&,
                                                          const Factors<double>&, double, int,
                                                          const Arriving<double>*, bool, bool);
template bool HalfSpace<double>::separate_grazing<Complex>(const Berreman<Complex>&,
                                                           const Matrix4<Complex>&,
                                                           const Quartic<Complex>&,
                                                           const Factors<Complex>&, double, int,
                                                           const Arriving<double>*, bool, bool);
template bool HalfSpace<long double>::separate_grazing<long double>(
    const Berreman<long double>&, const Matrix4<long double>&, const Quartic<long double>&,
    const Factors<long double>&, long double, int, const Arriving<long double>*, bool, bool);
template bool HalfSpace<long double>::separate_grazing<std::complex<long double>>(
    const Berreman<std::complex<long double>>&, const Matrix4<std::complex<long double>>&,
    const Quartic<std::complex<long double>>&, const Factors<std::complex<long double>>&,
    long double, int, const Arriving<long double>*, bool, bool);

}  // namespace icespar
