// Beams from whole facets through one stone, heaviest first.
#pragma once

#include <chrono>
#include <cmath>
#include <type_traits>

#include "beams/carry.hpp"
#include "beams/faint_rays.hpp"
#include "beams/fresnel.hpp"
#include "beams/response.hpp"
#include "interface/inner_face.hpp"
#include "interface/interface.hpp"
#include "views/beam_queue.hpp"
#include "views/colours.hpp"
#include "views/facet_cells.hpp"
#include "views/path_starts.hpp"
#include "views/remainder.hpp"
#include "views/symmetry.hpp"
#include "views/transmission.hpp"
#include "views/view.hpp"

namespace icespar {

/// With parallel light every path through plane facets keeps one wave vector and one response over
/// the whole polygon that takes it, and its places are linear in picture coordinates: nothing is
/// approximated.
template <class Response, bool crystal, bool absorbing>
class ViewTracer {
public:
    ViewTracer(const Stone& stone, const Medium& medium, std::span<const Absorption> absorption,
               const PictureFrame& frame, const ViewOptions& options, Exits& out)
        : stone_(stone),
          cells_(stone),
          air_(Medium::isotropic(1)),
          medium_(medium),
          modes_(modes_of(medium)),
          closed_form_(medium.plain()),
          colours_(medium, absorption),
          frame_(frame),
          options_(options),
          out_(out),
          facet_(options.error_of.value_or(-1)),
          random_(options.seed),
          rays_(cells_.facets()) {}

    void run() {
        frame_.centre = cells_.facets().centre();
        for (const Vec3& v : stone_.vertices) {
            diameter_ = std::max(diameter_, 2 * length(v - frame_.centre));
        }
        out_.frame = frame_;
        out_.rates = colours_.rates();
        if (options_.outlines) out_.outline.assign(1, 0);
        out_.entry_area.assign(stone_.facets.size(), 0);
        out_.entry_untraced = out_.entry_cut = out_.entry_area;
        symmetry_ = no_symmetry(stone_);
        measure();
        together_ = side_by_side();
        if (together_) rays_.set_medium(medium_);
        if (options_.symmetry && !options_.polarised && !options_.analyser) fold();
        out_.images = symmetry_.images;
        for (std::size_t i = 0; i < stone_.facets.size(); ++i) {
            if (out_.entry_area[i] > 0) enter(static_cast<int>(i));
        }
        while (wants_more() && may_go_on() && queue_.pop(beam_, polygon_)) {
            waiting_ -= beam_.weight();
            if (beam_.entry == facet_) waiting_there_ -= beam_.weight();
            ++out_.beams;
            advance();
        }
        waiting_ = waiting_there_ = 0;
        queue_.each([&](const Beam& b, PolygonView) {
            waiting_ += b.weight();
            if (b.entry == facet_) waiting_there_ += b.weight();
            give_up(b.entry, b.weight());
        });
        out_.residue = out_.untraced;
        if (options_.error > 0 && waiting_ > 0 && !stopped_) {
            out_.residue -= waiting_;
            const std::uint64_t before = out_.beams;
            if (options_.outlines) {
                sample();
            } else {
                walk();
            }
            out_.sampled = out_.beams - before;
        }
        unfold();
    }

private:
    static constexpr unsigned beams_between_looks = 4096;
    static constexpr int longest_path = 5000;  ///< in faces

    using Pair = typename Response::Pair;
    template <class R, bool>
    struct Carried {
        using type = typename R::Pair;
    };
    template <class R>
    struct Carried<R, true> {
        using type = typename R::Single;
    };

    using Moves = std::array<Vec3, 3>;

    struct Beam {
        BeamPlace place;
        Vec3 k;
        Vec3 s;  ///< a crystal's mode: its E
        /// Derivatives of k: with colour, and as the line of sight turns to picture-right and -up.
        Moves moves;
        typename Carried<Response, crystal>::type response;
        double area;
        std::array<Affine, absorbing ? (crystal ? 4 : 1) : 0> lengths{};  ///< Colours
        double passed = 1;  ///< the mean over polygon and colours of what they leave
        double gain = 1;    ///< for others that ended
        int entry, left, hits, corners;
        int mode;

        [[nodiscard]] double weight() const { return area * passed * gain * response.power(); }
    };
    using Sample = Remainder<Beam>;

    /// What goes on for all of a path's light at a face.
    struct Drawn {
        double power = 0;  ///< of all
        bool leaves = false, thinned = false;
        Vec3 k, s;  ///< where it leaves the stone
        Moves moves;
        Pair light;
        Beam next;  ///< else
    };

    /// A path that is to be followed with others.
    struct Gathered {
        double weight, area;
        int entry, group;
    };

    [[nodiscard]] bool may_go_on() {
        if (options_.max_beams > 0 && out_.beams >= options_.max_beams) return false;
        if (out_.beams % beams_between_looks != 0) return true;
        look();
        if (stopped_) return false;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        return options_.seconds == 0 || spent.count() < options_.seconds;
    }

    void look() { stopped_ = stopped_ || (options_.go_on && !options_.go_on()); }

    /// As little light is left as was asked for, or sampling it takes about as long as what was
    /// done.
    [[nodiscard]] bool wants_more() const {
        if (options_.bound) return waiting_ > *options_.bound * out_.area_total;
        const double each = options_.outlines ? Sample::beams_a_survivor : 1 / paths_a_beam();
        return each * survivors_wanted() > static_cast<double>(out_.beams);
    }

    /// So many that they take twice as long, which is when the whole takes least: light is lost
    /// slowly when many beams were followed.
    [[nodiscard]] double paths_a_beam() const { return together_ ? 4 : 1; }

    /// Radiances from 0 to 1 have a standard deviation of a half at most.
    [[nodiscard]] double survivors_wanted() const {
        const double ratio = 0.5 * waiting_ / (options_.error * out_.area_total);
        return ratio * ratio * (1 + (times_there() - 1) * waiting_there_ / waiting_);
    }

    /// As many times the survivors of a facet's light, for its weight, as its own error needs.
    [[nodiscard]] double times_there() const {
        if (facet_ < 0 || !(waiting_there_ > 0)) return 1;
        const double part = out_.entry_area[static_cast<std::size_t>(facet_)] / out_.area_total;
        return std::max(1.0, waiting_there_ / (waiting_ * part * part));
    }

    /// A few of the beams that are left go on for all of them.
    void sample() {
        const double most =
            options_.sample_effort * static_cast<double>(out_.beams) / Sample::beams_a_survivor;
        Sample rest(queue_, waiting_, std::min(survivors_wanted(), most), options_.seed, facet_,
                    times_there());
        out_.groups = Sample::groups;
        for (group_ = 1; group_ <= Sample::groups; ++group_) {
            out_.residue +=
                rest.follow(group_ - 1, [&](const BeamList<Beam>& beams, BeamList<Beam>& children) {
                    children_ = &children;
                    beams.each([&](const Beam& b, PolygonView polygon) {
                        beam_ = b;
                        // Light that is caught for long fades as its gain grows: neither may
                        // leave the range of numbers.
                        beam_.response.scale(beam_.gain);
                        beam_.gain = 1;
                        polygon_.assign(polygon.begin(), polygon.end());
                        advance();
                    });
                    const std::uint64_t looks = out_.beams / beams_between_looks;
                    out_.beams += beams.beams.size();
                    if (out_.beams / beams_between_looks > looks) look();
                    return !stopped_;
                });
        }
    }

    /// Paths of single rays, each from a point of a beam that is left, go on for all of them.
    void walk() {
        walking_ = true;
        out_.groups = PathStarts::groups;
        const double most =
            options_.sample_effort * paths_a_beam() * static_cast<double>(out_.beams);
        const double times = times_there(), elsewhere = waiting_ - waiting_there_;
        const double paths = std::max(std::min(survivors_wanted(), most), PathStarts::fewest) /
                             (elsewhere + times * waiting_there_);
        PathStarts others(elsewhere, paths * elsewhere, random_),
            there(waiting_there_, paths * times * waiting_there_, random_);
        queue_.each([&](const Beam& b, PolygonView polygon) {
            PathStarts& starts = b.entry == facet_ ? there : others;
            for (int n = starts.of(b.weight()); n > 0; --n) {
                group_ = starts.group();
                if (together_) {
                    gather(b, polygon, starts.spacing());
                } else {
                    walk(b, polygon, starts.spacing());
                }
            }
        });
        if (together_) walk_gathered();
    }

    /// Whether nothing but directions and powers is asked of paths, so that lanes can follow them.
    [[nodiscard]] bool side_by_side() const {
        return crystal && !absorbing && std::is_same_v<Response, IntensityResponse> &&
               closed_form_ && !options_.fan && !options_.turns && !options_.polarised &&
               options_.max_hits == 0 && options_.least_power == 0;
    }

    void gather(const Beam& b, PolygonView polygon, double weight) {
        const double u = random_.uniform(), v = random_.uniform();
        FaintRays::Ray ray;
        ray.position = b.place.at(point_in(polygon, u, v));
        ray.k = b.k;
        ray.field = b.s;
        ray.weight = 1;
        ray.seed = mixed(options_.seed ^ mixed(++paths_));
        ray.left = b.left;
        ray.hits = b.hits;
        ray.owner = static_cast<int>(gathered_.size());
        ray.extraordinary = b.mode == 1;
        rays_.add(ray);
        gathered_.push_back({weight, b.area, b.entry, group_});
        constexpr std::size_t enough = 4096;
        if (gathered_.size() == enough) walk_gathered();
    }

    void walk_gathered() {
        double left = 0;
        for (const Gathered& g : gathered_) left += g.weight;
        look();
        if (!stopped_) {
            const std::uint64_t before = rays_.events();
            beam_ = Beam{};
            const double lost = rays_.follow_whole(longest_path, [&](const FaintRays::Exit& e) {
                const Gathered& g = gathered_[static_cast<std::size_t>(e.owner)];
                left -= g.weight;
                beam_.area = g.area;
                beam_.entry = g.entry;
                beam_.left = e.facet;
                beam_.hits = e.hits;
                group_ = g.group;
                Pair light;
                light.scale(g.weight / g.area);
                record(e.k, {}, {}, light);
            });
            out_.beams += rays_.events() - before;
            if (!(lost > 0)) left = 0;
        }
        out_.residue += left;
        gathered_.clear();
    }

    /// At each face one of what becomes of the light goes on for all of it, by its power.
    void walk(const Beam& start, PolygonView polygon, double weight) {
        beam_ = start;
        begin_at(polygon);
        power_ = beam_.response.power();
        beam_.response.scale(weight / beam_.weight());
        for (int i = 0; i < longest_path && !stopped_; ++i) {
            if (++out_.beams % beams_between_looks == 0) look();
            if (!step(weight)) return;
        }
        out_.residue += weight;
    }

    /// From the beam to one of its rays, by their light.
    void begin_at(PolygonView polygon) {
        const auto anywhere = [&] {
            const double u = random_.uniform();
            return point_in(polygon, u, random_.uniform());
        };
        Point2 p = anywhere();
        if constexpr (absorbing) {
            const auto passed = [&](const Point2& q) {
                return colours_.transmit({&q, 1}, beam_.lengths);
            };
            // Convex: nowhere more than in a corner.
            double most = 0;
            for (const Point2& corner : polygon) most = std::max(most, passed(corner));
            while (random_.uniform() * most > (beam_.passed = passed(p))) p = anywhere();
            for (Affine& l : beam_.lengths) l = {l(p), 0, 0};
        }
        beam_.place = {beam_.place.at(p), {}, {}};
        piece_.assign(1, {});
    }

    /// To the next face of a path that carries so much; false where it ends.
    bool step(double weight) {
        const Vec3 along = flow();
        double t = 0;
        const int facet = cells_.facets().exit(beam_.place.origin, along, beam_.left, t);
        if (facet < 0) return lose(weight);
        beam_.place.origin = beam_.place.origin + t * along;
        beam_.left = facet;
        ++beam_.hits;
        if constexpr (absorbing) {
            const double before = beam_.passed;
            growth(along);
            absorb(piece_, {t, 0, 0});
            if (random_.uniform() * before >= beam_.passed) {
                out_.absorbed += weight;
                return false;
            }
        }
        drawn_.power = 0;
        meet(cells_.facets().normal(facet));
        if (!(drawn_.power > 0)) return lose(weight);
        if (drawn_.leaves) {
            drawn_.light.scale(weight / (beam_.area * beam_.passed * drawn_.light.power()));
            record(drawn_.k, drawn_.moves, drawn_.s, drawn_.light);
            return false;
        }
        beam_ = drawn_.next;
        power_ *= beam_.response.power() / drawn_.power;
        beam_.response.scale(weight / beam_.weight());
        if (!ends(drawn_.thinned, power_)) return true;
        cut(weight);
        return false;
    }

    bool lose(double weight) {
        out_.residue += weight;
        return false;
    }

    /// Whether what is drawn of a path's light at a face is this, as far as is known.
    bool draws(double power) {
        drawn_.power += power;
        return random_.uniform() * drawn_.power < power;
    }

    /// One sector of a symmetric view is enough.
    void fold() {
        const double whole = out_.area_total;
        symmetry_ = symmetry_of(stone_, medium_, colours_.axes(), frame_);
        measure();
        // Rounding may hide a part of the symmetry, so that sectors would not fill the picture.
        constexpr double rounding = 1e-12;
        const double filled = out_.area_total * static_cast<double>(symmetry_.images.size());
        if (std::abs(filled - whole) <= rounding * whole) return;
        symmetry_ = no_symmetry(stone_);
        measure();
    }

    /// Sums over all images.
    void unfold() {
        const auto whole = [&](std::vector<double>& sums, double& total) {
            const std::vector<double> part = sums;
            sums.assign(part.size(), 0);
            for (const PictureImage& image : symmetry_.images) {
                for (std::size_t i = 0; i < part.size(); ++i) {
                    sums[static_cast<std::size_t>(image.facets[i])] += part[i];
                }
            }
            total *= static_cast<double>(symmetry_.images.size());
        };
        whole(out_.entry_area, out_.area_total);
        whole(out_.entry_untraced, out_.untraced);
        whole(out_.entry_cut, out_.cut);
        out_.gaps *= static_cast<double>(symmetry_.images.size());
        out_.residue *= static_cast<double>(symmetry_.images.size());
        out_.absorbed *= static_cast<double>(symmetry_.images.size());
    }

    /// The outline of a facet in the picture, within the sector.
    void project(const Facet& facet) {
        polygon_.clear();
        for (const std::uint32_t c : facet.corners) {
            const Vec3 p = stone_.vertices[c] - frame_.centre;
            polygon_.push_back({dot(p, frame_.right), dot(p, frame_.up)});
        }
        for (const Affine& side : symmetry_.sector) {
            clip(polygon_, side, piece_);
            polygon_.swap(piece_);
        }
    }

    void measure() {
        out_.area_total = 0;
        for (std::size_t i = 0; i < stone_.facets.size(); ++i) {
            if (!(dot(stone_.facets[i].normal, frame_.direction) < 0)) continue;
            project(stone_.facets[i]);
            out_.entry_area[i] = std::max(0.0, extent(polygon_).area);
            out_.area_total += out_.entry_area[i];
        }
    }

    void enter(int facet) {
        const Vec3 &k = frame_.direction, &right = frame_.right, &up = frame_.up;
        const auto i = static_cast<std::size_t>(facet);
        project(stone_.facets[i]);
        colours_.begin();
        const Vec3 outside = cells_.facets().normal(facet), normal = -outside;
        const double slowness = 1 / dot(outside, k);
        beam_ = Beam{};
        beam_.place = BeamPlace{{}, right, up}.moved(
            {cells_.facets().distance(facet) * slowness, -dot(outside, right) * slowness,
             -dot(outside, up) * slowness},
            k);
        beam_.area = out_.entry_area[i];
        beam_.entry = beam_.left = facet;
        beam_.hits = 1;
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
            beam_.moves = sight;
            leave(back, outside_moves(back, normal), s, arriving.through(transfer(face, false)));
            send_modes(CrystalWaves(face, true), normal, false, [&](std::size_t m) {
                return Response::entering(arriving, face.flux_amplitude(0, true, m),
                                          face.flux_amplitude(1, true, m));
            });
        } else {
            const Pair arriving = on_face(launched, k, 1, normal, s);
            const double q = dot(normal, k);
            const Fresnel through = fresnel(1, medium_.n_o, q);
            beam_.moves = sight;
            leave(back, outside_moves(back, normal), s, arriving.times(through.r_s, through.r_p));
            beam_.k = k + (through.q - q) * normal;
            beam_.s = s;
            move(sight, normal);
            beam_.response = arriving.times(through.t_s, through.t_p);
            send(false);
        }
    }

    [[nodiscard]] Pair at_viewer() const {
        if constexpr (!std::is_same_v<Response, AveragedResponse>) {
            if (options_.analyser) return Pair::behind(*options_.analyser);
        }
        return {};
    }

    /// The direction of energy, not normalised.
    [[nodiscard]] Vec3 flow() const {
        if constexpr (crystal) {
            return beam_.k - dot(beam_.s, beam_.k) * beam_.s;
        } else {
            return beam_.k;
        }
    }

    void advance() {
        const Beam before = beam_;
        const Vec3 along = flow();
        if constexpr (absorbing) growth(along);
        const double longest = diameter_ / length(along);
        double met = 0, left = 0;
        for (const FacetCells::Piece& piece :
             cells_.divide(before.place, along, before.left, polygon_, extent(polygon_).centroid)) {
            const double area = extent(piece.polygon).area;
            if (!(area > 0) || !passable(piece, longest)) continue;
            met += area;
            beam_ = before;
            beam_.area = area;
            beam_.place = before.place.moved(piece.distance, along);
            beam_.left = piece.facet;
            ++beam_.hits;
            piece_ = piece.polygon;
            if constexpr (absorbing) left += absorb(piece_, piece.distance);
            meet(cells_.facets().normal(piece.facet));
        }
        const double gap = std::abs(before.area - met);
        const double power = before.gain * before.response.power(),
                     lost = gap * before.passed * power;
        if constexpr (absorbing) out_.absorbed += (met * before.passed - left) * power;
        if (group_ > 0) {
            out_.residue += lost;
            return;
        }
        out_.gaps += gap;
        give_up(before.entry, lost);
    }

    /// Beside rays that graze a facet rounding leaves slivers: no way in the stone is below 0 or
    /// longer than `longest`, but light would grow or all but vanish on theirs.
    [[nodiscard]] static bool passable(const FacetCells::Piece& piece, double longest) {
        constexpr double rounding = 1e-6;
        const auto [low, high] = range_of(piece.polygon, piece.distance);
        return low > -rounding * longest && high < (1 + rounding) * longest;
    }

    /// On the way of beam_ to its facet; what of its area's light arrives there.
    double absorb(PolygonView polygon, const Affine& t) {
        for (std::size_t i = 0; i < beam_.lengths.size(); ++i) {
            Affine& l = beam_.lengths[i];
            const double rate = growth_[i];
            l = {l.value + rate * t.value, l.dx + rate * t.dx, l.dy + rate * t.dy};
        }
        beam_.passed = colours_.transmit(polygon, beam_.lengths);
        return beam_.area * beam_.passed;
    }

    /// Of the lengths of beam_, per multiple of its flow.
    void growth(const Vec3& along) {
        growth_.fill(1);
        if constexpr (crystal) {
            for (std::size_t i = 0; i < growth_.size(); ++i) {
                growth_[i] = colours_.growth(i, beam_.s, beam_.k, along);
            }
        }
    }

    void meet(const Vec3& normal) {
        const Vec3 k = beam_.k;
        if constexpr (crystal) {
            const auto before = beam_.response;
            if (closed_form_) {
                const InnerFace face(medium_, air_, normal, k, beam_.s, beam_.mode == 1);
                if (face.passes) {
                    leave(face.k_out, outside_moves(face.k_out, normal), face.s,
                          before.leaving(face.out_s, face.out_p));
                }
                return send_modes(face.reflected, normal, face.passes,
                                  [&](std::size_t i) { return before.times(face.amplitude[i]); });
            }
            Wave incident;
            incident.mode = modes_[static_cast<std::size_t>(beam_.mode)];
            incident.k = complexified(k);
            incident.E = complexified(beam_.s);
            incident.H = complexified(cross(k, beam_.s));
            incident.n_phase = length(k);
            const Interface face(medium_, air_, normal, incident);
            const auto m = static_cast<std::size_t>(beam_.mode);
            if (face.propagating(true, 0)) {
                const Vec3 out = face.wave_vector(true, 0);
                leave(out, outside_moves(out, normal), face.s_direction(),
                      before.leaving(face.flux_amplitude(m, true, 0),
                                     face.flux_amplitude(m, true, 1)));
            }
            send_modes(
                CrystalWaves(face, false), normal, face.propagating(true, 0),
                [&](std::size_t i) { return before.times(face.flux_amplitude(m, false, i)); });
        } else {
            const double n = medium_.n_o, q = dot(normal, k);
            const Pair incident = on_face(beam_.response, k, n, normal, beam_.s);
            const Fresnel face = fresnel(n, 1, q);
            if (face.passes) {
                const Vec3 out = k + (face.q - q) * normal;
                leave(out, outside_moves(out, normal), beam_.s, incident.times(face.t_s, face.t_p));
            }
            beam_.response = incident.times(face.r_s, face.r_p);
            beam_.k = k - (2 * q) * normal;
            for (Vec3& m : beam_.moves) m = mirrored(m, normal);
            send(face.passes);
        }
    }

    /// Of beam_, whose wave vector had these when it met the face. By k x (k x E) = -eps E the
    /// surface on which k ends swells by E . (d eps) E / 2 with colour.
    void move(const Moves& before, const Vec3& normal) {
        const Vec3 along = flow();
        if (options_.fan) {
            const RealTensor& change = *options_.fan;
            const double swell = 0.5 * (crystal ? dot(beam_.s, change * beam_.s) : change.xx);
            beam_.moves[0] = fanned(before[0], normal, along, swell);
        }
        if (!options_.turns) return;
        for (std::size_t i : {1, 2}) beam_.moves[i] = fanned(before[i], normal, along, 0);
    }
    [[nodiscard]] Moves outside_moves(const Vec3& k, const Vec3& normal) const {
        Moves out{};
        if (options_.fan) out[0] = fanned(beam_.moves[0], normal, k, 0);
        if (!options_.turns) return out;
        for (std::size_t i : {1, 2}) out[i] = fanned(beam_.moves[i], normal, k, 0);
        return out;
    }

    template <class Coupled>
    void send_modes(const CrystalWaves& waves, const Vec3& normal, bool thinned,
                    const Coupled& coupled) {
        const Moves before = beam_.moves;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!waves.propagates[i]) continue;
            beam_.mode = static_cast<int>(i);
            beam_.response = coupled(i);
            beam_.k = waves.k[i];
            beam_.s = waves.E[i];
            move(before, normal);
            send(thinned);
        }
    }

    /// Goes on from a face, where part of the light may have left, with what is in beam_.
    void send(bool thinned) {
        const double power = beam_.response.power(), weight = beam_.weight();
        if (!(weight > 0)) return;
        if (walking_) {
            if (!draws(power)) return;
            drawn_.leaves = false;
            drawn_.thinned = thinned;
            drawn_.next = beam_;
            return;
        }
        if (ends(thinned, power)) return cut(weight);
        const PolygonView polygon = beam_.hits == 1 ? polygon_ : piece_;
        if (group_ > 0) return children_->push(beam_, polygon);
        waiting_ += weight;
        if (beam_.entry == facet_) waiting_there_ += weight;
        queue_.push(beam_, weight / out_.area_total, polygon);
    }

    /// Whether a path ends here by what was asked for; `thinned`: where part of the light left.
    [[nodiscard]] bool ends(bool thinned, double power) const {
        return (options_.max_hits > 0 && beam_.hits >= options_.max_hits) ||
               (thinned && beam_.passed * power < options_.least_power);
    }

    /// `s` is across k, of any length.
    void leave(const Vec3& k, const Moves& moves, const Vec3& s, const Pair& response) {
        if (!walking_) return record(k, moves, s, response);
        if (!draws(response.power())) return;
        drawn_.leaves = true;
        drawn_.k = k;
        drawn_.s = s;
        drawn_.moves = moves;
        drawn_.light = response;
    }

    void record(const Vec3& k, const Moves& moves, const Vec3& s, const Pair& response) {
        const double share = beam_.passed * beam_.gain;
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
        out_.area.push_back(beam_.area);
        out_.entry.push_back(beam_.entry);
        out_.facet.push_back(beam_.left);
        out_.hits.push_back(beam_.hits);
        out_.group.push_back(group_);
        if constexpr (absorbing) {
            const auto tint = colours_.tint();
            out_.tint.insert(out_.tint.end(), tint.begin(), tint.end());
        }
        if (!options_.outlines) return;
        const Polygon& polygon = beam_.hits == 1 ? polygon_ : piece_;
        out_.corners.insert(out_.corners.end(), polygon.begin(), polygon.end());
        out_.outline.push_back(out_.corners.size());
        if constexpr (absorbing) {
            out_.lengths.insert(out_.lengths.end(), beam_.lengths.begin(), beam_.lengths.end());
        }
    }

    void give_up(int entry, double weight) {
        out_.entry_untraced[static_cast<std::size_t>(entry)] += weight;
        out_.untraced += weight;
    }
    void cut(double weight) {
        out_.entry_cut[static_cast<std::size_t>(beam_.entry)] += weight;
        out_.cut += weight;
    }

    const Stone& stone_;
    FacetCells cells_;
    Medium air_, medium_;
    std::array<Mode, 2> modes_;
    bool closed_form_;  ///< of faces met from inside
    Colours colours_;
    std::array<double, std::tuple_size_v<decltype(Beam::lengths)>> growth_{};
    PictureFrame frame_;
    ViewOptions options_;
    Exits& out_;
    ViewSymmetry symmetry_;
    BeamQueue<Beam> queue_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double diameter_ = 0;                 ///< at least the stone's
    double waiting_ = 0;                  ///< weight times area of what is in the queue
    int facet_ = -1;                      ///< whose own error is asked for
    double waiting_there_ = 0;            ///< of that, what entered there
    int group_ = 0;                       ///< that is being sampled
    BeamList<Beam>* children_ = nullptr;  ///< where its beams go on
    bool stopped_ = false;                ///< by go_on
    Beam beam_{};
    Polygon polygon_, piece_;
    Random random_;
    bool walking_ = false;  ///< along paths
    Drawn drawn_{};
    double power_ = 0;  ///< of a path's light without what it carries for others
    bool together_ = false;
    FaintRays rays_;  ///< of paths that are followed side by side
    std::vector<Gathered> gathered_;
    std::uint64_t paths_ = 0;
};

}  // namespace icespar
