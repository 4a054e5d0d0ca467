// Functions of vectors.
#include <cmath>
#include <numbers>

#include "parser/arguments.hpp"

namespace icespar {
namespace {

using Vec = std::array<double, 3>;

Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// In left-handed coordinates, thumb of the left hand along the axis.
Vec turned(const Vec& v, const Vec& unit, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), along = dot(unit, v) * (1 - c);
    const Vec side = cross(unit, v);
    Vec out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = v[i] * c + side[i] * s + unit[i] * along;
    return out;
}

Numbers vector_of(const Vec& v) { return {{v[0], v[1], v[2]}, 3, false}; }

}  // namespace

std::optional<Value> vector_function(std::string_view name, const Arguments& a) {
    if (name == "vlength" || name == "vnormalize") {
        a.count(1, 1);
        Vec v = a.vector(0);
        const double length = std::sqrt(dot(v, v));
        if (name == "vlength") return length;
        if (!(length > 0)) throw Fault{a.whole, "a vector of length 0 has no direction", {}};
        for (double& c : v) c /= length;
        return vector_of(v);
    }
    if (name == "vdot" || name == "vcross") {
        a.count(2, 2);
        if (name == "vdot") return dot(a.vector(0), a.vector(1));
        return vector_of(cross(a.vector(0), a.vector(1)));
    }
    if (name == "vaxis_rotate") {
        a.count(3, 3);
        Vec axis = a.vector(1);
        const double length = std::sqrt(dot(axis, axis));
        if (!(length > 0)) throw Fault{a.places[1], "the axis of rotation has length 0", {}};
        for (double& c : axis) c /= length;
        return vector_of(turned(a.vector(0), axis, a.number(2) * std::numbers::pi / 180));
    }
    if (name == "vrotate") {
        a.count(2, 2);
        Vec v = a.vector(0);
        const Vec angles = a.vector(1);
        for (std::size_t i = 0; i < 3; ++i) {
            Vec axis{};
            axis[i] = 1;
            v = turned(v, axis, angles[i] * std::numbers::pi / 180);
        }
        return vector_of(v);
    }
    return std::nullopt;
}

}  // namespace icespar
