// GemCad's binary format (.gem), little-endian: for each facet the vector n / distance, its tier's
// number, a text "name TAB instructions" and the polygon's corners; then -99999, and what the
// design says of itself. Worked out from files whose .asc is known; no description is published.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "designs/design.hpp"
#include "designs/solved.hpp"
#include "designs/text.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

constexpr double end_of_facets = -99999;
constexpr std::size_t most_facets = 10'000;
constexpr std::int32_t unexplained = 0x7FFF;  // between index and offset in every file seen
constexpr std::size_t lines = 4;              // of headers, and of footnotes
static_assert(std::endian::native == std::endian::little);

class GemReader {
public:
    GemReader(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}
    Design read();

private:
    struct Entry {
        FacetPlane plane;
        std::int32_t tier;
        std::string instructions;
    };

    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        throw Error(file_ + ": byte " + std::to_string(at) + ": " + message);
    }
    void need(std::size_t count, const char* what) const {
        if (bytes_.size() - at_ < count)
            fail(at_,
                 "the file ends within " + std::string(what) + ": it is cut off; copy it again");
    }
    template <class T>
    T take(const char* what) {
        need(sizeof(T), what);
        T value;
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    double take_number(const char* what) {
        const std::size_t here = at_;
        const double value = take<double>(what);
        if (!std::isfinite(value))
            fail(here, std::string(what) + " is not a number: is this a GemCad .gem file?");
        return value;
    }
    std::string take_text(const char* what) {
        const auto size = take<std::uint8_t>(what);
        need(size, what);
        const std::string_view text = bytes_.substr(at_, size);
        at_ += size;
        return utf8(text);
    }
    Entry facet(double x);
    void trailer();

    std::string_view bytes_;
    std::string file_;
    std::size_t at_ = 0;
    Design design_;
};

GemReader::Entry GemReader::facet(double x) {
    const std::size_t here = at_ - sizeof x;
    const double y = take_number("a facet"), z = take_number("a facet");
    const Vec3 v{x, y, z};
    const double size = length(v);
    if (!(size > 1e-9 && size < 1e9))
        fail(here, "a facet's plane has no place: is this a GemCad .gem file?");
    Entry out{{v / size, 1 / size, {}}, take<std::int32_t>("a facet"), {}};
    const std::string text = take_text("a facet's name");
    const std::size_t tab = text.find('\t');
    out.plane.name = one_word(text.substr(0, tab));
    if (out.plane.name == "-") out.plane.name.clear();
    if (tab != std::string::npos) out.instructions = text.substr(tab + 1);
    // The corners follow from the planes.
    for (;;) {
        const std::size_t marker_at = at_;
        const auto marker = take<std::int32_t>("a facet's corners");
        if (marker == 0) return out;
        if (marker != 1)
            fail(marker_at,
                 "a facet's corners are not as GemCad writes them: is this a GemCad .gem file?");
        for (int i = 0; i < 3; ++i) (void)take_number("a facet's corners");
    }
}

void GemReader::trailer() {
    const std::size_t here = at_;
    design_.symmetry = take<std::int32_t>("the symmetry");
    design_.mirror = take<std::int32_t>("the symmetry") != 0;
    design_.gear = take<std::int32_t>("the gear");
    if (design_.symmetry < 1 || design_.symmetry > 10'000)
        fail(here, "the symmetry is not a count of folds");
    if (design_.gear == 0) fail(here + 8, "the gear has no teeth");
    design_.refractive_index = take_number("the refractive index");
    if (design_.refractive_index != 0 && design_.refractive_index < 1)
        fail(here + 12, "the refractive index is below 1");
    (void)take<std::int32_t>("the design's settings");
    design_.gear_offset = take_number("the gear's offset");
    for (std::size_t i = 0; i < 2 * lines; ++i) {
        if (at_ == bytes_.size()) break;
        (i < lines ? design_.headers : design_.footnotes)
            .push_back(take_text("the design's titles"));
    }
    for (auto* texts : {&design_.headers, &design_.footnotes}) {
        while (!texts->empty() && texts->back().find_first_not_of(' ') == std::string::npos)
            texts->pop_back();
    }
    if (at_ < bytes_.size()) {
        design_.remarks.push_back(std::to_string(bytes_.size() - at_) +
                                  " bytes after the design (a preform?) are not read");
    }
}

Design GemReader::read() {
    std::vector<Entry> entries;
    for (;;) {
        const double x = take_number("the facets");
        if (x == end_of_facets) break;
        if (entries.size() == most_facets)
            fail(at_, "more than " + std::to_string(most_facets) + " facets: split the design");
        entries.push_back(facet(x));
    }
    if (entries.empty()) throw Error(file_ + ": the design has no facets");
    trailer();
    TierBuilder tiers(design_);
    for (const Entry& entry : entries) tiers.add(entry.tier, entry.plane, entry.instructions);
    tiers.finish();
    return std::move(design_);
}

class GemWriter {
public:
    template <class T>
    void put(const T& value) {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), &value, sizeof value);
        out_.append(raw.data(), raw.size());
    }
    void put(const Vec3& v) {
        for (const double c : {v.x, v.y, v.z}) put(c);
    }
    void put_text(std::string_view text) {
        const std::string page = for_gemcad(text).substr(0, 255);
        put(static_cast<std::uint8_t>(page.size()));
        out_ += page;
    }
    std::string out_;
};

}  // namespace

Design read_gem(std::string_view bytes, const std::string& name) {
    return GemReader(bytes, name).read();
}

std::string gem_bytes(const Design& design) {
    const SolvedDesign solved(design);
    GemWriter writer;
    std::int32_t number = 0;
    std::size_t plane = 0;
    for (const Tier& tier : design.tiers) {
        ++number;
        std::string name;
        for (const Tier::Cut& cut : tier.cuts) {
            const FacetPlane& p = solved.planes[plane];
            if (!(p.distance > 0))
                throw Error(
                    "facet '" + cut.name +
                    "' passes through the stone's centre, which .gem cannot say: write .asc");
            // The side of a girdle facet shows in the sign of its zero.
            const double z =
                std::copysign(p.normal.z, std::signbit(tier.angle) ? -1.0 : p.normal.z);
            writer.put(Vec3{p.normal.x, p.normal.y, z} / p.distance);
            writer.put(number);
            writer.put_text((cut.name == name ? std::string() : cut.name) + "\t" +
                            tier.instructions);
            name = cut.name;
            for (const Vec3& corner : solved.polygon(plane)) {
                writer.put(std::int32_t{1});
                writer.put(corner);
            }
            writer.put(std::int32_t{0});
            ++plane;
        }
    }
    writer.put(end_of_facets);
    writer.put(static_cast<std::int32_t>(design.symmetry));
    writer.put(static_cast<std::int32_t>(design.mirror));
    writer.put(static_cast<std::int32_t>(design.gear));
    writer.put(design.refractive_index);
    writer.put(unexplained);
    writer.put(design.gear_offset);
    for (const auto* texts : {&design.headers, &design.footnotes}) {
        for (std::size_t i = 0; i < lines; ++i)
            writer.put_text(i < texts->size() ? (*texts)[i] : std::string());
    }
    return std::move(writer.out_);
}

}  // namespace icespar
