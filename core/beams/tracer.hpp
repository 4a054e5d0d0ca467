// Beams through one stone: fragments of a pixel, carried to first order from facet to facet.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "beams/beam_list.hpp"
#include "beams/block.hpp"
#include "beams/carry.hpp"
#include "beams/facet_search.hpp"
#include "beams/fading.hpp"
#include "beams/faint_rays.hpp"
#include "beams/fresnel.hpp"
#include "beams/index_surface.hpp"
#include "beams/leaf.hpp"
#include "beams/response.hpp"
#include "interface/inner_face.hpp"

namespace icespar {

/// Follows what enters a stone through a polygon of a pixel, depth first. The sink decides and
/// collects:
///
///   gain(weight, hits)  0 ends a beam of this area times power; a survivor's power is multiplied
///   stand_in(weight, part, hits)
///                       only if birefringent: of two modes of so much weight together, `part` of
///                       it the extraordinary one's, the one (0 or 1) that goes on for both, or -1
///   may_meet(hits)      false: the beam ends before its next interface event
///   lose(weight)        a beam given up so
///   open(), close(hits) around all that comes of a beam that survived by chance after so many
///                       hits, and is not itself the offspring of such a one
///   survivors_are_rays() if a sink has it: whether in a crystal such a beam goes on as rays
///                       instead, which do not fade
///   survive(hits, response)
///                       as how many
///   send(ray, pixel)    one of them, to which the sink gives its luck and owner
///   uniform()           a random number
///   see(leaf)
///   transmit(lengths)   only if absorbing: the mean over the beam's colours of what absorption has
///                       left of it, before anything of the sort is seen; responses hold the mean
///   absorb(weight)      only if absorbing: what the stone took
///
/// `spectral`: k's derivative with colour is carried, too. `absorbing`: so are lengths after which
/// a wave has lost as much as a wave of the isotropic stone; in a crystal one polarised across the
/// axis, one polarised along it, and any wave (the length itself).
template <class Response, bool birefringent, bool spectral = false, bool absorbing = false>
class BeamTracer {
public:
    explicit BeamTracer(const FacetSearch& facets)
        : facets_(facets), air_(Medium::isotropic(1)), medium_(air_) {}

    /// A colour is whatever number indices may depend on: dn_o and dn_e are their derivatives.
    void set_medium(const Medium& medium, double dn_o = 0, double dn_e = 0) {
        medium_ = medium;
        surface_ = IndexSurface(medium, dn_o, dn_e);
        if constexpr (absorbing) fading_.set_medium(medium);
    }

    /// The pixels that the footprint covers, and by how much of a pixel's light its beams' power
    /// may change where they lie in several.
    void set_block(const Block& block, double tolerance) {
        block_ = block;
        tolerance_ = tolerance;
    }

    [[nodiscard]] std::uint64_t events() const { return events_; }

    /// `field` is relative to the facets' centre and the pixel's; `right` is picture-right.
    template <class Sink>
    void trace(const RayField& field, const Vec3& right, PolygonView polygon, int facet,
               Sink& sink) {
        enter(field, right, polygon, facet, sink);
        bool chosen = false;
        std::size_t base = 0;
        int depth = 0;
        while (alive_ || !waiting_.beams.empty()) {
            if (!alive_) waiting_.pop(beam_, polygon_);
            alive_ = false;
            if (beam_.chosen && !chosen) {
                chosen = true;
                base = waiting_.beams.size();
                depth = beam_.hits;
                sink.open();
            }
            advance(sink);
            if (chosen && !alive_ && waiting_.beams.size() == base) {
                chosen = false;
                sink.close(depth);
            }
        }
        bases_.clear();
    }

private:
    using Pair = typename Response::Pair;
    using Single = typename Response::Single;

    struct Nothing {};
    using Fan = std::conditional_t<spectral, Vec3, Nothing>;
    using Fading = std::conditional_t<absorbing, FadingLengths<birefringent>, Nothing>;
    using Lengths = std::conditional_t<absorbing, LengthsOf<birefringent>, Nothing>;
    struct Absorbed {
        Lengths lengths{};
        double left = 1;
    };
    struct Clear {};
    using Absorption = std::conditional_t<absorbing, Absorbed, Clear>;

    struct Beam {
        Point2 centre;
        double area;
        Expansion position, k;
        [[no_unique_address]] Fan fan;
        [[no_unique_address]] Absorption absorbed;
        Vec3 s;  ///< a crystal's mode: its E
        std::conditional_t<birefringent, Single, Pair> response;
        int left;  ///< the facet just left
        int hits;
        bool extraordinary;
        bool chosen;  ///< it, or one it comes from, survived by chance
        int corners;  ///< in waiting_; they are relative to `centre`
        int bases;    ///< facets whose fragments have been cut off already: a chain in bases_
    };
    struct Base {
        int facet, next;
    };

    /// Follows the beam on from a face if it is worth it; its weight is area times power. One
    /// chance an event: a piece cut off later must not play again at the same depth. The last of an
    /// event's beams goes on at once, others wait.
    template <class Sink>
    void send(Sink& sink, bool last = true) {
        const double weight = beam_.area * beam_.response.power();
        if (!sink.may_meet(beam_.hits)) return sink.lose(weight);
        const double gain = sink.gain(weight, beam_.hits);
        if (gain == 0) return;
        const bool before = beam_.chosen;
        if (gain != 1) {
            beam_.response.scale(gain);
            if constexpr (birefringent && requires { sink.survivors_are_rays(); }) {
                if (sink.survivors_are_rays()) return set_off(sink);
            }
            beam_.chosen = true;
        }
        alive_ = last;
        if (last) return;
        waiting_.push(beam_, polygon_);
        beam_.chosen = before;
    }

    /// Goes on as rays through points of its polygon, spread evenly (Roberts 2018).
    template <class Sink>
    void set_off(Sink& sink) {
        constexpr Point2 apart{0.7548776662466927, 0.5698402909980532};
        const int rays = sink.survive(beam_.hits, beam_.response);
        const double weight = beam_.area * beam_.response.power() / rays;
        Point2 at{sink.uniform(), sink.uniform()};
        for (int i = 0; i < rays; ++i) {
            at = {at.x + apart.x - std::floor(at.x + apart.x),
                  at.y + apart.y - std::floor(at.y + apart.y)};
            const Point2 p = point_in(polygon_, at.x, at.y);
            FaintRays::Ray ray;
            ray.position = beam_.position.at(p);
            ray.k = surface_.onto(beam_.k.at(p), beam_.extraordinary);
            ray.field = field(ray.k, beam_.extraordinary, beam_.s);
            if constexpr (spectral) ray.fan = beam_.fan;
            ray.weight = weight;
            ray.left = beam_.left;
            ray.hits = beam_.hits;
            ray.extraordinary = beam_.extraordinary;
            sink.send(ray, block_.holding(beam_.centre + p));
        }
    }

    /// Moves the expansions to the polygon's centroid and its corners with them. False when nothing
    /// is left of it.
    bool recentre(Beam& beam, Polygon& polygon) {
        const Extent e = extent(polygon);
        if (!(e.area > 0)) return false;
        beam.area = e.area;
        beam.centre = beam.centre + e.centroid;
        beam.position.value = beam.position.at(e.centroid);
        beam.k.value = beam.k.at(e.centroid);
        if constexpr (absorbing) {
            for (Affine& length : beam.absorbed.lengths) {
                length.value = std::max(0.0, length(e.centroid));
            }
        }
        beam.k.value = surface_.onto(beam.k.value, beam.extraordinary);
        if constexpr (birefringent) beam.s = field(beam.k.value, beam.extraordinary, beam.s);
        for (Point2& p : polygon) p = p - e.centroid;
        return true;
    }

    /// E of a mode, but for its sign; along the axis it stays what it was.
    [[nodiscard]] Vec3 field(const Vec3& k, bool extraordinary, const Vec3& before) const {
        constexpr double along_axis = 1e-12;
        const Vec3 across = cross(k, medium_.axis);
        if (!(dot(across, across) > along_axis)) return before;
        return normalised(extraordinary ? medium_.axis - (dot(k, medium_.axis) / surface_.eps_o) * k
                                        : across);
    }

    [[nodiscard]] bool based_on(int chain, int facet) const {
        for (; chain >= 0; chain = bases_[static_cast<std::size_t>(chain)].next) {
            if (bases_[static_cast<std::size_t>(chain)].facet == facet) return true;
        }
        return false;
    }

    /// To the facet that the centroid meets. What falls beyond that facet's edges is cut off and
    /// starts again from its own centroid: parts always sum to the whole.
    template <class Sink>
    void advance(Sink& sink) {
        Expansion flow = beam_.k;
        if constexpr (birefringent) {
            if (beam_.extraordinary) {
                flow = {surface_.energy(beam_.k.value, true), surface_.energy(beam_.k.dx, true),
                        surface_.energy(beam_.k.dy, true)};
            }
        }
        double t = 0;
        const int facet = facets_.exit(beam_.position.value, flow.value, beam_.left, t);
        if (facet < 0) return sink.lose(beam_.area * beam_.response.power());
        const Vec3 normal = facets_.normal(facet);
        Expansion there = arrival(beam_.position, flow, normal, t);
        facets_.crossed(facet, there, polygon_, edges_);
        bool cut = false;
        // A piece that has been cut off by the facet it now meets is not cut again: the edge
        // between two facets is crossed once.
        if (!edges_.empty() && !based_on(beam_.bases, facet)) {
            for (const auto& [other, inside] : edges_) {
                if (other == beam_.left || based_on(beam_.bases, other)) continue;
                split(polygon_, inside, rest_, piece_);
                if (piece_.size() < 3) continue;
                cut = true;
                polygon_.swap(rest_);
                Beam off = beam_;
                if (recentre(off, piece_)) {
                    bases_.push_back({facet, beam_.bases});
                    off.bases = static_cast<int>(bases_.size()) - 1;
                    waiting_.push(off, piece_);
                }
                if (polygon_.empty()) break;
            }
        }
        if (cut) {
            if (!recentre(beam_, polygon_)) return;
            flow.value = surface_.energy(beam_.k.value, beam_.extraordinary);
            t = (facets_.distance(facet) - dot(normal, beam_.position.value)) /
                dot(normal, flow.value);
            there = arrival(beam_.position, flow, normal, t);
        }
        Lengths lengths{};
        if constexpr (absorbing) {
            lengths = fading_.onward(beam_.absorbed.lengths, beam_.position, beam_.k.value, beam_.s,
                                     flow, normal, t);
        }
        if (uneven(normal, lengths, sink) && part_by_pixel()) return;
        if constexpr (absorbing) absorb(lengths, sink);
        beam_.position = there;
        ++beam_.hits;
        beam_.left = facet;
        beam_.bases = -1;
        ++events_;
        meet(normal, sink);
    }

    /// Whether power changes so much over a beam that each of its pixels needs its own: by the face
    /// ahead or, in a stone of a colour, on the way there.
    template <class Sink>
    [[nodiscard]] bool uneven(const Vec3& normal, const Lengths& lengths, Sink& sink) const {
        if (block_.count() == 1) return false;
        const double most = tolerance_ / beam_.response.power();
        return near_critical(beam_.k, polygon_, normal, air_.n_o, most) ||
               fades_unevenly(lengths, most, sink);
    }

    template <class Sink>
    [[nodiscard]] bool fades_unevenly(const Lengths& lengths, double most, Sink& sink) const {
        if constexpr (absorbing) {
            const Affine& length = lengths.back();
            const auto longer = [&](const Point2& p) { return length(p) - length.value; };
            const Point2 far = *std::max_element(
                polygon_.begin(), polygon_.end(),
                [&](const Point2& a, const Point2& b) { return longer(a) < longer(b); });
            Lengths there = lengths;
            for (Affine& l : there) l.value = std::max(0.0, l(far));
            const double left = sink.transmit(there);
            return sink.transmit(lengths) - left > most * left;
        } else {
            return false;
        }
    }

    /// Starts again with what is on either side of a line between pixels. False where there is
    /// none.
    [[nodiscard]] bool part_by_pixel() {
        const Block::Span over = block_.span(polygon_, beam_.centre);
        if (over.one()) return false;
        const bool wide = over.x1 - over.x0 >= over.y1 - over.y0;
        split(polygon_,
              wide ? block_.right_of((over.x0 + over.x1) / 2, beam_.centre)
                   : block_.below((over.y0 + over.y1) / 2, beam_.centre),
              rest_, piece_);
        for (Polygon* part : {&rest_, &piece_}) {
            Beam side = beam_;
            if (recentre(side, *part)) waiting_.push(side, *part);
        }
        return true;
    }

    template <class Sink>
    void absorb(const Lengths& lengths, Sink& sink) {
        beam_.absorbed.lengths = lengths;
        const double left = sink.transmit(lengths);
        const double part = left / beam_.absorbed.left;
        beam_.absorbed.left = left;
        sink.absorb((1 - part) * beam_.area * beam_.response.power());
        beam_.response.scale(part);
    }

    template <class Sink>
    void leave(const Expansion& k, const Vec3& s, const Pair& response, const Vec3& normal,
               Sink& sink) {
        Leaf<Response> leaf;
        leaf.polygon = polygon_;
        leaf.centre = beam_.centre;
        leaf.area = beam_.area;
        leaf.position = beam_.position;
        leaf.k = k;
        if constexpr (spectral) leaf.fan = fanned(beam_.fan, normal, k.value, 0);
        leaf.s = s;
        leaf.response = response;
        leaf.facet = beam_.left;
        leaf.hits = beam_.hits;
        sink.see(leaf);
    }

    template <class Sink>
    void meet(const Vec3& normal, Sink& sink) {
        if constexpr (birefringent) {
            meet_crystal(normal, sink);
        } else {
            meet_isotropic(normal, sink);
        }
    }

    /// From inside.
    template <class Sink>
    void meet_isotropic(const Vec3& normal, Sink& sink) {
        const double n = medium_.n_o;
        const Expansion k = beam_.k;
        const Pair incident = on_face(beam_.response, k.value, n, normal, beam_.s);
        const double q = dot(normal, k.value);
        const Fresnel face = fresnel(n, 1, q);
        if (face.passes) {
            const Vec3 out = k.value + (face.q - q) * normal;
            leave(matched(k, normal, out, out), beam_.s, incident.times(face.t_s, face.t_p), normal,
                  sink);
        }
        beam_.response = incident.times(face.r_s, face.r_p);
        beam_.k = mirrored(k, normal);
        if constexpr (spectral) beam_.fan = mirrored(beam_.fan, normal);
        send(sink);
    }

    template <class Sink>
    void meet_crystal(const Vec3& normal, Sink& sink) {
        const Expansion k = beam_.k;
        const Single before = beam_.response;
        const InnerFace face(medium_, air_, normal, k.value, beam_.s, beam_.extraordinary);
        if (face.passes) {
            leave(matched(k, normal, face.k_out, face.k_out), face.s,
                  before.leaving(face.out_s, face.out_p), normal, sink);
        }
        send_modes(
            face.reflected, k, normal,
            [&](std::size_t i) { return before.times(face.amplitude[i]); }, sink);
    }

    /// Both modes that go into the crystal, or one that stands for both.
    template <class Coupled, class Sink>
    void send_modes(const CrystalWaves& waves, const Expansion& k, const Vec3& normal,
                    const Coupled& coupled, Sink& sink) {
        [[maybe_unused]] const Fan fan = beam_.fan;
        std::array<Single, 2> responses;
        double power = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!waves.propagates[i]) continue;
            responses[i] = coupled(i);
            power += responses[i].power();
        }
        std::array<bool, 2> goes_on = waves.propagates;
        if (goes_on[0] && goes_on[1] && power > 0) {
            const double extraordinary = responses[1].power() / power;
            const int only = sink.stand_in(beam_.area * power, extraordinary, beam_.hits);
            if (only >= 0) {
                const auto one = static_cast<std::size_t>(only);
                responses[one].scale(power / responses[one].power());
                goes_on[1 - one] = false;
            }
        }
        for (std::size_t i = 0; i < 2; ++i) {
            if (!goes_on[i]) continue;
            beam_.extraordinary = i == 1;
            beam_.response = responses[i];
            const Vec3 flow = surface_.energy(waves.k[i], i == 1);
            beam_.k = matched(k, normal, waves.k[i], flow);
            if constexpr (spectral) {
                beam_.fan = fanned(fan, normal, flow, surface_.swelling(waves.k[i], i == 1));
            }
            beam_.s = waves.E[i];
            send(sink, i == 1 || !goes_on[1]);
        }
    }

    template <class Sink>
    void enter(const RayField& field, const Vec3& right, PolygonView polygon, int facet,
               Sink& sink) {
        polygon_.assign(polygon.begin(), polygon.end());
        const Extent e = extent(polygon_);
        if (!(e.area > 0)) return;
        for (Point2& p : polygon_) p = p - e.centroid;
        const Expansion origin = field.origin.about(e.centroid);
        const Expansion line = field.direction.about(e.centroid);
        const Vec3 normal = facets_.normal(facet);
        const double size = length(line.value);
        const Vec3 unit = line.value / size;
        const auto turned = [&](const Vec3& d) { return (d - dot(unit, d) * unit) / size; };
        const Expansion k{unit, turned(line.dx), turned(line.dy)};
        const double t =
            (facets_.distance(facet) - dot(normal, origin.value)) / dot(normal, line.value);
        beam_ = Beam{};
        beam_.centre = e.centroid;
        beam_.area = e.area;
        beam_.position = arrival(origin, line, normal, t);
        beam_.left = facet;
        beam_.hits = 1;
        beam_.bases = -1;
        ++events_;
        Vec3 s = normalised(right - dot(right, unit) * unit);
        // Launched with x along s and y = x cross k, which is -p.
        const Pair launched = Pair{}.times(1, -1);
        enter_face(launched, k, s, -normal, sink);
    }

    template <class Sink>
    void enter_face(const Pair& launched, const Expansion& k, Vec3 s, const Vec3& normal,
                    Sink& sink) {
        if constexpr (absorbing) (void)sink.transmit(beam_.absorbed.lengths);
        const Expansion back = mirrored(k, normal);
        if constexpr (birefringent) {
            Wave incident;
            incident.k = complexified(k.value);
            const Interface face(air_, medium_, normal, incident);
            const Vec3& turned = face.s_direction();
            const Pair arriving = launched.turned(dot(turned, s), dot(turned, cross(k.value, s)));
            // From an isotropic medium both polarisations couple to both reflected ones.
            leave(back, turned, arriving.through(transfer(face, false)), normal, sink);
            send_modes(
                CrystalWaves(face, true), k, normal,
                [&](std::size_t i) {
                    return Response::entering(arriving, face.flux_amplitude(0, true, i),
                                              face.flux_amplitude(1, true, i));
                },
                sink);
        } else {
            const Pair arriving = on_face(launched, k.value, 1, normal, s);
            const double q = dot(normal, k.value);
            const Fresnel through = fresnel(1, medium_.n_o, q);
            leave(back, s, arriving.times(through.r_s, through.r_p), normal, sink);
            const Vec3 in = k.value + (through.q - q) * normal;
            beam_.k = matched(k, normal, in, in);
            if constexpr (spectral)
                beam_.fan = fanned({}, normal, in, surface_.swelling(in, false));
            beam_.s = s;
            beam_.response = arriving.times(through.t_s, through.t_p);
            send(sink);
        }
    }

    const FacetSearch& facets_;
    Medium air_, medium_;
    IndexSurface surface_{medium_};
    [[no_unique_address]] Fading fading_;
    BeamList<Beam> waiting_;
    std::vector<Base> bases_;
    Beam beam_{};         ///< with polygon_: the one being followed
    bool alive_ = false;  ///< it goes on
    Polygon polygon_, piece_, rest_;
    std::vector<FacetSearch::Edge> edges_;
    Block block_;
    double tolerance_ = 0;
    std::uint64_t events_ = 0;
};

}  // namespace icespar
