// What is left of a view's light when exact tracing ends, sampled.
#include <array>
#include <catch2/catch.hpp>

#include "support/gem_scenes.hpp"
#include "views/light_return.hpp"

using namespace icespar;
using namespace icespar::testing;

namespace {

const Medium zircon_of_issue = Medium::uniaxial(1.925, 1.984, {0, 0, 1});

double listed(const Exits& e) {
    double sum = 0;
    for (std::size_t i = 0; i < e.size(); ++i) sum += e.weight[i].s0 * e.area[i];
    return sum * static_cast<double>(e.images.size());
}

ViewOptions sampled_after(std::uint64_t beams) {
    ViewOptions options;
    options.bound = 0;
    options.max_beams = beams;
    options.error = 1e-9;
    return options;
}

}  // namespace

TEST_CASE("a sample keeps the light that exact tracing left", "[views][furnace]") {
    icespar::testing::Random random(12);
    for (int i = 0; i < 24; ++i) {
        const Stone stone =
            i % 4 == 0 ? brilliant_stone()
                       : Stone::from_planes(random_planes(random, 24 + random.below(40), 0.3));
        const Medium medium = i % 2 == 0 ? Medium::isotropic(1.3 + random.uniform())
                                         : Medium::uniaxial(1.925, 1.984, random.direction());
        const Vec3 direction = i % 8 == 0 ? Vec3{0, 0, -1} : random.direction();
        ViewOptions options = sampled_after(200);
        options.seed = static_cast<std::uint64_t>(i);
        options.weights = i % 3 == 0 ? Weights::stokes : Weights::intensity;
        options.max_hits = i % 5 == 0 ? 9 : 0;
        options.outlines = i % 8 >= 4;  // sampled by beams; else by paths
        Absorption colour;
        if (i % 4 >= 2) colour.per_length = 0.2;
        const Exits e = trace_view(stone, medium, {direction, random.perpendicular_to(direction)},
                                   options, {&colour, 1});
        CAPTURE(i, e.beams, e.sampled, e.untraced, e.residue);
        CHECK(std::abs(listed(e) + e.cut + e.absorbed + e.residue - e.area_total) <
              1e-12 * e.area_total);
        CHECK(e.residue <= 1.1e-5 * e.untraced);
        CHECK(e.groups > 1);
        // What was traced exactly is what it is without a sample.
        options.error = 0;
        const Exits plain =
            trace_view(stone, medium, {direction, e.frame.up}, options, {&colour, 1});
        CHECK(plain.beams + e.sampled == e.beams);
        CHECK(plain.residue == plain.untraced);
        double exact = 0, without = 0;
        for (std::size_t x = 0; x < e.size(); ++x) {
            if (e.group[x] == 0) exact += e.weight[x].s0 * e.area[x];
        }
        for (std::size_t x = 0; x < plain.size(); ++x) {
            without += plain.weight[x].s0 * plain.area[x];
        }
        CHECK(std::abs(exact - without) < 1e-12 * e.area_total);
    }
}

TEST_CASE("sampled numbers are right on average, and as far off as they say", "[views]") {
    // A bound on hits makes the whole finite, so that it is known without a sample.
    struct Case {
        Medium medium;
        Vec3 direction;
        int hits;
        std::uint64_t beams;
        bool outlines = false;  // sampled by beams; else by paths
        double colour = 0;
    };
    const Case cases[] = {
        {zircon_of_issue, {0.1, 0.23, -1}, 7, 300},
        {zircon_of_issue, {0.1, 0.23, -1}, 7, 300, true},
        {zircon_of_issue, {0, 0, -1}, 9, 30},
        {Medium::isotropic(2.42), {0.1, 0.23, -1}, 9, 100},
        {Medium::isotropic(2.42), {0.1, 0.23, -1}, 9, 100, false, 0.3},
        {Medium::biaxial({1.6, 1.65, 1.7}, {1, 0, 0}, {0, 0, 1}), {0.1, 0.23, -1}, 6, 300}};
    const Stone stone = brilliant_stone();
    const auto table = table_facet(stone);
    int within_one = 0, within_two = 0, count = 0;
    for (const Case& c : cases) {
        ViewOptions options;
        options.bound = 0;
        options.max_beams = 0;
        options.max_hits = c.hits;
        const ParallelView view{c.direction, {0, 1, 0}};
        Absorption colour;
        colour.per_length = c.colour;
        const Exits all = trace_view(stone, c.medium, view, options, {&colour, 1});
        options = sampled_after(c.beams);
        options.max_hits = c.hits;
        options.outlines = c.outlines;
        constexpr int seeds = 60;
        for (const auto& [light, facet] :
             {std::pair(DomeLight{Dome::iso, {0, 0, 1}, 10 * degree}, std::optional<int>{}),
              std::pair(DomeLight{Dome::sc2, normalised(Vec3{0.3, 0, 1}), 0}, table)}) {
            const double truth = light_return(all, light, facet).value;
            double sum = 0, squares = 0;
            for (int s = 0; s < seeds; ++s) {
                options.seed = static_cast<std::uint64_t>(s);
                const LightReturn r = light_return(
                    trace_view(stone, c.medium, view, options, {&colour, 1}), light, facet);
                const double off = r.value - truth;
                CHECK(std::abs(off) <= r.bound);
                sum += off;
                squares += off * off;
                within_one += std::abs(off) <= r.error;
                within_two += std::abs(off) <= 2 * r.error;
                ++count;
            }
            const double sd = std::sqrt(squares / seeds);
            CAPTURE(truth, sd, sum / seeds);
            CHECK(std::abs(sum / seeds) < 4 * sd / std::sqrt(seeds));
        }
    }
    // Of a hundred, by Student's t of 64 pairs of groups 68 and 95, of 8 pairs 65 and 92; more
    // where neighbours differ, who share the light out evenly.
    CHECK(within_one > 0.6 * count);
    CHECK(within_one < 0.82 * count);
    CHECK(within_two > 0.9 * count);
}

TEST_CASE("paths side by side find the same light as paths one by one", "[views]") {
    const Stone stone = brilliant_stone();
    const auto table = table_facet(stone);
    for (const Medium& medium : {Medium::uniaxial(2.6, 2.9, normalised(Vec3{1, 0, 1})),
                                 Medium::uniaxial(1.658, 1.486, {0, 0, 1})}) {
        // Of the light: from above, through the table, after few faces, by faces of low numbers.
        constexpr int seeds = 40;
        std::array<std::array<double, 4>, 2> sum{}, squares{};
        for (int s = 0; s < 2 * seeds; ++s) {
            const std::size_t alone = s % 2 == 1;
            ViewOptions options = sampled_after(300);
            options.seed = static_cast<std::uint64_t>(s);
            options.turns = alone;  // which lanes do not know
            const Exits e = trace_view(stone, medium, {{0.1, 0.23, -1}, {0, 1, 0}}, options);
            CHECK(std::abs(listed(e) + e.residue - e.area_total) < 1e-12 * e.area_total);
            std::array<double, 4> found{};
            for (std::size_t i = 0; i < e.size(); ++i) {
                const double light = e.weight[i].s0 * e.area[i] / e.area_total;
                const bool kinds[] = {e.direction[i].z > 0.3, e.entry[i] == *table, e.hits[i] < 7,
                                      e.facet[i] % 7 < 3};
                for (std::size_t k = 0; k < 4; ++k) found[k] += kinds[k] ? light : 0;
            }
            for (std::size_t k = 0; k < 4; ++k) {
                sum[alone][k] += found[k] / seeds;
                squares[alone][k] += found[k] * found[k] / seeds;
            }
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const auto variance = [&](std::size_t i) {
                return (squares[i][k] - sum[i][k] * sum[i][k]) / seeds;
            };
            CAPTURE(k, sum[0][k], sum[1][k]);
            CHECK(std::abs(sum[0][k] - sum[1][k]) <
                  4 * std::sqrt(variance(0) + variance(1)) + 1e-12);
        }
    }
}
