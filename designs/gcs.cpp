// Gem Cut Studio's format (.gcs): XML with every facet's normal and corners. Its frame is taken as
// right-handed with the table up along z; index 0 lies at -y, so the stone is turned by 180 degrees
// to have it at +y as in GemCad. The program counts indices the other way round on the crown; here
// they follow from the normals.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <sstream>

#include "designs/solved.hpp"
#include "designs/text.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

constexpr std::size_t most_facets = 10'000;
constexpr double degree = std::numbers::pi / 180;

Vec3 turned(const Vec3& v) { return {-v.x, -v.y, v.z}; }

/// Where Gem Cut Studio says a facet lies, from its normal in that program's frame.
double index_angle(const Vec3& normal) {
    const double azimuth = std::atan2(normal.y, normal.x) / degree;
    const double angle = normal.z > 1e-9 ? 90 + azimuth : 270 - azimuth;
    return angle - 360 * std::floor(angle / 360);
}

class GcsReader {
public:
    GcsReader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}
    Design read();

private:
    [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& message) const {
        const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
        throw Error(file_ + ":" + std::to_string(1 + std::count(text_.begin(), end, '\n')) + ": " +
                    message);
    }
    [[nodiscard]] double number(const pugi::xml_node& node, const char* name,
                                std::optional<double> missing = {}) const;
    void tier(const pugi::xml_node& node, int number_of_tier);
    [[nodiscard]] FacetPlane plane(const pugi::xml_node& facet, double angle, double depth) const;
    void describe(const pugi::xml_node& root);

    std::string_view text_;
    std::string file_;
    Design design_;
    std::size_t facets_ = 0;
};

double GcsReader::number(const pugi::xml_node& node, const char* name,
                         std::optional<double> missing) const {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) {
        if (missing) return *missing;
        fail(node.offset_debug(), "<" + std::string(node.name()) + "> has no '" + name +
                                      "': is this a Gem Cut Studio file?");
    }
    const std::string_view word = attribute.value();
    double value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
        fail(node.offset_debug(), shown(word) + " is not a number: give '" + std::string(name) +
                                      "' of <" + node.name() + "> as one");
    return value;
}

FacetPlane GcsReader::plane(const pugi::xml_node& facet, double angle, double depth) const {
    constexpr double flat = 1e-4;
    Vec3 normal;
    if (facet.attribute("nx")) {
        normal = {number(facet, "nx"), number(facet, "ny"), number(facet, "nz")};
    } else {
        const double azimuth = number(facet, "index_angle");
        const double phi = (angle < 90 - 1e-6 ? azimuth - 90 : 270 - azimuth) * degree;
        normal = {std::sin(angle * degree) * std::cos(phi),
                  std::sin(angle * degree) * std::sin(phi), std::cos(angle * degree)};
    }
    const double size = length(normal);
    if (!(size > 1e-9 && size < 1e9))
        fail(facet.offset_debug(), "a facet's normal has no direction");
    normal = normal / size;
    // The corners say where the facet lies; the tier's depth is stored less precisely.
    double sum = 0, least = 0, most = 0;
    int corners = 0;
    for (const pugi::xml_node& vertex : facet.children("vertex")) {
        const double d =
            dot(normal, Vec3{number(vertex, "x"), number(vertex, "y"), number(vertex, "z")});
        least = corners == 0 ? d : std::min(least, d);
        most = corners == 0 ? d : std::max(most, d);
        sum += d;
        ++corners;
    }
    if (most - least > flat * std::max(1.0, std::abs(most)))
        fail(facet.offset_debug(), "the corners of a facet do not lie in its plane");
    return {turned(normal), corners > 0 ? sum / corners : depth, {}};
}

void GcsReader::tier(const pugi::xml_node& node, int number_of_tier) {
    const std::string name = utf8(node.attribute("name").value());
    // Guides help to design and are not cut.
    if (node.attribute("guide").as_bool()) {
        design_.remarks.push_back("the guide tier " + shown(name) + " is not cut");
        return;
    }
    const double angle = number(node, "angle"), depth = number(node, "depth", 1.0);
    TierBuilder tiers(design_);
    bool any = false;
    for (const pugi::xml_node& facet : node.children("facet")) {
        if (++facets_ > most_facets)
            fail(facet.offset_debug(),
                 "more than " + std::to_string(most_facets) + " facets: split the design");
        FacetPlane p = plane(facet, angle, depth);
        if (!name.empty()) p.name = one_word(name);
        tiers.add(number_of_tier, p, utf8(node.attribute("instructions").value()));
        any = true;
    }
    if (!any) design_.remarks.push_back("the tier " + shown(name) + " has no facets");
}

void GcsReader::describe(const pugi::xml_node& root) {
    const pugi::xml_node info = root.child("info");
    for (const char* name : {"title", "author", "header2", "header3", "date"}) {
        const std::string text = utf8(info.attribute(name).value());
        if (!text.empty()) design_.headers.push_back(text);
    }
    for (const char* name : {"footer1", "footer2", "footer3", "footer4"}) {
        const std::string text = utf8(info.attribute(name).value());
        if (!text.empty()) design_.footnotes.push_back(text);
    }
    const pugi::xml_node render = root.child("render");
    design_.refractive_index = number(render, "refractive_index", 0.0);
    if (design_.refractive_index != 0 && design_.refractive_index < 1)
        fail(render.offset_debug(), "the refractive index is below 1");
}

Design GcsReader::read() {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(text_.data(), text_.size());
    if (!result) fail(result.offset, std::string("this is not sound XML: ") + result.description());
    const pugi::xml_node root = document.child("GemCutStudio");
    if (!root) throw Error(file_ + ": there is no <GemCutStudio>: is this a Gem Cut Studio file?");
    const pugi::xml_node index = root.child("index");
    design_.gear = number(index, "gear", 96.0);
    if (design_.gear == 0) fail(index.offset_debug(), "the gear has no teeth");
    int count = 0;
    for (const pugi::xml_node& node : root.children("tier")) tier(node, ++count);
    if (design_.tiers.empty()) throw Error(file_ + ": the design has no facets");
    describe(root);
    return std::move(design_);
}

void set(pugi::xml_node node, const char* name, double value) {
    node.append_attribute(name).set_value(exact(value).c_str());
}
void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

}  // namespace

Design read_gcs(std::string_view text, const std::string& name) {
    return GcsReader(text, name).read();
}

std::string gcs_text(const Design& design) {
    const SolvedDesign solved(design);
    // Gem Cut Studio's own files reach to 1 across and as far up as down.
    double reach = 0, top = -HUGE_VAL, bottom = HUGE_VAL;
    for (const Vec3& v : solved.stone.vertices) {
        reach = std::max({reach, std::abs(v.x), std::abs(v.y)});
        top = std::max(top, v.z);
        bottom = std::min(bottom, v.z);
    }
    const Vec3 centre{0, 0, 0.5 * (top + bottom)};
    const auto placed = [&](const Vec3& v) { return turned(v - centre) / reach; };

    pugi::xml_document document;
    pugi::xml_node root = document.append_child("GemCutStudio");
    set(root, "version", std::string("1000"));
    pugi::xml_node index = root.append_child("index");
    set(index, "gear", std::abs(design.gear));
    set(index, "base", 0);
    set(index, "symmetry", design.symmetry);
    set(index, "mirror", 0);
    std::size_t plane = 0;
    for (const Tier& t : design.tiers) {
        pugi::xml_node tier;
        std::string name;
        for (const Tier::Cut& cut : t.cuts) {
            const FacetPlane& p = solved.planes[plane];
            const std::vector<Vec3> polygon = solved.polygon(plane++);
            const double depth = (p.distance - dot(p.normal, centre)) / reach;
            if (!tier || cut.name != name) {
                tier = root.append_child("tier");
                name = cut.name;
                set(tier, "angle",
                    std::signbit(p.normal.z) || std::signbit(t.angle) ? 180 - std::abs(t.angle)
                                                                      : t.angle);
                set(tier, "depth", depth);
                set(tier, "name", cut.name);
                set(tier, "instructions", t.instructions);
                set(tier, "visible", std::string("true"));
                set(tier, "guide", std::string("false"));
            }
            const Vec3 normal = turned(p.normal);
            pugi::xml_node facet = tier.append_child("facet");
            set(facet, "nx", normal.x);
            set(facet, "ny", normal.y);
            set(facet, "nz", normal.z);
            set(facet, "index_angle", index_angle(normal));
            for (const Vec3& corner : polygon) {
                const Vec3 v = placed(corner);
                pugi::xml_node vertex = facet.append_child("vertex");
                set(vertex, "x", v.x);
                set(vertex, "y", v.y);
                set(vertex, "z", v.z);
            }
        }
    }
    if (design.refractive_index > 0)
        set(root.append_child("render"), "refractive_index", design.refractive_index);
    pugi::xml_node info = root.append_child("info");
    constexpr const char* headers[] = {"title", "author", "header2", "header3"};
    constexpr const char* footers[] = {"footer1", "footer2", "footer3", "footer4"};
    for (std::size_t i = 0; i < std::min(std::size(headers), design.headers.size()); ++i)
        set(info, headers[i], design.headers[i]);
    for (std::size_t i = 0; i < std::min(std::size(footers), design.footnotes.size()); ++i)
        set(info, footers[i], design.footnotes[i]);
    std::ostringstream out;
    document.save(out, " ", pugi::format_default | pugi::format_no_declaration);
    return out.str();
}

}  // namespace icespar
