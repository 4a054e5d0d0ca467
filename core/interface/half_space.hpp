// One side of a face: the two waves that leave on it, as a subspace that stays well defined where
// they coincide, and as modes.
#pragma once

#include <optional>

#include "crystal/medium.hpp"
#include "interface/berreman.hpp"
#include "interface/face_frame.hpp"

namespace icespar {

/// Ex, Ey, Hx, Hy in the face's frame.
template <class R>
using Field4 = Vector4<std::complex<R>>;

/// The axes of a face's frame: x along the tangential wave vector, z along the normal.
template <class R>
struct FaceAxes {
    Vector3<R> x, y, z;

    [[nodiscard]] Vector3<R> to_face(const Vector3<R>& v) const {
        return {dot(x, v), dot(y, v), dot(z, v)};
    }
    template <class T>
    [[nodiscard]] Vector3<T> from_face(const Vector3<T>& v) const {
        return v.x * x + v.y * y + v.z * z;
    }
    [[nodiscard]] SymmetricTensor<std::complex<R>> permittivity(const Medium& medium) const;
};

/// An incident wave: its normal component, more precise than anything worked out from the
/// tangential one at grazing incidence, its place in the pair of modes, and its tangential field.
template <class R>
struct Arriving {
    std::complex<R> q;
    std::size_t mode;
    Field4<R> field;
};

/// R is double, or long double where double would lose what is asked for.
template <class R>
struct HalfSpace {
    using C = std::complex<R>;
    using Field = Field4<R>;

    /// Spans the outgoing tangential fields; the identity on the two components `pivot`.
    std::array<Field, 2> basis;
    std::array<std::size_t, 2> pivot;
    /// Two independent rows that are 0 on all outgoing fields.
    std::array<Field, 2> rows;

    /// Modes: s p, o e, or fast slow. E of unit Hermitian norm, in the face's frame.
    std::array<C, 2> q;
    std::array<Vector3<C>, 2> E;
    std::array<Field, 2> psi;
    std::array<R, 2> flux;  ///< along the outgoing direction; 0 when evanescent
    std::array<bool, 2> propagating;
    /// Of the known wave: its flux where it is known more precisely than its field tells, or 0; its
    /// field in the plane of the waves it nearly meets.
    R incident_flux = 0;
    std::optional<Field> incident_field;
    /// The least distance of an outgoing normal component to an incoming one, over the index. All
    /// that is computed loses digits as it shrinks.
    R separation = 1;

    /// Waves that carry energy (or decay) along sign * normal for the tangential wave number K.
    /// `known` is a wave of this medium that carries energy the other way, or null.
    HalfSpace(const Medium& medium, const FaceAxes<R>& face, const C& K, int sign,
              const Arriving<R>* known);

    /// Amplitudes of the modes in an outgoing field given by its coefficients in `basis`.
    [[nodiscard]] std::array<C, 2> amplitudes(const std::array<C, 2>& coefficients) const;
    [[nodiscard]] Field field(const std::array<C, 2>& coefficients) const;

private:
    void isotropic(const C& n, const C& K, int sign, const Arriving<R>* known, bool absorbing);
    void uniaxial(const Medium& medium, const FaceAxes<R>& face, const C& K, int sign,
                  const Arriving<R>* known);
    template <class T>
    bool tensor(const Medium& medium, const FaceAxes<R>& face, const C& K, int sign,
                const Arriving<R>* known);

    /// Where an outgoing and an incoming wave nearly meet (grazing, critical), the other two are
    /// kept apart from them, since they do not share their sensitivity. False when none meet.
    template <class T>
    bool separate_grazing(const Berreman<T>& b, const Matrix4<T>& square, const Quartic<T>& f,
                          const Factors<T>& factors, R scale, int sign, const Arriving<R>* known,
                          bool lossy, bool followed);
    void order_by_sheet(int sign, bool transparent);
    void set_mode(std::size_t i, const C& K, const C& normal_component, const Vector3<C>& field,
                  R sign);
    void set_basis(std::array<Field, 2> columns);
};

/// Energy flow along the normal of a tangential field.
template <class R>
R normal_flux(const Field4<R>& f) {
    return (f[0] * std::conj(f[3]) - f[1] * std::conj(f[2])).real();
}

/// Complex index of a medium's ordinary or extraordinary wave.
template <class R>
std::complex<R> index_o(const MediumCore& m) {
    return {R(m.n_o), R(m.kappa_o)};
}
template <class R>
std::complex<R> index_e(const MediumCore& m) {
    return {R(m.n_e), R(m.kappa_e)};
}

template <class R>
SymmetricTensor<std::complex<R>> FaceAxes<R>::permittivity(const Medium& m) const {
    using C = std::complex<R>;
    if (m.symmetry == Symmetry::biaxial) {
        const C mean(m.mean);
        return SymmetricTensor<C>::diagonal(mean, mean, mean) +
               converted<C>(m.deviation).in_frame(x, y, z);
    }
    const C o = index_o<R>(m), e = index_e<R>(m);
    const C o2 = o * o;
    return SymmetricTensor<C>::diagonal(o2, o2, o2) +
           C((e - o) * (e + o)) * complexified(dyad(to_face(normalised(converted<R>(m.axis)))));
}

}  // namespace icespar
