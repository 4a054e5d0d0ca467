// Factors of a quartic into two quadratics: the starting point in closed form, then Newton's method
// on the factors. A pair of roots that nearly coincides inside one factor does no harm, for only
// symmetric functions of the pair are worked with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "interface/number.hpp"

namespace icespar {

/// q^4 + c3 q^3 + c2 q^2 + c1 q + c0.
template <class T>
struct Quartic {
    T c3, c2, c1, c0;
};

/// q^2 + b q + c.
template <class T>
struct Quadratic {
    T b, c;

    static Quadratic from_roots(const T& x, const T& y) { return {-(x + y), x * y}; }
};

template <class T>
struct Factors {
    Quadratic<T> first, second;
};

/// q = y - h makes y^4 + p y^2 + r y + s of the quartic.
template <class T>
struct Depressed {
    using R = Real<T>;
    T h, p, r, s;

    explicit Depressed(const Quartic<T>& f)
        : h(f.c3 / R(4)),
          p(f.c2 - R(6) * h * h),
          r(f.c1 - R(2) * f.c2 * h + R(8) * h * h * h),
          s(f.c0 - f.c1 * h + f.c2 * h * h - R(3) * h * h * h * h) {}

    /// (y^2 + a y + b)(y^2 - a y + c), a^2 = u a root of u^3 + 2 p u^2 + (p^2 - 4 s) u - r^2.
    [[nodiscard]] Factors<T> factors(const T& u, const T& a) const {
        const T sum = p + u, difference = r / a;
        const T b = R(0.5) * (sum - difference), c = R(0.5) * (sum + difference);
        return {{a + R(2) * h, h * h + a * h + b}, {-a + R(2) * h, h * h - a * h + c}};
    }
};

/// Factors of a quartic with four real roots, the two largest in `second`; false when some root is
/// complex or the middle two are closer than `gap`.
template <class R>
bool real_factors(const Quartic<R>& quartic, R gap, Factors<R>& out) {
    const Depressed<R> f(quartic);
    // The largest root of the resolvent cubic is the square of the sum of the two largest roots.
    const R A = 2 * f.p, B = f.p * f.p - 4 * f.s, C = -f.r * f.r;
    const R P = B - A * A / 3, Q = 2 * A * A * A / 27 - A * B / 3 + C;
    if (!(P < 0)) return false;
    const R root = std::sqrt(-P / 3);
    const R cosine = -Q / (2 * root * root * root);
    if (!(std::abs(cosine) <= 1 + R(1e-10))) return false;
    const R u = 2 * root * std::cos(std::acos(std::clamp(cosine, R(-1), R(1))) / 3) - A / 3;
    if (!(u > R(1e-6))) return false;
    out = f.factors(u, std::sqrt(u));
    const auto half_width = [](const Quadratic<R>& g) { return g.b * g.b / 4 - g.c; };
    const R low = half_width(out.first), high = half_width(out.second);
    if (!(low > R(-1e-9) && high > R(-1e-9))) return false;
    const R lower_top = -out.first.b / 2 + std::sqrt(std::max(low, R(0)));
    const R upper_bottom = -out.second.b / 2 - std::sqrt(std::max(high, R(0)));
    return upper_bottom - lower_top > gap;
}

/// Roots of a quadratic without cancellation.
template <class T>
std::array<std::complex<Real<T>>, 2> roots(const Quadratic<T>& f) {
    using C = std::complex<Real<T>>;
    const C half = -C(f.b) / Real<T>(2);
    const C root = std::sqrt(half * half - C(f.c));
    const C large = std::norm(half + root) > std::norm(half - root) ? half + root : half - root;
    if (large == C(0)) return {C(0), C(0)};
    return {large, C(f.c) / large};
}

/// Roots of a quartic, about half the digits where they coincide.
template <class R>
std::array<std::complex<R>, 4> roots(const Quartic<std::complex<R>>& quartic) {
    using C = std::complex<R>;
    const Depressed<C> f(quartic);
    const C A = R(2) * f.p, B = f.p * f.p - R(4) * f.s, D = -f.r * f.r;
    const C P = B - A * A / R(3), Q = R(2) * A * A * A / R(27) - A * B / R(3) + D;
    const C root = std::sqrt(Q * Q / R(4) + P * P * P / R(27));
    const C plus = -Q / R(2) + root, minus = -Q / R(2) - root;
    const C cube = std::norm(plus) > std::norm(minus) ? plus : minus;
    C u = -A / R(3);
    if (cube != C(0)) {
        const C turn(R(-0.5), R(0.8660254037844386));
        C candidate = std::pow(cube, R(1) / 3);
        C best = u;
        for (int i = 0; i < 3; ++i, candidate *= turn) {
            const C v = candidate - P / (R(3) * candidate) - A / R(3);
            if (i == 0 || std::norm(v) > std::norm(best)) best = v;
        }
        u = best;
    }
    Factors<C> g;
    if (std::abs(u) > R(1e-14)) {
        g = f.factors(u, std::sqrt(u));
    } else {
        const auto squares = roots(Quadratic<C>{f.p, f.s});
        const C x = std::sqrt(squares[0]), y = std::sqrt(squares[1]);
        return {x - f.h, y - f.h, -x - f.h, -y - f.h};
    }
    const auto x = roots(g.first), y = roots(g.second);
    return {x[0], x[1], y[0], y[1]};
}

/// Newton's method on the coefficients of both factors; false when it does not settle.
template <class T>
bool polish(const Quartic<T>& f, Factors<T>& g) {
    using R = Real<T>;
    constexpr R settled = 4 * rounding<R>, close = R(1e-6);
    auto& [b, c] = g.first;
    auto& [d, e] = g.second;
    R previous = std::numeric_limits<R>::infinity();
    for (int i = 0; i < 60; ++i) {
        const T r3 = f.c3 - (b + d), r2 = f.c2 - (c + e + b * d), r1 = f.c1 - (b * e + c * d),
                r0 = f.c0 - c * e;
        // db + dd = r3; dc + de + d db + b dd = r2; e db + d dc + c dd + b de = r1; e dc + c de =
        // r0.
        const T m = r2 - b * r3, k = b - d, w = e - c;
        const T right1 = r1 - c * r3 - b * m, right0 = r0 - c * m;
        const T det = (w + b * k) * w + k * k * c;
        const T db = (right1 * w + k * right0) / det,
                dc = ((w + b * k) * right0 - c * k * right1) / det;
        const R step = size1(db) + size1(dc);
        if (!std::isfinite(step)) return previous < close;
        const T dd = r3 - db, de = m - dc + k * db;
        b += db;
        c += dc;
        d += dd;
        e += de;
        if (step < settled || (step >= previous && step < close)) return true;
        previous = step;
    }
    return previous < close;
}

/// The factors (q - known)(q - other) = second and first, when one root of `second` is known better
/// than the coefficients tell: the quartic is divided by it.
template <class T>
void adopt(const Quartic<T>& f, const T& known, Factors<T>& g) {
    using R = Real<T>;
    const T h2 = R(4) * known + f.c3, h1 = (R(6) * known + R(3) * f.c3) * known + f.c2,
            h0 = ((R(4) * known + R(3) * f.c3) * known + R(2) * f.c2) * known + f.c1;
    // (t^2 + b t + c)(t + e) = t^3 + h2 t^2 + h1 t + h0 with t = q - known.
    T b = g.first.b + R(2) * known, c = (known + g.first.b) * known + g.first.c;
    T e = g.second.b + R(2) * known;
    for (int i = 0; i < 20; ++i) {
        const T r2 = h2 - (b + e), r1 = h1 - (c + b * e), r0 = h0 - c * e;
        const T det = e * (b - e) - c;
        const T db = (r0 - c * r2 - e * (r1 - b * r2)) / det;
        if (!std::isfinite(size1(db))) break;
        c += r1 - b * r2 + (b - e) * db;
        e += r2 - db;
        b += db;
        if (size1(db) < 4 * rounding<R>) break;
    }
    g.first = {b - R(2) * known, (known - b) * known + c};
    g.second = Quadratic<T>::from_roots(known, known - e);
}

}  // namespace icespar
