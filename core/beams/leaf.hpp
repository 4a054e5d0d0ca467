// Where beams leave a stone.
#pragma once

#include "beams/expansion.hpp"

namespace icespar {

/// Light that leaves the stone (or is thrown back by its outside) towards the surroundings.
template <class Response>
struct Leaf {
    PolygonView polygon;  ///< corners relative to `centre`, which is its centroid
    Point2 centre;        ///< in pixels, from the pixel's centre
    double area = 0;      ///< in pixels
    Expansion position;   ///< on the facet, relative to the stone's centre
    Expansion k;          ///< unit wave vector in the air
    Vec3 fan;             ///< dk/dc over the colours c of a spectral tracer
    Vec3 s;               ///< along the response's s, of any length; its p is k x s
    typename Response::Pair response;
    int facet = 0, hits = 0;
};

}  // namespace icespar
