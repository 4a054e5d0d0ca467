// Which part of a pixel, or of a few together, shows which facet of a stone, and which the
// background: exactly.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "beams/expansion.hpp"
#include "beams/facet_search.hpp"
#include "scene/scene.hpp"

namespace icespar {

/// The lines of pixel (x, y), counted from the top left, about its centre: picture x to the right
/// and y up, in pixels. Origins are relative to `centre`.
[[nodiscard]] RayField pixel_field(const Camera& camera, int width, int height, double x, double y,
                                   const Vec3& centre);

/// Pixels, first included, last not.
struct Frame {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool holds(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    [[nodiscard]] bool meets(const Frame& f) const {
        return f.x0 < x1 && x0 < f.x1 && f.y0 < y1 && y0 < f.y1;
    }
    [[nodiscard]] int across() const { return x1 - x0; }
    [[nodiscard]] int down() const { return y1 - y0; }
    [[nodiscard]] int count() const { return across() * down(); }
    /// In pixel units, as `pixel_field` counts them.
    [[nodiscard]] Point2 centre() const { return {0.5 * (x0 + x1 - 1), 0.5 * (y0 + y1 - 1)}; }
    /// The corners about the centre.
    [[nodiscard]] std::array<Point2, 4> corners() const {
        const double x = 0.5 * across(), y = 0.5 * down();
        return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
    }
};

/// Where points are seen.
class Projection {
public:
    Projection(const Camera& camera, int width, int height);
    /// The pixels in which the convex hull of the points may be seen: all of them when a point
    /// lies beside or behind the eye.
    [[nodiscard]] Frame frame(std::span<const Vec3> points) const;

private:
    int width_, height_;
    bool parallel_;
    Vec3 eye_, u_, v_, depth_;  ///< (p - eye) . u / (p - eye) . depth is picture u
};

/// A stone's picture. The edges of facets are straight in the picture of either kind of camera.
class Footprint {
public:
    Footprint(const Stone& stone, const Camera& camera, int width, int height);

    /// Beyond it the stone is not seen.
    [[nodiscard]] const Frame& frame() const { return frame_; }

    struct Part {
        int facet = -1;  ///< -1: background
        Polygon polygon;
    };
    /// The parts of these pixels, about their centre; `parts` is reused.
    void divide(const Frame& pixels, std::vector<Part>& parts, std::size_t& count) const;

private:
    struct Seen {
        int facet;
        Frame frame;
        std::vector<Affine> within;  ///< its neighbours
    };
    /// Of the whole picture, counted in pixels from its middle: positive where the line of sight
    /// meets plane `facet`, which faces the camera, within plane `other`.
    [[nodiscard]] Affine within(int facet, int other, const RayField& lines) const;

    int width_, height_;
    FacetSearch facets_;
    Frame frame_;
    std::vector<Seen> seen_;
    std::vector<Affine> outline_;  ///< of facets seen, within neighbours that are not
};

}  // namespace icespar
