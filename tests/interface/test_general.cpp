// Faces of biaxial, absorbing and active media agree with Maxwell in sixty digits, conserve energy
// and can be reversed; where the uniaxial solver applies too, the two agree.
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "support/general_cases.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

void check_kind(GeneralStress stress, int count, std::uint64_t seed) {
    Random random(seed + 1000 * static_cast<std::uint64_t>(stress));
    std::ostringstream report;
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        const GeneralCase c = random_case(random, stress);
        const GeneralDiscrepancy worst = compare(c);
        if (worst.excess <= 1) continue;
        if (++wrong <= 5) {
            report << worst.quantity << ": error " << worst.error << ", one ulp changes it by "
                   << worst.conditioning << "\n  " << c.text() << "\n";
        }
    }
    INFO(name(stress) << ": " << wrong << " of " << count << "\n" << report.str());
    CHECK(wrong == 0);
}

struct Answer {
    double reflected, transmitted;
    CVec3 reflected_E, transmitted_E, reflected_H, transmitted_H;
};

Answer answer(const Medium& from, const Medium& to, const Vec3& normal, const Wave& in) {
    const Interface face(from, to, normal, in);
    const Coefficients a = face.solve(in);
    const OutgoingWaves w = face.waves();
    Answer out{a.reflected_total, a.transmitted_total, {}, {}, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        out.reflected_E += a.reflected[i] * w.reflected[i].E;
        out.transmitted_E += a.transmitted[i] * w.transmitted[i].E;
        out.reflected_H += a.reflected[i] * w.reflected[i].H;
        out.transmitted_H += a.transmitted[i] * w.transmitted[i].H;
    }
    return out;
}

double distance(const Answer& a, const Answer& b) {
    return std::max(
        {std::abs(a.reflected - b.reflected), std::abs(a.transmitted - b.transmitted),
         length(a.reflected_E - b.reflected_E), length(a.transmitted_E - b.transmitted_E),
         length(a.reflected_H - b.reflected_H), length(a.transmitted_H - b.transmitted_H)});
}

}  // namespace

TEST_CASE("faces of biaxial, absorbing and active media agree with Maxwell in sixty digits",
          "[interface][general][reference]") {
    for (int stress = 0; stress < static_cast<int>(GeneralStress::count); ++stress) {
        check_kind(static_cast<GeneralStress>(stress), 10, 5);
    }
}

TEST_CASE("waves whose energy grazes a face keep their digits", "[interface][general]") {
    const auto crystal = [](Symmetry symmetry, std::array<Complex, 3> n, const Vec3& first,
                            const Vec3& second) {
        MediumRecipe m;
        m.symmetry = symmetry;
        m.n = n;
        m.first = first;
        m.second = second;
        return m;
    };
    // Found by bench/general_accuracy: k grazes the face; the ray does, beside an optic axis.
    const GeneralCase ordinary{
        crystal(Symmetry::uniaxial, {1.0655427721128612, 1.1704118725492199, 1},
                {-0.43342291236970448, 0.73563586210072129, 0.52056167494763994}, {1, 0, 0}),
        crystal(Symmetry::biaxial, {1.6765884816652368, 1.649149848839552, 1.7469382037243002},
                {-0.25960307888903705, -0.94003895806792614, -0.22120804403524796},
                {-0.90678903599668492, 0.31607096017595554, -0.27898529052559812}),
        {0, 0, 1},
        {0.58050403289397945, 0.81425737196160874, 5.1860496509994346e-09},
        0};
    const GeneralCase conical{
        crystal(Symmetry::biaxial, {1.9830606975640739, 2.0598240623943731, 1.79483907715191},
                {0.65866966995395215, -0.75108953220417551, 0.04493084125703084},
                {0.23769157197275592, 0.15104452659500459, -0.95952502187218192}),
        crystal(Symmetry::biaxial, {1.6491784357369059, 1.6595029675560546, 1.6430167743510526},
                {-0.25813086709169258, 0.47534824411318533, -0.84107817845489397},
                {0.93658455734867352, 0.3367073633722269, -0.097146890773264535}),
        {0.64180591445002466, -0.66503739263856732, 0.38185132521632542},
        {-0.73353508694377856, -0.63611515794319429, 0.23934030596054706},
        1};
    for (const GeneralCase& c : {ordinary, conical}) {
        const GeneralDiscrepancy worst = compare(c);
        INFO(worst.quantity << ": error " << in_digits(worst.error));
        CHECK(worst.excess <= 1);
    }
}

TEST_CASE("evanescent waves of an active crystal keep their digits when they nearly merge",
          "[interface][general]") {
    // Found by bench/general_accuracy: their normal components differ by 0.002, their fields by
    // 0.04, and their amplitudes are 22.
    GeneralCase c;
    c.from.symmetry = Symmetry::biaxial;
    c.from.n = {2.244898838324652, 2.321135303582516, 2.247676110806708};
    c.from.first = {-0.31289917817531582, -0.91598677487612423, 0.25112214667218941};
    c.from.second = {0.7343270622354261, -0.065621113573402695, 0.6756164852355776};
    c.to.symmetry = Symmetry::uniaxial;
    c.to.n = {1.3617935388731512, 1.4620453487054701, 1};
    c.to.first = {-0.52800534314435621, 0.031680696469349227, 0.84864992257245131};
    c.to.gyration = 0.0037248878452847073;
    c.to.gyration_along = 0.0042864797497616808;
    c.normal = {0.80055305334591575, 0.40598098565474766, 0.44078821225769077};
    c.direction = {0.81341983986268329, -0.54424099277581806, -0.20530442250511483};
    const GeneralDiscrepancy worst = compare(c);
    INFO(worst.quantity << ": error " << in_digits(worst.error));
    CHECK(worst.excess <= 1);
}

TEST_CASE("no face of any two media creates or loses energy", "[interface][general][energy]") {
    Random random(41);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 30000; ++i) {
        const auto stress =
            static_cast<GeneralStress>(random.below(static_cast<int>(GeneralStress::count)));
        const GeneralCase c = random_case(random, stress);
        const Wave in = c.incident();
        const Coefficients a = Interface(c.from.medium(), c.to.medium(), c.normal, in).solve(in);
        double excess = std::abs(a.reflected_total + a.transmitted_total + a.interference - 1) *
                        c.cos_ray / 1e-13;
        for (std::size_t j = 0; j < 2; ++j) {
            if (a.reflected_power[j] < 0) excess = 1e9;
            if (a.transmitted_power[j] < 0) excess = 1e9;
        }
        if (!(excess <= worst)) worst = excess, where = std::string(name(stress)) + ": " + c.text();
    }
    INFO(where);
    CHECK(worst <= 1);
}

TEST_CASE("every passage of a face of biaxial crystals has the same power backwards",
          "[interface][general][energy]") {
    Random random(42);
    double worst = 0;
    std::string where;
    const GeneralStress kinds[] = {GeneralStress::into_biaxial, GeneralStress::out_of_biaxial,
                                   GeneralStress::biaxial_to_biaxial,
                                   GeneralStress::strong_biaxiality, GeneralStress::backward_wave};
    for (int i = 0; i < 10000; ++i) {
        const GeneralCase c = random_case(random, kinds[random.below(5)]);
        const Medium from = c.from.medium(), to = c.to.medium();
        const Wave in = c.incident();
        const Interface face(from, to, c.normal, in);
        const Coefficients a = face.solve(in);
        for (std::size_t j = 0; j < 2; ++j) {
            const Wave t = face.transmitted(j);
            if (!t.propagating || dot(t.ray, c.normal) < 1e-3 || c.cos_ray < 1e-3) continue;
            if (modes_of(to)[j] != Mode::fast && modes_of(to)[j] != Mode::slow) {
                if (length(cross(c.normal, c.direction)) < 1e-3) continue;
            }
            // By their wave vectors: beside optic axes at grazing both waves may be slow.
            const auto both =
                waves_along(to, -(1 / t.n_phase) * real(t.k), By::wave_normal, -c.normal);
            const auto apart = [&](const Wave& w) { return length(w.k + t.k); };
            const Wave& back = modes_of(to)[0] != Mode::fast     ? both[j]
                               : apart(both[0]) < apart(both[1]) ? both[0]
                                                                 : both[1];
            const Interface reverse(to, from, -c.normal, back);
            std::size_t into = c.mode;
            if (modes_of(from)[0] == Mode::fast && length(reverse.transmitted(1 - into).k + in.k) <
                                                       length(reverse.transmitted(into).k + in.k)) {
                into = 1 - into;
            }
            const double b = reverse.solve(back).transmitted_power[into];
            const double error = std::abs(b - a.transmitted_power[j]);
            if (!(error <= worst)) worst = error, where = c.text();
        }
    }
    INFO(where);
    CHECK(worst < 1e-8);
}

TEST_CASE("a biaxial crystal with two equal indices is the uniaxial crystal",
          "[interface][general]") {
    Random random(43);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 20000; ++i) {
        const InterfaceCase c = random_case(random, Stress::ordinary);
        if (c.from.birefringent || !c.to.birefringent || c.cos_ray < 0.05) continue;
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const Medium twin = Medium::biaxial({c.to.n_e, c.to.n_o, c.to.n_o}, c.to.axis,
                                            any_perpendicular(c.to.axis));
        const Answer a = answer(c.from, c.to, c.normal, in), b = answer(c.from, twin, c.normal, in);
        // Beside a critical angle both depend on the index as a root.
        const double kt = length(cross(real(in.k), c.normal));
        if (std::abs(kt - c.to.n_o) < 0.01 || std::abs(kt - c.to.n_e) < 0.01) continue;
        const double error = distance(a, b);
        if (!(error <= worst)) worst = error, where = c.text();
    }
    INFO(where);
    CHECK(worst < 1e-11);
}

TEST_CASE("a trace of absorption changes nothing", "[interface][general]") {
    Random random(44);
    double worst = 0;
    std::string where;
    for (int i = 0; i < 20000; ++i) {
        const InterfaceCase c = random_case(random, Stress::ordinary);
        if (c.cos_ray < 0.05) continue;
        const Wave in = plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal);
        const double kt = length(cross(real(in.k), c.normal));
        if (std::abs(kt - c.to.n_o) < 0.01 || std::abs(kt - c.to.n_e) < 0.01) continue;
        const Complex trace(0, 1e-17);
        const Medium lossy = c.to.birefringent
                                 ? Medium::uniaxial(c.to.n_o + trace, c.to.n_e + trace, c.to.axis)
                                 : Medium::isotropic(c.to.n_o + trace);
        const double error =
            distance(answer(c.from, c.to, c.normal, in), answer(c.from, lossy, c.normal, in));
        if (!(error <= worst)) worst = error, where = c.text();
    }
    INFO(where);
    CHECK(worst < 1e-11);
}

TEST_CASE("what a face does changes smoothly across an optic axis", "[interface][general]") {
    const Medium topaz = Medium::biaxial({1.606, 1.609, 1.616}, {1, 0, 0}, {0, 1, 0});
    const Vec3 axis = optic_axes(topaz).first, side = any_perpendicular(axis);
    const Medium air = Medium::isotropic(1);
    const auto reflected = [&](double angle) {
        const Vec3 n = normalised(axis + angle * side);
        const Wave in =
            plane_wave(air, Mode::p, normalised(n + 0.3 * cross(n, side)), By::wave_normal, n);
        return Interface(air, topaz, n, in).solve(in).reflected_total;
    };
    const double at = reflected(0);
    for (double angle = 1e-2; angle > 1e-16; angle /= 3) {
        CHECK(std::abs(reflected(angle) - at) < 0.05 * angle + 1e-14);
        CHECK(std::abs(reflected(-angle) - at) < 0.05 * angle + 1e-14);
    }
}

TEST_CASE("silver reflects as its complex index says", "[interface][general]") {
    // Fresnel at normal incidence: |(n - 1) / (n + 1)|^2.
    const Complex n(0.15, 3.6);
    const Medium air = Medium::isotropic(1);
    const Wave in = plane_wave(air, Mode::s, {0, 0, 1}, By::wave_normal, {0, 0, 1});
    const Coefficients a = Interface(air, Medium::isotropic(n), {0, 0, 1}, in).solve(in);
    CHECK(a.reflected_total == Approx(std::norm((n - 1.0) / (n + 1.0))).epsilon(1e-14));
    CHECK(a.transmitted_total == Approx(1 - a.reflected_total).epsilon(1e-12));
}
