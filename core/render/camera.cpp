// Perspective, orthographic and fisheye cameras, with lens and analyser.
#include "render/camera.hpp"

#include <cmath>
#include <numbers>

namespace icespar {
namespace {

/// Direction of a fisheye's point: its angle from the axis grows evenly from the centre.
std::optional<Vec3> fisheye(const Camera& camera, double u, double v) {
    const double aspect = length(camera.right) / length(camera.up);
    const double x = (2 * u - 1) * aspect, y = 1 - 2 * v;
    const double radius = std::hypot(x, y), angle = 0.5 * radius * camera.fisheye_angle;
    if (radius > 1) return std::nullopt;
    const Vec3 across =
        radius > 0 ? (x / radius) * normalised(camera.right) + (y / radius) * normalised(camera.up)
                   : Vec3{};
    return normalised(std::sin(angle) * across + std::cos(angle) * normalised(camera.direction));
}

}  // namespace

std::optional<Branch> camera_branch(const Camera& camera, double u, double v, double a, double b) {
    const Vec3 offset = (u - 0.5) * camera.right + (0.5 - v) * camera.up;
    Vec3 origin = camera.location, direction = camera.direction + offset;
    if (camera.kind == Camera::Kind::orthographic) {
        origin = camera.location + offset;
        direction = camera.direction;
    } else if (camera.kind == Camera::Kind::fisheye) {
        const auto seen = fisheye(camera, u, v);
        if (!seen) return std::nullopt;
        direction = *seen;
    }
    if (camera.lens_radius > 0) {
        const Vec3 axis = normalised(camera.direction);
        const Vec3 in_focus =
            origin + (camera.focal_distance / std::abs(dot(direction, axis))) * direction;
        const Vec3 across = normalised(camera.right - dot(camera.right, axis) * axis);
        const double r = camera.lens_radius * std::sqrt(a), turn = 2 * std::numbers::pi * b;
        origin += r * std::cos(turn) * across + r * std::sin(turn) * cross(across, axis);
        direction = in_focus - origin;
    }
    Branch branch = Branch::from_sensor(origin, normalised(direction), camera.right);
    if (camera.analyser) {
        // The sensor's component i of J E is (row i of J) . E.
        for (std::size_t i = 0; i < 2; ++i) {
            branch.amplitude[i] = {camera.analyser->m[i][0], camera.analyser->m[i][1]};
        }
        branch.weight = branch.power();
    }
    return branch;
}

}  // namespace icespar
