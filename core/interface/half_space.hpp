// One side of a face: the two waves that leave on it, as a subspace that stays well defined where
// they coincide, and as modes.
#pragma once

#include <optional>

#include "crystal/medium.hpp"
#include "interface/berreman.hpp"
#include "interface/face_frame.hpp"

namespace icespar {

using Field4 = Vector4<Complex>;  ///< Ex, Ey, Hx, Hy in the face's frame

struct HalfSpace {
    /// Spans the outgoing tangential fields; the identity on the two components `pivot`.
    std::array<Field4, 2> basis;
    std::array<std::size_t, 2> pivot;
    /// Two independent rows that are 0 on all outgoing fields.
    std::array<Field4, 2> rows;

    /// Modes: s p, o e, or fast slow. E of unit Hermitian norm, in the face's frame.
    std::array<Complex, 2> q;
    std::array<CVec3, 2> E;
    std::array<Field4, 2> psi;
    std::array<double, 2> flux;  ///< along the outgoing direction; 0 when evanescent
    std::array<bool, 2> propagating;
    /// Of the known wave with |E| = 1, where k alone says them better than its given field does.
    double incident_flux = 0;
    std::optional<Field4> incident_field;

    /// Waves that carry energy (or decay) along sign * normal for the tangential wave number K.
    /// `known` is the normal component of a wave of mode `mode` that carries energy the other way.
    HalfSpace(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
              const Complex* known, std::size_t mode);

    /// Amplitudes of the modes in an outgoing field given by its coefficients in `basis`.
    [[nodiscard]] std::array<Complex, 2> amplitudes(
        const std::array<Complex, 2>& coefficients) const;
    [[nodiscard]] Field4 field(const std::array<Complex, 2>& coefficients) const;

private:
    void plain(const Medium& medium, const FaceFrame& face, int sign, const Complex* known,
               std::size_t mode);
    void isotropic(const Complex& eps, const Complex& K, int sign, const Complex* known);
    void uniaxial(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                  const Complex* known, std::size_t mode);
    template <class T>
    bool tensor(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                const Complex* known);

    /// Where an outgoing and an incoming wave nearly meet (grazing, critical), the other two are
    /// kept apart from them, since they do not share their sensitivity. False when none meet.
    template <class T>
    bool separate_grazing(const Berreman<T>& b, const Matrix4<T>& square, const Quartic<T>& f,
                          const Factors<T>& factors, double scale, int sign, const Complex* known,
                          bool absorbing);
    void order_by_sheet(int sign, bool transparent);
    void set_mode(std::size_t i, const Complex& K, const Complex& normal_component,
                  const CVec3& field, double sign);
    void set_basis(std::array<Field4, 2> columns);
};

/// Energy flow along the normal of a tangential field.
inline double normal_flux(const Field4& f) {
    return (f[0] * std::conj(f[3]) - f[1] * std::conj(f[2])).real();
}

}  // namespace icespar
