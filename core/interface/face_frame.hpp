// The frame of a face: x along the tangential wave vector, y = normal x k direction (s), z =
// normal.
#pragma once

#include "math/vec3.hpp"

namespace icespar {

struct FaceFrame {
    Vec3 x, y, z;
    double kt = 0;  ///< length of the tangential wave vector
    double kn = 0;  ///< k . normal

    FaceFrame(const Vec3& normal, const Vec3& k) : z(normal), kn(dot(normal, k)) {
        const Vec3 once = k - kn * normal;
        const Vec3 t = once - dot(normal, once) * normal;
        kt = length(t);
        // A second projection that takes away much says that the first left only rounding.
        if (kt > 0.5 * length(once) && kt > 1e-150) {
            const Vec3 unit = t / kt;
            x = normalised(unit - dot(normal, unit) * normal);
        } else {
            kt = 0;
            x = any_perpendicular(normal);
        }
        y = cross(z, x);
    }

    [[nodiscard]] Vec3 to_face(const Vec3& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
    template <class T>
    [[nodiscard]] Vector3<T> from_face(const Vector3<T>& v) const {
        return v.x * x + v.y * y + v.z * z;
    }
};

}  // namespace icespar
