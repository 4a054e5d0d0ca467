// Nanoseconds per interface, face by face and in batches: interface_speed [repeats].
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "interface/batch.hpp"
#include "interface/interface.hpp"
#include "support/batch_arrays.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

constexpr std::size_t count = 1024;  // faces a batch; arrays stay in the caches

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
    }
    return "unknown processor";
}

double cpu_seconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Median over runs of CPU time for one face.
template <class Work>
double nanoseconds(int runs, const Work& work) {
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const int repeats = 50;
        const double start = cpu_seconds();
        for (int i = 0; i < repeats; ++i) work();
        times.push_back((cpu_seconds() - start) * 1e9 / (repeats * static_cast<double>(count)));
    }
    std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
    return times[static_cast<std::size_t>(runs / 2)];
}

std::vector<InterfaceCase> cases(const Medium& from, const Medium& to, Mode mode, double tilt) {
    Random random(5);
    std::vector<InterfaceCase> all(count);
    for (InterfaceCase& c : all) {
        c.from = from;
        c.to = to;
        c.mode = mode;
        c.normal = {0, 0, 1};
        const double up = random.uniform(tilt, 1), angle = random.uniform(0, 6.28);
        const double r = std::sqrt(1 - up * up);
        c.direction = {r * std::cos(angle), r * std::sin(angle), up};
    }
    return all;
}

double sink = 0;

void row(int runs, const char* what, const Medium& from, const Medium& to, Mode mode,
         double least_cos) {
    const std::vector<InterfaceCase> all = cases(from, to, mode, least_cos);
    std::vector<Wave> waves;
    for (const auto& c : all) {
        waves.push_back(plane_wave(c.from, c.mode, c.direction, By::wave_normal, c.normal));
    }
    const double scalar_powers = nanoseconds(runs, [&] {
        for (std::size_t i = 0; i < count; ++i) {
            const Interface face(from, to, all[i].normal, waves[i]);
            sink += face.solve(waves[i]).transmitted_power[0];
        }
    });
    const double scalar_rays = nanoseconds(runs, [&] {
        for (std::size_t i = 0; i < count; ++i) {
            const Interface face(from, to, all[i].normal, waves[i]);
            sink += face.solve(waves[i]).transmitted_power[0];
            for (const bool transmitted : {false, true}) {
                for (const std::size_t m : {0, 1}) sink += face.ray(transmitted, m).x;
            }
        }
    });
    const double scalar_all = nanoseconds(runs, [&] {
        for (std::size_t i = 0; i < count; ++i) {
            const Interface face(from, to, all[i].normal, waves[i]);
            sink += face.solve(waves[i]).transmitted_power[0];
            const OutgoingWaves out = face.waves();
            sink += out.reflected[0].ray.x + out.reflected[1].ray.x + out.transmitted[0].ray.x +
                    out.transmitted[1].ray.x;
        }
    });
    std::printf("%-34s %8.1f %8.1f %8.1f", what, scalar_powers, scalar_rays, scalar_all);
    BatchArrays arrays(all);
    arrays.faces.from = {&from, 0};
    arrays.faces.to = {&to, 0};
    const Vec3& n = all[0].normal;
    arrays.faces.normal = {{&n.x, 0}, {&n.y, 0}, {&n.z, 0}};
    std::array<std::vector<double>, 3> d;
    for (const auto& c : all) {
        d[0].push_back(c.direction.x);
        d[1].push_back(c.direction.y);
        d[2].push_back(c.direction.z);
    }
    arrays.faces.direction = {{d[0].data()}, {d[1].data()}, {d[2].data()}};
    const auto outgoing = [&](bool rays, bool fields) {
        BatchResult wanted;
        for (int side = 0; side < 2; ++side) {
            for (std::size_t m = 0; m < 2; ++m) {
                const WaveColumns& have =
                    side == 0 ? arrays.wanted.reflected[m] : arrays.wanted.transmitted[m];
                WaveColumns& w = side == 0 ? wanted.reflected[m] : wanted.transmitted[m];
                w.power = have.power;
                if (!rays) continue;
                w.ray = have.ray;
                if (fields) w = have;
            }
        }
        return wanted;
    };
    for (const Lanes lanes : {Lanes::baseline, Lanes::avx512}) {
        if (lanes == Lanes::avx512 && widest_lanes() != Lanes::avx512) continue;
        for (const auto& wanted :
             {outgoing(false, false), outgoing(true, false), outgoing(true, true)}) {
            std::printf(" %8.1f", nanoseconds(runs, [&] {
                            solve_batch(arrays.faces, wanted, 0, count, lanes);
                        }));
        }
        arrays.faces.precision = Precision::single;
        std::printf(" %8.1f", nanoseconds(runs, [&] {
                        solve_batch(arrays.faces, outgoing(true, false), 0, count, lanes);
                    }));
        arrays.faces.precision = Precision::full;
    }
    std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::atoi(argv[1]) : 25;
    const Medium air = Medium::isotropic(1), glass = Medium::isotropic(1.5);
    const Vec3 oblique{0.36, 0.48, 0.8}, up{0, 0, 1};
    const Medium calcite = Medium::uniaxial(1.6584, 1.4864, oblique);
    std::printf(
        "%s\nns a face on one core, median of %d runs; batches of %zu faces\n"
        "%-34s %26s %35s %35s\n%-34s %8s %8s %8s %8s %8s %8s %8s %8s %8s %8s %8s\n",
        processor().c_str(), runs, count, "", "Interface", "baseline (AVX2) batch", "AVX-512 batch",
        "", "powers", "+ rays", "all", "powers", "+ rays", "all", "+ rays f", "powers", "+ rays",
        "all", "+ rays f");
    row(runs, "air to glass", air, glass, Mode::p, 0.1);
    row(runs, "glass to air, total reflection", glass, air, Mode::p, 0.1);
    row(runs, "air to calcite", air, calcite, Mode::s, 0.1);
    row(runs, "air to calcite, axis on normal", air, Medium::uniaxial(1.6584, 1.4864, up), Mode::s,
        0.1);
    row(runs, "calcite to air, refracted", calcite, air, Mode::extraordinary, 0.85);
    row(runs, "calcite to air, total reflection", calcite, air, Mode::extraordinary, 0.2);
    row(runs, "calcite to quartz", Medium::uniaxial(1.6584, 1.4864, oblique),
        Medium::uniaxial(1.5442, 1.5533, {0.6, 0, 0.8}), Mode::ordinary, 0.6);
    const Vec3 across{0.8, -0.6, 0};
    const Medium topaz = Medium::biaxial({1.606, 1.609, 1.616}, oblique, across),
                 aragonite = Medium::biaxial({1.530, 1.681, 1.686}, oblique, across);
    row(runs, "air to topaz", air, topaz, Mode::s, 0.1);
    row(runs, "topaz to air, refracted", topaz, air, Mode::fast, 0.85);
    row(runs, "topaz to air, total reflection", topaz, air, Mode::slow, 0.2);
    row(runs, "air to aragonite", air, aragonite, Mode::p, 0.1);
    row(runs, "topaz to aragonite", topaz, aragonite, Mode::fast, 0.6);
    return sink == 0.5 ? 2 : 0;
}
