// How each kind of interface case is drawn.
#include <algorithm>
#include <numbers>

#include "support/interface_cases.hpp"

namespace icespar::testing {

namespace {

Vec3 times_epsilon(const Medium& m, const Vec3& v) {
    return m.n_o * m.n_o * v + (m.n_e * m.n_e - m.n_o * m.n_o) * dot(v, m.axis) * m.axis;
}

Vec3 ray_of(const Medium& m, Mode mode, const Vec3& direction) {
    return mode == Mode::extraordinary ? normalised(times_epsilon(m, direction)) : direction;
}

double index_along(const Medium& m, Mode mode, const Vec3& direction) {
    if (mode != Mode::extraordinary) return m.n_o;
    return m.n_o * m.n_e / std::sqrt(dot(direction, times_epsilon(m, direction)));
}

Medium crystal(Random& random, const Vec3& axis) {
    const double n_o = random.uniform(1.3, 2.7);
    const double n_e = std::max(1.05, n_o + random.sign() * random.uniform(0.001, 0.4));
    return Medium::uniaxial(n_o, n_e, axis);
}

Medium any_medium(Random& random) {
    const double kind = random.uniform();
    if (kind < 0.25) return Medium::isotropic(1);
    if (kind < 0.45) return Medium::isotropic(random.uniform(1, 2.5));
    return crystal(random, random.direction());
}

Mode any_mode(Random& random, const Medium& m) {
    const bool second = random.uniform() < 0.5;
    if (m.birefringent) return second ? Mode::extraordinary : Mode::ordinary;
    return second ? Mode::p : Mode::s;
}

/// Quadratic discriminant of a mode's normal wave number; negative when the mode is evanescent.
double discriminant(const Medium& m, bool extraordinary, const Vec3& normal, const Vec3& kt) {
    if (!extraordinary) return m.n_o * m.n_o - dot(kt, kt);
    const Vec3 en = times_epsilon(m, normal);
    const double cross_term = dot(en, kt), square = dot(kt, times_epsilon(m, kt));
    return cross_term * cross_term - dot(en, normal) * (square - m.n_o * m.n_o * m.n_e * m.n_e);
}

/// Puts the direction at `angle` from the normal, in the plane of the normal and `tangent`.
void incline(InterfaceCase& c, const Vec3& tangent, double angle) {
    c.direction = normalised(std::cos(angle) * c.normal + std::sin(angle) * tangent);
}

/// The sign that a mode of one side has at an angle: its discriminant there.
double discriminant_at(InterfaceCase c, const Vec3& tangent, double angle, const Medium& side,
                       bool extraordinary) {
    incline(c, tangent, angle);
    const Vec3 k = index_along(c.from, c.mode, c.direction) * c.direction;
    return discriminant(side, extraordinary, c.normal, k - dot(k, c.normal) * c.normal);
}

/// Moves the direction to the angle where a mode of `side` turns evanescent, times 1 + offset;
/// false when there is no such angle.
bool to_critical(InterfaceCase& c, const Vec3& tangent, const Medium& side, bool extraordinary,
                 double offset) {
    double low = 0, high = std::numbers::pi / 2;
    if (discriminant_at(c, tangent, high, side, extraordinary) >= 0) return false;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (discriminant_at(c, tangent, middle, side, extraordinary) >= 0 ? low : high) = middle;
    }
    incline(c, tangent, std::min(low * (1 + offset), 1.5707));
    return true;
}

/// Draws one candidate; false when the draw does not lead to a case of this kind.
bool draw(InterfaceCase& c, Random& random, Stress stress) {
    c.normal = random.uniform() < 0.2 ? Vec3{0, 0, random.sign()} : random.direction();
    c.from = any_medium(random);
    c.to = any_medium(random);
    c.direction = random.direction();
    const auto crystal_inside = [&](const Vec3& axis) {
        (random.uniform() < 0.5 ? c.from : c.to) = crystal(random, axis);
    };
    switch (stress) {
        case Stress::normal_incidence:
            c.direction = c.normal;
            break;
        case Stress::near_normal:
            incline(c, random.perpendicular_to(c.normal), random.power_of_ten(-12, -1));
            break;
        case Stress::grazing:
            incline(c, random.perpendicular_to(c.normal),
                    std::numbers::pi / 2 - random.power_of_ten(-8.7, -1));
            break;
        case Stress::axis_on_normal:
            crystal_inside(random.sign() * c.normal);
            if (random.uniform() < 0.3) c.direction = c.normal;
            break;
        case Stress::axis_near_normal:
            crystal_inside(normalised(c.normal + random.power_of_ten(-16, -2) *
                                                     random.perpendicular_to(c.normal)));
            incline(c, random.perpendicular_to(c.normal), random.power_of_ten(-16, -2));
            break;
        case Stress::axis_on_incident:
            c.from = crystal(random, c.direction);
            if (random.uniform() < 0.7)
                c.direction = normalised(c.direction + random.power_of_ten(-17, -3) *
                                                           random.perpendicular_to(c.direction));
            break;
        case Stress::axis_in_face:
            crystal_inside(random.perpendicular_to(c.normal));
            break;
        case Stress::axis_in_plane:
            crystal_inside(normalised(c.direction + random.uniform(-2, 2) * c.normal));
            break;
        case Stress::tiny_birefringence:
            for (Medium* m : {&c.from, &c.to})
                if (m->birefringent) m->n_e = m->n_o + random.sign() * random.power_of_ten(-16, -2);
            if (!c.from.birefringent && !c.to.birefringent) return false;
            break;
        case Stress::no_birefringence:
            for (Medium* m : {&c.from, &c.to})
                if (m->birefringent) m->n_e = m->n_o;
            if (!c.from.birefringent && !c.to.birefringent) return false;
            break;
        case Stress::strong_birefringence: {
            const bool calomel = random.uniform() < 0.6;
            const double n_o = calomel ? 1.97 : random.uniform(1, 3);
            const double n_e = calomel ? 2.66 : n_o + random.uniform(0.3, 1);
            const bool negative = random.uniform() < 0.4;
            (random.uniform() < 0.5 ? c.from : c.to) =
                Medium::uniaxial(negative ? n_e : n_o, negative ? n_o : n_e, random.direction());
            break;
        }
        case Stress::high_ratio:
            c.from = Medium::isotropic(1);
            c.to = Medium::uniaxial(random.uniform(2.5, 4), random.uniform(2.5, 4),
                                    random.direction());
            if (random.uniform() < 0.5) std::swap(c.from, c.to);
            break;
        case Stress::same_medium:
            c.to = c.from;
            break;
        case Stress::same_medium_turned:
            c.from = c.to = crystal(random, random.direction());
            c.to.axis = random.direction();
            break;
        case Stress::matched_index:
            c.from = crystal(random, random.direction());
            c.to = Medium::isotropic(random.uniform() < 0.5 ? c.from.n_o : c.from.n_e);
            if (random.uniform() < 0.5) std::swap(c.from, c.to);
            break;
        case Stress::denser_outside:
            c.from = Medium::isotropic(random.uniform(1.8, 2.6));
            c.to = Medium::uniaxial(random.uniform(1.1, 1.8), random.uniform(1.1, 1.8),
                                    random.direction());
            break;
        case Stress::crystal_to_crystal:
            c.from = crystal(random, random.direction());
            c.to = crystal(random, random.direction());
            break;
        case Stress::backward_wave:
        case Stress::near_critical_reflected:
            c.from = crystal(random, random.direction());
            break;
        default:
            break;
    }
    c.mode = any_mode(random, c.from);
    if (stress == Stress::axis_on_refracted) {
        c.to = crystal(random, random.direction());
        if (dot(c.direction, c.normal) < 0) c.direction = -c.direction;
        const Vec3 k = index_along(c.from, c.mode, c.direction) * c.direction;
        const Vec3 kt = k - dot(k, c.normal) * c.normal;
        const double q2 = c.to.n_o * c.to.n_o - dot(kt, kt);
        if (q2 < 0) return false;
        c.to.axis = normalised(kt + std::sqrt(q2) * c.normal +
                               random.power_of_ten(-17, -2) * random.direction());
    }
    if (stress == Stress::near_critical || stress == Stress::near_critical_reflected) {
        const bool reflected = stress == Stress::near_critical_reflected;
        const Medium& side = reflected ? c.from : c.to;
        const bool extraordinary =
            reflected ? c.mode == Mode::ordinary : side.birefringent && random.uniform() < 0.5;
        const double offset = random.sign() * random.power_of_ten(-15.5, -3);
        return to_critical(c, random.perpendicular_to(c.normal), side, extraordinary, offset);
    }
    if (stress == Stress::critical_along_axis || stress == Stress::critical_tiny_birefringence) {
        // Both waves of one crystal turn evanescent together. Not so close to the critical angle
        // and to the axis at once that the last ulp of the inputs spans every split into o and e.
        const bool closest = random.uniform() < 0.5;
        const Vec3 tangent = random.perpendicular_to(c.normal);
        const bool reflected = c.from.birefringent && random.uniform() < 0.3;
        Medium& side = reflected ? c.from : c.to;
        if (stress == Stress::critical_along_axis) {
            const double tilt = random.power_of_ten(closest ? -6 : -17, -1);
            side = crystal(random, normalised(tangent + tilt * random.perpendicular_to(tangent)));
        } else {
            side = crystal(random, random.direction());
            side.n_e = side.n_o + random.sign() * random.power_of_ten(-16, -2);
        }
        const bool extraordinary = reflected ? c.mode == Mode::ordinary : random.uniform() < 0.5;
        const double offset = random.sign() * random.power_of_ten(closest ? -17 : -13, -3);
        return to_critical(c, tangent, side, extraordinary, offset);
    }
    if (stress == Stress::one_mode_evanescent) {
        if (!c.to.birefringent) return false;
        const Vec3 k = index_along(c.from, c.mode, c.direction) * c.direction;
        const Vec3 kt = k - dot(k, c.normal) * c.normal;
        return (discriminant(c.to, false, c.normal, kt) < 0) !=
               (discriminant(c.to, true, c.normal, kt) < 0);
    }
    if (stress == Stress::backward_wave) {
        c.mode = Mode::extraordinary;
        Vec3 t = random.perpendicular_to(c.normal);
        if (dot(t, times_epsilon(c.from, c.normal)) < 0) t = -t;
        c.direction = normalised(t - random.power_of_ten(-8, -1) * c.normal);
        return dot(times_epsilon(c.from, c.direction), c.normal) > 0;
    }
    if (stress == Stress::merging_evanescent) {
        // Axis in the face of `to` and kt . axis = n_o: there both evanescent waves become one.
        const Vec3 axis = random.perpendicular_to(c.normal), across = cross(c.normal, axis);
        c.to = Medium::uniaxial(random.uniform(1.1, 1.6), random.uniform(1.1, 1.6), axis);
        c.from = Medium::isotropic(random.uniform(2, 2.6));
        c.mode = any_mode(random, c.from);
        const double n = c.from.n_o;
        const double along = c.to.n_o * (1 + random.sign() * random.power_of_ten(-17, -2)) / n;
        const double side = random.uniform(-1, 1) * std::sqrt(1 - along * along);
        const double up = std::sqrt(1 - along * along - side * side);
        c.direction = normalised(along * axis + side * across + up * c.normal);
    }
    return true;
}

}  // namespace

InterfaceCase random_case(Random& random, Stress stress) {
    for (;;) {
        InterfaceCase c;
        if (!draw(c, random, stress)) continue;
        Vec3 ray = ray_of(c.from, c.mode, c.direction);
        if (dot(ray, c.normal) < 0) c.direction = -c.direction, ray = -ray;
        c.cos_ray = dot(ray, c.normal);
        if (c.cos_ray > 1e-9) return c;
    }
}

}  // namespace icespar::testing
