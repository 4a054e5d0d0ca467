// Exact beams of parallel views: nothing is lost or doubled, and every point of the picture sees
// what its ray sees.
#include <catch2/catch.hpp>

#include "math/error.hpp"
#include "support/gem_scenes.hpp"
#include "views/view.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::Contains;
using Draws = icespar::testing::Random;

namespace {

double traced(const Exits& exits) {
    double sum = 0;
    for (std::size_t i = 0; i < exits.size(); ++i) sum += exits.weight[i].s0 * exits.area[i];
    return sum * static_cast<double>(exits.images.size());
}

/// Light that is neither traced nor untraced, or is both.
double imbalance(const Exits& e) {
    return std::abs(traced(e) + e.untraced + e.cut - e.area_total) / e.area_total;
}

Medium medium_of(const Crystal& c) {
    const auto n = [&](std::size_t i) { return c.indices[i](550); };
    if (c.indices.size() == 1) return Medium::isotropic(n(0));
    if (c.indices.size() == 2) return Medium::uniaxial(n(0), n(1), c.axis);
    return Medium::biaxial({n(0), n(1), n(2)}, c.axis, cross(c.third_axis, c.axis));
}

ViewOptions within(double bound, std::uint64_t beams) {
    ViewOptions options;
    options.bound = bound;
    options.max_beams = beams;
    return options;
}

/// But for edges and slivers that come from rounding.
bool holds(PolygonView polygon, const Point2& p) {
    constexpr double rounding = 1e-12;
    if (extent(polygon).area < rounding) return false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 a = polygon[i], edge = polygon[(i + 1) % polygon.size()] - a, to = p - a;
        const double size = std::hypot(edge.x, edge.y);
        if (size > rounding && edge.x * to.y - edge.y * to.x < 0) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("in a furnace the exits of random stones and what is untraced make up all light",
          "[views][furnace]") {
    Draws random(3);
    for (int i = 0; i < 45; ++i) {
        const Stone stone =
            Stone::from_planes(random_planes(random, 24 + random.below(60), 0.3 * (i % 2)));
        const Medium medium = i % 3 == 0   ? Medium::isotropic(1.2 + 1.5 * random.uniform())
                              : i % 3 == 1 ? Medium::uniaxial(1.925, 1.984, random.direction())
                                           : medium_of(topaz(random));
        const Vec3 direction = random.direction();
        const Exits e = trace_view(stone, medium, {direction, random.perpendicular_to(direction)},
                                   within(1e-3, i % 3 == 0 ? 3000 : 500));
        CAPTURE(i, e.beams, e.size());
        CHECK(imbalance(e) < 1e-12);
        CHECK(e.gaps < 1e-12 * e.area_total);
        CHECK(e.untraced < e.area_total);
    }
}

TEST_CASE("views along a facet, an edge, a facet's normal or the optic axis lose no light",
          "[views][furnace]") {
    const Vec3 directions[] = {{0, 0, -1},   {-1, 0, 0},     {-1, -1, 0},
                               {-1, -1, -1}, {0, -1, 1e-15}, {1e-9, 0, -1}};
    for (const Stone& stone : {cube_stone(), brilliant_stone(), rhomb_stone()}) {
        for (const Medium& medium :
             {Medium::isotropic(1.5), Medium::uniaxial(1.6584, 1.4864, {0, 0, 1})}) {
            for (const Vec3& direction : directions) {
                const Exits e =
                    trace_view(stone, medium, {direction, {0.1, 0.7, 0.2}}, within(1e-4, 500));
                double area = 0;
                for (const Facet& f : stone.facets) {
                    area += f.area * std::abs(dot(f.normal, direction)) / (2 * length(direction));
                }
                CHECK(imbalance(e) < 1e-12);
                CHECK(e.gaps < 1e-12 * e.area_total);
                CHECK(std::abs(e.area_total - area) < 1e-12 * area);
            }
        }
    }
}

TEST_CASE("a cube seen along its edges reflects as the sum over all echoes of a plate", "[views]") {
    constexpr double n = 1.7, r = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    const Exits e = trace_view(cube_stone(), Medium::isotropic(n), {}, within(0, 60));
    double back = 0;
    const double part = static_cast<double>(e.images.size()) / e.area_total;
    for (std::size_t i = 0; i < e.size(); ++i) {
        CHECK(std::abs(std::abs(e.direction[i].z) - 1) < 1e-15);
        if (e.direction[i].z > 0) back += part * e.weight[i].s0 * e.area[i];
    }
    CHECK(std::abs(back - 2 * r / (1 + r)) < 1e-14);
}

TEST_CASE("a point of the picture sees what its ray sees, in all four components", "[views]") {
    Draws random(5);
    for (int i = 0; i < 8; ++i) {
        const Crystal crystal = i % 4 == 0   ? glass(2.417)
                                : i % 4 == 1 ? calcite(random.direction())
                                : i % 4 == 2 ? quartz(random.direction())
                                             : sphene(random);
        Scene scene = scene_of(brilliant_stone(), crystal, slope(random.direction()));
        scene.environment.illuminant = Spectrum(1.0);
        constexpr int hits = 5;
        const Vec3 direction = random.direction();
        ViewOptions options = within(0, 0);
        options.max_hits = hits;
        options.outlines = true;
        options.weights = Weights::stokes;
        const ParallelView view{direction, random.perpendicular_to(direction)};
        const Exits e = trace_view(scene.gems[0].stone, medium_of(crystal), view, options);
        options.weights = Weights::intensity;
        const Exits plain = trace_view(scene.gems[0].stone, medium_of(crystal), view, options);
        const auto look = [&](const Exits& from, const Point2& p) {
            Stokes seen;
            for (std::size_t x = 0; x < from.size(); ++x) {
                const PolygonView polygon(from.corners.data() + from.outline[x],
                                          from.outline[x + 1] - from.outline[x]);
                if (!holds(polygon, p)) continue;
                const double light = 0.5 * (1 + dot(from.direction[x], scene.environment.up));
                seen += light * from.weight[x];
            }
            return seen;
        };
        for (int j = 0; j < 20; ++j) {
            const Point2 p{random.uniform() - 0.5, random.uniform() - 0.5};
            const Stokes seen = look(e, p);
            if (seen.s0 == 0) continue;  // beside the stone
            const Vec3 place = e.frame.centre + p.x * e.frame.right + p.y * e.frame.up;
            TraceOptions rays;
            rays.wavelength_nm = 550;
            rays.max_hits = hits;
            const Stokes ray =
                trace_one(scene, {place - 5.0 * direction, direction, e.frame.right}, rays);
            CAPTURE(i, j, text(ray), text(seen));
            CHECK(difference(seen, ray) < 1e-7);
            CHECK(std::abs(look(plain, p).s0 - seen.s0) < 1e-12);
        }
    }
}

TEST_CASE("the mean over a view is the sum of its pixels", "[views]") {
    // The tracer of pixels, with roulette and noise, on a grid that covers the whole stone.
    const Vec3 axis = normalised(Vec3{0.3, 0.2, 1});
    Scene scene = scene_of(brilliant_stone(), zircon(axis), slope({0, 0, 1}));
    scene.camera = towards_origin(2.2);
    scene.camera.kind = Camera::Kind::orthographic;
    RenderOptions options = small(8, 96);
    options.engine = Engine::beams;
    const Rendering picture = render(scene, options);
    const Exits e =
        trace_view(scene.gems[0].stone, medium_of(scene.gems[0].crystal), {}, within(3e-3, 0));
    double seen = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
        seen += e.weight[i].s0 * e.area[i] * 0.5 * (1 + e.direction[i].z);
    }
    seen *= static_cast<double>(e.images.size());
    // Beside the stone one looks down, where it is dark.
    const double whole = 2.2 * 2.2, mean = mean_of(picture.image.rgb, 1, 3);
    CHECK(mean * whole > seen - 1e-3 * e.area_total);
    CHECK(mean * whole < seen + e.untraced + 1e-3 * e.area_total);
}

TEST_CASE("less is untraced the more is followed, and numbers stay within their bounds",
          "[views]") {
    const Stone stone = rhomb_stone();
    double least = 0, most = 1;
    for (const double bound : {0.1, 0.03, 0.01, 3e-3, 1e-3}) {
        const Exits e = trace_view(stone, Medium::isotropic(2.42), {}, within(bound, 0));
        double up = 0;
        for (std::size_t i = 0; i < e.size(); ++i) {
            if (e.direction[i].z > 0) up += e.weight[i].s0 * e.area[i];
        }
        up *= static_cast<double>(e.images.size());
        const double low = up / e.area_total, high = low + e.untraced / e.area_total;
        CHECK(e.untraced <= bound * e.area_total);
        CHECK(low >= least);
        CHECK(high <= most + 1e-15);
        least = low;
        most = high;
    }
}

TEST_CASE("a view that cannot be traced says why", "[views]") {
    const Stone stone = cube_stone();
    const Medium glass_of_2 = Medium::isotropic(2);
    const auto refused = [&](const Medium& medium, const ParallelView& view,
                             const ViewOptions& options, const char* why) {
        CHECK_THROWS_WITH(trace_view(stone, medium, view, options), Contains(why));
    };
    refused(glass_of_2, {{0, 0, 0}, {0, 1, 0}}, {}, "direction");
    refused(glass_of_2, {{0, 1, 0}, {0, 1, 0}}, {}, "up");
    refused(glass_of_2, {}, within(0, 0), "end");
    refused(glass_of_2, {}, within(-1, 0), "bound");
    refused(Medium::isotropic(Complex(2, 0.1)), {}, {}, "clear stone");
    refused(Medium::isotropic(0.9), {}, {}, "index 1");
    refused(Medium::active(1.54, 1.55, {0, 0, 1}, 21, 589), {}, {}, "rotation");
    ViewOptions averaged;
    averaged.weights = Weights::averaged;
    refused(Medium::uniaxial(1.54, 1.55, {0, 0, 1}), {}, averaged, "birefringent");
}

TEST_CASE("directions move with the permittivity as their fans say", "[views]") {
    const Stone stone = rhomb_stone();
    // Ordinary and extraordinary indices need not move alike.
    const auto medium_at = [](int symmetry, double c) {
        const Vec3 axis = normalised(Vec3{0.3, 1, 0.5});
        if (symmetry == 0) return Medium::isotropic(1.7 + c);
        if (symmetry == 1) return Medium::uniaxial(1.7 + c, 1.55 - 0.6 * c, axis);
        return Medium::biaxial({1.55 + 0.4 * c, 1.62 + c, 1.7 - 0.7 * c}, axis,
                               any_perpendicular(axis));
    };
    constexpr double step = 1e-7;
    for (const int symmetry : {0, 1, 2}) {
        const auto eps = [&](double c) { return real(medium_at(symmetry, c).permittivity()); };
        const auto traced_at = [&](double c) {
            ViewOptions options = within(0, 0);
            options.max_hits = 6;
            options.fan = (0.5 / step) * (eps(step) + -1.0 * eps(-step));
            return trace_view(stone, medium_at(symmetry, c), {{0.2, 0.1, -1}}, options);
        };
        const Exits low = traced_at(-step), middle = traced_at(0), high = traced_at(step);
        REQUIRE(middle.size() > 20);
        // They may come in another order.
        const auto apart = [&](const Exits& those, double c, std::size_t i) {
            double least = 1;
            for (std::size_t j = 0; j < those.size(); ++j) {
                if (those.facet[j] != middle.facet[i] || those.hits[j] != middle.hits[i]) continue;
                const Vec3 wanted = middle.direction[i] + c * middle.fan[i];
                least = std::min(least, length(those.direction[j] - wanted));
            }
            return least;
        };
        double steepest = 0;
        for (std::size_t i = 0; i < middle.size(); ++i) {
            if (middle.weight[i].s0 * middle.area[i] < 1e-6) continue;
            CAPTURE(symmetry, i, middle.hits[i]);
            // A grazing beam turns ever faster.
            const double size = length(middle.fan[i]),
                         allowed = 1e-5 * step * (1 + size * size * size);
            CHECK(apart(low, -step, i) < allowed);
            CHECK(apart(high, step, i) < allowed);
            steepest = std::max(steepest, size);
        }
        CHECK(steepest > 1);
    }
}

TEST_CASE("directions move with the line of sight as their derivatives say", "[views]") {
    const Stone stone = rhomb_stone();
    const Vec3 axis = normalised(Vec3{0.3, 1, 0.5});
    const Medium media[] = {Medium::isotropic(1.7), Medium::uniaxial(1.7, 1.55, axis),
                            Medium::biaxial({1.55, 1.62, 1.7}, axis, any_perpendicular(axis))};
    constexpr double step = 1e-7;
    for (const Medium& medium : media) {
        ViewOptions options = within(0, 0);
        options.max_hits = 6;
        options.turns = true;
        const Exits middle = trace_view(stone, medium, {{0.2, 0.1, -1}}, options);
        REQUIRE(middle.size() > 20);
        double steepest = 0;
        for (const std::size_t way : {0u, 1u}) {
            const Vec3 turn = way == 0 ? middle.frame.right : middle.frame.up;
            const Exits there =
                trace_view(stone, medium, {middle.frame.direction + step * turn}, options);
            for (std::size_t i = 0; i < middle.size(); ++i) {
                if (middle.weight[i].s0 * middle.area[i] < 1e-6) continue;
                const Vec3 moved = middle.turned[i][way],
                           wanted = middle.direction[i] + step * moved;
                double least = 1;
                for (std::size_t j = 0; j < there.size(); ++j) {
                    if (there.facet[j] != middle.facet[i] || there.hits[j] != middle.hits[i]) {
                        continue;
                    }
                    least = std::min(least, length(there.direction[j] - wanted));
                }
                CAPTURE(way, i, middle.hits[i]);
                // A grazing beam turns ever faster.
                const double size = length(moved);
                CHECK(least < 1e-5 * step * (1 + size * size * size));
                steepest = std::max(steepest, size);
            }
        }
        CHECK(steepest > 1);
    }
}
