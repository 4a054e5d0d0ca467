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

/// Orthonormal x, y, z with z along a normal and x along the tangential wave vector.
struct Frame {
    std::array<Vector, 3> axes;
    Real tangential = 0;  ///< size of the tangential wave vector

    Frame(const RealVector& normal, const Vector& k) {
        const Vector n = complexified(normal);
        Vector t = combine(Cplx(1), k, -dot(k, n), n);
        tangential = hermitian_norm(t);
        if (tangential < Real("1e-45")) {
            tangential = 0;
            Vector least{};
            least[abs(normal[0]) < Real("0.6") ? 0 : 1] = 1;
            t = combine(Cplx(1), least, -dot(least, n), n);
        }
        axes = {normalised(t), Vector{}, n};
        axes[1] = cross(axes[2], axes[0]);
    }
    Vector out(const Cplx& x, const Cplx& y, const Cplx& z) const {
        return combine(Cplx(1), combine(x, axes[0], y, axes[1]), z, axes[2]);
    }
    Vector in(const Vector& v) const { return {dot(v, axes[0]), dot(v, axes[1]), dot(v, axes[2])}; }
};

/// One eigenvector: Ex, Ey, Hx, Hy of a wave whose wave vector is K x + q z.
struct Eigenwave {
    Cplx q;
    std::vector<Vector> fields;  ///< basis of the E belonging to q, in global coordinates
};

/// q (Ex, Ey, Hx, Hy) = D (Ex, Ey, Hx, Hy), from k x E = H and k x H = -epsilon E with the z
/// components eliminated: epsilon_zz Ez = -epsilon_zx Ex - epsilon_zy Ey - K Hy, Hz = K Ey.
std::vector<Eigenwave> eigenwaves(const Material& m, const Frame& frame) {
    Tensor e{};
    for (int j = 0; j < 3; ++j) {
        const Vector column = frame.in(times(m.epsilon, frame.axes[j]));
        for (int i = 0; i < 3; ++i) e[i][j] = column[i];
    }
    const Cplx K(frame.tangential);
    const Row<4> ez{-e[2][0] / e[2][2], -e[2][1] / e[2][2], Cplx(0), -K / e[2][2]};
    Matrix4 d{};
    for (int j = 0; j < 4; ++j) {
        d[0][j] = K * ez[j];
        d[2][j] = -e[1][2] * ez[j];
        d[3][j] = e[0][2] * ez[j];
    }
    d[0][3] += 1;
    d[1][2] -= 1;
    d[2][0] -= e[1][0];
    d[2][1] += K * K - e[1][1];
    d[3][0] += e[0][0];
    d[3][1] += e[0][1];

    std::vector<Eigenwave> waves;
    for (const Cplx& q : eigenvalues(d)) {
        Matrix4 shifted = d;
        for (int i = 0; i < 4; ++i) shifted[i][i] -= q;
        Eigenwave wave{q, {}};
        for (const Vector4& x : null_space(shifted)) {
            Cplx z = 0;
            for (int j = 0; j < 4; ++j) z += ez[j] * x[j];
            wave.fields.push_back(normalised(frame.out(x[0], x[1], z)));
        }
        waves.push_back(wave);
    }
    return waves;
}

PlaneWave make_wave(const Vector& k, const Vector& E, bool propagating) {
    PlaneWave w;
    w.k = k;
    w.E = normalised(E);
    w.H = cross(k, w.E);
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
    const auto k_of = [&](const Cplx& q) { return frame.out(Cplx(frame.tangential), Cplx(0), q); };
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
        waves[mode] = make_wave(k, E, abs(im(q)) < tiny);
    }
    return waves;
}

/// The two waves that carry energy, or decay, along sign * z.
std::array<PlaneWave, 2> outgoing(const Material& m, const Frame& frame, int sign,
                                  const Vector& face_normal) {
    struct Ranked {
        Real along;
        Eigenwave wave;
    };
    std::vector<Ranked> ranked;
    const RealVector z{re(frame.axes[2][0]), re(frame.axes[2][1]), re(frame.axes[2][2])};
    for (const Eigenwave& w : eigenwaves(m, frame)) {
        const Vector k = frame.out(Cplx(frame.tangential), Cplx(0), w.q);
        const bool decays = abs(im(w.q)) >= Real("1e-25");
        const Real along = decays ? im(w.q) : dot(make_wave(k, w.fields[0], true).flow, z);
        ranked.push_back({sign * along, w});
    }
    std::sort(ranked.begin(), ranked.end(),
              [](const Ranked& a, const Ranked& b) { return a.along > b.along; });
    if (ranked[1].along < 0 || ranked[2].along > 0)
        throw std::runtime_error("reference: the outgoing waves are not two");
    return named(m, frame, {ranked[0].wave, ranked[1].wave}, face_normal);
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
    s.reflected = outgoing(from, frame, -1, face_normal);
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
        const Vector faraday = combine(Cplx(1), cross(w.k, w.E), Cplx(-1), w.H);
        const Vector ampere = combine(Cplx(1), cross(w.k, w.H), Cplx(1), times(m.epsilon, w.E));
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
