// Faceting diagrams: cut, and design files.
#include <algorithm>
#include <cmath>

#include "designs/design.hpp"
#include "math/error.hpp"
#include "parser/builder.hpp"
#include "parser/limits.hpp"

namespace icespar {
namespace {

/// GemCad's x, y, z (table up along z) are the language's x, z, y: this keeps a stone's handedness.
Vec3 from_gemcad(const Vec3& v) { return {v.x, v.z, v.y}; }

/// Of a gear; far more than there are on any.
constexpr double most_teeth = 1e6;

}  // namespace

void bound_stone(std::size_t count, const Place& place) {
    if (count > limits::stone_points) {
        throw Fault{place,
                    "a stone of more than " + std::to_string(limits::stone_points) +
                        " planes or points, the bound",
                    {}};
    }
}

void Builder::cut(const Block& block, Solid& solid) {
    double gear = 96, offset = 0;
    int facets = 0;
    for (Cursor cursor(block); cursor.more();) {
        if (const auto t = read_transform(cursor)) {
            transform_shape(*t, solid);
            continue;
        }
        const Item& item = cursor.take();
        if (item.word == "gear") {
            gear = cursor.number("the number of teeth", -most_teeth, most_teeth);
            if (gear == 0 || gear != std::floor(gear)) {
                throw Fault{cursor.place(), "a gear has a whole number of teeth, not 0", {}};
            }
        } else if (item.word == "offset") {
            offset = cursor.number("an offset in teeth", -most_teeth, most_teeth);
        } else if (item.word == "facet" && item.kind == Item::Kind::block) {
            ++facets;
            const std::size_t before = solid.planes.size();
            guarded([&] {
                if (!item.block->broken) facet(*item.block, gear, offset, solid);
            });
            if (solid.planes.size() == before) solid.at_fault = true;
            bound_stone(solid.planes.size(), block.place);
        } else if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
        } else {
            throw unexpected(item, "cut");
        }
    }
    if (facets == 0) throw Fault{block.place, "this cut has no facets", {}};
}

void Builder::facet(const Block& block, double gear, double offset, Solid& solid) {
    std::string name;
    std::optional<double> angle, distance;
    std::vector<double> indices;
    for (Cursor cursor(block); cursor.more();) {
        const Item& item = cursor.peek();
        if (item.kind == Item::Kind::value && item.value.text()) {
            name = cursor.text("a name");
            continue;
        }
        cursor.take();
        if (item.word == "name") {
            name = cursor.text("a name");
        } else if (item.word == "angle") {
            angle = cursor.number("the angle of a facet", -90, 90);
        } else if (item.word == "distance") {
            distance = cursor.number("a distance from the stone's centre");
        } else if (item.word == "index") {
            do {
                indices.push_back(cursor.number("a tooth of the gear", -most_teeth, most_teeth));
            } while (cursor.next_is_number());
        } else if (item.word == "every") {
            const double by = cursor.number("a number of teeth");
            const double teeth = std::abs(gear);
            const double count = by > 0 ? teeth / by : 0;
            bound_stone(count < 1e9 ? static_cast<std::size_t>(count) : limits::stone_points + 1,
                        cursor.place());
            if (!(count >= 1) || std::abs(count - std::round(count)) > 1e-9) {
                throw Fault{cursor.place(),
                            "'every' divides the gear of " +
                                std::to_string(static_cast<long long>(teeth)) + " teeth evenly",
                            {}};
            }
            double from = 0;
            if (cursor.accept_word("from"))
                from = cursor.number("a tooth of the gear", -most_teeth, most_teeth);
            for (int i = 0; i < static_cast<int>(std::round(count)); ++i)
                indices.push_back(from + i * by);
        } else if (item.word.empty() && item.kind == Item::Kind::word) {
            cursor.skip_values();
            solid.at_fault = true;
            return;
        } else {
            throw unexpected(item, "facet");
        }
    }
    if (!angle || !distance) {
        throw Fault{block.place, std::string("this facet has no ") + (angle ? "distance" : "angle"),
                    "write facet { \"P1\" angle -41 distance 0.65 every 6 from 3 }"};
    }
    if (indices.empty()) {
        if (*angle != 0) {
            throw Fault{block.place, "this facet has no index",
                        "add 'index 0 6 12 ...' or 'every 6 from 0'"};
        }
        indices.push_back(0);
    }
    if (name.empty())
        name = "line " +
               std::to_string(sources_.line_column(block.place.file, block.place.begin).line);
    solid.facet_places.try_emplace(name, block.place);
    const bool pavilion = std::signbit(*angle) || (*angle == 0 && *distance < 0);
    for (const double index : indices) {
        FacetPlane plane = cut_plane(*angle, *distance, index, gear, offset, pavilion, name);
        plane.normal = from_gemcad(plane.normal);
        solid.planes.push_back(std::move(plane));
    }
}

std::string Builder::design(const Place& place, const std::string& file, Solid& solid) {
    const std::string path = file_named(file, place);
    try {
        const Design design = read_design(path);
        bound_stone(design.facet_count(), place);
        for (const FacetPlane& plane : design.planes()) {
            solid.planes.push_back({from_gemcad(plane.normal), plane.distance, plane.name});
        }
        return path;
    } catch (const Error& error) {
        // By the name that the scene gives it, not by its place on this machine.
        std::string message = error.what();
        if (message.starts_with(path)) message.replace(0, path.size(), printable(file));
        throw Fault{place, message, {}};
    }
}

}  // namespace icespar
