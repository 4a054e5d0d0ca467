// Chooses the code for a batch, run by run of like media, and solves face by face what it leaves.
#include "interface/batch.hpp"

#include <string>

#include "interface/interface.hpp"
#include "interface/lane_run.hpp"
#include "math/error.hpp"

namespace icespar {

namespace {

double at(const Column& column, std::size_t i) {
    return column.data[static_cast<std::ptrdiff_t>(i) * column.stride];
}
Vec3 at(const VectorColumn& column, std::size_t i) {
    return {at(column.x, i), at(column.y, i), at(column.z, i)};
}
const Medium& at(const MediumColumn& column, std::size_t i) {
    return column.data[static_cast<std::ptrdiff_t>(i) * column.stride];
}

void put(const ResultColumn& to, std::size_t i, double value) {
    if (to.data) to.data[static_cast<std::ptrdiff_t>(i) * to.stride] = value;
}
void put(const VectorResult& to, std::size_t i, const Vec3& v) {
    put(to.x, i, v.x);
    put(to.y, i, v.y);
    put(to.z, i, v.z);
}
void put(const ComplexResult& to, std::size_t i, const CVec3& v) {
    put(to.real, i, real(v));
    put(to.imag, i, {v.x.imag(), v.y.imag(), v.z.imag()});
}
/// Whether more of a wave is wanted than its amplitude, power and ray.
bool rest_wanted(const WaveColumns& to) {
    return lanes::wanted(to.k) || lanes::fields_wanted(to) || to.n_phase.data || to.n_ray.data ||
           to.propagating;
}

void put(const WaveColumns& to, std::size_t i, const Complex& amplitude, double power) {
    put(to.power, i, power);
    put(to.amplitude_real, i, amplitude.real());
    put(to.amplitude_imag, i, amplitude.imag());
}

void put(const WaveColumns& to, std::size_t i, const Wave& wave) {
    put(to.ray, i, wave.ray);
    put(to.k, i, wave.k);
    put(to.E, i, wave.E);
    put(to.H, i, wave.H);
    put(to.n_phase, i, wave.n_phase);
    put(to.n_ray, i, wave.n_ray);
    if (to.propagating) {
        to.propagating[static_cast<std::ptrdiff_t>(i) * to.propagating_stride] = wave.propagating;
    }
}

/// An outgoing wave; only what is wanted of it is worked out.
void put(const WaveColumns& to, std::size_t i, const Interface& face, bool transmitted,
         std::size_t m) {
    if (rest_wanted(to)) {
        put(to, i, transmitted ? face.transmitted(m) : face.reflected(m));
    } else if (lanes::wanted(to.ray)) {
        put(to.ray, i, face.ray(transmitted, m));
    }
}

/// The incident wave, which must carry energy through the face.
Wave arriving(const FaceBatch& faces, std::size_t i, const Medium& from, const Vec3& normal) {
    const Wave wave = plane_wave(from, faces.mode, at(faces.direction, i), faces.by, normal);
    constexpr double least_flux = 1e-140;
    if (wave.flux(normal) > least_flux) return wave;
    throw Error(
        "the energy of this wave leaves the face or runs along it; it must flow along the normal");
}

void solve_face(const FaceBatch& faces, const BatchResult& wanted, std::size_t i) {
    const Medium &from = at(faces.from, i), &to = at(faces.to, i);
    const Vec3 normal = at(faces.normal, i);
    const Wave wave = arriving(faces, i, from, normal);
    const Interface face(from, to, normal, wave);
    const Coefficients c = face.solve(wave);
    put(wanted.incident, i, 1, 1);
    put(wanted.incident, i, wave);
    for (std::size_t m = 0; m < 2; ++m) {
        put(wanted.reflected[m], i, c.reflected[m], c.reflected_power[m]);
        put(wanted.transmitted[m], i, c.transmitted[m], c.transmitted_power[m]);
        put(wanted.reflected[m], i, face, false, m);
        put(wanted.transmitted[m], i, face, true, m);
    }
    put(wanted.reflected_total.power, i, c.reflected_total);
    put(wanted.transmitted_total.power, i, c.transmitted_total);
    if (lanes::fields_wanted(wanted.reflected_total) ||
        lanes::fields_wanted(wanted.transmitted_total)) {
        const SummedFields sum = face.summed_fields(wave);
        put(wanted.reflected_total.E, i, sum.reflected_E);
        put(wanted.reflected_total.H, i, sum.reflected_H);
        put(wanted.transmitted_total.E, i, sum.transmitted_E);
        put(wanted.transmitted_total.H, i, sum.transmitted_H);
    }
}

void solve_one(const FaceBatch& faces, const BatchResult& wanted, std::size_t i) {
    try {
        solve_face(faces, wanted, i);
    } catch (const Error& error) {
        throw Error("direction[" + std::to_string(faces.first + i) + "]: " + error.what());
    }
}

/// The end of the run of media of one kind that starts at `begin`.
template <class Kind>
std::size_t end_of_run(std::size_t begin, std::size_t end, const Kind& kind) {
    const auto first = kind(begin);
    std::size_t i = begin + 1;
    while (i < end && kind(i) == first) ++i;
    return i;
}

}  // namespace

Lanes widest_lanes() {
#ifdef ICESPAR_AVX512
    static const bool wide =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl");
    if (wide) return Lanes::avx512;
#endif
    return Lanes::baseline;
}

void solve_batch(const FaceBatch& faces, const BatchResult& wanted, std::size_t begin,
                 std::size_t end, Lanes width) {
    auto run = lanes::run_baseline;
#ifdef ICESPAR_AVX512
    if (width == Lanes::avx512 && widest_lanes() == Lanes::avx512) run = lanes::run_avx512;
#endif
    // Of a medium: its symmetry, or 3 where lanes do not know it.
    constexpr int unknown = 3;
    const auto kind_of = [](const Medium& m) {
        return m.absorbing || m.active() ? unknown : static_cast<int>(m.symmetry);
    };
    const auto kind = [&](std::size_t i) {
        return 4 * kind_of(at(faces.from, i)) + kind_of(at(faces.to, i));
    };
    const bool alike = faces.from.stride == 0 && faces.to.stride == 0;
    while (begin < end) {
        const std::size_t next = alike ? end : end_of_run(begin, end, kind);
        const int from = kind(begin) / 4, to = kind(begin) % 4;
        const auto modes = modes_of(at(faces.from, begin));
        const bool fits = faces.mode == modes[0] || faces.mode == modes[1];
        const auto from_symmetry = static_cast<Symmetry>(from),
                   to_symmetry = static_cast<Symmetry>(to);
        const auto mixes = [](Symmetry a, Symmetry b) {
            return a == Symmetry::uniaxial && b == Symmetry::biaxial;
        };
        if (width == Lanes::scalar || from == unknown || to == unknown || !fits ||
            mixes(from_symmetry, to_symmetry) || mixes(to_symmetry, from_symmetry) ||
            (from_symmetry == Symmetry::biaxial && faces.by == By::ray)) {
            for (; begin < next; ++begin) solve_one(faces, wanted, begin);
        } else {
            run(faces, wanted, begin, next, from_symmetry, to_symmetry, solve_one);
        }
        begin = next;
    }
}

}  // namespace icespar
