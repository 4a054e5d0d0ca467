// Beams that wait, with their polygons.
#pragma once

#include <vector>

#include "beams/polygon.hpp"

namespace icespar {

/// Beams with their polygons one behind the other; `corners` of a beam is how many its has.
template <class Beam>
struct BeamList {
    std::vector<Beam> beams;
    Polygon corners;

    void push(const Beam& beam, PolygonView polygon) {
        beams.push_back(beam);
        beams.back().corners = static_cast<int>(polygon.size());
        corners.insert(corners.end(), polygon.begin(), polygon.end());
    }
    /// The last one.
    void pop(Beam& beam, Polygon& polygon) {
        beam = beams.back();
        beams.pop_back();
        polygon.assign(corners.end() - beam.corners, corners.end());
        corners.resize(corners.size() - static_cast<std::size_t>(beam.corners));
    }
    void clear() {
        beams.clear();
        corners.clear();
    }
    /// Calls visit(beam, polygon) in the order of pushing.
    template <class Visit>
    void each(Visit&& visit) const {
        std::size_t from = 0;
        for (const Beam& b : beams) {
            const auto count = static_cast<std::size_t>(b.corners);
            visit(b, PolygonView(corners.data() + from, count));
            from += count;
        }
    }
};

}  // namespace icespar
