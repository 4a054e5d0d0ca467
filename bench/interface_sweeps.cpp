// Error of the interface along each axis of stress, as rows for the plots of docs/accuracy.md:
// interface_sweeps [cases a point] [seed]. CSV on standard output.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "support/general_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr double pi = std::numbers::pi;

MediumRecipe isotropic(Complex n) {
    MediumRecipe m;
    m.n = {n, n, n};
    return m;
}

MediumRecipe crystal(Random& random, Symmetry symmetry, double spread = 0.3) {
    MediumRecipe m;
    m.symmetry = symmetry;
    const double base = random.uniform(1.3, 2.2);
    m.n = {base, base + spread, base + spread * random.uniform(0.1, 0.9)};
    m.first = random.direction();
    m.second = random.perpendicular_to(m.first);
    return m;
}

/// From outside in or from inside out, any polarisation, 6 to 75 degrees from the normal.
GeneralCase ordinary(Random& random, Symmetry symmetry) {
    GeneralCase c;
    c.from = isotropic(random.uniform(1, 1.3));
    c.to = crystal(random, symmetry);
    if (random.uniform() < 0.5) std::swap(c.from, c.to);
    c.mode = random.uniform() < 0.5 ? 0 : 1;
    c.normal = random.direction();
    return c;
}

void incline(GeneralCase& c, Random& random, double angle) {
    const Vec3 along = random.perpendicular_to(c.normal);
    c.direction = normalised(std::cos(angle) * c.normal + std::sin(angle) * along);
}

void incline(GeneralCase& c, Random& random) { incline(c, random, random.uniform(0.1, 1.3)); }

/// To the angle at which a wave of the second medium grazes the face, times 1 + offset.
void to_critical(GeneralCase& c, Random& random, double offset) {
    if (c.to.symmetry == Symmetry::isotropic) std::swap(c.from, c.to);
    c.from = isotropic(random.uniform(2.6, 3));
    const Vec3 along = random.perpendicular_to(c.normal);
    const std::size_t which = random.uniform() < 0.5 ? 0 : 1;
    const auto at = [&](double angle) {
        c.direction = normalised(std::cos(angle) * c.normal + std::sin(angle) * along);
    };
    double low = 0, high = pi / 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        at(middle);
        const Interface face(c.from.medium(), c.to.medium(), c.normal, c.incident());
        (face.propagating(true, which) ? low : high) = middle;
    }
    at(low * (1 + offset));
}

/// The refracted wave normal at `distance` (radians) from an optic axis.
bool to_optic_axis(GeneralCase& c, Random& random, double distance) {
    c.from = isotropic(random.uniform(1, 2.4));
    if (c.to.symmetry == Symmetry::isotropic) return false;
    const OpticAxes axes = optic_axes(c.to.medium());
    const Vec3 axis = random.uniform() < 0.5 ? axes.first : axes.second;
    const Vec3 beside = normalised(axis + distance * random.perpendicular_to(normalised(axis)));
    const double n =
        c.to.symmetry == Symmetry::biaxial ? c.to.medium().n_principal[1] : c.to.n[0].real();
    if (dot(beside, c.normal) < 0) c.normal = -c.normal;
    const Vec3 k = n * beside, t = (k - dot(k, c.normal) * c.normal) / c.from.n[0].real();
    if (dot(t, t) > 0.99) return false;
    c.direction = normalised(t + std::sqrt(1 - dot(t, t)) * c.normal);
    return true;
}

/// Every input moved by up to one ulp, at random.
GeneralCase moved(GeneralCase c, Random& random) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    for (MediumRecipe* m : {&c.from, &c.to}) {
        for (Complex& n : m->n) {
            n = {n.real() * (1 + epsilon * random.sign()),
                 n.imag() * (1 + epsilon * random.sign())};
        }
        if (m->symmetry == Symmetry::isotropic) m->n[1] = m->n[2] = m->n[0];
        for (Vec3* v : {&m->first, &m->second}) {
            *v += 0.5 * epsilon * Vec3{random.sign(), random.sign(), random.sign()};
        }
    }
    for (Vec3* v : {&c.normal, &c.direction}) {
        *v += 0.5 * epsilon * Vec3{random.sign(), random.sign(), random.sign()};
    }
    return c;
}

using Draw = std::function<bool(GeneralCase&, Random&, double)>;

struct Axis {
    const char* name;
    std::vector<double> values;
    Draw draw;
};

std::vector<double> decades(int first, int last) {
    std::vector<double> values;
    for (int i = first; i >= last; --i) values.push_back(std::pow(10.0, i));
    return values;
}

MediumRecipe& crystal_of(GeneralCase& c) {
    return c.from.symmetry == Symmetry::isotropic ? c.to : c.from;
}

const std::vector<Axis>& axes() {
    static const std::vector<Axis> all{
        {"normal", decades(0, -12),
         [](GeneralCase& c, Random& r, double x) { return incline(c, r, x), true; }},
        {"grazing", decades(1, -7),
         [](GeneralCase& c, Random& r, double x) {
             return incline(c, r, pi / 2 - x * pi / 180), true;
         }},
        {"critical", decades(-3, -15),
         [](GeneralCase& c, Random& r, double x) { return to_critical(c, r, r.sign() * x), true; }},
        {"birefringence", decades(0, -16),
         [](GeneralCase& c, Random& r, double x) {
             // From inside, fast and slow of almost equal indices would be no determined light.
             if (c.from.symmetry == Symmetry::biaxial) std::swap(c.from, c.to);
             MediumRecipe& m = crystal_of(c);
             m.n[1] = m.n[0] + x;
             m.n[2] = m.n[0] + x * r.uniform(0.1, 0.9);
             return incline(c, r), true;
         }},
        {"ratio",
         {1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25, 3.5, 3.75, 4},
         [](GeneralCase& c, Random& r, double x) {
             MediumRecipe& m = crystal_of(c);
             MediumRecipe& other = &m == &c.to ? c.from : c.to;
             other = isotropic(m.n[0] / x);
             return incline(c, r), true;
         }},
        {"kappa",
         {1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 1, 2, 3, 5, 7, 10},
         [](GeneralCase& c, Random& r, double x) {
             if (c.to.symmetry == Symmetry::isotropic) std::swap(c.from, c.to);
             for (Complex& n : c.to.n) n += Complex(0, x * r.uniform(0.3, 1));
             return incline(c, r), true;
         }},
        {"optic_axis", decades(-2, -15), to_optic_axis},
    };
    return all;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 24;
    const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    std::printf(
        "axis,medium,x,what,median_error,largest_error,single_median,single_largest,"
        "median_change,largest_change\n");
    for (const Axis& axis : axes()) {
        for (const Symmetry symmetry : {Symmetry::uniaxial, Symmetry::biaxial}) {
            const char* medium = symmetry == Symmetry::uniaxial ? "uniaxial" : "biaxial";
            for (std::size_t point = 0; point < axis.values.size(); ++point) {
                const double x = axis.values[point];
                Random random(seed * 1000 + point);
                std::vector<double> errors[2], single[2], changes[2];
                while (errors[0].size() < static_cast<std::size_t>(count)) {
                    GeneralCase c = ordinary(random, symmetry);
                    if (!axis.draw(c, random, x) || dot(c.incident().ray, c.normal) <= 0) continue;
                    const GeneralExtent e = extent(c, moved(c, random));
                    errors[0].push_back(e.error_of_totals);
                    errors[1].push_back(e.error_of_waves);
                    single[0].push_back(e.single_error_of_totals);
                    single[1].push_back(e.single_error_of_waves);
                    changes[0].push_back(e.change_of_totals);
                    changes[1].push_back(e.change_of_waves);
                }
                for (int what = 0; what < 2; ++what) {
                    const auto& e = errors[what];
                    const auto& d = changes[what];
                    const auto& f = single[what];
                    std::printf("%s,%s,%g,%s,%.2e,%.2e,%.2e,%.2e,%.2e,%.2e\n", axis.name, medium, x,
                                what == 0 ? "totals" : "waves", median(e),
                                *std::max_element(e.begin(), e.end()), median(f),
                                *std::max_element(f.begin(), f.end()), median(d),
                                *std::max_element(d.begin(), d.end()));
                }
                std::fflush(stdout);
            }
        }
    }
}
