// Light left untraced against CPU seconds for parallel views, one core; then against facets.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string_view>

#include "designs/design.hpp"
#include "math/random.hpp"
#include "views/light_return.hpp"

using namespace icespar;

namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void row(const char* name, const char* how, const Stone& stone, const Medium& medium,
         const ParallelView& view, double bound, bool symmetry) {
    ViewOptions options;
    options.bound = bound;
    options.max_beams = 2'000'000;
    options.symmetry = symmetry;
    const double start = cpu_seconds();
    const Exits exits = trace_view(stone, medium, view, options);
    const double seconds = cpu_seconds() - start;
    double traced = 0;
    for (std::size_t i = 0; i < exits.size(); ++i) traced += exits.weight[i].s0 * exits.area[i];
    traced *= static_cast<double>(exits.images.size());
    const double whole = exits.area_total;
    std::printf("%s,%s,%zu,%g,%.3f,%llu,%zu,%.5f,%.1e,%.1e,%.4f\n", name, how, stone.facets.size(),
                bound, seconds, static_cast<unsigned long long>(exits.beams),
                exits.size() * exits.images.size(), exits.untraced / whole, exits.gaps / whole,
                (traced + exits.untraced) / whole - 1,
                light_return(exits, {Dome::iso, -exits.frame.direction, 0}).value);
    std::fflush(stdout);
}

/// The same with what is left sampled to an error. Three seeds tell how far apart numbers are.
void sampled_row(const char* name, const char* how, const Stone& stone, const Medium& medium,
                 const ParallelView& view, double error) {
    ViewOptions options;
    options.bound = {};
    options.error = error;
    const double start = cpu_seconds();
    for (int seed = 0; seed < 3; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        const Exits exits = trace_view(stone, medium, view, options);
        const LightReturn iso =
            light_return(exits, {Dome::iso, -exits.frame.direction, 10 * std::numbers::pi / 180});
        const double seconds = (cpu_seconds() - start) / (seed + 1);
        std::printf("%s,%s,%g,%.3f,%llu,%llu,%.4f,%.6f,%.6f\n", name, how, error, seconds,
                    static_cast<unsigned long long>(exits.beams),
                    static_cast<unsigned long long>(exits.sampled),
                    exits.untraced / exits.area_total, iso.value, iso.error);
    }
    std::fflush(stdout);
}

/// Planes that touch the unit ball, evenly spread but for chance.
Stone random_stone(int facets, std::uint64_t seed) {
    Random random(seed);
    std::vector<FacetPlane> planes;
    for (int i = 0; i < facets; ++i) {
        const double z = 1 - (2 * i + 2 * random.uniform()) / facets, r = std::sqrt(1 - z * z),
                     turn = 2 * std::numbers::pi * (i / std::numbers::phi + 0.1 * random.uniform());
        planes.push_back({{r * std::cos(turn), r * std::sin(turn), z}, 1.0});
    }
    return Stone::from_planes(planes);
}

/// A thousand random stones and views, a thousand beams each: the worst there is.
void balance() {
    double gaps = 0, imbalance = 0;
    std::uint64_t beams = 0;
    Random random(1);
    const auto direction = [&] {
        const double z = 2 * random.uniform() - 1, turn = 2 * std::numbers::pi * random.uniform();
        return Vec3{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn),
                    z};
    };
    for (int i = 0; i < 1000; ++i) {
        const Stone stone = random_stone(20 + i % 80, static_cast<std::uint64_t>(i));
        const Medium medium = i % 2 == 0 ? Medium::isotropic(1.3 + 1.2 * random.uniform())
                                         : Medium::uniaxial(1.925, 1.984, direction());
        ViewOptions options;
        options.bound = 0;
        options.max_beams = 1000;
        const Vec3 along = direction();
        const Exits e = trace_view(stone, medium, {along, any_perpendicular(along)}, options);
        double traced = 0;
        for (std::size_t x = 0; x < e.size(); ++x) traced += e.weight[x].s0 * e.area[x];
        traced *= static_cast<double>(e.images.size());
        beams += e.beams;
        gaps = std::max(gaps, e.gaps / e.area_total);
        imbalance = std::max(imbalance, std::abs((traced + e.untraced) / e.area_total - 1));
    }
    std::printf("%llu beams of 1000 stones: gaps %.1e, traced + untraced - 1 %.1e at most\n",
                static_cast<unsigned long long>(beams), gaps, imbalance);
}

}  // namespace

/// Prints the table, or with the word sampled that of views whose rest is sampled, or with the word
/// balance what the areas of a million beams come to.
int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "balance") {
        balance();
        return 0;
    }
    const Stone brilliant = Stone::from_planes(
        read_design(ICESPAR_SCENES_DIR "/designs/srb_tolkowsky_diamond.asc").planes());
    struct Case {
        const char* name;
        Medium medium;
    };
    const Case cases[] = {{"isotropic", Medium::isotropic(2.42)},
                          {"zircon", Medium::uniaxial(1.925, 1.984, {0, 0, 1})},
                          {"quartz", Medium::uniaxial(1.5443, 1.5534, {0, 0, 1})},
                          {"topaz", Medium::biaxial({1.619, 1.621, 1.627}, {1, 0, 0}, {0, 1, 0})},
                          {"zircon across", Medium::uniaxial(1.925, 1.984, {1, 0, 0})},
                          {"corundum", Medium::uniaxial(1.768, 1.760, {0, 0, 1})}};
    const ParallelView tilted{{0.1, 0.23, -1}};
    if (argc > 1 && std::string_view(argv[1]) == "sampled") {
        std::puts("medium,view,wanted,seconds,beams,of the sample,untraced,ISO,error");
        for (const Case& c : cases) {
            for (const double error : {2e-3, 1e-3, 5e-4, 2e-4, 1e-4}) {
                sampled_row(c.name, "face-up", brilliant, c.medium, {}, error);
                sampled_row(c.name, "tilted", brilliant, c.medium, tilted, error);
            }
        }
        return 0;
    }
    std::puts("medium,view,facets,bound,seconds,beams,exits,untraced,gaps,traced+untraced-1,ISO");
    for (const Case& c : cases) {
        for (const double bound : {0.02, 0.01, 0.005, 0.002, 0.001}) {
            row(c.name, "face-up", brilliant, c.medium, {}, bound, true);
            row(c.name, "face-up without symmetry", brilliant, c.medium, {}, bound, false);
            row(c.name, "tilted", brilliant, c.medium, tilted, bound, true);
        }
    }
    for (const int facets : {20, 50, 100, 200, 500, 1000}) {
        row("isotropic", "random", random_stone(facets, static_cast<std::uint64_t>(facets)),
            Medium::isotropic(1.8), {}, 0.01, true);
    }
}
