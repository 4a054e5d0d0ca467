// The incident wave as the general solver sees it, to the digits of its number type.
#pragma once

#include "interface/half_space.hpp"
#include "interface/wave.hpp"

namespace icespar {

template <class R>
struct IncidentWave {
    using C = std::complex<R>;

    FaceAxes<R> axes;
    C K, kn;  ///< tangential and normal component of k
    Field4<R> field;

    /// The wave as given.
    IncidentWave(const FaceFrame& frame, const Wave& wave)
        : axes{converted<R>(frame.x), converted<R>(frame.y), converted<R>(frame.z)} {
        set(converted<C>(wave.k), converted<C>(wave.E), converted<C>(wave.H));
    }

    /// Where the given numbers have fewer digits than R: the wave of the medium that has the given
    /// wave normal, its index and field worked out anew. Beside an optic axis, where the wave
    /// normal no longer tells the field, it is the combination of both waves that comes nearest to
    /// the given field. An inhomogeneous wave is taken as given.
    static IncidentWave refined(const Medium& medium, const FaceFrame& frame, const Wave& wave);

private:
    IncidentWave() = default;
    void set(const Vector3<C>& k, const Vector3<C>& E, const Vector3<C>& H) {
        K = dot(k, axes.x);
        kn = dot(k, axes.z);
        field = {dot(E, axes.x), dot(E, axes.y), dot(H, axes.x), dot(H, axes.y)};
    }
};

}  // namespace icespar
