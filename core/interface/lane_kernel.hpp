// A batch of faces between media of given kinds, group by group: read, solve, write what is wanted.
#pragma once

#include "interface/lane_columns.hpp"
#include "interface/lane_run.hpp"

namespace icespar::lanes {

template <class V>
struct Kernel {
    const FaceBatch& faces;
    const BatchResult& result;
    SolveOne solve_one;
    bool second = mode_index_of(faces.mode) == 1;

    static std::size_t mode_index_of(Mode m) { return m == Mode::p || m == Mode::extraordinary; }

    void leave(const Group<V>& group, const Mask<V>& lanes) const {
        for (std::size_t lane = 0; lane < group.count; ++lane) {
            if (lanes[lane]) solve_one(faces, result, group.first + lane);
        }
    }

    template <bool uniaxial>
    void write_incident(const Group<V>& group, const Incident<V, uniaxial>& in) const {
        const WaveColumns& to = result.incident;
        group.store(to.power, V(1));
        group.store(to.amplitude_real, V(1));
        group.store(to.amplitude_imag, V(0));
        group.store(to.ray, in.ray);
        group.store(to.k, in.k);
        group.store(to.E, in.E);
        if (wanted(to.H)) group.store(to.H, cross(in.k, in.E));
        if (to.n_phase.data) group.store(to.n_phase, sqrt(norm_of(in.k)));
        if (to.n_ray.data) group.store(to.n_ray, dot(in.k, in.ray));
        group.store(to.propagating, to.propagating_stride, Mask<V>(true));
    }

    /// eps k of a medium's extraordinary wave, or k.
    template <bool uniaxial>
    static Vector3<V> energy_flow(const MediumLanes<V>& m, const Vector3<V>& k, std::size_t i) {
        if (!uniaxial || i == 0) return k;
        const V eps_o = m.n_o * m.n_o;
        return eps_o * k + ((m.n_e * m.n_e - eps_o) * dot(k, m.axis)) * m.axis;
    }

    template <bool uniaxial, class T>
    void write(const Group<V>& group, const Frame<V>& frame, const MediumLanes<V>& medium,
               const FaceWave<T, V>& wave, std::size_t i, const Mask<V>& propagating,
               const WaveColumns& to) const {
        const bool ray_wanted = wanted(to.ray) || to.n_ray.data;
        if (ray_wanted || wanted(to.k) || to.n_phase.data) {
            const Vector3<V> k = frame.kt * frame.x + real_part(wave.q) * frame.z;
            group.store(to.k.real, k);
            if (wanted(to.k.imag)) group.store(to.k.imag, imag_part(wave.q) * frame.z);
            if (to.n_phase.data) group.store(to.n_phase, sqrt(norm_of(k)));
            if (ray_wanted) {
                Vector3<V> ray = unit(energy_flow<uniaxial>(medium, k, i));
                if constexpr (!std::is_same_v<T, V>) {
                    if (!all_of(propagating)) {
                        ray = select<V>(propagating, ray, mean_flow(frame, wave));
                    }
                }
                group.store(to.ray, ray);
                if (to.n_ray.data) group.store(to.n_ray, dot(k, ray));
            }
        }
        if (wanted(to.E)) group.store(to.E, frame.from_face(wave.E));
        if (wanted(to.H)) {
            const Vector3<T> H{wave.hx, wave.hy, frame.kt * wave.E.y};
            group.store(to.H, frame.from_face(H));
        }
        group.store(to.propagating, to.propagating_stride, propagating);
    }

    /// Unit Re(E x H*) of an evanescent wave.
    static Vector3<V> mean_flow(const Frame<V>& frame, const FaceWave<Cx<V>, V>& w) {
        const auto part = [](const Cx<V>& a, const Cx<V>& b) { return a.re * b.re + a.im * b.im; };
        const Cx<V> hz = frame.kt * w.E.y;
        const V x = part(w.E.y, hz) - part(w.E.z, w.hy), y = part(w.E.z, w.hx) - part(w.E.x, hz),
                z = part(w.E.x, w.hy) - part(w.E.y, w.hx);
        const V size2 = x * x + y * y + z * z;
        const Mask<V> flows = size2 > V(0);
        const V f = V(1) / sqrt(select<V>(flows, size2, V(1)));
        return frame.from_face(Vector3<V>{select<V>(flows, f * x, V(1)), f * y, f * z});
    }

    template <class T, bool from_uniaxial, bool to_uniaxial>
    void solve(const Group<V>& group, const Frame<V>& frame, const MediumLanes<V>& from,
               const MediumLanes<V>& to, const Seen<V, from_uniaxial>& near,
               const Seen<V, to_uniaxial>& far, const Vector3<V>& E) const {
        Pair<T, V> incident;
        if constexpr (from_uniaxial) {
            incident = incident_waves<T>(near, frame.to_face(E), frame.kn, second);
        } else {
            incident = waves_towards<T>(near, V(1));
        }
        const Solution<T, V> s(near, far, incident, second);
        for (std::size_t i = 0; i < 2; ++i) {
            const WaveColumns &r = result.reflected[i], &t = result.transmitted[i];
            group.store(r.power, s.r_power[i]);
            group.store(t.power, s.t_power[i]);
            group.store(r.amplitude_real, real_part(s.r[i]));
            group.store(r.amplitude_imag, imag_part(s.r[i]));
            group.store(t.amplitude_real, real_part(s.t[i]));
            group.store(t.amplitude_imag, imag_part(s.t[i]));
            const auto propagating = [&](const auto& m, bool uniaxial) {
                return uniaxial && i == 1 ? m.w2 > V(0) : m.q_o2 > V(0);
            };
            write<from_uniaxial>(group, frame, from, s.reflected[i], i,
                                 propagating(near, from_uniaxial), r);
            write<to_uniaxial>(group, frame, to, s.transmitted[i], i, propagating(far, to_uniaxial),
                               t);
        }
    }

    template <bool from_uniaxial, bool to_uniaxial>
    void one_group(const Group<V>& group) const {
        const MediumLanes<V> from = group.load(faces.from), to = group.load(faces.to);
        const Vector3<V> normal = group.load(faces.normal);
        const Incident<V, from_uniaxial> in(from, normal, group.load(faces.direction), second,
                                            faces.by == By::ray);
        const Vector3<V> H = cross(in.k, in.E);
        Mask<V> left = !(dot(cross(in.E, H), normal) > V(1e-140));
        const Frame<V> frame(normal, in.k);
        Seen<V, from_uniaxial> near(from, frame);
        Seen<V, to_uniaxial> far(to, frame);
        near.adopt(frame.kn, second);
        far.q_o2 = near.q_o2 + (to.n_o - from.n_o) * (to.n_o + from.n_o);
        far.complete();
        const Mask<V> real = near.all_real() && far.all_real();
        if constexpr (to_uniaxial) left = left || merging(far, V(1));
        if (!all_of(left)) {
            write_incident(group, in);
            if (all_of(real)) {
                solve<V>(group, frame, from, to, near, far, in.E);
            } else {
                solve<Cx<V>>(group, frame, from, to, near, far, in.E);
            }
        }
        if (any_of(left)) leave(group, left);
    }

    template <bool from_uniaxial, bool to_uniaxial>
    void run(std::size_t begin, std::size_t end) const {
        for (std::size_t i = begin; i < end; i += V::size()) {
            const std::size_t rest = end - i;
            one_group<from_uniaxial, to_uniaxial>({i, rest < V::size() ? rest : V::size()});
        }
    }
};

template <class V>
void run(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin, std::size_t end,
         bool from_uniaxial, bool to_uniaxial, SolveOne solve_one) {
    const Kernel<V> kernel{faces, wanted, solve_one};
    if (from_uniaxial && to_uniaxial) {
        kernel.template run<true, true>(begin, end);
    } else if (from_uniaxial) {
        kernel.template run<true, false>(begin, end);
    } else if (to_uniaxial) {
        kernel.template run<false, true>(begin, end);
    } else {
        kernel.template run<false, false>(begin, end);
    }
}

}  // namespace icespar::lanes
