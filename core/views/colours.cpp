// Where depth varies little over a polygon, its second moments tell the mean.
#include "views/colours.hpp"

#include <algorithm>
#include <cmath>

#include "crystal/loss.hpp"
#include "math/decay.hpp"
#include "math/error.hpp"
#include "views/transmission.hpp"

namespace icespar {
namespace {

/// Central ones of a convex polygon, over its area.
class PolygonMoments {
public:
    Point2 centre;
    double xx = 0, xy = 0, yy = 0;
    double reach2 = 0;  ///< squared distance of the farthest corner

    explicit PolygonMoments(PolygonView polygon) {
        double area = 0, x = 0, y = 0;
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            const Point2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
            const double part = a.x * b.y - a.y * b.x;
            area += part;
            x += part * (a.x + b.x);
            y += part * (a.y + b.y);
            xx += part * (a.x * a.x + a.x * b.x + b.x * b.x);
            xy += part * (a.x * a.y + 0.5 * (a.x * b.y + a.y * b.x) + b.x * b.y);
            yy += part * (a.y * a.y + a.y * b.y + b.y * b.y);
        }
        reach_from(polygon[0], polygon);
        // Of a sliver rounding knows no more than a corner.
        constexpr double thin = 1e-9;
        if (!(area > thin * reach2)) {
            xx = xy = yy = 0;
            return;
        }
        x /= 3 * area;
        y /= 3 * area;
        xx = xx / (6 * area) - x * x;
        xy = xy / (6 * area) - x * y;
        yy = yy / (6 * area) - y * y;
        reach_from({polygon[0].x + x, polygon[0].y + y}, polygon);
    }

private:
    void reach_from(const Point2& point, PolygonView polygon) {
        centre = point;
        reach2 = 0;
        for (const Point2& p : polygon) {
            const Point2 d = p - centre;
            reach2 = std::max(reach2, d.x * d.x + d.y * d.y);
        }
    }
};

std::array<RealTensor, 3> axes_of(const Medium& medium) {
    if (medium.symmetry == Symmetry::biaxial) {
        return {dyad(medium.principal[0]), dyad(medium.principal[1]), dyad(medium.principal[2])};
    }
    const RealTensor along = dyad(medium.axis);
    return {RealTensor::diagonal(1, 1, 1) + -1.0 * along, along, {}};
}

}  // namespace

Colours::Colours(const Medium& medium, std::span<const Absorption> colours) {
    if (medium.birefringent) axes_ = axes_of(medium);
    for (const Absorption& c : colours) {
        ColourRates rates{};
        RealTensor spanned;
        if (medium.birefringent) {
            for (std::size_t i = 0; i < axes_.size(); ++i) {
                const double size = product(axes_[i], axes_[i]);
                if (size > 0) rates[i] = product(c.tensor, axes_[i]) / size;
                spanned = spanned + rates[i] * axes_[i];
            }
            rates[3] = c.per_length;
        } else {
            spanned = RealTensor::diagonal(c.tensor.xx, c.tensor.xx, c.tensor.xx);
            rates[0] = c.tensor.xx + c.per_length * medium.n_o;
        }
        const RealTensor rest = c.tensor + -1.0 * spanned;
        constexpr double rounding = 1e-20;
        if (product(rest, rest) > rounding * product(c.tensor, c.tensor)) {
            throw Error("the absorption must have the axes of the medium");
        }
        rates_.push_back(rates);
    }
    begin();
}

double Colours::growth(std::size_t i, const Vec3& E, const Vec3& k, const Vec3& along) const {
    return i < axes_.size() ? loss_along(axes_[i], E, k, along) : length(along);
}

double Colours::transmit(PolygonView polygon, std::span<const Affine> lengths) {
    constexpr double small2 = 1e-5;  // squared, of the depth's variation
    const PolygonMoments m(polygon);
    double sum = 0;
    for (std::size_t c = 0; c < count(); ++c) {
        const Affine depth = depth_of(rates_[c], lengths);
        const double dx = depth.dx, dy = depth.dy;
        const double variance = dx * dx * m.xx + 2 * dx * dy * m.xy + dy * dy * m.yy;
        tint_[c] = (dx * dx + dy * dy) * m.reach2 < small2
                       ? decay(depth(m.centre)) * (1 + 0.5 * variance)
                       : mean_transmission(polygon, depth);
        sum += tint_[c];
    }
    if (!(sum > 0)) {
        begin();
        return 0;
    }
    const double mean = sum / static_cast<double>(count());
    for (double& t : tint_) t /= mean;
    return mean;
}

}  // namespace icespar
