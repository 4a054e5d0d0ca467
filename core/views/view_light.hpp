// Light of a view on its way through the stone: along a beam, and at a face.
#pragma once

#include <array>
#include <type_traits>

#include "beams/carry.hpp"
#include "beams/facet_search.hpp"
#include "beams/fresnel.hpp"
#include "beams/response.hpp"
#include "interface/inner_face.hpp"
#include "interface/interface.hpp"
#include "views/colours.hpp"
#include "views/facet_cells.hpp"
#include "views/view.hpp"

namespace icespar {

/// Derivatives of a wave vector: with colour, and as the line of sight turns to picture-right and
/// -up.
using ViewMoves = std::array<Vec3, 3>;

template <class Response, bool>
struct CarriedBy {
    using type = typename Response::Pair;
};
template <class Response>
struct CarriedBy<Response, true> {
    using type = typename Response::Single;
};

template <class Response, bool crystal, bool absorbing>
struct ViewBeam {
    using Pair = typename Response::Pair;
    using Carried = typename CarriedBy<Response, crystal>::type;

    BeamPlace place;
    Vec3 k;
    Vec3 s;  ///< a crystal's mode: its E
    /// Derivatives of k: with colour, and as the line of sight turns to picture-right and -up.
    ViewMoves moves;
    Carried response;
    double area;
    std::array<Affine, absorbing ? (crystal ? 4 : 1) : 0> lengths{};  ///< Colours
    double passed = 1;  ///< the mean over polygon and colours of what they leave
    double gain = 1;    ///< for others that ended
    int entry, left, hits, corners;
    int mode;

    [[nodiscard]] double weight() const { return area * passed * gain * response.power(); }
};

/// Sinks decide and collect:
///
///   leave(beam, k, moves, s, response)
///                       what leaves the stone at the face that the beam has met; `s` is across k,
///                       of any length
///   send(beam, thinned) what goes on from there; `thinned`: where part of the light left
template <class Response, bool crystal, bool absorbing>
class ViewLight {
public:
    using Pair = typename Response::Pair;
    using Moves = ViewMoves;
    using Beam = ViewBeam<Response, crystal, absorbing>;

    ViewLight(const Medium& medium, std::span<const Absorption> absorption,
              const ViewOptions& options)
        : air_(Medium::isotropic(1)),
          medium_(medium),
          modes_(modes_of(medium)),
          closed_form_(medium.plain()),
          colours_(medium, absorption),
          options_(options) {}

    [[nodiscard]] Colours& colours() { return colours_; }
    [[nodiscard]] const Colours& colours() const { return colours_; }

    /// Of all the light that meets a facet, so much of whose area is seen.
    template <class Sink>
    void enter(const FacetSearch& facets, int facet, double area, Beam& beam,
               const PictureFrame& frame, Sink& sink) {
        const Vec3 &k = frame.direction, &right = frame.right, &up = frame.up;
        colours_.begin();
        const Vec3 outside = facets.normal(facet), normal = -outside;
        const double slowness = 1 / dot(outside, k);
        beam = Beam{};
        beam.place = BeamPlace{{}, right, up}.moved(
            {facets.distance(facet) * slowness, -dot(outside, right) * slowness,
             -dot(outside, up) * slowness},
            k);
        beam.area = area;
        beam.entry = beam.left = facet;
        beam.hits = 1;
        // Launched with x along s and y = x cross k, which is -p.
        const Pair launched = at_viewer().times(1, -1);
        const Vec3 back = k - (2 * dot(normal, k)) * normal;
        const Moves sight{Vec3{}, right, up};
        Vec3 s = right;
        if constexpr (crystal) {
            Wave incident = plane_wave(air_, Mode::s, k, By::wave_normal, normal);
            const Interface face(air_, medium_, normal, incident);
            s = face.s_direction();
            const Pair arriving = launched.turned(dot(s, right), dot(s, cross(k, right)));
            beam.moves = sight;
            sink.leave(beam, back, outside_moves(beam, back, normal), s,
                       arriving.through(transfer(face, false)));
            send_modes(
                beam, CrystalWaves(face, true), normal, false,
                [&](std::size_t m) {
                    return Response::entering(arriving, face.flux_amplitude(0, true, m),
                                              face.flux_amplitude(1, true, m));
                },
                sink);
        } else {
            const Pair arriving = on_face(launched, k, 1, normal, s);
            const double q = dot(normal, k);
            const Fresnel through = fresnel(1, medium_.n_o, q);
            beam.moves = sight;
            sink.leave(beam, back, outside_moves(beam, back, normal), s,
                       arriving.times(through.r_s, through.r_p));
            beam.k = k + (through.q - q) * normal;
            beam.s = s;
            move(beam, sight, normal);
            beam.response = arriving.times(through.t_s, through.t_p);
            sink.send(beam, false);
        }
    }

    /// The direction of energy, not normalised.
    [[nodiscard]] static Vec3 flow(const Beam& beam) {
        if constexpr (crystal) {
            return beam.k - dot(beam.s, beam.k) * beam.s;
        } else {
            return beam.k;
        }
    }

    /// On the way of a beam to its facet; what of its area's light arrives there.
    double absorb(Beam& beam, PolygonView polygon, const Affine& t) {
        for (std::size_t i = 0; i < beam.lengths.size(); ++i) {
            Affine& l = beam.lengths[i];
            const double rate = growth_[i];
            l = {l.value + rate * t.value, l.dx + rate * t.dx, l.dy + rate * t.dy};
        }
        beam.passed = colours_.transmit(polygon, beam.lengths);
        return beam.area * beam.passed;
    }

    /// Of the lengths of a beam, per multiple of its flow.
    void grow(const Beam& beam, const Vec3& along) {
        growth_.fill(1);
        if constexpr (crystal) {
            for (std::size_t i = 0; i < growth_.size(); ++i) {
                growth_[i] = colours_.growth(i, beam.s, beam.k, along);
            }
        }
    }

    template <class Sink>
    void meet(Beam& beam, const Vec3& normal, Sink& sink) {
        const Vec3 k = beam.k;
        if constexpr (crystal) {
            const auto before = beam.response;
            if (closed_form_) {
                const InnerFace face(medium_, air_, normal, k, beam.s, beam.mode == 1);
                if (face.passes) {
                    sink.leave(beam, face.k_out, outside_moves(beam, face.k_out, normal), face.s,
                               before.leaving(face.out_s, face.out_p));
                }
                return send_modes(
                    beam, face.reflected, normal, face.passes,
                    [&](std::size_t i) { return before.times(face.amplitude[i]); }, sink);
            }
            Wave incident;
            incident.mode = modes_[static_cast<std::size_t>(beam.mode)];
            incident.k = complexified(k);
            incident.E = complexified(beam.s);
            incident.H = complexified(cross(k, beam.s));
            incident.n_phase = length(k);
            const Interface face(medium_, air_, normal, incident);
            const auto m = static_cast<std::size_t>(beam.mode);
            if (face.propagating(true, 0)) {
                const Vec3 out = face.wave_vector(true, 0);
                sink.leave(beam, out, outside_moves(beam, out, normal), face.s_direction(),
                           before.leaving(face.flux_amplitude(m, true, 0),
                                          face.flux_amplitude(m, true, 1)));
            }
            send_modes(
                beam, CrystalWaves(face, false), normal, face.propagating(true, 0),
                [&](std::size_t i) { return before.times(face.flux_amplitude(m, false, i)); },
                sink);
        } else {
            const double n = medium_.n_o, q = dot(normal, k);
            const Pair incident = on_face(beam.response, k, n, normal, beam.s);
            const Fresnel face = fresnel(n, 1, q);
            if (face.passes) {
                const Vec3 out = k + (face.q - q) * normal;
                sink.leave(beam, out, outside_moves(beam, out, normal), beam.s,
                           incident.times(face.t_s, face.t_p));
            }
            beam.response = incident.times(face.r_s, face.r_p);
            beam.k = k - (2 * q) * normal;
            for (Vec3& m : beam.moves) m = mirrored(m, normal);
            sink.send(beam, face.passes);
        }
    }

private:
    [[nodiscard]] Pair at_viewer() const {
        if constexpr (!std::is_same_v<Response, AveragedResponse>) {
            if (options_.analyser) return Pair::behind(*options_.analyser);
        }
        return {};
    }

    /// Of a beam, whose wave vector had these when it met the face. By k x (k x E) = -eps E the
    /// surface on which k ends swells by E . (d eps) E / 2 with colour.
    void move(Beam& beam, const Moves& before, const Vec3& normal) {
        const Vec3 along = flow(beam);
        if (options_.fan) {
            const RealTensor& change = *options_.fan;
            const double swell = 0.5 * (crystal ? dot(beam.s, change * beam.s) : change.xx);
            beam.moves[0] = fanned(before[0], normal, along, swell);
        }
        if (!options_.turns) return;
        for (std::size_t i : {1, 2}) beam.moves[i] = fanned(before[i], normal, along, 0);
    }
    [[nodiscard]] Moves outside_moves(const Beam& beam, const Vec3& k, const Vec3& normal) const {
        Moves out{};
        if (options_.fan) out[0] = fanned(beam.moves[0], normal, k, 0);
        if (!options_.turns) return out;
        for (std::size_t i : {1, 2}) out[i] = fanned(beam.moves[i], normal, k, 0);
        return out;
    }

    template <class Coupled, class Sink>
    void send_modes(Beam& beam, const CrystalWaves& waves, const Vec3& normal, bool thinned,
                    const Coupled& coupled, Sink& sink) {
        const Moves before = beam.moves;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!waves.propagates[i]) continue;
            beam.mode = static_cast<int>(i);
            beam.response = coupled(i);
            beam.k = waves.k[i];
            beam.s = waves.E[i];
            move(beam, before, normal);
            sink.send(beam, thinned);
        }
    }

    Medium air_, medium_;
    std::array<Mode, 2> modes_;
    bool closed_form_;  ///< of faces met from inside
    Colours colours_;
    const ViewOptions& options_;
    std::array<double, std::tuple_size_v<decltype(Beam::lengths)>> growth_{};
};

}  // namespace icespar
