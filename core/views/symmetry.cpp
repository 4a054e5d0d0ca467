// Candidates map one facet to each that leans and lies alike; the others must follow.
#include "views/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace icespar {
namespace {

constexpr double rounding = 1e-12;

/// A facet as the view sees it: about an axis along the line of sight.
struct Seen {
    Point2 across;  ///< the part of the normal in the picture
    double along = 0, distance = 0;
};

Vec3 centroid_of(const Stone& stone) {
    const Vec3 origin = stone.vertices[0];
    Vec3 moment;
    double volume = 0;
    for (const Facet& f : stone.facets) {
        const Vec3 a = stone.vertices[f.corners[0]] - origin;
        for (std::size_t i = 2; i < f.corners.size(); ++i) {
            const Vec3 b = stone.vertices[f.corners[i - 1]] - origin,
                       c = stone.vertices[f.corners[i]] - origin;
            const double part = dot(a, cross(b, c));
            volume += part;
            moment += part * (a + b + c);
        }
    }
    return origin + moment / (4 * volume);
}

double size_of(const Point2& p) { return std::hypot(p.x, p.y); }

/// Facets in the order of how they lean, for finding one again.
class SeenFacets {
public:
    SeenFacets(const Stone& stone, const PictureFrame& frame, const Vec3& centre) {
        for (const Facet& f : stone.facets) {
            seen_.push_back({{dot(f.normal, frame.right), dot(f.normal, frame.up)},
                             dot(f.normal, frame.direction),
                             dot(f.normal, stone.vertices[f.corners[0]] - centre)});
            scale_ = std::max(scale_, std::abs(seen_.back().distance));
        }
        order_.resize(seen_.size());
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(),
                  [&](int a, int b) { return of(a).along < of(b).along; });
    }

    [[nodiscard]] const Seen& of(int i) const { return seen_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] int size() const { return static_cast<int>(seen_.size()); }

    /// The one that leans and lies alike, with this normal across if it is given.
    template <class Found>
    void alike(const Seen& s, const Found& found) const {
        auto i = std::lower_bound(order_.begin(), order_.end(), s.along - rounding,
                                  [&](int f, double along) { return of(f).along < along; });
        for (; i != order_.end() && of(*i).along <= s.along + rounding; ++i) {
            if (std::abs(of(*i).distance - s.distance) <= rounding * scale_) found(*i);
        }
    }

    [[nodiscard]] int find(const Seen& s) const {
        int at = -1;
        alike(s, [&](int f) {
            if (size_of(of(f).across - s.across) <= rounding) at = f;
        });
        return at;
    }

private:
    std::vector<Seen> seen_;
    std::vector<int> order_;
    double scale_ = 0;
};

bool keeps(const PictureImage& image, const RealTensor& tensor, const PictureFrame& frame) {
    for (const Vec3& v : {frame.right, frame.up, frame.direction}) {
        const Vec3 field = tensor * v;
        const Vec3 apart = tensor * image.of(v, frame) - image.of(field, frame);
        if (length(apart) > rounding * length(field)) return false;
    }
    return true;
}

std::optional<PictureImage> completed(PictureImage image, const SeenFacets& facets) {
    for (int i = 0; i < facets.size(); ++i) {
        Seen s = facets.of(i);
        s.across = image.turned(s.across);
        image.facets.push_back(facets.find(s));
        if (image.facets.back() < 0) return {};
    }
    return image;
}

/// Positive on the left of a line through the centre, towards `to`.
Affine left_of(const Point2& centre, const Point2& to) {
    return {to.y * centre.x - to.x * centre.y, -to.y, to.x};
}

std::vector<Affine> sector_of(const std::vector<PictureImage>& images) {
    const Point2 centre = images[0].centre;
    const auto towards = [](double angle) { return Point2{std::cos(angle), std::sin(angle)}; };
    const auto mirror = std::find_if(images.begin(), images.end(),
                                     [](const PictureImage& i) { return i.mirrors(); });
    const double whole = 2 * std::numbers::pi, width = whole / static_cast<double>(images.size());
    // A mirror at angle a turns picture-right by 2 a; neighbouring mirrors are one sector apart.
    const double from =
        mirror == images.end() ? 0 : 0.5 * std::atan2(mirror->right.y, mirror->right.x);
    std::vector<Affine> out;
    if (images.size() > 1) out.push_back(left_of(centre, towards(from)));
    if (images.size() > 2) out.push_back(left_of(centre, towards(from + width + whole / 2)));
    return out;
}

}  // namespace

Vec3 PictureImage::of(const Vec3& direction, const PictureFrame& frame) const {
    const Point2 p = turned({dot(direction, frame.right), dot(direction, frame.up)});
    return p.x * frame.right + p.y * frame.up + dot(direction, frame.direction) * frame.direction;
}

Stokes PictureImage::of(const Stokes& s) const {
    // With picture-right turned by a: S1 + i S2 turns by 2 a, of a mirror its conjugate.
    const double c = right.x * right.x - right.y * right.y, d = 2 * right.x * right.y;
    const double sign = mirrors() ? -1 : 1, s2 = sign * s.s2;
    return {s.s0, c * s.s1 - d * s2, d * s.s1 + c * s2, sign * s.s3};
}

ViewSymmetry no_symmetry(const Stone& stone) {
    PictureImage identity;
    identity.facets.resize(stone.facets.size());
    std::iota(identity.facets.begin(), identity.facets.end(), 0);
    return {{identity}, {}};
}

ViewSymmetry symmetry_of(const Stone& stone, const Medium& medium, const RealTensor& loss,
                         const PictureFrame& frame) {
    const Vec3 centre = centroid_of(stone);
    const SeenFacets facets(stone, frame, centre);
    // The facet that has the fewest like it, among those that lean at all.
    constexpr double leans = 1e-3;
    std::vector<int> fewest;
    for (int i = 0; i < facets.size(); ++i) {
        if (size_of(facets.of(i).across) < leans) continue;
        std::vector<int> like;
        facets.alike(facets.of(i), [&](int f) { like.push_back(f); });
        if (!like.empty() && (fewest.empty() || like.size() < fewest.size())) fewest.swap(like);
    }
    ViewSymmetry out = no_symmetry(stone);
    if (fewest.empty()) return out;
    const auto unit = [&](int f) {
        const Point2& p = facets.of(f).across;
        return (1 / size_of(p)) * p;
    };
    const Vec3 middle = centre - frame.centre;
    const Point2 at{dot(middle, frame.right), dot(middle, frame.up)};
    out.images[0].centre = at;
    const Point2 a = unit(fewest[0]);
    for (const bool mirrored : {false, true}) {
        for (const int f : fewest) {
            if (!mirrored && f == fewest[0]) continue;
            // What takes a to b, and a's left to b's left, or to b's right.
            const Point2 b = unit(f);
            const double side = mirrored ? -1 : 1;
            PictureImage image;
            image.centre = at;
            image.right = {a.x * b.x + side * a.y * b.y, a.x * b.y - side * a.y * b.x};
            image.up = {a.y * b.x - side * a.x * b.y, a.y * b.y + side * a.x * b.x};
            if (!keeps(image, real(medium.permittivity()), frame)) continue;
            if (!keeps(image, loss, frame)) continue;
            if (auto whole = completed(std::move(image), facets)) {
                out.images.push_back(std::move(*whole));
            }
        }
    }
    out.sector = sector_of(out.images);
    return out;
}

}  // namespace icespar
