// Writes down what leaves the stone of a view.
#pragma once

#include <type_traits>

#include "views/view_light.hpp"

namespace icespar {

template <class Response, bool crystal, bool absorbing>
class ExitRecorder {
public:
    using Beam = ViewBeam<Response, crystal, absorbing>;

    ExitRecorder(const ViewOptions& options, const Colours& colours, Exits& out)
        : options_(options), colours_(colours), out_(out) {}

    /// What leaves the stone where a beam is; by the group it belongs to, 0 if it was followed
    /// exactly.
    void add(const Beam& beam, PolygonView polygon, int group, const Vec3& k,
             const ViewMoves& moves, const Vec3& s, const typename Beam::Pair& response) {
        const double share = beam.passed * beam.gain;
        out_.direction.push_back(normalised(k));
        const auto known = [](const Vec3& v) { return is_finite(v) ? v : Vec3{}; };
        if (options_.fan) out_.fan.push_back(known(moves[0]));
        if (options_.turns) out_.turned.push_back({known(moves[1]), known(moves[2])});
        out_.weight.push_back(share * response.unpolarised());
        if constexpr (!std::is_same_v<Response, AveragedResponse>) {
            if (options_.polarised) {
                out_.axis.push_back(normalised(s));
                out_.polarised.push_back({share * response.seen({0, 1, 0, 0}),
                                          share * response.seen({0, 0, 1, 0}),
                                          share * response.seen({0, 0, 0, 1})});
            }
        }
        out_.area.push_back(beam.area);
        out_.entry.push_back(beam.entry);
        out_.facet.push_back(beam.left);
        out_.hits.push_back(beam.hits);
        out_.group.push_back(group);
        if constexpr (absorbing) {
            const auto tint = colours_.tint();
            out_.tint.insert(out_.tint.end(), tint.begin(), tint.end());
        }
        if (!options_.outlines) return;
        out_.corners.insert(out_.corners.end(), polygon.begin(), polygon.end());
        out_.outline.push_back(out_.corners.size());
        if constexpr (absorbing) {
            out_.lengths.insert(out_.lengths.end(), beam.lengths.begin(), beam.lengths.end());
        }
    }

private:
    const ViewOptions& options_;
    const Colours& colours_;
    Exits& out_;
};

}  // namespace icespar
