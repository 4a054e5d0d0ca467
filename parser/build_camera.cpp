// The camera, computed as POV-Ray 3.7 does, so that the same block gives the same view.
#include <cmath>
#include <numbers>

#include "parser/builder.hpp"

namespace icespar {

namespace {

struct View {
    Camera::Kind kind = Camera::Kind::perspective;
    Vec3 location{0, 0, 0}, direction{0, 0, 1}, right{1.33, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
    Vec3 look_at{0, 0, 1};
    bool looks = false, sized = false;
    double angle = 0;
    double aperture = 0;
    std::optional<Vec3> focal_point{};
    std::optional<Jones> analyser{};
    Transform place{};
    Place look_place;
};

/// What passes: linear light at an angle from x towards y, or one hand of circular light.
Jones analyser(const Block& block) {
    Cursor cursor(block);
    if (cursor.accept_word("linear")) {
        const double angle = cursor.number("an angle in degrees");
        return jones_polariser(angle * std::numbers::pi / 180);
    }
    if (cursor.accept_word("circular")) {
        const bool right = cursor.accept_word("right");
        if (right || cursor.accept_word("left")) {
            // Right circular is (1, -i), of S3 = 2 Im(Ex Ey*) > 0.
            const std::complex<double> i(0, right ? 0.5 : -0.5);
            return {{{{0.5, i}, {-i, 0.5}}}};
        }
    }
    throw Fault{block.place, "'analyser' takes linear ANGLE, circular right, or circular left", {}};
}

View read(const Block& block) {
    View view;
    view.look_place = block.place;
    std::optional<Place> angle_place;
    for (Cursor cursor(block); cursor.more();) {
        if (const auto t = read_transform(cursor)) {
            view.place = view.place.then(*t);
            continue;
        }
        const Item& item = cursor.take();
        const auto vector = [&](std::string_view what) {
            const Vec3 v = cursor.vector(what);
            if (!(length(v) > 0))
                throw Fault{cursor.place(), "'" + std::string(item.word) + "' of length 0", {}};
            return v;
        };
        if (item.word == "perspective") {
            view.kind = Camera::Kind::perspective;
        } else if (item.word == "orthographic") {
            view.kind = Camera::Kind::orthographic;
        } else if (item.word == "fisheye") {
            view.kind = Camera::Kind::fisheye;
        } else if (item.word == "aperture") {
            view.aperture = cursor.number("an aperture", 0, 1e9);
        } else if (item.word == "focal_point") {
            view.focal_point = cursor.vector("a point");
        } else if (item.word == "blur_samples" || item.word == "confidence" ||
                   item.word == "variance") {
            // As many as the picture needs.
            while (cursor.next_is_number()) (void)cursor.number("a number");
        } else if (item.word == "analyser" && item.kind == Item::Kind::block) {
            if (item.block->broken) throw Poisoned{item.place};
            view.analyser = analyser(*item.block);
        } else if (item.word == "location") {
            view.location = cursor.vector("a point");
        } else if (item.word == "look_at") {
            view.look_at = cursor.vector("a point");
            view.looks = true;
            view.look_place = cursor.place();
        } else if (item.word == "direction") {
            view.direction = vector("a direction");
        } else if (item.word == "right" || item.word == "up") {
            (item.word == "up" ? view.up : view.right) = vector("a direction");
            view.sized = true;
        } else if (item.word == "sky") {
            view.sky = cursor.vector("a direction");
        } else if (item.word == "angle") {
            view.angle = cursor.number("an angle of view");
            angle_place = cursor.place();
        } else if (item.kind == Item::Kind::value && item.value.block() &&
                   (*item.value.block())->word == "camera") {
            view = read(**item.value.block());
        } else if (item.kind == Item::Kind::value && !item.value.empty()) {
            throw unexpected(item, "camera");
        } else if (item.word.empty()) {
            cursor.skip_values();
        }
    }
    const double widest = view.kind == Camera::Kind::fisheye ? 360 : 180;
    if (angle_place &&
        !(view.angle > 0 && (view.angle < 180 || (widest == 360 && view.angle <= 360)))) {
        throw Fault{*angle_place,
                    "an angle of view lies between 0 and " +
                        std::to_string(static_cast<int>(widest)) + " degrees",
                    {}};
    }
    return view;
}

}  // namespace

/// As in POV-Ray the order of the items does not matter: first `angle` sets the size of the view,
/// then `look_at` turns it and keeps the vectors' lengths, then the transforms move all of it.
Camera build_camera(const Block& block) {
    View view = read(block);
    Vec3 &direction = view.direction, &right = view.right, &up = view.up;
    const double tangent = std::tan(view.angle * std::numbers::pi / 360);
    const double distance = length(view.look_at - view.location);
    if (view.kind == Camera::Kind::fisheye) {
        if (!(view.angle > 0)) view.angle = 180;
    } else if (view.kind == Camera::Kind::perspective) {
        if (view.angle > 0) direction = normalised(direction) * (length(right) / (2 * tangent));
    } else if (view.angle > 0 || !view.sized) {
        // The view is as wide where it looks at as a perspective one would be.
        const double f =
            view.angle > 0 ? 2 * tangent * distance / length(right) : distance / length(direction);
        if (!(f > 0)) throw Fault{view.look_place, "the camera looks at where it stands", {}};
        right = right * f;
        up = up * f;
    }
    if (view.looks) {
        if (!(distance > 0))
            throw Fault{view.look_place, "the camera looks at where it stands", {}};
        const double along = length(direction), across = length(right), high = length(up);
        const double handedness = dot(cross(up, direction), right) > 0 ? 1 : -1;
        const Vec3 forward = (view.look_at - view.location) / distance;
        Vec3 side = cross(view.sky, forward);
        if (length(side) < 1e-10) side = right;  // straight along the sky: `right` decides
        side = normalised(side);
        const Vec3 above = cross(forward, side);
        if (length(above) < 1e-10) {
            throw Fault{view.look_place, "the camera looks along its 'sky' and its 'right'",
                        "give a 'sky' across the view"};
        }
        direction = forward * along;
        right = side * (handedness * across);
        up = normalised(above) * high;
    }
    Camera camera;
    camera.kind = view.kind;
    camera.location = mirrored(view.place.point(view.location));
    camera.direction = mirrored(view.place.vector(direction));
    camera.right = mirrored(view.place.vector(right));
    camera.up = mirrored(view.place.vector(up));
    camera.fisheye_angle = view.angle * std::numbers::pi / 180;
    camera.analyser = view.analyser;
    if (view.aperture > 0) {
        // POV-Ray's lens reaches a quarter of the aperture from its middle.
        camera.lens_radius = 0.25 * view.aperture;
        const Vec3 focus = view.focal_point ? *view.focal_point
                           : view.looks     ? view.look_at
                                            : view.location + direction;
        const Vec3 seen = mirrored(view.place.point(focus)) - camera.location;
        camera.focal_distance = dot(seen, normalised(camera.direction));
        if (!(camera.focal_distance > 0)) {
            throw Fault{block.place, "this camera's focal_point is not before it", {}};
        }
    }
    if (!(std::abs(dot(cross(camera.right, camera.up), camera.direction)) > 0)) {
        throw Fault{block.place,
                    "this camera sees nothing: its right, up and direction lie in a plane",
                    {}};
    }
    return camera;
}

}  // namespace icespar
