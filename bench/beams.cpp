// Error against CPU seconds of rays and beams on the reference brilliant, one thread.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>

#include "designs/design.hpp"
#include "render/render.hpp"

using namespace icespar;

namespace {

constexpr double degree = std::numbers::pi / 180;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Vec3 turned(const Vec3& v, double angle) {
    return {v.x, std::cos(angle) * v.y - std::sin(angle) * v.z,
            std::sin(angle) * v.y + std::cos(angle) * v.z};
}

/// Issue 5's scene: a brilliant whose table leans by 12 degrees to a camera of 35 degrees at 3.75
/// girdle radii, below a graded sky with six lamps.
Scene brilliant(const std::string& kind) {
    Scene scene;
    std::vector<FacetPlane> planes =
        read_design(ICESPAR_SCENES_DIR "/designs/srb_tolkowsky_diamond.asc").planes();
    for (FacetPlane& p : planes) p.normal = turned(p.normal, 12 * degree);
    const Vec3 axis = turned({0, 0, 1}, 12 * degree);
    Crystal crystal;
    if (kind == "isotropic") crystal.indices = {IndexFunction(2.417)};
    if (kind == "dispersive") crystal.indices = {IndexFunction::cauchy(2.3784, 0.0134)};
    if (kind == "isotropic_zircon") crystal.indices = {IndexFunction(1.945)};
    if (kind == "zircon") crystal = {{IndexFunction(1.925), IndexFunction(1.984)}, axis};
    if (kind == "calcite") crystal = {{IndexFunction(1.6584), IndexFunction(1.4864)}, axis};
    if (kind == "quartz") crystal = {{IndexFunction(1.5443), IndexFunction(1.5534)}, axis};
    scene.gems.push_back({Stone::from_planes(planes), crystal, "brilliant"});
    const double width = 2 * std::tan(17.5 * degree);
    scene.camera.location = {0, 0, 3.75};
    scene.camera.direction = {0, 0, -1};
    scene.camera.right = {width, 0, 0};
    scene.camera.up = {0, width, 0};
    Environment& sky = scene.environment;
    sky.illuminant = Spectrum(1.0);
    sky.below = Spectrum(0.25);
    sky.above = Spectrum(0.6);
    sky.up = {0, 0, 1};
    // Six lamps, one towards each face of a tilted cube.
    const Vec3 x = normalised({0.9, 0.3, 0.35}), y = normalised(cross(Vec3{0.1, 0.2, 1}, x));
    for (const Vec3& axis_of_lamps : {x, y, cross(x, y)}) {
        for (const double sign : {1.0, -1.0}) {
            sky.discs.push_back({sign * axis_of_lamps, std::cos(9 * degree), Spectrum(12.0)});
        }
    }
    return scene;
}

struct Shot {
    std::vector<float> rgb;
    double seconds, events, error;
};

Shot picture(const Scene& scene, int size, int samples, std::uint64_t seed, Engine engine,
             const std::string& forced, bool stokes) {
    RenderOptions o;
    o.width = o.height = size;
    o.samples = samples;
    o.threads = 1;
    o.seed = seed;
    o.engine = engine;
    if (!forced.empty()) o.forced.part(forced) = true;
    o.stokes = stokes;
    const double start = cpu_seconds();
    Rendering r = render(scene, o);
    return {std::move(r.image.rgb), cpu_seconds() - start, static_cast<double>(r.report.events),
            r.report.error};
}

/// Of luminances, whose error a render tells.
double luminance_rms(const Shot& x, const Shot& a, const Shot& b) {
    const auto luminance = [](const Shot& s, std::size_t i) {
        return xyz_from_rgb({s.rgb[i], s.rgb[i + 1], s.rgb[i + 2]})[1];
    };
    double sum = 0;
    for (std::size_t i = 0; i < x.rgb.size(); i += 3) {
        const double y = luminance(x, i);
        sum += (y - luminance(a, i)) * (y - luminance(b, i));
    }
    return std::sqrt(std::max(0.0, 3 * sum / static_cast<double>(x.rgb.size())));
}

double rms(const Shot& x, const Shot& a, const Shot& b) {
    double sum = 0;
    for (std::size_t i = 0; i < x.rgb.size(); ++i) {
        sum += (double(x.rgb[i]) - a.rgb[i]) * (double(x.rgb[i]) - b.rgb[i]);
    }
    const double mean = sum / static_cast<double>(x.rgb.size());
    return mean < 0 ? -std::sqrt(-mean) : std::sqrt(mean);
}

}  // namespace

/// beams KIND SIZE REFERENCE_SAMPLES DOUBLINGS [reference: rays|beams]
/// [rays|beams|pixels|survivors] [stokes]
int main(int argc, char** argv) {
    const std::string kind = argc > 1 ? argv[1] : "isotropic";
    const int size = argc > 2 ? std::atoi(argv[2]) : 256;
    const int reference = argc > 3 ? std::atoi(argv[3]) : 1024;
    const int doublings = argc > 4 ? std::atoi(argv[4]) : 8;
    const bool reference_rays = argc > 5 && std::string(argv[5]) == "rays";
    const std::string engine = argc > 6 ? argv[6] : "beams";
    const bool rays = engine == "rays";
    const std::string forced = rays || engine == "beams" ? "" : engine;
    const bool stokes = argc > 7;
    const Scene scene = brilliant(kind);
    const Engine truth = reference_rays ? Engine::rays : Engine::beams;
    const Shot a = picture(scene, size, reference, 101, truth, "pixels", false),
               b = picture(scene, size, reference, 102, truth, "pixels", false);
    double mean = 0;
    for (const float v : a.rgb) mean += v / static_cast<double>(a.rgb.size());
    std::printf("# reference %.2f s, mean %.4f\n", a.seconds, mean);
    std::printf(
        "kind,engine,samples,cpu_seconds,rmse,luminance_rmse,estimated_rmse,events,ns_per_event\n");
    for (int samples = 1; samples <= 1 << doublings; samples *= 2) {
        const Shot p = picture(scene, size, samples, static_cast<std::uint64_t>(samples),
                               rays ? Engine::rays : Engine::beams, forced, stokes);
        std::printf("%s,%s,%d,%.3f,%.5f,%.5f,%.5f,%.0f,%.0f\n", kind.c_str(), engine.c_str(),
                    samples, p.seconds, rms(p, a, b), luminance_rms(p, a, b), p.error * mean,
                    p.events, 1e9 * p.seconds / p.events);
        std::fflush(stdout);
    }
}
