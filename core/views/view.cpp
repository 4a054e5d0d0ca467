// Which tracer a view needs.
#include "views/view.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "math/error.hpp"
#include "views/view_tracer.hpp"

namespace icespar {
namespace {

void check(const Medium& medium, const ParallelView& view, const ViewOptions& options) {
    if (!is_finite(view.direction) || !is_finite(view.up) ||
        !(length(cross(view.direction, view.up)) > 0)) {
        throw Error("a view needs a direction and an up that is not along it");
    }
    if (options.bound && !(*options.bound >= 0)) throw Error("bound must be 0 or more");
    if (!(options.error >= 0)) throw Error("error must be 0 (no sample) or more");
    if (!options.bound && options.error == 0) {
        throw Error("a view without a bound needs an error to which the rest is sampled");
    }
    if (!(options.seconds >= 0)) throw Error("the time must be 0 (no limit) or more");
    if (options.max_hits < 0) throw Error("max_hits must be 0 (no limit) or more");
    if (!(options.least_power >= 0)) throw Error("least_power must be 0 or more");
    if (options.bound == 0.0 && options.max_beams == 0 && options.seconds == 0 &&
        options.max_hits == 0) {
        throw Error("a view needs an end: give a bound, max_beams, a time or max_hits");
    }
    if (medium.absorbing) {
        throw Error(
            "waves of a view are those of a clear stone; give real indices and an absorption");
    }
    if (medium.active()) throw Error("views do not know optical activity; leave the rotation out");
    if (medium.birefringent && options.weights == Weights::averaged) {
        throw Error("a birefringent stone has no averaged light; ask for intensity or stokes");
    }
    if (options.weights == Weights::averaged && (options.polarised || options.analyser)) {
        throw Error("averaged light has no polarisation; ask for intensity or stokes");
    }
    if (medium.n_o < 1 && !medium.birefringent) {
        throw Error("views need a stone of index 1 or more");
    }
}

}  // namespace

bool Absorption::none() const {
    const RealTensor& t = tensor;
    return per_length == 0 && t.xx == 0 && t.yy == 0 && t.zz == 0 && t.yz == 0 && t.xz == 0 &&
           t.xy == 0;
}

Absorption absorption_of(const Medium& medium, std::span<const double> per_length) {
    const std::size_t axes = static_cast<std::size_t>(medium.symmetry) + 1;
    if (per_length.size() != axes) {
        throw Error("absorption: a medium of " + std::to_string(axes) +
                    (axes == 1 ? " index needs 1 number" : " indices needs as many numbers"));
    }
    for (const double a : per_length) {
        if (!(a >= 0) || !std::isfinite(a)) {
            throw Error("absorption must be finite and not negative");
        }
    }
    Absorption out;
    if (medium.symmetry == Symmetry::biaxial) {
        for (std::size_t i = 0; i < 3; ++i) {
            out.tensor =
                out.tensor + (medium.n_principal[i] * per_length[i]) * dyad(medium.principal[i]);
        }
        return out;
    }
    const double across = medium.n_o * per_length[0];
    out.tensor = RealTensor::diagonal(across, across, across);
    if (axes == 2) {
        out.tensor = out.tensor + (medium.n_e * per_length[1] - across) * dyad(medium.axis);
    }
    return out;
}

Affine depth_of(const ColourRates& rates, std::span<const Affine> lengths) {
    Affine depth{0, 0, 0};
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        depth.value += rates[i] * lengths[i].value;
        depth.dx += rates[i] * lengths[i].dx;
        depth.dy += rates[i] * lengths[i].dy;
    }
    return depth;
}

Exits Exits::expanded() const {
    Exits out = *this;
    if (images.size() == 1) return out;
    out.images.resize(1);
    const std::size_t each = size() > 0 ? lengths.size() / size() : 0;
    for (std::size_t g = 1; g < images.size(); ++g) {
        const PictureImage& image = images[g];
        const auto becomes = [&](std::int32_t i) {
            return image.facets[static_cast<std::size_t>(i)];
        };
        for (std::size_t i = 0; i < size(); ++i) {
            out.direction.push_back(image.of(direction[i], frame));
            if (!fan.empty()) out.fan.push_back(image.of(fan[i], frame));
            if (!turned.empty()) out.turned.push_back(image.of(turned[i], frame));
            out.weight.push_back(image.of(weight[i]));
            out.area.push_back(area[i]);
            out.entry.push_back(becomes(entry[i]));
            out.facet.push_back(becomes(facet[i]));
            out.hits.push_back(hits[i]);
            out.group.push_back(group[i]);
            const auto tints = tint_of(i);
            out.tint.insert(out.tint.end(), tints.begin(), tints.end());
            if (outline.empty()) continue;
            const auto begin = static_cast<std::ptrdiff_t>(out.corners.size());
            for (std::size_t c = outline[i]; c < outline[i + 1]; ++c) {
                out.corners.push_back(image.of(corners[c]));
            }
            // Counter-clockwise, also in a mirror.
            if (image.mirrors()) std::reverse(out.corners.begin() + begin, out.corners.end());
            out.outline.push_back(out.corners.size());
            for (std::size_t l = i * each; l < (i + 1) * each; ++l) {
                out.lengths.push_back(image.of(lengths[l]));
            }
        }
    }
    return out;
}

Estimate estimate_of(std::span<const double> sums) {
    Estimate out{sums[0]};
    const std::span<const double> groups = sums.subspan(1);
    if (groups.empty()) return out;
    double squares = 0;
    for (std::size_t i = 0; i + 1 < groups.size(); i += 2) {
        const double apart = groups[i] - groups[i + 1];
        out.value += groups[i] + groups[i + 1];
        squares += apart * apart;
    }
    out.error = std::sqrt(squares);
    return out;
}

Exits trace_view(const Stone& stone, const Medium& medium, const ParallelView& view,
                 const ViewOptions& options, std::span<const Absorption> absorption) {
    check(medium, view, options);
    PictureFrame frame;
    frame.direction = normalised(view.direction);
    frame.right = normalised(cross(frame.direction, view.up));
    frame.up = cross(frame.right, frame.direction);
    Exits out;
    const bool clear = std::all_of(absorption.begin(), absorption.end(),
                                   [](const Absorption& a) { return a.none(); });
    const auto run = [&]<class Response, bool crystal>() {
        if (clear) {
            ViewTracer<Response, crystal, false>(stone, medium, {}, frame, options, out).run();
        } else {
            ViewTracer<Response, crystal, true>(stone, medium, absorption, frame, options, out)
                .run();
        }
    };
    const bool stokes = options.weights == Weights::stokes;
    if (medium.birefringent) {
        if (stokes) {
            run.operator()<FullResponse, true>();
        } else {
            run.operator()<IntensityResponse, true>();
        }
    } else if (stokes) {
        run.operator()<FullResponse, false>();
    } else if (options.weights == Weights::averaged) {
        run.operator()<AveragedResponse, false>();
    } else {
        run.operator()<IntensityResponse, false>();
    }
    return out;
}

}  // namespace icespar
