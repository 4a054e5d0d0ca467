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

/// Squared distance of the farthest corner.
double reach2(PolygonView polygon, const Point2& from) {
    double farthest = 0;
    for (const Point2& p : polygon) {
        const Point2 d = p - from;
        farthest = std::max(farthest, d.x * d.x + d.y * d.y);
    }
    return farthest;
}

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
    constexpr double thin = 1e-9;
    // Of a sliver rounding knows no more than a corner.
    Extent e = extent(polygon);
    const bool sliver = !(e.area > thin * reach2(polygon, polygon[0]));
    if (sliver) e.centroid = polygon[0];
    const Moments m = sliver ? Moments{} : moments(polygon, e);
    const double reach = reach2(polygon, e.centroid);
    double sum = 0;
    for (std::size_t c = 0; c < count(); ++c) {
        const Affine depth = depth_of(rates_[c], lengths);
        const double dx = depth.dx, dy = depth.dy;
        tint_[c] = (dx * dx + dy * dy) * reach < small2
                       ? decay(depth(e.centroid)) * (1 + 0.5 * m.variance(dx, dy))
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
