// Pictures by beams held against pictures by rays, which are the reference.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "support/gem_scenes.hpp"

namespace icespar::testing {

inline constexpr int engine_runs = 6;

struct PictureEstimate {
    std::vector<double> mean, variance;  ///< of each pixel and channel; variance of the mean
    std::array<double, 3> picture{}, picture_variance{};  ///< of R, G, B (of S1..S3 alike)
};

/// Independent pictures by one engine.
inline PictureEstimate estimated(const Scene& scene, Engine engine, int samples, int size,
                                 bool stokes = false) {
    PictureEstimate out;
    std::vector<double> squares;
    std::array<double, 3> squared{};
    for (int run = 0; run < engine_runs; ++run) {
        RenderOptions options = small(size, samples);
        options.engine = engine;
        options.stokes = stokes;
        options.seed = static_cast<std::uint64_t>(100 + run);
        const Rendering r = render(scene, options);
        REQUIRE(r.report.engine == engine);
        const auto& values = stokes ? r.image.rgb_stokes : r.image.rgb;
        out.mean.resize(values.size());
        squares.resize(values.size());
        std::array<double, 3> mean{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            out.mean[i] += values[i] / double(engine_runs);
            squares[i] += double(values[i]) * values[i] / double(engine_runs);
            mean[i % 3] += 3 * values[i] / static_cast<double>(values.size());
        }
        for (std::size_t c = 0; c < 3; ++c) {
            out.picture[c] += mean[c] / engine_runs;
            squared[c] += mean[c] * mean[c] / engine_runs;
        }
    }
    for (std::size_t i = 0; i < squares.size(); ++i) {
        out.variance.push_back(std::max(0.0, squares[i] - out.mean[i] * out.mean[i]) /
                               (engine_runs - 1));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        out.picture_variance[c] =
            std::max(0.0, squared[c] - out.picture[c] * out.picture[c]) / (engine_runs - 1);
    }
    return out;
}

/// Whole pictures and every pixel agree within their noise.
inline void compare_engines(const Scene& scene, int rays, int beams, int size,
                            bool stokes = false) {
    const PictureEstimate a = estimated(scene, Engine::rays, rays, size, stokes),
                          b = estimated(scene, Engine::beams, beams, size, stokes);
    for (std::size_t c = 0; c < 3; ++c) {
        const double z = (a.picture[c] - b.picture[c]) /
                         std::sqrt(a.picture_variance[c] + b.picture_variance[c] + 1e-14);
        CAPTURE(c, a.picture[c], b.picture[c], z);
        CHECK(std::abs(z) < 6);
    }
    // Every pixel, with a bound for the largest of them all (Student's t for the few runs).
    double worst = 0;
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const double d = a.mean[i] - b.mean[i];
        worst = std::max(worst, d * d / (a.variance[i] + b.variance[i] + 1e-7));
    }
    CAPTURE(std::sqrt(worst));
    CHECK(std::sqrt(worst) < 16);
}

/// With two lamps.
inline Scene lit(Scene scene) {
    scene.environment.discs.push_back(
        {normalised({1, 2, 4}), std::cos(12 * degree), Spectrum(5.0)});
    scene.environment.discs.push_back({{0, 0, 1}, std::cos(4 * degree), Spectrum(5.0)});
    return scene;
}

}  // namespace icespar::testing
