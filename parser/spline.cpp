// Splines as POV-Ray computes them, read and asked.
#include "parser/spline.hpp"

#include <algorithm>

#include "parser/limits.hpp"
#include "parser/parser.hpp"

namespace icespar {
namespace {

template <class F>
Numbers componentwise(const Numbers& like, F&& f) {
    Numbers out = like;
    for (std::size_t k = 0; k < static_cast<std::size_t>(like.size); ++k) out.c[k] = f(k);
    return out;
}

}  // namespace

/// The tridiagonal equations of a natural cubic spline, by elimination.
void Spline::prepare() {
    if (kind != Kind::natural) return;
    const std::size_t n = points.size();
    bends.assign(n, componentwise(points[0].second, [](std::size_t) { return 0.0; }));
    if (n < 3) return;
    std::vector<double> above(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double left = points[i].first - points[i - 1].first;
        const double right = points[i + 1].first - points[i].first;
        const double pivot = 2 * (left + right) - left * above[i - 1];
        above[i] = right / pivot;
        bends[i] = componentwise(bends[i], [&](std::size_t k) {
            const double p = points[i - 1].second.c[k], q = points[i].second.c[k],
                         r = points[i + 1].second.c[k];
            return (6 * ((r - q) / right - (q - p) / left) - left * bends[i - 1].c[k]) / pivot;
        });
    }
    for (std::size_t i = n - 1; i-- > 1;) {
        bends[i] = componentwise(
            bends[i], [&](std::size_t k) { return bends[i].c[k] - above[i] * bends[i + 1].c[k]; });
    }
}

Numbers Spline::operator()(double t) const {
    const std::size_t edge = kind == Kind::cubic ? 1 : 0, last = points.size() - 1 - edge;
    if (t <= points[edge].first) return points[edge].second;
    if (t >= points[last].first) return points[last].second;
    const auto above = std::upper_bound(points.begin(), points.end(), t,
                                        [](double x, const auto& p) { return x < p.first; });
    const auto i = static_cast<std::size_t>(above - points.begin()) - 1;
    const auto time = [&](std::size_t j) { return points[j].first; };
    const double h = time(i + 1) - time(i), u = (t - time(i)) / h;
    return componentwise(points[i].second, [&](std::size_t k) {
        const auto v = [&](std::size_t j) { return points[j].second.c[k]; };
        const auto slope = [&](std::size_t j) {
            return (v(j + 1) - v(j)) / (time(j + 1) - time(j));
        };
        switch (kind) {
            case Kind::quadratic: {
                // Through three points, the first of them one before where there is one.
                const std::size_t a = i > 0 ? i - 1 : 0, b = a + 1, c = a + 2;
                const double bend = (slope(b) - slope(a)) / (time(c) - time(a));
                return v(a) + (t - time(a)) * (slope(a) + (t - time(b)) * bend);
            }
            case Kind::cubic: {
                // Catmull and Rom's, with the mean slope of both sides at each point.
                const double from = 0.5 * h * (slope(i - 1) + slope(i));
                const double to = 0.5 * h * (slope(i) + slope(i + 1));
                const double uu = u * u, uuu = uu * u;
                return (2 * uuu - 3 * uu + 1) * v(i) + (uuu - 2 * uu + u) * from +
                       (3 * uu - 2 * uuu) * v(i + 1) + (uuu - uu) * to;
            }
            case Kind::natural: {
                const double w = 1 - u;
                return w * v(i) + u * v(i + 1) +
                       h * h / 6 *
                           ((w * w * w - w) * bends[i].c[k] + (u * u * u - u) * bends[i + 1].c[k]);
            }
            default:
                return v(i) + u * (v(i + 1) - v(i));
        }
    });
}

/// `spline { cubic_spline 0, <0, 1>, 0.5, <1, 1>, ... }`.
Value Parser::spline_value(const Token& word) {
    const Place where = place(word);
    next();
    expect('{', "'{'");
    const Nesting nesting(*this, where);
    const Argument none(*this, 0);
    const int depth = braces_;
    try {
        return spline_points(where);
    } catch (const Fault& fault) {
        diagnostics_.error(fault);
        recover(depth);
        return {};
    }
}

Value Parser::spline_points(const Place& where) {
    Spline spline;
    if (peek_is(tok::word)) {
        static constexpr std::array<std::string_view, 4> kinds{"linear_spline", "quadratic_spline",
                                                               "cubic_spline", "natural_spline"};
        const auto found = std::find(kinds.begin(), kinds.end(), names_[peek().index].text);
        if (found != kinds.end()) {
            spline.kind = static_cast<Spline::Kind>(found - kinds.begin());
            next();
            accept(',');
        }
    }
    bool known = true;
    int size = 0;
    while (!peek_is('}')) {
        const Place at = here();
        const double t = number_argument("the place of a value");
        accept(',');
        const Value value = expression(Context::item);
        accept(',');
        known = known && !value.empty();
        if (value.empty()) continue;
        const Numbers* n = value.numbers();
        if (!n) throw Fault{joined(at, last_place_), "a spline is made of numbers", {}};
        if (size != 0 && n->size != size) {
            throw Fault{joined(at, last_place_), "all values of a spline are of one size", {}};
        }
        size = n->size;
        if (spline.points.size() >= limits::spline_points) {
            throw Fault{at,
                        "a spline of more than " + std::to_string(limits::spline_points) +
                            " values, the bound",
                        {}};
        }
        const auto after = std::find_if(spline.points.begin(), spline.points.end(),
                                        [&](const auto& p) { return p.first >= t; });
        if (after != spline.points.end() && after->first == t) {
            throw Fault{at, "this spline has two values in one place", {}};
        }
        spline.points.insert(after, {t, *n});
    }
    if (!known) {
        next();
        return {};
    }
    const std::size_t least = spline.kind == Spline::Kind::cubic       ? 4
                              : spline.kind == Spline::Kind::quadratic ? 3
                                                                       : 2;
    if (spline.points.size() < least) {
        throw Fault{joined(where, last_place_),
                    "this spline needs " + std::to_string(least) + " values at least",
                    {}};
    }
    next();
    spline.prepare();
    return Value(std::shared_ptr<const Spline>(std::make_shared<Spline>(std::move(spline))));
}

}  // namespace icespar
