// Damaged design files of each kind: every truncation of real files, and flipped bytes by the ten
// thousand.
#include <catch2/catch.hpp>
#include <cctype>
#include <cmath>
#include <random>
#include <string>

#include "designs/design.hpp"
#include "math/error.hpp"
#include "stone/stone.hpp"

using namespace icespar;

namespace {

// The sanitizers take twenty times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr int flips = 20'000;
constexpr std::size_t stride = 5;
#else
constexpr int flips = 100'000;
constexpr std::size_t stride = 1;
#endif

struct Format {
    const char* name;
    Design (*read)(std::string_view, const std::string&);
    std::string (*write)(const Design&);
};
const Format formats[] = {
    {"asc", read_asc, asc_text}, {"gem", read_gem, gem_bytes}, {"gcs", read_gcs, gcs_text}};

/// A closed polyhedron by Euler's count, convex by its planes.
bool is_sound(const Stone& stone) {
    std::size_t corners = 0;
    for (const Facet& facet : stone.facets) {
        corners += facet.corners.size();
        for (const Vec3& v : stone.vertices)
            if (!(dot(facet.normal, v) <= facet.distance + 1e-6 * (1 + length(v)))) return false;
    }
    return stone.volume > 0 && std::isfinite(stone.volume) &&
           stone.vertices.size() + stone.facets.size() == corners / 2 + 2;
}

/// Empty when the bytes are read as a design, or refused with their place; `build`: as a stone, or
/// refused.
std::string verdict(const Format& format, const std::string& bytes, bool build) {
    std::vector<FacetPlane> planes;
    try {
        planes = format.read(bytes, "broken").planes();
    } catch (const Error& error) {
        const std::string said = error.what();
        // What is missing altogether has no place.
        const bool placed = said.starts_with("broken: byte ") ||
                            (said.starts_with("broken:") && said.size() > 7 &&
                             std::isdigit(static_cast<unsigned char>(said[7]))) ||
                            said.find("has no facets") != std::string::npos ||
                            said.find("there is no <GemCutStudio>") != std::string::npos;
        return placed ? std::string() : "no place: " + said;
    }
    for (const FacetPlane& plane : planes)
        if (!is_finite(plane.normal) || !std::isfinite(plane.distance)) return "not finite";
    if (!build) return {};
    try {
        return is_sound(Stone::from_planes(planes)) ? std::string() : "a stone that is not sound";
    } catch (const Error& error) {
        return std::string(error.what()).empty() ? "no message" : std::string();
    }
}

}  // namespace

TEST_CASE("every truncation of a design is an error with its place, or a sound stone",
          "[designs][hostile]") {
    const Format format = GENERATE(from_range(std::begin(formats), std::end(formats)));
    const char* file = GENERATE("rose_cut_flat.asc", "trilliant_quartz.asc");
    CAPTURE(format.name, file);
    const std::string whole =
        format.write(read_design(std::string(ICESPAR_SCENES_DIR "/designs/") + file));
    const std::size_t stones = 1 + whole.size() / 150;
    std::string fault;
    for (std::size_t n = 0; n < whole.size() && fault.empty(); n += stride)
        fault = verdict(format, whole.substr(0, n), n % stones == 0);
    CHECK(fault == "");
    CHECK(verdict(format, whole, true) == "");
}

TEST_CASE("flipped bytes are an error with their place, or a sound stone", "[designs][hostile]") {
    const Format format = GENERATE(from_range(std::begin(formats), std::end(formats)));
    CAPTURE(format.name);
    // Small, so that most bytes matter.
    const Design design = read_asc(
        "GemCad 5.0\ng 96 0.0\ny 4 n\nI 1.54\nH A lozenge\n"
        "a -43 0.61 12 n P1 36 60 84 G Meet\na 35.5 0.7 12 n C1 36 60 84\na 0 0.3 96 n T\n",
        "lozenge.asc");
    const std::string whole = format.write(design);
    std::mt19937_64 random(11);
    std::string fault, bytes;
    for (int i = 0; i < flips && fault.empty(); ++i) {
        bytes = whole;
        for (int k = 1 + i % 3; k > 0; --k)
            bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
        fault = verdict(format, bytes, i % 200 == 0);
    }
    CAPTURE(bytes);
    CHECK(fault == "");
}

TEST_CASE("a design whose facets do not close says which directions are open", "[designs]") {
    const Design open = read_asc("GemCad 5.0\ng 96 0.0\na -43 0.6 12 36 60 84\n", "open.asc");
    CHECK_THROWS_WITH(Stone::from_planes(open.planes()),
                      Catch::Contains("runs out towards <") && Catch::Contains("1>"));
}
