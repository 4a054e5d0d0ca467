// Which part of a pixel shows which facet of a stone, and which the background: exactly.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "beams/expansion.hpp"
#include "beams/facet_search.hpp"
#include "scene/scene.hpp"

namespace icespar {

/// A pixel's corners about its centre.
inline constexpr std::array<Point2, 4> pixel_square{
    {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};

/// The lines of pixel (x, y), counted from the top left, about its centre: picture x to the right
/// and y up, in pixels. Origins are relative to `centre`.
[[nodiscard]] RayField pixel_field(const Camera& camera, int width, int height, double x, double y,
                                   const Vec3& centre);

/// Pixels, first included, last not.
struct Frame {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool holds(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
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
    /// The parts of a pixel within the frame; `parts` is reused.
    void divide(int x, int y, std::vector<Part>& parts, std::size_t& count) const;

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
