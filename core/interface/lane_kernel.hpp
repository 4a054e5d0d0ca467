// A batch of faces between media of given kinds, group by group: read, solve, write what is wanted.
#pragma once

#include "interface/lane_columns.hpp"
#include "interface/lane_fresnel.hpp"
#include "interface/lane_run.hpp"

namespace icespar::lanes {

template <class V>
struct Kernel {
    const FaceBatch& faces;
    const BatchResult& result;
    SolveOne solve_one;
    bool second = mode_index_of(faces.mode) == 1;
    /// Along the normal. Waves with less are left: to be refused by name, or, in single precision,
    /// since rounding may take all of it.
    static constexpr double least_flux = single<V> ? 1e-5 : 1e-140;

    static std::size_t mode_index_of(Mode m) {
        return m == Mode::p || m == Mode::extraordinary || m == Mode::slow;
    }

    void leave(const Group<V>& group, const Mask<V>& lanes) const {
        for (std::size_t lane = 0; lane < group.count; ++lane) {
            if (lanes[lane]) solve_one(faces, result, group.first + lane);
        }
    }

    /// Fields need the face's frame; the shortcut does without.
    bool fields = [this] {
        bool any = fields_wanted(result.incident) || fields_wanted(result.reflected_total) ||
                   fields_wanted(result.transmitted_total);
        for (std::size_t i = 0; i < 2; ++i) {
            any = any || fields_wanted(result.reflected[i]) || fields_wanted(result.transmitted[i]);
        }
        return any;
    }();

    template <class Wave>
    void write_incident(const Group<V>& group, const Wave& in) const {
        const WaveColumns& to = result.incident;
        group.store(to.power, V(1));
        group.store(to.amplitude_real, V(1));
        group.store(to.amplitude_imag, V(0));
        group.store(to.ray, in.ray);
        group.store(to.k, in.k);
        if (to.n_phase.data) group.store(to.n_phase, sqrt(norm_of(in.k)));
        if (to.n_ray.data) group.store(to.n_ray, dot(in.k, in.ray));
        group.store(to.propagating, to.propagating_stride, Mask<V>(true));
    }

    /// eps k of a medium's extraordinary wave, or k.
    template <bool uniaxial>
    static Vector3<V> energy_flow(const MediumLanes<V>& m, const Vector3<V>& k, std::size_t i) {
        if (!uniaxial || i == 0) return k;
        return m.eps_o * k + ((m.eps_e - m.eps_o) * dot(k, m.axis)) * m.axis;
    }

    /// `flow` gives the direction of a propagating wave's energy from its k. An evanescent wave of
    /// an isotropic medium flows along x.
    template <bool isotropic = false, class T, class Flow>
    void write(const Group<V>& group, const Frame<V>& frame, const FaceWave<T, V>& wave,
               const Mask<V>& propagating, const Flow& flow, const WaveColumns& to) const {
        const bool ray_wanted = wanted(to.ray) || to.n_ray.data;
        if (ray_wanted || wanted(to.k) || to.n_phase.data) {
            const Vector3<V> k = frame.kt * frame.x + real_part(wave.q) * frame.z;
            group.store(to.k.real, k);
            if (wanted(to.k.imag)) group.store(to.k.imag, imag_part(wave.q) * frame.z);
            if (to.n_phase.data) group.store(to.n_phase, sqrt(norm_of(k)));
            if (ray_wanted) {
                Vector3<V> ray = unit(flow(k));
                if constexpr (!std::is_same_v<T, V>) {
                    if (!all_of(propagating)) {
                        ray = select<V>(propagating, ray,
                                        isotropic ? frame.x : mean_flow(frame, wave));
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

    template <class A, class T>
    void write_total(const Group<V>& group, const Frame<V>& frame, const Pair<T, V>& waves,
                     const std::array<A, 2>& amplitude, const TotalColumns& to) const {
        if (!fields_wanted(to)) return;
        Vector3<A> E, H;
        for (std::size_t i = 0; i < 2; ++i) {
            const FaceWave<T, V>& w = waves[i];
            E += amplitude[i] * w.E;
            H += amplitude[i] * Vector3<T>{w.hx, w.hy, frame.kt * w.E.y};
        }
        group.store(to.E, frame.from_face(E));
        group.store(to.H, frame.from_face(H));
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
        group.store(result.reflected_total.power, s.r_power[0] + s.r_power[1]);
        group.store(result.transmitted_total.power, s.t_power[0] + s.t_power[1]);
        write_total(group, frame, s.reflected, s.r, result.reflected_total);
        write_total(group, frame, s.transmitted, s.t, result.transmitted_total);
        for (std::size_t i = 0; i < 2; ++i) {
            const WaveColumns &r = result.reflected[i], &t = result.transmitted[i];
            group.store(r.power, s.r_power[i]);
            group.store(t.power, s.t_power[i]);
            group.store(r.amplitude_real, real_part(s.r[i]));
            group.store(r.amplitude_imag, imag_part(s.r[i]));
            group.store(t.amplitude_real, real_part(s.t[i]));
            group.store(t.amplitude_imag, imag_part(s.t[i]));
            const auto propagating = [&](const auto& m, bool uniaxial) {
                return uniaxial && i == 1 ? m.real_e : m.real_o;
            };
            write<!from_uniaxial>(
                group, frame, s.reflected[i], propagating(near, from_uniaxial),
                [&](const Vector3<V>& k) { return energy_flow<from_uniaxial>(from, k, i); }, r);
            write<!to_uniaxial>(
                group, frame, s.transmitted[i], propagating(far, to_uniaxial),
                [&](const Vector3<V>& k) { return energy_flow<to_uniaxial>(to, k, i); }, t);
        }
    }

    /// Both waves of one side of a face that does not mix s and p. In isotropic media they have the
    /// same direction.
    template <bool uniaxial>
    void write_upright(const Group<V>& group, const MediumLanes<V>& medium, const Vector3<V>& kt,
                       const Vector3<V>& normal, const std::array<V, 2>& squares, const V& sign,
                       const std::array<WaveColumns, 2>& to) const {
        const auto ray_wanted = [](const WaveColumns& c) { return wanted(c.ray) || c.n_ray.data; };
        const bool rays = ray_wanted(to[0]) || ray_wanted(to[1]);
        const bool any =
            rays || wanted(to[0].k) || wanted(to[1].k) || to[0].n_phase.data || to[1].n_phase.data;
        for (std::size_t i = 0; i < 2; ++i) {
            group.store(to[i].propagating, to[i].propagating_stride, squares[i] > V(0));
        }
        if (!any) return;
        V q, q_real;
        Vector3<V> k, ray;
        for (std::size_t i = 0; i < 2; ++i) {
            const Mask<V> propagating = squares[i] > V(0);
            if (uniaxial || i == 0) {
                q = sign * sqrt(abs(squares[i]));
                q_real = select<V>(propagating, q, V(0));
                k = kt + q_real * normal;
            }
            if constexpr (uniaxial) {
                if (rays) ray = unit(select<V>(propagating, energy_flow<true>(medium, k, i), kt));
            } else if (rays && i == 0) {
                ray = (medium.inverse_o * medium.n_o) * k;
                if (!all_of(propagating)) ray = select<V>(propagating, ray, unit(kt));
            }
            group.store(to[i].k.real, k);
            if (wanted(to[i].k.imag)) group.store(to[i].k.imag, (q - q_real) * normal);
            if (to[i].n_phase.data) group.store(to[i].n_phase, sqrt(norm_of(k)));
            group.store(to[i].ray, ray);
            if (to[i].n_ray.data) group.store(to[i].n_ray, dot(k, ray));
        }
    }

    /// Whether both media are isotropic or stand upright on the face; then solves it.
    template <bool from_uniaxial, bool to_uniaxial>
    [[gnu::flatten]] bool fresnel_group(const Group<V>& group, const MediumLanes<V>& from,
                                        const MediumLanes<V>& to, const Vector3<V>& normal,
                                        const Incident<V, from_uniaxial>& in) const {
        if constexpr (from_uniaxial) {
            if (!all_of(parallel(from.axis, normal))) return false;
        }
        if constexpr (to_uniaxial) {
            if (!all_of(parallel(to.axis, normal))) return false;
        }
        const V q1 = dot(normal, in.k);
        const Vector3<V> kt = in.k - q1 * normal;
        // Along the axis the polarisation is the incident wave's own.
        if (from_uniaxial && any_of(norm_of(kt) < number<V>(1e-6) * from.n_o)) return false;
        V q_o2 = q1 * q1;
        if (from_uniaxial && second) {
            q_o2 = from.n_e * from.n_e / (from.n_o * from.n_o) * q_o2 -
                   (from.n_e - from.n_o) * (from.n_e + from.n_o);
        }
        const Upright<V, from_uniaxial> near(from, normal, q_o2);
        const Upright<V, to_uniaxial> far(to, normal,
                                          q_o2 + (to.n_o - from.n_o) * (to.n_o + from.n_o));
        const Fresnel<V> f(near, far, q1, second);
        const Mask<V> left = !(q1 > number<V>(least_flux));
        if (any_of(left)) leave(group, left);
        write_incident(group, in);
        group.store(result.reflected_total.power, f.r_power);
        group.store(result.transmitted_total.power, f.t_power);
        for (std::size_t i = 0; i < 2; ++i) {
            const bool own = i == static_cast<std::size_t>(second);
            const V zero(0);
            const WaveColumns &r = result.reflected[i], &t = result.transmitted[i];
            group.store(r.power, own ? f.r_power : zero);
            group.store(t.power, own ? f.t_power : zero);
            group.store(r.amplitude_real, own ? f.r_real : zero);
            group.store(r.amplitude_imag, own ? f.r_imag : zero);
            group.store(t.amplitude_real, own ? f.t_real : zero);
            group.store(t.amplitude_imag, own ? f.t_imag : zero);
        }
        write_upright<from_uniaxial>(group, from, kt, normal, near.q2, V(-1), result.reflected);
        write_upright<to_uniaxial>(group, to, kt, normal, far.q2, V(1), result.transmitted);
        return true;
    }

    static Mask<V> parallel(const Vector3<V>& a, const Vector3<V>& b) {
        const V sign = copysign(V(1), dot(a, b));
        return a.x == sign * b.x && a.y == sign * b.y && a.z == sign * b.z;
    }

    template <bool from_uniaxial, bool to_uniaxial>
    void one_group(const Group<V>& group, const MediumLanes<V>& from,
                   const MediumLanes<V>& to) const {
        const Vector3<V> normal = group.load(faces.normal);
        const Incident<V, from_uniaxial> in(from, group.load(faces.direction), second,
                                            faces.by == By::ray);
        if (!fields && fresnel_group<from_uniaxial, to_uniaxial>(group, from, to, normal, in))
            return;
        const Frame<V> frame(normal, in.k);
        const Vector3<V> E = in.field(from, frame, second), H = cross(in.k, E);
        Mask<V> left = !(dot(cross(E, H), normal) > number<V>(least_flux));
        Seen<V, from_uniaxial> near(from, frame);
        Seen<V, to_uniaxial> far(to, frame);
        near.adopt(frame.kn, second);
        far.complete(near.q_o2 + (to.n_o - from.n_o) * (to.n_o + from.n_o));
        const Mask<V> real = near.all_real() && far.all_real();
        if constexpr (to_uniaxial) left = left || merging(far, V(1));
        if (!all_of(left)) {
            write_incident(group, in);
            group.store(result.incident.E, E);
            group.store(result.incident.H, H);
            if (all_of(real)) {
                solve<V>(group, frame, from, to, near, far, E);
            } else {
                solve<Cx<V>>(group, frame, from, to, near, far, E);
            }
        }
        if (any_of(left)) leave(group, left);
    }

    template <bool from_uniaxial, bool to_uniaxial>
    void run(std::size_t begin, std::size_t end) const {
        const auto group_at = [&](std::size_t i) {
            const std::size_t rest = end - i;
            return Group<V>{i, rest < V::size() ? rest : V::size()};
        };
        if (faces.from.stride == 0 && faces.to.stride == 0) {
            const MediumLanes<V> from = group_at(begin).load(faces.from),
                                 to = group_at(begin).load(faces.to);
            for (std::size_t i = begin; i < end; i += V::size()) {
                one_group<from_uniaxial, to_uniaxial>(group_at(i), from, to);
            }
            return;
        }
        for (std::size_t i = begin; i < end; i += V::size()) {
            const Group<V> group = group_at(i);
            one_group<from_uniaxial, to_uniaxial>(group, group.load(faces.from),
                                                  group.load(faces.to));
        }
    }
};

}  // namespace icespar::lanes
