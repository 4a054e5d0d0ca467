// translate, rotate, scale, matrix and transform, composed in the order they are written.
#include <cmath>
#include <numbers>

#include "math/error.hpp"
#include "parser/builder.hpp"

namespace icespar {
namespace {

/// About x, then y, then z, by degrees; in left-handed coordinates, thumb of the left hand along
/// the axis.
Transform rotation(const Vec3& degrees) {
    // Right angles are exact, so that facets that should be parallel are.
    const auto sine_cosine = [](double degree) {
        const double turns = std::fmod(degree, 360.0);
        if (std::fmod(turns, 90.0) == 0) {
            const int quarter = (static_cast<int>(turns / 90) % 4 + 4) % 4;
            constexpr std::array<double, 4> sines{0, 1, 0, -1};
            return std::pair{sines[static_cast<std::size_t>(quarter)],
                             sines[static_cast<std::size_t>((quarter + 1) % 4)]};
        }
        const double radians = turns * std::numbers::pi / 180;
        return std::pair{std::sin(radians), std::cos(radians)};
    };
    Transform t;
    const auto [sx, cx] = sine_cosine(degrees.x);
    t = t.then({{Vec3{1, 0, 0}, Vec3{0, cx, -sx}, Vec3{0, sx, cx}}, Vec3{}});
    const auto [sy, cy] = sine_cosine(degrees.y);
    t = t.then({{Vec3{cy, 0, sy}, Vec3{0, 1, 0}, Vec3{-sy, 0, cy}}, Vec3{}});
    const auto [sz, cz] = sine_cosine(degrees.z);
    return t.then({{Vec3{cz, -sz, 0}, Vec3{sz, cz, 0}, Vec3{0, 0, 1}}, Vec3{}});
}

/// The images of x, y and z, and the translation; the parser hands the twelve numbers over as four
/// vectors.
Transform matrix(Cursor& cursor) {
    std::array<Vec3, 4> rows;
    for (Vec3& row : rows) row = cursor.vector("four vectors of 3");
    return {{Vec3{rows[0].x, rows[1].x, rows[2].x}, Vec3{rows[0].y, rows[1].y, rows[2].y},
             Vec3{rows[0].z, rows[1].z, rows[2].z}},
            rows[3]};
}

Transform checked(const Transform& t, const Place& place) {
    const std::array<Vec3, 4> images{t.point({0, 0, 0}), t.point({1, 0, 0}), t.point({0, 1, 0}),
                                     t.point({0, 0, 1})};
    for (const Vec3& p : images) {
        if (!is_finite(p)) throw Fault{place, "this transform is not finite", {}};
    }
    return t;
}

}  // namespace

Transform transform_of(const Block& block) {
    Transform all;
    bool inverse = false;
    for (Cursor cursor(block); cursor.more();) {
        if (const auto t = read_transform(cursor)) {
            all = all.then(*t);
        } else if (const Item& item = cursor.take(); item.word == "inverse") {
            inverse = true;
        } else if (item.kind == Item::Kind::value) {
            if (const BlockPtr* inner = item.value.block();
                inner && (*inner)->word == "transform") {
                all = all.then(transform_of(**inner));
            } else if (!item.value.empty()) {
                throw Fault{item.place, "expected a transform, found " + kind_of(item.value), {}};
            }
        }
    }
    return inverse ? all.inverse() : all;
}

const Transform& mirror() {
    static const Transform m = Transform::scaling({1, 1, -1});
    return m;
}

std::optional<Transform> read_transform(Cursor& cursor) {
    if (!cursor.more()) return std::nullopt;
    const Item& item = cursor.peek();
    const Place place = item.place;
    try {
        if (item.kind == Item::Kind::block && item.word == "transform") {
            cursor.take();
            return checked(transform_of(*item.block), place);
        }
        if (item.kind != Item::Kind::word) return std::nullopt;
        if (item.word == "translate") {
            cursor.take();
            return checked(Transform::translation(cursor.vector("a distance")), place);
        }
        if (item.word == "rotate") {
            cursor.take();
            return rotation(cursor.vector("three angles"));
        }
        if (item.word == "scale") {
            cursor.take();
            const Vec3 by = cursor.vector("a factor");
            if (by.x == 0 || by.y == 0 || by.z == 0) {
                throw Fault{cursor.place(), "a scale of 0 flattens space",
                            "give three factors that are not 0, such as <2, 1, 1>"};
            }
            return checked(Transform::scaling(by), place);
        }
        if (item.word == "matrix") {
            cursor.take();
            return checked(matrix(cursor), place);
        }
        if (item.word == "transform") {
            cursor.take();
            if (cursor.next_is(Item::Kind::value)) {
                const Item& value = cursor.take();
                if (const BlockPtr* t = value.value.block(); t && (*t)->word == "transform") {
                    return checked(transform_of(**t), place);
                }
                if (value.value.empty()) return Transform{};
            }
            throw Fault{cursor.place(), "'transform' needs a block or the name of one", {}};
        }
    } catch (const Error& error) {
        throw Fault{place, error.what(), {}};
    }
    return std::nullopt;
}

}  // namespace icespar
