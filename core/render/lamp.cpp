// Lamps as POV-Ray has them: points, spots, cylinders and parallel beams, with area and fading.
#include "render/lamp.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace icespar {
namespace {

/// 0 up to `low`, 1 from `high` on, smooth between.
double smooth_step(double low, double high, double at) {
    if (!(high > low)) return at >= high ? 1 : 0;
    const double p = std::clamp((at - low) / (high - low), 0.0, 1.0);
    return p * p * (3 - 2 * p);
}

Vec3 point_of_area(const Light& light, const Vec3& seen_from, double u, double v) {
    Vec3 eu = light.edge_u, ev = light.edge_v;
    if (light.orient) {
        const Vec3 n = normalised(seen_from - light.position);
        const Vec3 across = any_perpendicular(n);
        eu = length(eu) * across;
        ev = length(ev) * cross(n, across);
    }
    u -= 0.5;
    v -= 0.5;
    if (light.circular) {
        const double r = 0.5 * std::sqrt(u + 0.5), turn = 2 * std::numbers::pi * (v + 0.5);
        u = r * std::cos(turn);
        v = r * std::sin(turn);
    }
    return light.position + u * eu + v * ev;
}

double beam(const Light& light, const Vec3& lamp, const Vec3& point, const Vec3& to_lamp) {
    if (light.kind == Light::Kind::spot) {
        const double cosine = -dot(to_lamp, light.direction);
        if (!(cosine > 0)) return 0;
        const double edge =
            light.radius > 0 ? smooth_step(std::cos(light.falloff), std::cos(light.radius), cosine)
                             : (cosine >= std::cos(light.falloff) ? 1 : 0);
        return std::pow(cosine, light.tightness) * edge;
    }
    if (light.kind == Light::Kind::cylinder) {
        const Vec3 from = point - lamp;
        const double along = dot(from, light.direction);
        if (!(along > 0)) return 0;
        const double inwards = 1 - length(from - along * light.direction) / light.falloff;
        if (!(inwards > 0)) return 0;
        return std::pow(inwards, light.tightness) *
               smooth_step(0, 1 - light.radius / light.falloff, inwards);
    }
    return 1;
}

}  // namespace

LampRay lamp_ray(const Light& light, const Vec3& point, double u, double v) {
    LampRay out;
    const Vec3 lamp = light.parallel ? light.position : point_of_area(light, point, u, v);
    const Vec3 to_lamp = lamp - point;
    out.distance = length(to_lamp);
    out.to_lamp = to_lamp / out.distance;
    out.strength = beam(light, lamp, point, light.parallel ? -light.direction : out.to_lamp);
    if (light.parallel) {
        // Rays along one direction, through the plane of the lamp: what lies behind it is lit too.
        out.to_lamp = -light.direction;
        out.distance = std::max(0.0, dot(to_lamp, out.to_lamp));
    }
    if (light.fade_distance > 0 && light.fade_power > 0) {
        out.strength *= 2 / (1 + std::pow(out.distance / light.fade_distance, light.fade_power));
    }
    return out;
}

}  // namespace icespar
