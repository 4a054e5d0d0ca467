// The sixty-digit boundary problem: modes of each half space from Berreman's matrix, named, then
// matched.
#include "support/maxwell_reference.hpp"

#include <algorithm>
#include <stdexcept>

namespace reference {

namespace {

Vector scaled(const Vector& v, const Cplx& factor) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}

Vector normalised(const Vector& v) { return scaled(v, Cplx(1 / hermitian_norm(v))); }

/// Orthonormal x, y, z with z along a normal and x along the tangential wave vector, which is a
/// complex multiple of a real one.
struct Frame {
    std::array<Vector, 3> axes;
    Cplx tangential = 0;

    Frame(const RealVector& normal, const Vector& k) {
        const Vector n = complexified(normal);
        Vector t = combine(Cplx(1), k, -dot(k, n), n);
        const Real size = hermitian_norm(t);
        if (size < Real("1e-45")) {
            Vector least{};
            least[abs(normal[0]) < Real("0.6") ? 0 : 1] = 1;
            t = combine(Cplx(1), least, -dot(least, n), n);
            axes[0] = normalised(t);
        } else {
            std::size_t largest = 0;
            for (std::size_t i = 1; i < 3; ++i) {
                if (norm2(t[i]) > norm2(t[largest])) largest = i;
            }
            Vector along = scaled(t, Cplx(1) / t[largest]);
            for (Cplx& z : along) z = re(z);
            axes[0] = normalised(along);
            tangential = dot(t, axes[0]);
            if (re(tangential) < 0) axes[0] = scaled(axes[0], -1), tangential = -tangential;
        }
        axes[2] = n;
        axes[1] = cross(axes[2], axes[0]);
    }
    Vector out(const Cplx& x, const Cplx& y, const Cplx& z) const {
        return combine(Cplx(1), combine(x, axes[0], y, axes[1]), z, axes[2]);
    }
    Vector in(const Vector& v) const { return {dot(v, axes[0]), dot(v, axes[1]), dot(v, axes[2])}; }
};

Vector turned(const Material& m, const Vector& v) {
    Vector out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) out[i] += Cplx(m.alpha[i][j]) * v[j];
    return out;
}

/// q (Ex, Ey, Hx, Hy) = D (Ex, Ey, Hx, Hy), from k x E = B and k x H = -D with the z components
/// eliminated: Bz = K Ey, Dz = -K Hy.
struct Berreman {
    Matrix4 d{};
    Row<4> ez{};

    Berreman(const Material& m, const Frame& frame, const Cplx& K) {
        const Cplx i(Real(0), Real(1));
        Tensor e{}, a{};
        for (int j = 0; j < 3; ++j) {
            const Vector column = frame.in(times(m.epsilon, frame.axes[j])),
                         spin = frame.in(turned(m, frame.axes[j]));
            for (int l = 0; l < 3; ++l) e[l][j] = column[l], a[l][j] = i * spin[l];
        }
        for (int column = 0; column < 4; ++column) {
            Vector E{}, H{};
            (column < 2 ? E[column] : H[column - 2]) = 1;
            // Hz - a Ez = K Ey + ...; e Ez + a Hz = -K Hy - ..., with a = i alpha.
            const Cplx b = K * E[1] + a[2][0] * E[0] + a[2][1] * E[1];
            const Cplx c =
                -K * H[1] - e[2][0] * E[0] - e[2][1] * E[1] - a[2][0] * H[0] - a[2][1] * H[1];
            E[2] = (c - a[2][2] * b) / (e[2][2] + a[2][2] * a[2][2]);
            H[2] = b + a[2][2] * E[2];
            ez[column] = E[2];
            Vector B = H, D{};
            for (int l = 0; l < 3; ++l)
                for (int j = 0; j < 3; ++j) {
                    B[l] -= a[l][j] * E[j];
                    D[l] += e[l][j] * E[j] + a[l][j] * H[j];
                }
            // k x E = (-q Ey, q Ex - K Ez, K Ey), likewise H.
            d[0][column] = B[1] + K * E[2];
            d[1][column] = -B[0];
            d[2][column] = -D[1] + K * H[2];
            d[3][column] = D[0];
        }
    }
};

/// One eigenvector: Ex, Ey, Hx, Hy of a wave whose wave vector is K x + q z.
struct Eigenwave {
    Cplx q;
    std::vector<Vector> fields;  ///< basis of the E belonging to q, in global coordinates
};

std::vector<Eigenwave> eigenwaves(const Material& m, const Frame& frame, const Cplx& K) {
    const Berreman berreman(m, frame, K);
    std::vector<Eigenwave> waves;
    for (const Cplx& q : eigenvalues(berreman.d)) {
        Matrix4 shifted = berreman.d;
        for (int i = 0; i < 4; ++i) shifted[i][i] -= q;
        Eigenwave wave{q, {}};
        for (const Vector4& x : null_space(shifted)) {
            Cplx z = 0;
            for (int j = 0; j < 4; ++j) z += berreman.ez[j] * x[j];
            wave.fields.push_back(normalised(frame.out(x[0], x[1], z)));
        }
        waves.push_back(wave);
    }
    return waves;
}

PlaneWave make_wave(const Material& m, const Vector& k, const Vector& E, bool propagating) {
    PlaneWave w;
    w.k = k;
    w.E = normalised(E);
    w.H = combine(Cplx(1), cross(k, w.E), Cplx(Real(0), Real(1)), turned(m, w.E));
    const Vector h{conjugate(w.H[0]), conjugate(w.H[1]), conjugate(w.H[2])};
    const Vector flow = cross(w.E, h);
    w.flow = {re(flow[0]), re(flow[1]), re(flow[2])};
    w.propagating = propagating;
    return w;
}

/// The polarisations that define the two modes at k, each zero where it is undetermined.
std::array<Vector, 2> named_polarisations(const Material& m, const Vector& k,
                                          const Vector& face_normal) {
    if (m.modes == Material::Modes::s_p) {
        const Vector s = cross(face_normal, k);
        return {s, cross(k, s)};
    }
    const Vector axis = complexified(m.axis);
    return {cross(k, axis), combine(Cplx(1), axis, -dot(k, axis) / m.epsilon_o, k)};
}

/// The two waves of one half space in the order of their names.
std::array<PlaneWave, 2> named(const Material& m, const Frame& frame, std::vector<Eigenwave> pair,
                               const Vector& face_normal) {
    const auto k_of = [&](const Cplx& q) { return frame.out(frame.tangential, Cplx(0), q); };
    const Real tiny("1e-25");
    if (m.modes == Material::Modes::fast_slow) {
        if (re(pair[0].q * pair[0].q) > re(pair[1].q * pair[1].q)) std::swap(pair[0], pair[1]);
    } else if (m.modes == Material::Modes::o_e) {
        const auto off_sphere = [&](const Eigenwave& w) {
            const Vector k = k_of(w.q);
            return norm2(dot(k, k) - m.epsilon_o);
        };
        if (off_sphere(pair[0]) > off_sphere(pair[1])) std::swap(pair[0], pair[1]);
    }
    std::array<PlaneWave, 2> waves;
    for (int mode = 0; mode < 2; ++mode) {
        const Cplx q = pair[mode].q;
        const Vector k = k_of(q);
        Vector E = pair[mode].fields[0];
        const bool free_choice = pair[mode].fields.size() > 1;
        if (m.modes == Material::Modes::fast_slow) {
            if (free_choice) E = pair[mode].fields[mode];
        } else {
            // The named polarisation spans the null space (residual() shows it), and keeps its
            // digits where two eigenvalues nearly meet and the null space of one is lost in that of
            // both.
            const auto model = named_polarisations(m, k, face_normal);
            if (hermitian_norm(model[0]) > Real("1e-40"))
                E = model[mode];
            else if (free_choice)
                E = mode == 0 ? frame.axes[1] : cross(k, frame.axes[1]);
        }
        waves[mode] = make_wave(m, k, E, abs(im(q)) < tiny);
    }
    return waves;
}

/// The four waves for tangential wave number K, those that carry energy or decay along sign * z
/// first.
std::vector<Eigenwave> ranked(const Material& m, const Frame& frame, const Real& K, int sign) {
    struct Ranked {
        Real along;
        Eigenwave wave;
    };
    std::vector<Ranked> all;
    const RealVector z{re(frame.axes[2][0]), re(frame.axes[2][1]), re(frame.axes[2][2])};
    for (const Eigenwave& w : eigenwaves(m, frame, Cplx(K))) {
        const Vector k = frame.out(Cplx(K), Cplx(0), w.q);
        const bool decays = abs(im(w.q)) >= Real("1e-25");
        const Real along = decays ? im(w.q) : dot(make_wave(m, k, w.fields[0], true).flow, z);
        all.push_back({sign * along, w});
    }
    std::sort(all.begin(), all.end(),
              [](const Ranked& a, const Ranked& b) { return a.along > b.along; });
    if (all[1].along < 0 || all[2].along > 0)
        throw std::runtime_error("reference: the outgoing waves are not two");
    return {all[0].wave, all[1].wave, all[2].wave, all[3].wave};
}

/// Puts `waves` in the order of `before`, which they continue; false when it is not certain which
/// of them continue the first two.
bool continued(const std::vector<Eigenwave>& before, std::vector<Eigenwave>& waves) {
    std::array<std::size_t, 4> order{0, 1, 2, 3}, best = order;
    Real least = -1;
    do {
        Real sum = 0;
        for (std::size_t i = 0; i < 4; ++i) sum += norm2(waves[order[i]].q - before[i].q);
        if (least < 0 || sum < least) least = sum, best = order;
    } while (std::next_permutation(order.begin(), order.end()));
    std::vector<Eigenwave> sorted;
    for (const std::size_t i : best) sorted.push_back(waves[i]);
    waves = sorted;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 2; j < 4; ++j)
            if (25 * least > norm2(waves[i].q - waves[j].q)) return false;
    return true;
}

/// The two waves that leave along sign * z. For a complex tangential wave number K they are those
/// of its real part, followed as the imaginary part grows; but `incident`, where given, comes in
/// whatever happens, and the incoming wave nearest to it goes out instead.
std::array<PlaneWave, 2> outgoing(const Material& m, const Frame& frame, int sign,
                                  const Vector& face_normal, const Cplx* incident = nullptr) {
    const Real a = re(frame.tangential), b = im(frame.tangential);
    std::vector<Eigenwave> waves = ranked(m, frame, a, sign);
    Real at = 0, step = b == 0 ? Real(1) : Real("0.1");
    while (b != 0 && at < 1) {
        const Real next = std::min(Real(at + step), Real(1));
        auto moved = eigenwaves(m, frame, Cplx(a, next * b));
        if (continued(waves, moved)) {
            waves = moved, at = next, step *= 2;
        } else {
            step /= 4;
            if (step < Real("1e-30")) throw std::runtime_error("reference: lost its waves");
        }
    }
    if (incident) {
        const auto off = [&](std::size_t i) { return norm2(waves[i].q - *incident); };
        const std::size_t out = off(0) < off(1) ? 0 : 1, in = off(2) < off(3) ? 2 : 3;
        if (off(out) < Real("1e-60") && off(out) < off(in)) std::swap(waves[out], waves[in]);
    }
    return named(m, frame, {waves[0], waves[1]}, face_normal);
}

}  // namespace

PlaneWave wave_along(const Material& m, int mode, const Double3& direction,
                     const Double3& face_normal) {
    // A face across the wave normal, with no tangential wave vector, has the waves of that normal.
    const Frame frame(unit(direction), Vector{});
    return outgoing(m, frame, 1, complexified(unit(face_normal)))[mode];
}

Solution solve(const Material& from, const Material& to, const Double3& normal,
               const Double3& direction, int mode) {
    Solution s;
    const RealVector n = unit(normal);
    const Vector face_normal = complexified(n);
    s.incident = wave_along(from, mode, direction, normal);
    s.normal_flux = dot(s.incident.flow, n);
    const Frame frame(n, s.incident.k);
    const Cplx incident_q = dot(s.incident.k, face_normal);
    s.reflected =
        outgoing(from, frame, -1, face_normal, im(frame.tangential) != 0 ? &incident_q : nullptr);
    s.transmitted = outgoing(to, frame, 1, face_normal);

    // Incident + reflected - transmitted has no tangential E or H.
    const auto tangential = [&](const PlaneWave& w) -> Vector4 {
        return {dot(w.E, frame.axes[0]), dot(w.E, frame.axes[1]), dot(w.H, frame.axes[0]),
                dot(w.H, frame.axes[1])};
    };
    Matrix4 a;
    Vector4 b = tangential(s.incident);
    for (int m = 0; m < 2; ++m) {
        const Vector4 r = tangential(s.reflected[m]), t = tangential(s.transmitted[m]);
        for (int i = 0; i < 4; ++i) a[i][m] = -r[i], a[i][2 + m] = t[i];
    }
    const Vector4 x = solve_linear(a, b);
    for (int m = 0; m < 2; ++m)
        s.reflected[m].amplitude = x[m], s.transmitted[m].amplitude = x[2 + m];
    for (auto* side : {&s.reflected, &s.transmitted})
        for (PlaneWave& w : *side)
            w.power = w.propagating ? Real(norm2(w.amplitude) * abs(dot(w.flow, n)) / s.normal_flux)
                                    : Real(0);
    s.reflected_field = combine(x[0], s.reflected[0].E, x[1], s.reflected[1].E);
    s.transmitted_field = combine(x[2], s.transmitted[0].E, x[3], s.transmitted[1].E);
    return s;
}

Real residual(const Solution& s, const Material& from, const Material& to, const Double3& normal) {
    Real worst = 0;
    const auto check = [&](const PlaneWave& w, const Material& m) {
        const Cplx i(Real(0), Real(1));
        const Vector B = combine(Cplx(1), w.H, -i, turned(m, w.E)),
                     D = combine(Cplx(1), times(m.epsilon, w.E), i, turned(m, w.H));
        const Vector faraday = combine(Cplx(1), cross(w.k, w.E), Cplx(-1), B);
        const Vector ampere = combine(Cplx(1), cross(w.k, w.H), Cplx(1), D);
        worst = std::max({worst, hermitian_norm(faraday), hermitian_norm(ampere),
                          Real(abs(hermitian_norm(w.E) - 1))});
    };
    check(s.incident, from);
    for (const auto& w : s.reflected) check(w, from);
    for (const auto& w : s.transmitted) check(w, to);
    const Vector n = complexified(unit(normal));
    for (Vector PlaneWave::*field : {&PlaneWave::E, &PlaneWave::H}) {
        Vector jump = s.incident.*field;
        for (const auto& w : s.reflected) jump = combine(Cplx(1), jump, w.amplitude, w.*field);
        for (const auto& w : s.transmitted) jump = combine(Cplx(1), jump, -w.amplitude, w.*field);
        worst = std::max(worst, hermitian_norm(cross(n, jump)));
    }
    return worst;
}

}  // namespace reference
