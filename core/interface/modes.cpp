// Plane waves of a medium from a direction.
#include "interface/crystal_frame.hpp"
#include "interface/face_frame.hpp"
#include "interface/wave.hpp"
#include "math/error.hpp"

namespace icespar {

Wave plane_wave(const Medium& medium, Mode mode, const Vec3& direction, By by, const Vec3& normal) {
    const bool crystal_mode = mode == Mode::ordinary || mode == Mode::extraordinary;
    if (crystal_mode != medium.birefringent) {
        throw Error(crystal_mode ? "an isotropic medium has the modes s and p, not o and e"
                                 : "a uniaxial medium has the modes o and e, not s and p");
    }
    const double eps_o = medium.n_o * medium.n_o, eps_e = medium.n_e * medium.n_e;
    const CrystalFrame crystal(medium.axis);
    Wave wave;
    wave.mode = mode;
    Vec3 k, E;
    if (mode == Mode::extraordinary) {
        // Ray direction ~ eps k, so k ~ eps^-1 ray; k . eps k = n_o^2 n_e^2 sets the length.
        const Vec3 d = by == By::wave_normal
                           ? direction
                           : direction / eps_o + (1 / eps_e - 1 / eps_o) *
                                                     dot(direction, medium.axis) * medium.axis;
        const double x = dot(d, crystal.a), y = dot(d, crystal.b), z = dot(d, crystal.c);
        const double scale =
            medium.n_o * medium.n_e / std::sqrt(eps_o * (x * x + y * y) + eps_e * z * z);
        k = scale * d;
        E = normalised(crystal.extraordinary(scale * x, scale * y, scale * z, eps_o, eps_e));
        wave.ray =
            by == By::ray
                ? direction
                : normalised(eps_o * k + ((eps_e - eps_o) * dot(k, medium.axis)) * medium.axis);
    } else {
        k = medium.n_o * direction;
        wave.ray = direction;
        if (mode == Mode::ordinary) {
            E = crystal.ordinary(dot(direction, crystal.a), dot(direction, crystal.b));
        } else {
            const FaceFrame face(normal, k);
            E = mode == Mode::s ? face.y : cross(direction, face.y);
        }
    }
    wave.k = complexified(k);
    wave.E = complexified(E);
    wave.H = complexified(cross(k, E));
    wave.n_phase = length(k);
    wave.n_ray = dot(k, wave.ray);
    return wave;
}

}  // namespace icespar
