// The outgoing waves of one side of a face, for every medium.
//
// Of Berreman's matrix D only the two quadratic factors of its characteristic polynomial are
// needed, out(q) of the outgoing and in(q) of the incoming pair: the columns of in(D) span the
// outgoing fields, the rows of out(D) annihilate them. Both are smooth functions of symmetric
// functions of each pair, and so know nothing of optic axes and of exceptional points (waves that
// merge). The modes are found afterwards inside the subspace.
#include "interface/half_space.hpp"

#include <algorithm>
#include <utility>

#include "interface/local_wave.hpp"

namespace icespar {
namespace {

constexpr std::size_t two = 2;

template <class T>
double size2(const T& x) {
    if constexpr (std::is_same_v<T, double>) {
        return x * x;
    } else {
        return std::norm(x);
    }
}

template <class T>
T conjugate(const T& x) {
    if constexpr (std::is_same_v<T, double>) {
        return x;
    } else {
        return std::conj(x);
    }
}

template <class T>
double real_part(const T& x) {
    return std::real(x);
}

/// Two columns that span a space, made the identity on the two rows where they are most
/// independent.
template <class T>
struct Plane {
    std::array<Vector4<T>, 2> columns;
    std::array<std::size_t, 2> pivot{};

    Plane() = default;

    explicit Plane(const std::array<Vector4<T>, 2>& given) : columns(given) {
        double best = -1;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double s =
                    size2(columns[0][i] * columns[1][j] - columns[0][j] * columns[1][i]);
                if (s > best) {
                    best = s;
                    pivot = {j, i};
                }
            }
        }
        const auto [j, i] = pivot;
        const T a = columns[0][j], b = columns[1][j], c = columns[0][i], d = columns[1][i];
        const T det = a * d - b * c;
        const T ia = d / det, ib = -b / det, ic = -c / det, id = a / det;
        for (std::size_t r = 0; r < 4; ++r) {
            const T x = columns[0][r], y = columns[1][r];
            columns[0][r] = x * ia + y * ic;
            columns[1][r] = x * ib + y * id;
        }
        columns[0][j] = columns[1][i] = T(1);
        columns[0][i] = columns[1][j] = T(0);
    }
};

/// The two most independent columns of a matrix of rank 2.
template <class T>
std::array<Vector4<T>, 2> spanning_columns(const Matrix4<T>& m) {
    std::size_t row = 0, column = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            if (size2(m[i][j]) > size2(m[row][column])) row = i, column = j;
        }
    }
    double best = -1;
    std::size_t second = column;
    for (std::size_t j = 0; j < 4; ++j) {
        if (j == column) continue;
        const T factor = m[row][j] / m[row][column];
        double left = 0;
        for (std::size_t i = 0; i < 4; ++i) left += size2(T(m[i][j] - factor * m[i][column]));
        if (left > best) best = left, second = j;
    }
    std::array<Vector4<T>, 2> out;
    const T factor = m[row][second] / m[row][column];
    for (std::size_t i = 0; i < 4; ++i) {
        out[0][i] = m[i][column];
        out[1][i] = i == row ? T(0) : T(m[i][second] - factor * m[i][column]);
    }
    return out;
}

template <class T>
T dot4(const Vector4<T>& a, const Vector4<T>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

template <class T>
struct Eigen2 {
    std::array<T, 2> value;
    std::array<std::array<T, 2>, 2> vector;
};

/// Hermitian 2 x 2 matrix [a b; conj(b) d].
template <class T>
Eigen2<T> hermitian_eigen(double a, const T& b, double d) {
    const double half = 0.5 * (a - d), mean = 0.5 * (a + d), off = std::sqrt(size2(b));
    const double radius = std::sqrt(half * half + off * off);
    const T turn = off > 0 ? T(b / off) : T(1);
    // (cos, sin) of half the angle whose tangent is off / half, without cancellation.
    double c = 1, s = 0;
    if (radius > 0) {
        const double large = std::sqrt(0.5 * (1 + std::abs(half) / radius));
        const double small = 0.5 * off / (radius * large);
        c = half >= 0 ? large : small;
        s = half >= 0 ? small : large;
    }
    Eigen2<T> out;
    out.value = {T(mean + radius), T(mean - radius)};
    out.vector = {{{turn * c, T(s)}, {T(-s) * turn, T(c)}}};
    return out;
}

/// Any 2 x 2 matrix [a b; c d].
Eigen2<Complex> general_eigen(const Complex& a, const Complex& b, const Complex& c,
                              const Complex& d) {
    const Complex half = 0.5 * (a - d), mean = 0.5 * (a + d);
    const Complex root = std::sqrt(half * half + b * c);
    Eigen2<Complex> out;
    for (std::size_t i = 0; i < 2; ++i) {
        const Complex r = i == 0 ? root : -root;
        // Columns of the adjoint: (b, r - half) and (r + half, c).
        const Complex up = r + half, down = r - half;
        out.value[i] = mean + r;
        out.vector[i] = std::norm(up) >= std::norm(down) ? std::array{up, c} : std::array{b, down};
        if (std::norm(out.vector[i][0]) + std::norm(out.vector[i][1]) == 0) {
            out.vector[i] = {Complex(i == 0 ? 1 : 0), Complex(i == 0 ? 0 : 1)};
        }
    }
    return out;
}

/// The outgoing plane of a crystal that is almost isotropic, eps = mean I + deviation, as a
/// perturbation of the isotropic one, so that its two waves keep their own precision: H = X E and
/// D = q + M on the plane, M of the size of the deviation. X solves a Riccati equation whose linear
/// part is -2 q; false where the deviation is not small beside q.
bool nearly_isotropic(double mean, const RealTensor& dev, double K, int sign, Plane<double>& plane,
                      double (&M)[2][2], double& q) {
    const double q2 = mean - K * K;
    const double size = std::max({std::abs(dev.xx), std::abs(dev.yy), std::abs(dev.zz),
                                  std::abs(dev.yz), std::abs(dev.xz), std::abs(dev.xy)});
    if (!(q2 > 0.04) || !(size < 1e-3 * q2)) return false;
    q = sign * std::sqrt(q2);
    const double zz = mean + dev.zz;
    const double ez[4] = {-dev.xz / zz, -dev.yz / zz, 0, -K / zz};
    // Berreman's matrix less the isotropic one, in 2 x 2 blocks of E (p) and H (r).
    const double pp[2][2] = {{K * ez[0], K * ez[1]}, {0, 0}};
    const double pr[2][2] = {{0, K * K * dev.zz / (mean * zz)}, {0, 0}};
    const double rp[2][2] = {{-dev.yz * ez[0] - dev.xy, -dev.yz * ez[1] - dev.yy},
                             {dev.xz * ez[0] + dev.xx, dev.xz * ez[1] + dev.xy}};
    const double rr[2][2] = {{0, -dev.yz * ez[3]}, {0, dev.xz * ez[3]}};
    const double pr0[2][2] = {{0, 1 - K * K / mean}, {-1, 0}};
    const double X0[2][2] = {{0, -q}, {mean / q, 0}};
    using Block = std::array<std::array<double, 2>, 2>;
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
        double change = 0;
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
        if (change <= 1e-16 * size) break;
    }
    const Block prX = times(pr, X), pr0dX = times(pr0, step);
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) M[i][j] = pp[i][j] + prX[i][j] + pr0dX[i][j];
    }
    plane.columns = {{{1, 0, X[0][0], X[1][0]}, {0, 1, X[0][1], X[1][1]}}};
    plane.pivot = {0, 1};
    return true;
}

template <class T>
SymmetricTensor<T> cast(const ComplexTensor& t) {
    if constexpr (std::is_same_v<T, double>) {
        return real(t);
    } else {
        return t;
    }
}

template <class T>
T cast(const Complex& z) {
    if constexpr (std::is_same_v<T, double>) {
        return z.real();
    } else {
        return z;
    }
}

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

Field4 dual(const Field4& f) { return {f[3], -f[2], -f[1], f[0]}; }

Field4 as_field(const LocalWave<Complex>& w) { return {w.E.x, w.E.y, w.hx, w.hy}; }

}  // namespace

HalfSpace::HalfSpace(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                     const Arriving* known) {
    if (medium.plain() && K.imag() == 0) {
        plain(medium, face, sign, known);
    } else if (medium.symmetry == Symmetry::isotropic && !medium.active()) {
        isotropic(medium.eps_o(), K, sign, known);
    } else if (medium.symmetry == Symmetry::uniaxial && !medium.active()) {
        uniaxial(medium, face, K, sign, known);
    } else if (medium.absorbing || medium.active() || K.imag() != 0 ||
               !tensor<double>(medium, face, K, sign, known)) {
        tensor<Complex>(medium, face, K, sign, known);
    }
}

void HalfSpace::set_mode(std::size_t i, const Complex& K, const Complex& normal_component,
                         const CVec3& field, double sign) {
    q[i] = normal_component;
    E[i] = field / length(field);
    psi[i] = {E[i].x, E[i].y, -q[i] * E[i].y, q[i] * E[i].x - K * E[i].z};
    flux[i] = propagating[i] ? std::max(sign * normal_flux(psi[i]), 0.0) : 0;
}

void HalfSpace::set_basis(std::array<Field4, 2> columns) {
    const Plane<Complex> plane(columns);
    basis = plane.columns;
    pivot = plane.pivot;
    std::size_t row = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == pivot[0] || i == pivot[1]) continue;
        rows[row] = {};
        rows[row][i] = 1;
        rows[row][pivot[0]] = -basis[0][i];
        rows[row][pivot[1]] = -basis[1][i];
        ++row;
    }
}

void HalfSpace::plain(const Medium& medium, const FaceFrame& face, int sign,
                      const Arriving* known) {
    FaceMedium m(medium, face);
    if (known) m.adopt(known->q.real(), medium.birefringent && known->mode == 1);
    auto out = waves_towards<Complex>(m, sign), in = waves_towards<Complex>(m, -sign);
    for (std::size_t i = 0; i < 2; ++i) {
        q[i] = out[i].q;
        E[i] = out[i].E;
        psi[i] = as_field(out[i]);
        flux[i] = sign * out[i].flux;
        propagating[i] = out[i].propagating;
    }
    incident_flux = known ? std::abs(in[known->mode].flux) : 0;
    if (merging(m, sign)) {
        const MergedPair away(m, sign), towards(m, -sign);
        out = {away.ordinary, away.partner};
        in = {towards.ordinary, towards.partner};
    }
    set_basis({as_field(out[0]), as_field(out[1])});
    rows = {dual(as_field(in[0])), dual(as_field(in[1]))};
}

void HalfSpace::isotropic(const Complex& eps, const Complex& K, int sign, const Arriving* known) {
    const double s = sign;
    Complex qs;
    if (known) {
        qs = -known->q;
    } else {
        const Complex n = std::sqrt(eps);
        qs = std::sqrt(n - K) * std::sqrt(n + K);
        // Decay decides; where K is complex, the branch that a real K of the same size would take.
        const Complex at_real = std::sqrt(n - K.real()) * std::sqrt(n + K.real());
        if (std::norm(qs - at_real) > std::norm(qs + at_real)) qs = -qs;
        if (at_real.imag() < 0 || (at_real.imag() == 0 && at_real.real() < 0)) qs = -qs;
        qs = s * qs;
    }
    propagating = {true, true};
    set_mode(0, K, qs, {Complex(0), Complex(1), Complex(0)}, s);
    set_mode(1, K, qs, {-qs, Complex(0), K}, s);
    set_basis(psi);
    rows = {dual({Complex(0), Complex(1), qs, Complex(0)}),
            dual({qs, Complex(0), Complex(0), -eps})};
}

void HalfSpace::uniaxial(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                         const Arriving* known) {
    const Vec3 c = face.to_face(medium.axis);
    const CrystalFrame crystal(c);
    const Complex eo = medium.eps_o(), ee = medium.eps_e();
    const Complex delta = Complex(medium.n_e - medium.n_o, medium.kappa_e - medium.kappa_o) *
                          Complex(medium.n_e + medium.n_o, medium.kappa_e + medium.kappa_o);
    const double s = sign;
    // Ordinary: q = +-root(eo - K^2). Extraordinary: eg q^2 + 2 X q + C = 0.
    const Complex n_o(medium.n_o, medium.kappa_o);
    const auto decaying = [&](const Complex& root, const Complex& centre, const Complex& scale) {
        // Of (centre +- root) / scale the one that decays along sign; for tiny loss the real part
        // of the root, which has the sign of the energy flow, breaks the tie.
        const auto score = [&](const Complex& r) {
            return s * (((centre + r) / scale).imag() + 1e-3 * r.real());
        };
        return score(root) >= score(-root) ? root : -root;
    };
    const Complex qo_root = decaying(std::sqrt(n_o - K) * std::sqrt(n_o + K), 0.0, 1.0);
    const Complex eg = eo + delta * (c.z * c.z);
    const Complex X = delta * (c.z * c.x) * K;
    const Complex w2 = eo * (eg * (ee - K * K) - delta * (c.x * c.x) * K * K);
    const Complex w = decaying(std::sqrt(w2), -X, eg);
    Complex o_out = qo_root, o_in = -qo_root, e_out = (w - X) / eg, e_in = (-w - X) / eg;
    if (known && known->mode == 0) o_in = known->q, o_out = -known->q;
    if (known && known->mode == 1) e_in = known->q, e_out = -2.0 * X / eg - known->q;

    propagating = {true, true};
    const auto across = [&](const Complex& kn, const Vec3& a) { return K * a.x + kn * a.z; };
    set_mode(0, K, o_out, crystal.ordinary(across(o_out, crystal.a), across(o_out, crystal.b)), s);
    const Complex ka = across(e_out, crystal.a), kb = across(e_out, crystal.b),
                  kc = across(e_out, crystal.c);
    const double m = norm2(ka, kb);
    const CVec3 e_field = m == 0 ? complexified(crystal.a)
                                 : (-kc / eo * (ka / m)) * crystal.a +
                                       (-kc / eo * (kb / m)) * crystal.b +
                                       ((ka * ka + kb * kb) / (m * ee)) * crystal.c;
    set_mode(1, K, e_out, e_field, s);

    const LocalMedium<Complex> local{
        medium.permittivity().in_frame(face.x, face.y, face.z), {}, false};
    const Berreman<Complex> b(local, K);
    const auto square = product(b.d, b.d);
    const auto in = Quadratic<Complex>::from_roots(o_in, e_in);
    set_basis(spanning_columns(evaluate(in, b.d, square)));
}

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

template <class T>
bool HalfSpace::separate_grazing(const Berreman<T>& b, const Matrix4<T>& square,
                                 const Quartic<T>& f, const Factors<T>& factors, double scale,
                                 int sign, const Arriving* known, bool absorbing) {
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
    const double gap = std::abs(out[1] - in[1]);
    const double others = std::min({std::abs(out[0] - out[1]), std::abs(out[0] - in[1]),
                                    std::abs(in[0] - out[1]), std::abs(in[0] - in[1])});
    if (gap > 0.2 * others) return false;

    const auto nearest = [](std::array<Complex, 2> found, Complex& x, Complex& y) {
        if (std::abs(found[0] - x) + std::abs(found[1] - y) >
            std::abs(found[1] - x) + std::abs(found[0] - y)) {
            std::swap(found[0], found[1]);
        }
        x = found[0];
        y = found[1];
    };
    const auto refine = [&](auto type) {
        using S = decltype(type);
        const Quartic<S> g{cast<S>(Complex(f.c3)), cast<S>(Complex(f.c2)), cast<S>(Complex(f.c1)),
                           cast<S>(Complex(f.c0))};
        Factors<S> pairs{{cast<S>(-(out[0] + in[0])), cast<S>(out[0] * in[0])},
                         {cast<S>(-(out[1] + in[1])), cast<S>(out[1] * in[1])}};
        if (!polish(g, pairs)) return;
        nearest(roots(pairs.first), out[0], in[0]);
        nearest(roots(pairs.second), out[1], in[1]);
    };
    if (known) {
        const Complex exact = known->q / scale;
        if (std::abs(in[0] - exact) < std::abs(in[1] - exact)) {
            in[0] = exact;
        } else {
            in[1] = exact;
        }
    } else if (absorbing) {
        refine(Complex{});
    } else {
        refine(double{});
    }

    using Matrix = Matrix4<Complex>;
    Matrix d, d2;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            d[i][j] = b.d[i][j];
            d2[i][j] = square[i][j];
        }
    }
    const auto outer = Quadratic<Complex>::from_roots(out[0], in[0]),
               inner = Quadratic<Complex>::from_roots(out[1], in[1]);
    // The eigenvector of `root`, alone; `rest` is the root beside it in the outer pair.
    const auto alone = [&](const Matrix& m, const Matrix& m2, const Complex& rest) {
        Matrix shifted = m;
        for (std::size_t i = 0; i < 4; ++i) shifted[i][i] -= rest;
        const Matrix w = product(shifted, evaluate(inner, m, m2));
        Field4 best{};
        double most = -1;
        for (std::size_t j = 0; j < 4; ++j) {
            double size = 0;
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
    const Plane<Complex> plane(spanning_columns(evaluate(outer, d, d2)));
    const auto& B = plane.columns;
    Complex M[2][2];
    for (std::size_t i = 0; i < two; ++i) {
        for (std::size_t j = 0; j < two; ++j) M[i][j] = dot4(d[plane.pivot[i]], B[j]);
    }
    const auto flow = [&](const Field4& x, const Field4& y) {
        return 0.5 * (std::conj(x[0]) * y[3] + std::conj(x[3]) * y[0] - std::conj(x[1]) * y[2] -
                      std::conj(x[2]) * y[1]);
    };
    // M = middle + N; without loss the flow's form times N is Hermitian, which rounding must not
    // spoil where N itself is but rounding.
    Complex middle = 0.5 * (M[0][0] + M[1][1]);
    if (!absorbing) middle = middle.real();
    Complex N[2][2] = {{M[0][0] - middle, M[0][1]}, {M[1][0], M[1][1] - middle}};
    const double p = flow(B[0], B[0]).real(), r = flow(B[1], B[1]).real();
    const Complex o = flow(B[0], B[1]);
    const double form = p * r - std::norm(o);
    if (!absorbing) {
        const double w0 = (p * N[0][0] + o * N[1][0]).real(),
                     w1 = (std::conj(o) * N[0][1] + r * N[1][1]).real();
        const Complex w =
            0.5 * (p * N[0][1] + o * N[1][1] + std::conj(std::conj(o) * N[0][0] + r * N[1][0]));
        N[0][0] = (r * w0 - o * std::conj(w)) / form;
        N[0][1] = (r * w - o * w1) / form;
        N[1][0] = (p * std::conj(w) - std::conj(o) * w0) / form;
        N[1][1] = (p * w1 - std::conj(o) * w) / form;
        const Complex rest = 0.5 * (N[0][0] + N[1][1]);
        N[0][0] -= rest;
        N[1][1] -= rest;
    }
    const bool exact = known && in[1] == known->q / scale;
    Complex root;  // q_out - middle
    if (exact) {
        root = middle - in[1];
        if (!absorbing) root = root.real();
    } else {
        const Complex half = 0.5 * (N[0][0] - N[1][1]),
                      square_root = half * half + N[0][1] * N[1][0];
        root = std::sqrt(absorbing ? square_root : Complex(square_root.real()));
        in[1] = middle - root;
    }
    out[1] = middle + root;
    const std::size_t j = std::norm(N[0][0] + root) + std::norm(N[1][0]) >=
                                  std::norm(N[0][1]) + std::norm(N[1][1] + root)
                              ? 0
                              : 1;
    const auto column = [&](const Complex& shift) {
        const Complex x = N[0][j] + (j == 0 ? shift : 0.0), y = N[1][j] + (j == 1 ? shift : 0.0);
        Field4 v;
        for (std::size_t i = 0; i < 4; ++i) v[i] = x * B[0][i] + y * B[1][i];
        return std::norm(x) + std::norm(y) > 0 ? v : B[j];
    };
    Field4 leaving = column(root), arriving = column(-root);
    double incident = 0, returned = 0;  // energy flows of `arriving` and `leaving`
    if (exact && !absorbing) {
        // What leaves beside the given wave is orthogonal to it in the energy flow, an indefinite
        // form on this plane; its own flow is that of the given wave times the determinant.
        const Complex x = known->field[plane.pivot[0]] / (plane.pivot[0] < 2 ? 1 : scale),
                      y = known->field[plane.pivot[1]] / (plane.pivot[1] < 2 ? 1 : scale);
        const Complex fx = p * x + o * y, fy = std::conj(o) * x + r * y;
        for (std::size_t i = 0; i < 4; ++i) {
            arriving[i] = x * B[0][i] + y * B[1][i];
            leaving[i] = -std::conj(fy) * B[0][i] + std::conj(fx) * B[1][i];
        }
        incident = std::abs((std::conj(x) * fx + std::conj(y) * fy).real());
        returned = std::abs(form) * incident;
    } else if (!exact) {
        // Decay and energy flow have the same sign; which of the two shows depends on the case.
        const auto outward = [&](const Field4& v, const Complex& kn) {
            const double size =
                std::norm(v[0]) + std::norm(v[1]) + std::norm(v[2]) + std::norm(v[3]);
            return sign * (kn.imag() + flow(v, v).real() / size);
        };
        if (outward(leaving, out[1]) < outward(arriving, in[1])) {
            std::swap(leaving, arriving);
            std::swap(out[1], in[1]);
        }
    }
    std::array<Field4, 2> columns{alone(d, d2, in[0]), leaving};
    const auto z_component = [&](const Field4& v) {
        Complex ez = 0;
        for (std::size_t i = 0; i < 4; ++i) ez += b.ez[i] * v[i];
        return ez;
    };
    const auto size2_of = [&](const Field4& v) {
        return std::norm(v[0]) + std::norm(v[1]) + std::norm(z_component(v));
    };
    q = {scale * out[0], scale * out[1]};
    for (std::size_t i = 0; i < two; ++i) {
        const Field4& v = columns[i];
        const double size = std::sqrt(size2_of(v));
        E[i] = {v[0] / size, v[1] / size, z_component(v) / size};
        psi[i] = {v[0] / size, v[1] / size, scale / size * v[2], scale / size * v[3]};
        propagating[i] =
            absorbing || (i == 1 && !exact ? root.imag() == 0 : std::abs(out[i].imag()) < 1e-13);
        flux[i] = propagating[i] ? std::max(sign * normal_flux(psi[i]), 0.0) : 0;
    }
    if (exact && !absorbing) {
        flux[1] = scale * returned / size2_of(leaving);
        incident_flux = scale * incident / size2_of(arriving);
    }
    if (exact && !absorbing) {
        const double size = std::sqrt(size2_of(arriving));
        incident_field = {arriving[0] / size, arriving[1] / size, scale / size * arriving[2],
                          scale / size * arriving[3]};
    }
    for (Field4& v : columns) {
        v[2] *= scale;
        v[3] *= scale;
    }
    set_basis(columns);
    return true;
}

std::array<Complex, 2> HalfSpace::amplitudes(const std::array<Complex, 2>& coefficients) const {
    const Complex a = psi[0][pivot[0]], b = psi[1][pivot[0]], c = psi[0][pivot[1]],
                  d = psi[1][pivot[1]];
    const Complex det = a * d - b * c;
    return {(coefficients[0] * d - b * coefficients[1]) / det,
            (a * coefficients[1] - coefficients[0] * c) / det};
}

Field4 HalfSpace::field(const std::array<Complex, 2>& c) const {
    Field4 out;
    for (std::size_t i = 0; i < 4; ++i) out[i] = c[0] * basis[0][i] + c[1] * basis[1][i];
    return out;
}

}  // namespace icespar
