// The polarisation that a picture shows, against Brewster, Fresnel, Malus and the reversal of
// light.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "support/gem_scenes.hpp"
#include "support/recorder.hpp"

using namespace icespar;
using namespace icespar::testing;
using Catch::Matchers::WithinAbs;

namespace {

/// What Fresnel's two total reflections do to light of unit field along (x, y): s along x, p along
/// y. For exp(-i w t) the wave beyond the face decays, so cos_t has a
/// positive imaginary part.
struct FresnelRhomb {
    double n, angle;  ///< incidence on the totally reflecting faces

    [[nodiscard]] Complex s() const { return (n * cos_i() - cos_t()) / (n * cos_i() + cos_t()); }
    [[nodiscard]] Complex p() const { return (cos_i() - n * cos_t()) / (cos_i() + n * cos_t()); }
    [[nodiscard]] double cos_i() const { return std::cos(angle); }
    [[nodiscard]] Complex cos_t() const {
        return {0, std::sqrt(std::pow(n * std::sin(angle), 2) - 1)};
    }
    /// Power through the end faces, met at right angles.
    [[nodiscard]] double ends() const { return std::pow(4 * n / ((n + 1) * (n + 1)), 2); }
    /// s lies along -s at the second face, and p with it: both signs cancel.
    [[nodiscard]] Stokes turned(const Complex& x, const Complex& y) const {
        return ends() * stokes_from_field(s() * s() * x, p() * p() * y);
    }

    /// Looked through along -z by an eye at large z; right is x, up is y.
    [[nodiscard]] Stone stone() const {
        const Vec3 d{0, 0, -1};
        const Vec3 face = cos_i() * d + std::sin(angle) * Vec3{0, 1, 0};
        const std::vector<FacetPlane> planes{{face, 1, "upper"},      {-face, 1, "lower"},
                                             {d, 2, "far end"},       {-d, 2, "near end"},
                                             {{1, 0, 0}, 1, "right"}, {{-1, 0, 0}, 1, "left"}};
        return Stone::from_planes(planes);
    }
    /// Enters at the height from which the path is symmetric about the centre.
    [[nodiscard]] SensorRay eye() const {
        return {{0.1, std::sin(2 * angle) / cos_i(), 10}, {0, 0, -1}, {1, 0, 0}};
    }
};

/// Surroundings of full polarisation `state` that are dark behind the eye and 1 ahead of it.
Environment ahead(const Vec3& direction, const Stokes& state) {
    Environment e = slope(direction);
    e.state = state;
    return e;
}

TraceOptions hits(int n) {
    TraceOptions options;
    options.max_hits = n;
    return options;
}

Stokes rotated_frame(const Stokes& s, double angle) {
    const double c = std::cos(2 * angle), t = std::sin(2 * angle);
    return {s.s0, c * s.s1 + t * s.s2, c * s.s2 - t * s.s1, s.s3};
}

}  // namespace

TEST_CASE("at Brewster's angle reflected light is wholly polarised across the plane of incidence",
          "[render][stokes][convention]") {
    for (const double n : {1.3, 1.5, 2.417}) {
        const Scene scene = scene_of(cube_stone(), glass(n));
        const double c = 1 / std::hypot(1, n), s = n * c;
        const Vec3 d{s, 0, -c};
        const double r_s = (1 - n * n) / (1 + n * n), half = r_s * r_s / 2;
        const Vec3 origin = Vec3{0.1, 0.2, 1} - 5.0 * d;
        CAPTURE(n);
        CHECK(difference(trace_one(scene, {origin, d, {0, 1, 0}}, hits(1)), {half, half, 0, 0}) <=
              1e-15);
        CHECK(difference(trace_one(scene, {origin, d, {c, 0, s}}, hits(1)), {half, -half, 0, 0}) <=
              1e-15);
        // With x turned by -45 degrees from across, the light lies at +45 degrees to it.
        const Vec3 y_axis = cross(-d, Vec3{0, 1, 0});
        const Vec3 diagonal = Vec3{0, 1, 0} - y_axis;
        CHECK(difference(trace_one(scene, {origin, d, diagonal}, hits(1)), {half, 0, half, 0}) <=
              1e-15);
    }
}

TEST_CASE("a glass face mirrors any polarisation as Fresnel's coefficients say",
          "[render][stokes][convention]") {
    testing::Random random(23);
    const double n = 1.5;
    Scene scene = scene_of(cube_stone(), glass(n));
    for (int i = 0; i < 60; ++i) {
        // The eye looks down at the face z = 1; the light comes from where the mirror shows.
        const double c = random.uniform(0.1, 0.95), turn = random.uniform(0, 7);
        const double s = std::sqrt(1 - c * c), c_t = std::sqrt(1 - s * s / (n * n));
        const Vec3 look{s * std::cos(turn), s * std::sin(turn), -c};
        const Vec3 mirror{look.x, look.y, -look.z};
        const Vec3 across = normalised(cross(Vec3{0, 0, 1}, look));
        const Complex ex{random.uniform(-1, 1), random.uniform(-1, 1)};
        const Complex ey{random.uniform(-1, 1), random.uniform(-1, 1)};
        const double size = std::sqrt(std::norm(ex) + std::norm(ey));
        scene.environment = furnace();
        scene.environment.state = stokes_from_field(ex / size, ey / size);

        // Light travels along -mirror and then along -look; p = k x s on both ways.
        const Vec3 y = normalised(Vec3{0, 1, 0} - mirror.y * mirror), x = cross(mirror, y);
        const CVec3 in = (ex / size) * x + (ey / size) * y;
        const double r_s = (c - n * c_t) / (c + n * c_t), r_p = (n * c - c_t) / (n * c + c_t);
        const CVec3 out = (r_s * dot(in, across)) * across +
                          (r_p * dot(in, cross(-mirror, across))) * cross(-look, across);
        const Vec3 right = random.perpendicular_to(look), up = cross(-look, right);
        const Stokes expected = stokes_from_field(dot(out, right), dot(out, up));
        const Vec3 origin = Vec3{0.1, 0.2, 1} - 5.0 * look;
        const Stokes seen = trace_one(scene, {origin, look, right}, hits(1));
        INFO(text(seen) << " expected " << text(expected));
        CHECK(difference(seen, expected) <= 1e-14);
    }
}

TEST_CASE("a Fresnel rhomb turns light at 45 degrees into circular light of the right hand or left",
          "[render][stokes][convention]") {
    // The angle near 54.6 degrees at which the two reflections delay p against s by 90 degrees.
    const auto delay = [](double angle) {
        const FresnelRhomb rhomb{1.51, angle};
        return 2 * std::arg(rhomb.p() / rhomb.s());
    };
    double low = 54.0 * degree, high = 56.0 * degree;
    const double wanted = std::copysign(std::numbers::pi / 2, std::sin(delay(low)));
    const auto short_of = [&](double angle) {
        return std::remainder(delay(angle) - wanted, 2 * std::numbers::pi);
    };
    REQUIRE(short_of(low) * short_of(high) < 0);
    const double sign = std::copysign(1, short_of(low));
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (sign * short_of(middle) > 0 ? low : high) = middle;
    }
    CHECK_THAT(low / degree, WithinAbs(54.6, 0.1));  // Born & Wolf: 54 degrees 37', n = 1.51

    const FresnelRhomb rhomb{1.51, low};
    Scene scene = scene_of(rhomb.stone(), glass(rhomb.n));
    for (const double s2 : {1.0, -1.0}) {
        scene.environment = ahead({0, 0, -1}, {1, 0, s2, 0});
        const Stokes seen = trace_one(scene, rhomb.eye(), hits(4));
        const double a = std::sqrt(0.5);
        const Stokes expected = rhomb.turned(a, s2 * a);
        INFO(text(seen) << " expected " << text(expected));
        CHECK(difference(seen, expected) <= 1e-14);
        CHECK_THAT(std::abs(seen.s3), WithinAbs(seen.s0, 1e-14));
    }
}

TEST_CASE("a rhomb at any angle does to any polarisation what Fresnel's coefficients say",
          "[render][stokes]") {
    testing::Random random(17);
    for (const double angle : {45.5, 50.0, 57.0, 60.0}) {
        const FresnelRhomb rhomb{1.51, angle * degree};
        Scene scene = scene_of(rhomb.stone(), glass(rhomb.n));
        for (int i = 0; i < 10; ++i) {
            const Complex x{random.uniform(-1, 1), random.uniform(-1, 1)};
            const Complex y{random.uniform(-1, 1), random.uniform(-1, 1)};
            const double size = std::sqrt(std::norm(x) + std::norm(y));
            scene.environment = ahead({0, 0, -1}, stokes_from_field(x / size, y / size));
            const Stokes seen = trace_one(scene, rhomb.eye(), hits(4));
            const Stokes expected = rhomb.turned(x / size, y / size);
            INFO(angle << ": " << text(seen) << " expected " << text(expected));
            CHECK(difference(seen, expected) <= 2e-14);
        }
    }
}

TEST_CASE("polarised surroundings show their own Stokes vector, turned with the receiver's frame",
          "[render][stokes][convention]") {
    testing::Random random(4);
    for (int i = 0; i < 200; ++i) {
        Scene scene;
        scene.environment = furnace();
        const Vec3 pole = random.uniform() * random.direction();
        const Stokes state{1, pole.x, pole.y, pole.z};
        scene.environment.state = state;
        Vec3 d = random.direction();
        if (i == 0) d = normalised(Vec3{1e-3, -1, 1e-3});
        const Vec3 right = normalised(cross(d, Vec3{0, 1, 0})), up = cross(right, d);
        const double turn = random.uniform(-4, 4), lean = random.uniform(-2, 2);
        // A lean of x along the ray is taken out, and its length does not matter.
        const Vec3 x = random.uniform(0.1, 9) * (std::cos(turn) * right + std::sin(turn) * up) +
                       lean * 0.1 * d;
        const Stokes seen = trace_one(scene, {{1, 2, 3}, d, x});
        INFO(text(seen) << " of " << text(state) << " turned by " << turn);
        CHECK(difference(seen, rotated_frame(state, turn)) <= 1e-13);
    }
}

TEST_CASE("a picture of polarised surroundings is in the frame of its camera",
          "[render][stokes][convention]") {
    Scene scene;
    scene.environment = furnace();
    const Stokes state{1, 0.3, -0.5, 0.7};
    scene.environment.state = state;
    const double turn = GENERATE(0.0, 30.0, -75.0);
    CAPTURE(turn);
    const double c = std::cos(turn * degree), s = std::sin(turn * degree);
    const double tiny = 1e-6;
    scene.camera.location = {3, 1, 2};
    scene.camera.direction = {0, 0, -1};
    scene.camera.right = tiny * Vec3{c, s, 0};
    scene.camera.up = tiny * Vec3{-s, c, 0};
    RenderOptions options;
    options.width = options.height = 2;
    options.samples = 2;
    options.stokes = true;
    const Image image = render(scene, options).image;
    const Stokes expected = rotated_frame(state, turn * degree);
    for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float* seen = &image.rgb_stokes[(p * 3 + channel) * 3];
            CHECK_THAT(image.rgb[p * 3 + channel], WithinAbs(1, 2e-6));
            CHECK_THAT(seen[0], WithinAbs(expected.s1, 2e-6));
            CHECK_THAT(seen[1], WithinAbs(expected.s2, 2e-6));
            CHECK_THAT(seen[2], WithinAbs(expected.s3, 2e-6));
        }
    }
}

namespace {

/// Light sent along a ray: the power that goes out after `hits` events near a point and direction.
double through(const World& world, const Palette& palette, const Vec3& origin,
               const Vec3& direction, int hits, const Vec3& point, const Vec3& outward) {
    double sum = 0;
    for (const Branch& b : recorded(world, palette, origin, direction, hits).out) {
        const Vec3 off = point - b.position;
        const double aside = length(off - dot(off, outward) * outward);
        if (b.hits == hits && length(b.ray - outward) < 1e-9 && aside < 1e-9) sum += b.weight;
    }
    return sum;
}

}  // namespace

TEST_CASE("light passes a stone backwards as well as forwards", "[render][reciprocity]") {
    int compared = 0;
    for (int seed = 0; seed < 24; ++seed) {
        testing::Random random(static_cast<std::uint64_t>(seed));
        const Crystal crystal =
            seed % 3 == 0 ? zircon(random.direction()) : calcite(random.direction());
        const Scene scene = scene_of(rhomb_stone(), crystal);
        const SensorRay ray = random_ray(random, 4, 0.4);
        const World world(scene);
        const Palette palette(scene, 0);
        for (const Branch& b : recorded(world, palette, ray.origin, ray.direction, 5).out) {
            if (b.weight < 1e-5) continue;
            const Vec3 eye = b.position + 3.0 * b.ray;
            const double forth =
                through(world, palette, ray.origin, ray.direction, b.hits, b.position, b.ray);
            const double back =
                through(world, palette, eye, -b.ray, b.hits, ray.origin, -ray.direction);
            CAPTURE(seed, b.hits, in_digits(forth), in_digits(back), in_digits(forth - back));
            CHECK(std::abs(forth - back) <= 1e-12 * forth);
            ++compared;
        }
    }
    CHECK(compared > 200);
}
