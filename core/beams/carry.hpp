// How what is known to first order goes on: along a flow to a plane, and through a face.
#pragma once

#include "beams/expansion.hpp"

namespace icespar {

/// Where lines along `flow` meet a plane that is `t` away from the first of them.
[[nodiscard]] inline Expansion arrival(const Expansion& from, const Expansion& flow,
                                       const Vec3& normal, double t) {
    const double speed = -1 / dot(normal, flow.value);
    const Vec3 x = from.dx + t * flow.dx, y = from.dy + t * flow.dy;
    return {from.value + t * flow.value, x + (speed * dot(normal, x)) * flow.value,
            y + (speed * dot(normal, y)) * flow.value};
}

[[nodiscard]] inline Vec3 mirrored(const Vec3& v, const Vec3& normal) {
    return v - (2 * dot(normal, v)) * normal;
}
[[nodiscard]] inline Expansion mirrored(const Expansion& k, const Vec3& normal) {
    return {mirrored(k.value, normal), mirrored(k.dx, normal), mirrored(k.dy, normal)};
}

/// The outgoing wave vector `value` that shares k's tangential part, with its derivatives: dk lies
/// across the flow of energy, which fixes its normal part.
[[nodiscard]] inline Expansion matched(const Expansion& k, const Vec3& normal, const Vec3& value,
                                       const Vec3& flow) {
    const double slope = 1 / dot(flow, normal);
    const auto derivative = [&](const Vec3& d) { return d - (dot(flow, d) * slope) * normal; };
    return {value, derivative(k.dx), derivative(k.dy)};
}

/// dk/dc of the outgoing wave: like any derivative, but the index surface it ends on swells.
[[nodiscard]] inline Vec3 fanned(const Vec3& fan, const Vec3& normal, const Vec3& flow,
                                 double swell) {
    return fan + ((swell - dot(flow, fan)) / dot(flow, normal)) * normal;
}

}  // namespace icespar
