// Facets towards the camera, and the outline of them all.
#include "beams/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace icespar {
namespace {

/// Of a pixel, in pixels from the picture's.
Point2 pixel_middle(int width, int height, double x, double y) {
    return {x + 0.5 - 0.5 * width, 0.5 * height - y - 0.5};
}

enum class Side { within, beyond, both };

/// Where a rectangle about the origin lies, of which this is a corner.
Side side(const Affine& f, const Point2& corner) {
    const double reach = corner.x * std::abs(f.dx) + corner.y * std::abs(f.dy);
    return f.value >= reach ? Side::within : f.value < -reach ? Side::beyond : Side::both;
}

}  // namespace

RayField pixel_field(const Camera& camera, int width, int height, double x, double y,
                     const Vec3& centre) {
    const Vec3 right = camera.right / width, up = camera.up / height;
    const Point2 middle = pixel_middle(width, height, x, y);
    const Vec3 offset = middle.x * right + middle.y * up;
    const Vec3 location = camera.location - centre;
    if (camera.kind == Camera::Kind::orthographic) {
        return {{location + offset, right, up}, {normalised(camera.direction), {}, {}}};
    }
    return {{location, {}, {}}, {camera.direction + offset, right, up}};
}

Projection::Projection(const Camera& camera, int width, int height)
    : width_(width),
      height_(height),
      parallel_(camera.kind == Camera::Kind::orthographic),
      eye_(camera.location) {
    // p - eye = z (direction + u right + v up), or without the z in a parallel view.
    const double volume = dot(camera.direction, cross(camera.right, camera.up));
    u_ = cross(camera.up, camera.direction) / volume;
    v_ = cross(camera.direction, camera.right) / volume;
    depth_ = cross(camera.right, camera.up) / volume;
}

Frame Projection::frame(std::span<const Vec3> points) const {
    const Frame all{0, 0, width_, height_};
    Frame out{width_, height_, 0, 0};
    for (const Vec3& point : points) {
        const Vec3 p = point - eye_;
        const double z = parallel_ ? 1 : dot(p, depth_);
        const double x = (dot(p, u_) / z + 0.5) * width_, y = (0.5 - dot(p, v_) / z) * height_;
        if (!(z > 0) || !std::isfinite(x) || !std::isfinite(y)) return all;
        // A pixel more on either side, for rounding.
        const auto low = [](double v, int size) {
            return static_cast<int>(std::clamp(std::floor(v) - 1, 0.0, size + 0.0));
        };
        const auto high = [](double v, int size) {
            return static_cast<int>(std::clamp(std::floor(v) + 2, 0.0, size + 0.0));
        };
        out = {std::min(out.x0, low(x, width_)), std::min(out.y0, low(y, height_)),
               std::max(out.x1, high(x, width_)), std::max(out.y1, high(y, height_))};
    }
    return out;
}

Affine Footprint::within(int facet, int other, const RayField& lines) const {
    // With gap = d - n . origin and ahead = n . direction, the line reaches plane f at gap_f /
    // ahead_f and is then gap_g - ahead_g gap_f / ahead_f from plane g; ahead_f is negative. Either
    // the gaps or the aheads are constant over the picture, so that the product is linear; and
    // taken for (g, f) it is exactly the opposite, so that no part is lost between facets.
    const Affine up_f = lines.direction.along(facets_.normal(facet)),
                 up_g = lines.direction.along(facets_.normal(other));
    const Affine at_f = lines.origin.along(facets_.normal(facet)),
                 at_g = lines.origin.along(facets_.normal(other));
    const double gap_f = facets_.distance(facet) - at_f.value,
                 gap_g = facets_.distance(other) - at_g.value;
    return {gap_f * up_g.value - gap_g * up_f.value,
            (gap_f * up_g.dx - gap_g * up_f.dx) - (at_f.dx * up_g.value - at_g.dx * up_f.value),
            (gap_f * up_g.dy - gap_g * up_f.dy) - (at_f.dy * up_g.value - at_g.dy * up_f.value)};
}

Footprint::Footprint(const Stone& stone, const Camera& camera, int width, int height)
    : width_(width), height_(height), facets_(stone) {
    const Projection projection(camera, width, height);
    const auto faces = [&](const Facet& f, int i) {
        return camera.kind == Camera::Kind::orthographic
                   ? dot(f.normal, camera.direction) < 0
                   : dot(f.normal, camera.location - facets_.centre()) > facets_.distance(i);
    };
    frame_ = {width, height, 0, 0};
    std::vector<int> place(stone.facets.size(), -1);
    for (int i = 0; i < facets_.facets(); ++i) {
        const Facet& f = stone.facets[static_cast<std::size_t>(i)];
        if (!faces(f, i)) continue;
        std::vector<Vec3> polygon;
        for (const std::uint32_t c : f.corners) polygon.push_back(stone.vertices[c]);
        place[static_cast<std::size_t>(i)] = static_cast<int>(seen_.size());
        seen_.push_back({i, projection.frame(polygon), {}});
        const Frame& own = seen_.back().frame;
        frame_ = {std::min(frame_.x0, own.x0), std::min(frame_.y0, own.y0),
                  std::max(frame_.x1, own.x1), std::max(frame_.y1, own.y1)};
    }
    const auto around = neighbours(stone);
    const RayField lines =
        pixel_field(camera, width, height, 0.5 * (width - 1), 0.5 * (height - 1), facets_.centre());
    for (Seen& s : seen_) {
        for (const int j : around[static_cast<std::size_t>(s.facet)]) {
            s.within.push_back(within(s.facet, j, lines));
            if (place[static_cast<std::size_t>(j)] < 0) outline_.push_back(s.within.back());
        }
    }
}

void Footprint::divide(const Frame& pixels, std::vector<Part>& parts, std::size_t& count) const {
    count = 0;
    const Point2 centre = pixels.centre();
    const Point2 middle = pixel_middle(width_, height_, centre.x, centre.y);
    const std::array<Point2, 4> corners = pixels.corners();
    const Point2& corner = corners[2];
    const auto here = [&](const Affine& f) { return Affine{f(middle), f.dx, f.dy}; };
    const auto next = [&](int facet) -> Polygon& {
        if (count == parts.size()) parts.emplace_back();
        parts[count].facet = facet;
        return parts[count].polygon;
    };
    Polygon rest(corners.begin(), corners.end()), swap;
    for (const Affine& border : outline_) {
        const Affine f = here(border);
        if (side(f, corner) == Side::within) continue;
        split(rest, f, swap, next(-1));
        if (!(extent(parts[count].polygon).area > 0)) continue;
        ++count;
        rest.swap(swap);
        if (rest.empty()) return;
    }
    for (const Seen& s : seen_) {
        if (!s.frame.meets(pixels)) continue;
        Polygon& part = next(s.facet);
        part = rest;
        for (const Affine& neighbour : s.within) {
            const Affine f = here(neighbour);
            const Side where = side(f, corner);
            if (where == Side::within) continue;
            if (where == Side::beyond) {
                part.clear();
                break;
            }
            clip(part, f, swap);
            part.swap(swap);
            if (part.empty()) break;
        }
        if (extent(part).area > 0) ++count;
    }
}

}  // namespace icespar
