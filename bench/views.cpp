// Light left untraced against CPU seconds for parallel views, one core.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "designs/design.hpp"
#include "views/light_return.hpp"

using namespace icespar;

namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int argc, char** argv) {
    const Stone stone = Stone::from_planes(
        read_design(argc > 1 ? argv[1] : ICESPAR_SCENES_DIR "/designs/srb_tolkowsky_diamond.asc")
            .planes());
    struct Case {
        const char* name;
        Medium medium;
    };
    const Case cases[] = {{"isotropic", Medium::isotropic(2.42)},
                          {"zircon", Medium::uniaxial(1.925, 1.984, {0, 0, 1})},
                          {"topaz", Medium::biaxial({1.619, 1.621, 1.627}, {1, 0, 0}, {0, 1, 0})}};
    std::puts("medium,bound,seconds,beams,exits,untraced,gaps,traced+untraced-1,ISO");
    for (const Case& c : cases) {
        for (const double bound : {0.02, 0.01, 0.005, 0.002, 0.001}) {
            ViewOptions options;
            options.bound = bound;
            options.max_beams = 20'000'000;
            const double start = cpu_seconds();
            const Exits exits = trace_view(stone, c.medium, {}, options);
            const double seconds = cpu_seconds() - start;
            double traced = 0;
            for (std::size_t i = 0; i < exits.size(); ++i) {
                traced += exits.weight[i].s0 * exits.area[i];
            }
            traced *= static_cast<double>(exits.images.size());
            const double whole = exits.area_total;
            std::printf("%s,%g,%.3f,%llu,%zu,%.3g,%.1e,%.1e,%.4f\n", c.name, bound, seconds,
                        static_cast<unsigned long long>(exits.beams), exits.size(),
                        exits.untraced / whole, exits.gaps / whole,
                        (traced + exits.untraced) / whole - 1, light_return(exits, {}).value);
            std::fflush(stdout);
        }
    }
}
