// One side of a face: the two waves that leave on it, as a subspace that stays well defined where
// they coincide, and as modes.
#pragma once

#include <optional>

#include "crystal/medium.hpp"
#include "interface/berreman.hpp"
#include "interface/face_frame.hpp"

namespace icespar {

using Field4 = Vector4<Complex>;  ///< Ex, Ey, Hx, Hy in the face's frame

/// An incident wave: its normal component, more precise than anything worked out from the
/// tangential one at grazing incidence, its place in the pair of modes, and its tangential field.
struct Arriving {
    Complex q;
    std::size_t mode;
    Field4 field;
};

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
    /// Of the known wave: its flux where it is known more precisely than its field tells, or 0; its
    /// field in the plane of the waves it nearly meets.
    double incident_flux = 0;
    std::optional<Field4> incident_field;

    /// Waves that carry energy (or decay) along sign * normal for the tangential wave number K.
    /// `known` is a wave of this medium that carries energy the other way, or null.
    HalfSpace(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
              const Arriving* known);

    /// Amplitudes of the modes in an outgoing field given by its coefficients in `basis`.
    [[nodiscard]] std::array<Complex, 2> amplitudes(
        const std::array<Complex, 2>& coefficients) const;
    [[nodiscard]] Field4 field(const std::array<Complex, 2>& coefficients) const;

private:
    void plain(const Medium& medium, const FaceFrame& face, int sign, const Arriving* known);
    void isotropic(const Complex& eps, const Complex& K, int sign, const Arriving* known);
    void uniaxial(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                  const Arriving* known);
    template <class T>
    bool tensor(const Medium& medium, const FaceFrame& face, const Complex& K, int sign,
                const Arriving* known);

    /// Where an outgoing and an incoming wave nearly meet (grazing, critical), the other two are
    /// kept apart from them, since they do not share their sensitivity. False when none meet.
    template <class T>
    bool separate_grazing(const Berreman<T>& b, const Matrix4<T>& square, const Quartic<T>& f,
                          const Factors<T>& factors, double scale, int sign, const Arriving* known,
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
