// The outgoing waves of one side of a face: isotropic and uniaxial media, absorbing or not.
#include "interface/half_space.hpp"

#include <algorithm>

#include "interface/plane.hpp"

namespace icespar {
namespace {

/// The root of square(K) that belongs to a complex K, by continuity from that of its real part:
/// behind an absorbing medium neither decay nor energy flow alone tells which wave leaves.
template <class C, class F>
C followed(const F& square, C root, const C& K) {
    constexpr int steps = 32;
    for (int i = 1; i <= steps; ++i) {
        const Real<C> t = Real<C>(i * i) / (steps * steps);
        const C next = std::sqrt(square(C(K.real(), t * K.imag())));
        root = std::norm(next - root) > std::norm(next + root) ? -next : next;
    }
    return root;
}

}  // namespace

template <class R>
HalfSpace<R>::HalfSpace(const Medium& medium, const FaceAxes<R>& face, const C& K, int sign,
                        const Arriving<R>* known) {
    if (medium.symmetry == Symmetry::isotropic && !medium.active()) {
        isotropic(index_o<R>(medium), K, sign, known, medium.absorbing);
    } else if (medium.symmetry == Symmetry::uniaxial && !medium.active()) {
        uniaxial(medium, face, K, sign, known);
    } else if (medium.absorbing || medium.active() || K.imag() != 0 ||
               !tensor<R>(medium, face, K, sign, known)) {
        tensor<C>(medium, face, K, sign, known);
    }
}

template <class R>
void HalfSpace<R>::set_mode(std::size_t i, const C& K, const C& normal_component,
                            const Vector3<C>& field, R sign) {
    q[i] = normal_component;
    E[i] = field / length(field);
    psi[i] = {E[i].x, E[i].y, -q[i] * E[i].y, q[i] * E[i].x - K * E[i].z};
    flux[i] = propagating[i] ? std::max(sign * normal_flux<R>(psi[i]), R(0)) : R(0);
}

template <class R>
void HalfSpace<R>::set_basis(std::array<Field, 2> columns) {
    const Plane<C> plane(columns);
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

template <class R>
void HalfSpace<R>::isotropic(const C& n, const C& K, int sign, const Arriving<R>* known,
                             bool absorbing) {
    const R s = R(sign);
    C qs;
    if (known) {
        qs = -known->q;
    } else {
        const C real_K = K.real();
        qs = std::sqrt(n - real_K) * std::sqrt(n + real_K);
        if (qs.imag() < 0 || (qs.imag() == 0 && qs.real() < 0)) qs = -qs;
        if (K.imag() != 0) {
            qs = followed([&](const C& k) { return (n - k) * (n + k); }, qs, K);
        }
        qs = s * qs;
    }
    propagating[0] = propagating[1] = absorbing || K.imag() != 0 || qs.imag() == 0;
    separation = 2 * std::abs(qs / n);
    set_mode(0, K, qs, {C(0), C(1), C(0)}, s);
    set_mode(1, K, qs, {-qs, C(0), K}, s);
    set_basis(psi);
    // <incoming, f> of the reciprocity pairing: s (0, 1, qs, 0), p (qs, 0, 0, -eps).
    rows = {Field{C(0), -qs, C(-1), C(0)}, Field{-n * n, C(0), C(0), qs}};
}

template <class R>
void HalfSpace<R>::uniaxial(const Medium& medium, const FaceAxes<R>& face, const C& K, int sign,
                            const Arriving<R>* known) {
    const Vector3<R> c = face.to_face(normalised(converted<R>(medium.axis)));
    const Vector3<R> a = any_perpendicular(c), b = cross(c, a);
    const C n_o = index_o<R>(medium), n_e = index_e<R>(medium), eo = n_o * n_o, ee = n_e * n_e;
    const C delta = (n_e - n_o) * (n_e + n_o);
    const R s = R(sign);
    const bool lossless = !medium.absorbing && K.imag() == 0;
    // Ordinary: q = +-root(eo - K^2). Extraordinary: eg q^2 + 2 X q + C = 0.
    const auto decaying = [&](const C& root, const C& centre, const C& scale) {
        // Of (centre +- root) / scale the one that decays along sign; for tiny loss the real part
        // of the root, which has the sign of the energy flow, breaks the tie.
        const auto score = [&](const C& r) {
            return s * (((centre + r) / scale).imag() + R(1e-3) * r.real());
        };
        return score(root) >= score(-root) ? root : -root;
    };
    const C real_K = K.real();
    C qo_root = decaying(std::sqrt(n_o - real_K) * std::sqrt(n_o + real_K), C(0), C(1));
    const C eg = eo + delta * (c.z * c.z), ex = delta * (c.z * c.x), X = ex * K;
    const auto flow_squared = [&](const C& k) {
        const C w2 = eo * (eg * (ee - k * k) - delta * (c.x * c.x) * k * k);
        return lossless ? C(w2.real()) : w2;
    };
    C w = decaying(std::sqrt(flow_squared(real_K)), -ex * real_K, eg);
    if (K.imag() != 0) {
        qo_root = followed([&](const C& k) { return (n_o - k) * (n_o + k); }, qo_root, K);
        w = followed(flow_squared, w, K);
    }
    C o_out = qo_root, o_in = -qo_root, e_out = (w - X) / eg, e_in = (-w - X) / eg;
    if (known && known->mode == 0) o_in = known->q, o_out = -known->q;
    if (known && known->mode == 1) {
        e_in = known->q, e_out = R(-2) * X / eg - known->q;
        if (lossless) w = -(eg * known->q + X);
    }
    separation = std::min(std::abs(o_out - o_in), std::abs(e_out - e_in)) / std::abs(n_o);

    propagating = {!lossless || qo_root.imag() == 0, !lossless || w.imag() == 0};
    const auto across = [&](const C& kn, const Vector3<R>& v) { return K * v.x + kn * v.z; };
    const auto size = [](const C& x, const C& y) { return std::sqrt(std::norm(x) + std::norm(y)); };
    C ka = across(o_out, a), kb = across(o_out, b);
    R m = size(ka, kb);
    set_mode(0, K, o_out, m == 0 ? complexified(-b) : (kb / m) * a - (ka / m) * b, s);
    ka = across(e_out, a), kb = across(e_out, b);
    const C kc = across(e_out, c);
    m = size(ka, kb);
    // ka^2 + kb^2 as a product, which stays precise where it vanishes.
    const C i(0, 1);
    const Vector3<C> e_field = m == 0 ? complexified(a)
                                      : (-kc / eo * (ka / m)) * a + (-kc / eo * (kb / m)) * b +
                                            ((ka + i * kb) / m * (ka - i * kb) / ee) * c;
    set_mode(1, K, e_out, e_field, s);
    if (lossless) {
        // The energy of o flows along k. Of e, with a field as above, it is eps k / (eo ee).
        const R amplitude = length(e_field);
        if (propagating[0]) flux[0] = s * o_out.real();
        if (propagating[1]) flux[1] = s * w.real() / (amplitude * amplitude * (eo * ee).real());
        if (known && known->mode == 0) incident_flux = -s * known->q.real();
    }

    C overlap = 0;
    std::array<R, 2> norm{};
    for (std::size_t j = 0; j < 4; ++j) {
        overlap += std::conj(psi[0][j]) * psi[1][j];
        for (std::size_t k = 0; k < 2; ++k) norm[k] += std::norm(psi[k][j]);
    }
    if (std::norm(overlap) < R(0.9) * norm[0] * norm[1]) {
        set_basis(psi);
        return;
    }
    // Two evanescent waves that merge: their plane from what both are not.
    const Berreman<C> berreman({face.permittivity(medium), {}, false}, K);
    const auto square = product(berreman.d, berreman.d);
    const auto in = Quadratic<C>::from_roots(o_in, e_in);
    set_basis(spanning_columns(evaluate(in, berreman.d, square)));
}

template <class R>
std::array<std::complex<R>, 2> HalfSpace<R>::amplitudes(
    const std::array<C, 2>& coefficients) const {
    const C a = psi[0][pivot[0]], b = psi[1][pivot[0]], c = psi[0][pivot[1]], d = psi[1][pivot[1]];
    C det = a * d - b * c;
    // Exactly merged: amplitudes as large as rounding lets the two be told apart.
    const R least = rounding<R> * (std::abs(a * d) + std::abs(b * c));
    if (std::abs(det) < least) det = least;
    return {(coefficients[0] * d - b * coefficients[1]) / det,
            (a * coefficients[1] - coefficients[0] * c) / det};
}

template <class R>
Field4<R> HalfSpace<R>::field(const std::array<C, 2>& c) const {
    Field out;
    for (std::size_t i = 0; i < 4; ++i) out[i] = c[0] * basis[0][i] + c[1] * basis[1][i];
    return out;
}

template struct HalfSpace<double>;
template struct HalfSpace<long double>;

}  // namespace icespar
