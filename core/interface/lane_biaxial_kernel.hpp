// A batch of faces between transparent media, one of them biaxial and the other biaxial or
// isotropic: the matching of quick_face.cpp in lanes, group by group.
#pragma once

#include "interface/lane_biaxial.hpp"
#include "interface/lane_kernel.hpp"

namespace icespar::lanes {

template <class V>
struct BiaxialKernel {
    const Kernel<V> kernel;

    template <bool biaxial>
    static auto load(const Group<V>& group, const MediumColumn& column) {
        if constexpr (!biaxial) {
            return group.load(column);
        } else {
            const auto each = [&](auto part) {
                if (column.stride == 0) return V(part(*column.data));
                return V([&](auto lane) {
                    return part(
                        column.data[static_cast<std::ptrdiff_t>(group.face(lane)) * column.stride]);
                });
            };
            const auto of = [&](Complex ComplexTensor::*element) {
                return each([=](const Medium& m) { return (m.deviation.*element).real(); });
            };
            using T = ComplexTensor;
            return BiaxialLanes<V>{
                each([](const Medium& m) { return m.mean.real(); }),
                {of(&T::xx), of(&T::yy), of(&T::zz), of(&T::yz), of(&T::xz), of(&T::xy)}};
        }
    }

    /// Amplitudes from the pairings; where R + T = 1 tells that nothing was lost.
    template <class T>
    struct Matched {
        std::array<T, 2> r, t;
        std::array<V, 2> r_power, t_power;
        Mask<V> sound;

        Matched(const FaceWave<V, V>& in, const Pair<V, V>& returned, const Pair<T, V>& away,
                const Pair<T, V>& probe) {
            const T a = pairing(probe[0], returned[0]), b = pairing(probe[0], returned[1]),
                    c = pairing(probe[1], returned[0]), d = pairing(probe[1], returned[1]);
            const T x = -pairing(probe[0], in), y = -pairing(probe[1], in);
            const T inverse = reciprocal(a * d - b * c);
            r = {(x * d - b * y) * inverse, (a * y - x * c) * inverse};
            const V per_flux = V(1) / in.flux;
            V carried(0);
            for (std::size_t i = 0; i < 2; ++i) {
                const FaceWave<T, V>& w = away[i];
                t[i] = (pairing(w, in) + r[0] * pairing(w, returned[0]) +
                        r[1] * pairing(w, returned[1])) *
                       reciprocal(pairing(w, w));
                r_power[i] = norm(r[i]) * -returned[i].flux * per_flux;
                t_power[i] = norm(t[i]) * w.flux * per_flux;
                carried += r_power[i] + t_power[i];
            }
            sound = abs(carried - V(1)) < V(1e-14);
        }
    };

    /// Where an isotropic medium's waves are neither near grazing nor near critical.
    static Mask<V> clear(const Seen<V, false>& m) { return m.q_o2 > V(4e-4) || m.q_o2 < V(-1e-3); }

    template <bool from_biaxial, bool to_biaxial, class From, class To>
    void one_group(const Group<V>& group, const From& from, const To& to) const {
        const Vector3<V> normal = group.load(kernel.faces.normal),
                         direction = group.load(kernel.faces.direction);
        const auto in = [&] {
            if constexpr (from_biaxial) {
                return BiaxialIncident<V>(from, direction, kernel.second);
            } else {
                return Incident<V, false>(from, direction, kernel.second, false);
            }
        }();
        const Frame<V> frame(normal, in.k);
        const auto kt = frame.kt;
        FaceWave<V, V> source{};
        Pair<V, V> returned;
        Mask<V> sound(true);
        Vector3<V> E;
        if constexpr (from_biaxial) {
            const BiaxialWaves<V> near(from, frame);
            sound = near.sound;
            returned = near.down;
            E = in.E;
            source.E = frame.to_face(E);
            const Vector3<V> H = cross(in.k, E);
            source.hx = dot(H, frame.x);
            source.hy = dot(H, frame.y);
        } else {
            Seen<V, false> near(from, frame);
            near.complete((from.n_o - kt) * (from.n_o + kt));
            sound = near.q_o2 > V(4e-4);
            returned = waves_towards<V>(near, V(-1));
            source = waves_towards<V>(near, V(1))[kernel.second];
            E = in.field(from, frame, kernel.second);
        }
        source.flux = source.E.x * source.hy - source.E.y * source.hx;
        sound = sound && (from_biaxial ? source.flux : frame.kn) > V(Kernel<V>::least_flux);
        const auto finish = [&](const auto& away, const auto& probe, const auto& carries) {
            using T = std::remove_cvref_t<decltype(away[0].q)>;
            const Matched<T> found(source, returned, away, probe);
            sound = sound && found.sound;
            if (any_of(sound)) {
                kernel.write_incident(group, in);
                group.store(kernel.result.incident.E, E);
                group.store(kernel.result.incident.H, cross(in.k, E));
                write(group, frame, returned, away, carries, found);
            }
            if (!all_of(sound)) kernel.leave(group, !sound);
        };
        const Mask<V> always(true);
        if constexpr (to_biaxial) {
            const BiaxialWaves<V> far(to, frame);
            sound = sound && far.sound;
            finish(far.up, far.down, always);
        } else {
            Seen<V, false> far(to, frame);
            far.complete((to.n_o - kt) * (to.n_o + kt));
            sound = sound && clear(far);
            if (all_of(far.real_o)) {
                finish(waves_towards<V>(far, V(1)), waves_towards<V>(far, V(-1)), always);
            } else {
                finish(waves_towards<Cx<V>>(far, V(1)), waves_towards<Cx<V>>(far, V(-1)),
                       far.real_o);
            }
        }
    }

    template <class T>
    void write(const Group<V>& group, const Frame<V>& frame, const Pair<V, V>& returned,
               const Pair<T, V>& away, const Mask<V>& carries, const Matched<T>& found) const {
        const BatchResult& to = kernel.result;
        group.store(to.reflected_total.power, found.r_power[0] + found.r_power[1]);
        group.store(to.transmitted_total.power, found.t_power[0] + found.t_power[1]);
        kernel.write_total(group, frame, returned, found.r, to.reflected_total);
        kernel.write_total(group, frame, away, found.t, to.transmitted_total);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto one = [&](const auto& wave, const Mask<V>& propagating, const T& amplitude,
                                 const V& power, const WaveColumns& columns) {
                group.store(columns.power, power);
                group.store(columns.amplitude_real, real_part(amplitude));
                group.store(columns.amplitude_imag, imag_part(amplitude));
                // E x (k x E).
                const auto flow = [&](const Vector3<V>& k) {
                    const Vector3<V> E = frame.from_face(real_part(wave.E));
                    return dot(E, E) * k - dot(k, E) * E;
                };
                kernel.write(group, frame, wave, propagating, flow, columns);
            };
            one(returned[i], Mask<V>(true), found.r[i], found.r_power[i], to.reflected[i]);
            one(away[i], carries, found.t[i], found.t_power[i], to.transmitted[i]);
        }
    }

    template <bool from_biaxial, bool to_biaxial>
    void run(std::size_t begin, std::size_t end) const {
        const auto group_at = [&](std::size_t i) {
            const std::size_t rest = end - i;
            return Group<V>{i, rest < V::size() ? rest : V::size()};
        };
        const FaceBatch& faces = kernel.faces;
        const bool alike = faces.from.stride == 0 && faces.to.stride == 0;
        auto from = load<from_biaxial>(group_at(begin), faces.from);
        auto to = load<to_biaxial>(group_at(begin), faces.to);
        for (std::size_t i = begin; i < end; i += V::size()) {
            const Group<V> group = group_at(i);
            if (!alike && i > begin) {
                from = load<from_biaxial>(group, faces.from);
                to = load<to_biaxial>(group, faces.to);
            }
            one_group<from_biaxial, to_biaxial>(group, from, to);
        }
    }
};

}  // namespace icespar::lanes
