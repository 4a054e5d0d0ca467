// How faces between any two media are drawn.
#include "support/general_cases.hpp"

#include <numbers>
#include <sstream>

namespace icespar::testing {

const char* name(GeneralStress stress) {
    static constexpr std::array<const char*, static_cast<std::size_t>(GeneralStress::count)> names{
        "into biaxial",
        "out of biaxial",
        "biaxial to biaxial",
        "normal incidence",
        "near normal",
        "grazing",
        "near critical",
        "total reflection",
        "optic axis refracted",
        "optic axis incident",
        "optic axis along normal",
        "principal plane",
        "weak biaxiality",
        "almost uniaxial",
        "no biaxiality",
        "strong biaxiality",
        "same medium",
        "backward wave",
        "absorbing isotropic",
        "absorbing uniaxial",
        "absorbing biaxial",
        "absorbing triclinic",
        "weak absorption",
        "strong absorption",
        "one lossy axis",
        "near critical inside",
        "matched index",
        "absorbing incident",
        "absorbing incident grazing",
        "absorbing to absorbing",
        "active second",
        "active first",
        "active both",
        "weak activity",
        "active near axis",
        "active grazing",
        "active near critical"};
    return names[static_cast<std::size_t>(stress)];
}

bool MediumRecipe::absorbing() const {
    return n[0].imag() > 0 || n[1].imag() > 0 || n[2].imag() > 0 || skew != Complex(0);
}

Medium MediumRecipe::medium() const {
    if (symmetry == Symmetry::isotropic) return Medium::isotropic(n[0]);
    if (symmetry == Symmetry::uniaxial) {
        Medium m = Medium::uniaxial(n[0], n[1], first);
        m.gyration = gyration;
        m.gyration_along = gyration_along;
        return m;
    }
    Medium m = Medium::biaxial(n, first, second);
    if (skew != Complex(0)) {
        const Vec3 a = normalised(first), b = normalised(second - dot(second, a) * a);
        const ComplexTensor t = m.permittivity() + skew * complexified(dyad(Vec3(a + b))) +
                                (-skew) * complexified(dyad(Vec3(a - b)));
        m = Medium::from_tensor({{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}});
    }
    return m;
}

reference::Material MediumRecipe::material() const {
    using namespace reference;
    const auto array = [](const Vec3& v) { return Double3{v.x, v.y, v.z}; };
    if (!absorbing() && symmetry == Symmetry::isotropic) return Material::isotropic(n[0].real());
    const bool active = gyration != 0 || gyration_along != 0;
    if (!absorbing() && !active && symmetry == Symmetry::uniaxial) {
        return Material::uniaxial(n[0].real(), n[1].real(), array(first));
    }
    const auto square = [](const Complex& z) {
        const Cplx w(Real(z.real()), Real(z.imag()));
        return Cplx(w * w);
    };
    Material m;
    m.modes = symmetry == Symmetry::isotropic             ? Material::Modes::s_p
              : symmetry == Symmetry::uniaxial && !active ? Material::Modes::o_e
                                                          : Material::Modes::fast_slow;
    const RealVector a = unit(array(first));
    m.axis = a;
    m.epsilon_o = square(n[0]);
    std::array<Cplx, 3> e{square(n[0]), square(n[1]), square(n[2])};
    if (symmetry == Symmetry::isotropic) e = {e[0], e[0], e[0]};
    if (symmetry == Symmetry::biaxial && n[0] == n[1] && n[0] == n[2] && skew == Complex(0)) {
        for (std::size_t i = 0; i < 3; ++i) m.epsilon[i][i] = e[0];
        return m;
    }
    if (symmetry == Symmetry::uniaxial) e = {e[1], e[0], e[0]};
    RealVector b{Real(second.x), Real(second.y), Real(second.z)};
    if (symmetry != Symmetry::biaxial) {
        const bool x = std::abs(first.x) < 0.6;
        b = {Real(x ? 1 : 0), Real(x ? 0 : 1), Real(0)};
    }
    const Real along = reference::dot(a, b);
    for (std::size_t i = 0; i < 3; ++i) b[i] -= along * a[i];
    const Real size = sqrt(reference::dot(b, b));
    for (auto& x : b) x /= size;
    const RealVector c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0]};
    const Cplx s(Real(2 * skew.real()), Real(2 * skew.imag()));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            m.alpha[i][j] = (i == j ? Real(gyration) : Real(0)) +
                            (Real(gyration_along) - Real(gyration)) * a[i] * a[j];
            m.epsilon[i][j] = e[0] * Cplx(Real(a[i] * a[j])) + e[1] * Cplx(Real(b[i] * b[j])) +
                              e[2] * Cplx(Real(c[i] * c[j])) +
                              s * Cplx(Real(a[i] * b[j] + b[i] * a[j]));
        }
    }
    return m;
}

std::string GeneralCase::text() const {
    std::ostringstream out;
    out.precision(17);
    const auto vector = [&](const Vec3& v) {
        out << "{" << v.x << ", " << v.y << ", " << v.z << "}";
    };
    const auto recipe = [&](const MediumRecipe& m) {
        out << "{Symmetry(" << static_cast<int>(m.symmetry) << "), {";
        for (const Complex& n : m.n) out << "Complex" << n << ", ";
        out << "}, ", vector(m.first), out << ", ", vector(m.second),
            out << ", " << m.gyration << ", " << m.gyration_along << ", Complex" << m.skew << "}";
    };
    recipe(from), out << " -> ", recipe(to), out << " normal ", vector(normal);
    out << " direction ", vector(direction), out << " mode " << mode;
    return out.str();
}

Wave GeneralCase::incident() const {
    const Medium m = from.medium();
    return plane_wave(m, modes_of(m)[mode], direction, By::wave_normal, normal);
}

namespace {

MediumRecipe biaxial(Random& random, double spread = 0.3) {
    MediumRecipe m;
    m.symmetry = Symmetry::biaxial;
    const double base = random.uniform(1.3, 2.2);
    for (auto& n : m.n) n = base + random.uniform(0, spread);
    m.first = random.direction();
    m.second = random.perpendicular_to(m.first);
    return m;
}

MediumRecipe plain(Random& random) {
    MediumRecipe m;
    const double kind = random.uniform();
    m.n = {1, 1, 1};
    if (kind < 0.4) return m;
    m.n[0] = random.uniform(1, 2.5);
    if (kind < 0.7) return m;
    m.symmetry = Symmetry::uniaxial;
    m.n[1] = m.n[0] + random.uniform(0.0, 0.4);
    m.first = random.direction();
    return m;
}

MediumRecipe any(Random& random) {
    return random.uniform() < 0.5 ? plain(random) : biaxial(random);
}

Complex lossy(Random& random, double kappa) {
    return {random.uniform(0.3, 3), kappa * random.uniform(0.1, 1)};
}

void make_lossy(Random& random, MediumRecipe& m, double kappa) {
    for (auto& n : m.n) n = lossy(random, kappa);
}

MediumRecipe active(Random& random, double size) {
    MediumRecipe m;
    m.symmetry = Symmetry::uniaxial;
    m.n[0] = random.uniform(1.3, 2.2);
    m.n[1] = m.n[0] + random.uniform(-0.2, 0.2);
    m.first = random.direction();
    m.gyration = random.sign() * size * random.uniform(0.1, 1);
    m.gyration_along = random.uniform(-1, 1) * size;
    return m;
}

void incline(GeneralCase& c, const Vec3& tangent, double angle) {
    c.direction = normalised(std::cos(angle) * c.normal + std::sin(angle) * tangent);
}

/// The inclination, by bisection, beyond which a wave on the far side no longer propagates.
double critical_angle(GeneralCase& c, const Vec3& tangent, std::size_t which) {
    double low = 0, high = std::numbers::pi / 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        incline(c, tangent, middle);
        const Wave in = c.incident();
        if (dot(in.ray, c.normal) <= 0) {
            high = middle;
            continue;
        }
        const Interface face(c.from.medium(), c.to.medium(), c.normal, in);
        (face.propagating(true, which) ? low : high) = middle;
    }
    return low;
}

bool draw(GeneralCase& c, Random& random, GeneralStress stress) {
    c.normal = random.uniform() < 0.2 ? Vec3{0, 0, random.sign()} : random.direction();
    c.direction = random.direction();
    c.from = any(random);
    c.to = biaxial(random);
    if (random.uniform() < 0.4) std::swap(c.from, c.to);
    c.mode = random.uniform() < 0.5 ? 0 : 1;
    const auto along_face = [&] { return random.perpendicular_to(c.normal); };
    const auto absorbing_side = [&](Symmetry s, double kappa) {
        c.from = any(random);
        c.to = biaxial(random);
        c.to.symmetry = s;
        make_lossy(random, c.to, kappa);
    };
    switch (stress) {
        case GeneralStress::into_biaxial:
            c.from = plain(random);
            c.to = biaxial(random);
            break;
        case GeneralStress::out_of_biaxial:
            c.from = biaxial(random);
            c.to = plain(random);
            break;
        case GeneralStress::biaxial_to_biaxial:
            c.from = biaxial(random);
            c.to = biaxial(random);
            break;
        case GeneralStress::normal_incidence:
            c.direction = c.normal;
            break;
        case GeneralStress::near_normal:
            incline(c, along_face(), random.power_of_ten(-12, -1));
            break;
        case GeneralStress::grazing:
            incline(c, along_face(), std::numbers::pi / 2 - random.power_of_ten(-8.7, -1));
            break;
        case GeneralStress::total_reflection:
            c.from = random.uniform() < 0.5 ? biaxial(random) : plain(random);
            c.from.n = {2.6, 2.7, 2.65};
            c.to = biaxial(random, 0.2);
            incline(c, along_face(), random.uniform(0.8, 1.5));
            break;
        case GeneralStress::near_critical: {
            // From glass to the angle where a wave of the crystal grazes, by bisection.
            c.from = MediumRecipe{};
            c.from.n[0] = random.uniform(2.2, 2.6);
            c.to = biaxial(random, 0.2);
            const Vec3 t = along_face();
            const std::size_t which = random.uniform() < 0.5 ? 0 : 1;
            const double low = critical_angle(c, t, which);
            incline(c, t, low * (1 + random.sign() * random.power_of_ten(-15.5, -3)));
            break;
        }
        case GeneralStress::optic_axis_refracted:
        case GeneralStress::optic_axis_along_normal: {
            c.from = MediumRecipe{};
            c.from.n[0] = random.uniform(1, 2.4);
            c.to = biaxial(random);
            const OpticAxes axes = optic_axes(c.to.medium());
            const Vec3 axis = normalised((random.uniform() < 0.5 ? axes.first : axes.second) +
                                         random.power_of_ten(-17, -2) * random.direction());
            if (stress == GeneralStress::optic_axis_along_normal) {
                c.normal = c.direction = normalised(axis);
                break;
            }
            const Vec3 k = c.to.medium().n_principal[1] * axis;
            if (dot(k, c.normal) < 0) c.normal = -c.normal;
            const Vec3 t = (1 / c.from.n[0].real()) * (k - dot(k, c.normal) * c.normal);
            if (dot(t, t) > 0.999) return false;
            c.direction = normalised(t + std::sqrt(1 - dot(t, t)) * c.normal);
            break;
        }
        case GeneralStress::optic_axis_incident: {
            c.from = biaxial(random);
            c.to = any(random);
            const OpticAxes axes = optic_axes(c.from.medium());
            c.direction = normalised((random.uniform() < 0.5 ? axes.first : axes.second) +
                                     random.power_of_ten(-17, -2) * random.direction());
            break;
        }
        case GeneralStress::principal_plane: {
            MediumRecipe& m = c.to.symmetry == Symmetry::biaxial ? c.to : c.from;
            const double kind = random.uniform();
            if (kind < 0.6) m.first = c.normal, m.second = along_face();
            if (kind < 0.3) {
                incline(c, m.second, random.uniform(-1.5, 1.5));
            } else if (kind > 0.8) {
                m.first = {1, 0, 0}, m.second = {0, 1, 0}, c.normal = {0, 0, 1};
            }
            break;
        }
        case GeneralStress::weak_biaxiality:
            for (MediumRecipe* m : {&c.from, &c.to}) {
                if (m->symmetry != Symmetry::biaxial) continue;
                const double size = random.power_of_ten(-15, 0);
                m->n[1] = m->n[0] + size * random.uniform();
                m->n[2] = m->n[0] + size * random.uniform();
            }
            break;
        case GeneralStress::almost_uniaxial:
            for (MediumRecipe* m : {&c.from, &c.to}) {
                if (m->symmetry == Symmetry::biaxial)
                    m->n[1] = m->n[0] + random.power_of_ten(-15, -2);
            }
            break;
        case GeneralStress::no_biaxiality:
            for (MediumRecipe* m : {&c.from, &c.to}) {
                if (m->symmetry != Symmetry::biaxial) continue;
                m->n[1] = m->n[0];
            }
            break;
        case GeneralStress::strong_biaxiality:
            for (MediumRecipe* m : {&c.from, &c.to}) {
                if (m->symmetry == Symmetry::biaxial) {
                    for (auto& n : m->n) n = random.uniform(1.2, 3.5);
                }
            }
            break;
        case GeneralStress::same_medium:
            c.to = c.from = biaxial(random);
            break;
        case GeneralStress::backward_wave:
            c.from = biaxial(random, 0.8);
            incline(c, along_face(), std::numbers::pi / 2 + random.power_of_ten(-8, -1));
            break;
        case GeneralStress::absorbing_isotropic:
            absorbing_side(Symmetry::isotropic, random.power_of_ten(-6, 1));
            break;
        case GeneralStress::absorbing_uniaxial:
            absorbing_side(Symmetry::uniaxial, random.power_of_ten(-6, 1));
            break;
        case GeneralStress::absorbing_biaxial:
            absorbing_side(Symmetry::biaxial, random.power_of_ten(-6, 1));
            break;
        case GeneralStress::absorbing_triclinic:
            absorbing_side(Symmetry::biaxial, random.power_of_ten(-4, 0.5));
            c.to.skew = Complex(
                random.uniform(-0.1, 0.1),
                0.2 * random.uniform(-1, 1) *
                    std::min({(c.to.n[0] * c.to.n[0]).imag(), (c.to.n[1] * c.to.n[1]).imag()}));
            break;
        case GeneralStress::weak_absorption:
            c.to = biaxial(random);
            if (random.uniform() < 0.3) c.to.symmetry = Symmetry::uniaxial;
            for (auto& n : c.to.n) n += Complex(0, random.power_of_ten(-17, -6));
            c.from = any(random);
            break;
        case GeneralStress::strong_absorption:
            absorbing_side(random.uniform() < 0.5 ? Symmetry::biaxial : Symmetry::uniaxial, 10);
            break;
        case GeneralStress::one_lossy_axis:
            c.from = any(random);
            c.to = biaxial(random);
            c.to.n[static_cast<std::size_t>(random.below(3))] +=
                Complex(0, random.power_of_ten(-3, 0.5));
            break;
        case GeneralStress::near_critical_inside: {
            c.from = random.uniform() < 0.7 ? biaxial(random) : plain(random);
            for (auto& n : c.from.n) n += 0.8;
            c.to = random.uniform() < 0.5 ? biaxial(random, 0.2) : plain(random);
            if (c.from.symmetry != Symmetry::biaxial) c.to = biaxial(random, 0.2);
            const Vec3 t = along_face();
            const double low = critical_angle(c, t, random.uniform() < 0.5 ? 0 : 1);
            incline(c, t, low * (1 + random.sign() * random.power_of_ten(-15.5, -3)));
            break;
        }
        case GeneralStress::matched_index:
            c.from = plain(random);
            c.to = biaxial(random);
            c.from.n[0] = c.to.n[static_cast<std::size_t>(random.below(3))] +
                          (random.uniform() < 0.5 ? 0 : random.power_of_ten(-15, -3));
            if (random.uniform() < 0.5) std::swap(c.from, c.to);
            if (random.uniform() < 0.7) {
                incline(c, along_face(), std::numbers::pi / 2 - random.power_of_ten(-8, -0.3));
            }
            break;
        case GeneralStress::absorbing_incident:
        case GeneralStress::absorbing_incident_grazing:
        case GeneralStress::absorbing_to_absorbing: {
            const auto lossy_medium = [&] {
                MediumRecipe m = biaxial(random);
                const double kind = random.uniform();
                m.symmetry = kind < 0.3   ? Symmetry::isotropic
                             : kind < 0.6 ? Symmetry::uniaxial
                                          : Symmetry::biaxial;
                const double kappa = random.power_of_ten(-6, 0);
                for (auto& n : m.n) n += Complex(0, kappa * random.uniform(0.1, 1));
                return m;
            };
            c.from = lossy_medium();
            c.to = stress == GeneralStress::absorbing_to_absorbing ? lossy_medium() : any(random);
            if (stress == GeneralStress::absorbing_incident_grazing) {
                incline(c, along_face(), std::numbers::pi / 2 - random.power_of_ten(-6, -0.3));
            }
            break;
        }
        case GeneralStress::active_second:
        case GeneralStress::active_first:
        case GeneralStress::active_both:
        case GeneralStress::weak_activity:
        case GeneralStress::active_near_axis:
        case GeneralStress::active_grazing:
        case GeneralStress::active_near_critical: {
            const double size =
                random.power_of_ten(stress == GeneralStress::weak_activity ? -15 : -6, -1);
            c.from = active(random, size);
            c.to = stress == GeneralStress::active_both ? active(random, size) : any(random);
            const bool second = stress == GeneralStress::active_second ||
                                (stress != GeneralStress::active_first && random.uniform() < 0.5);
            if (second) std::swap(c.from, c.to);
            const MediumRecipe& m = second ? c.to : c.from;
            if (stress == GeneralStress::active_near_axis) {
                c.direction =
                    normalised(m.first + random.power_of_ten(-17, -2) * random.direction());
                if (second) c.normal = c.direction;
            } else if (stress == GeneralStress::active_grazing) {
                incline(c, along_face(), std::numbers::pi / 2 - random.power_of_ten(-8, -1));
            } else if (stress == GeneralStress::active_near_critical) {
                for (auto& n : c.from.n) n += 0.8;
                const Vec3 t = along_face();
                const double low = critical_angle(c, t, random.uniform() < 0.5 ? 0 : 1);
                incline(c, t, low * (1 + random.sign() * random.power_of_ten(-15.5, -3)));
            }
            break;
        }
        default:
            break;
    }
    return true;
}

}  // namespace

GeneralCase random_case(Random& random, GeneralStress stress) {
    for (;;) {
        GeneralCase c;
        if (!draw(c, random, stress)) continue;
        if (dot(c.incident().ray, c.normal) < 0) c.direction = -c.direction;
        c.cos_ray = dot(c.incident().ray, c.normal);
        if (c.cos_ray > 1e-9) return c;
    }
}

}  // namespace icespar::testing
