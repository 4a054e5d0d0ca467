// Beams from whole facets through one stone, heaviest first.
#pragma once

#include <cmath>

#include "views/beam_queue.hpp"
#include "views/path_starts.hpp"
#include "views/remainder.hpp"
#include "views/symmetry.hpp"
#include "views/transmission.hpp"
#include "views/view_paths.hpp"

namespace icespar {

/// With parallel light every path through plane facets keeps one wave vector and one response over
/// the whole polygon that takes it, and its places are linear in picture coordinates: nothing is
/// approximated.
template <class Response, bool crystal, bool absorbing>
class ViewTracer {
public:
    using Light = ViewLight<Response, crystal, absorbing>;
    using Beam = typename Light::Beam;
    using Moves = typename Light::Moves;

    ViewTracer(const Stone& stone, const Medium& medium, std::span<const Absorption> absorption,
               const PictureFrame& frame, const ViewOptions& options, Exits& out)
        : stone_(stone),
          medium_(medium),
          cells_(stone),
          frame_(frame),
          options_(options),
          light_(medium, absorption, options_),
          watch_(options_),
          recorder_(options_, light_.colours(), out),
          out_(out),
          facet_(options.error_of.value_or(-1)),
          together_(Paths::side_by_side(medium, options)) {}

    void run() {
        frame_.centre = cells_.facets().centre();
        for (const Vec3& v : stone_.vertices) {
            diameter_ = std::max(diameter_, 2 * length(v - frame_.centre));
        }
        out_.frame = frame_;
        out_.rates = light_.colours().rates();
        if (options_.outlines) out_.outline.assign(1, 0);
        out_.entry_area.assign(stone_.facets.size(), 0);
        out_.entry_untraced = out_.entry_cut = out_.entry_area;
        symmetry_ = no_symmetry(stone_);
        measure();
        if (options_.symmetry && !options_.polarised && !options_.analyser) fold();
        out_.images = symmetry_.images;
        for (std::size_t i = 0; i < stone_.facets.size(); ++i) {
            if (!(out_.entry_area[i] > 0)) continue;
            project(stone_.facets[i]);
            light_.enter(cells_.facets(), static_cast<int>(i), out_.entry_area[i], beam_, frame_,
                         *this);
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
        if (options_.error > 0 && waiting_ > 0 && !watch_.stopped()) {
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

    // For the light.
    void leave(const Beam& beam, const Vec3& k, const Moves& moves, const Vec3& s,
               const typename Light::Pair& response) {
        recorder_.add(beam, outline(beam), group_, k, moves, s, response);
    }
    void send(const Beam& beam, bool thinned) {
        const double weight = beam.weight();
        if (!(weight > 0)) return;
        if (ends_by(options_, beam, thinned, beam.response.power())) {
            out_.entry_cut[static_cast<std::size_t>(beam.entry)] += weight;
            out_.cut += weight;
            return;
        }
        if (group_ > 0) return children_->push(beam, outline(beam));
        waiting_ += weight;
        if (beam.entry == facet_) waiting_there_ += weight;
        queue_.push(beam, weight / out_.area_total, outline(beam));
    }

private:
    using Paths = ViewPaths<Response, crystal, absorbing>;
    using Sample = Remainder<Beam>;

    [[nodiscard]] PolygonView outline(const Beam& beam) const {
        return beam.hits == 1 ? polygon_ : piece_;
    }

    [[nodiscard]] bool may_go_on() {
        if (options_.max_beams > 0 && out_.beams >= options_.max_beams) return false;
        if (out_.beams % Watch::beams_between_looks != 0) return true;
        watch_.look();
        return !watch_.stopped() && !watch_.out_of_time();
    }

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
                    const std::uint64_t looks = out_.beams / Watch::beams_between_looks;
                    out_.beams += beams.beams.size();
                    if (out_.beams / Watch::beams_between_looks > looks) watch_.look();
                    return !watch_.stopped();
                });
        }
    }

    /// Paths begin on the beams that are left, for all of them.
    void walk() {
        Paths paths(light_, medium_, cells_.facets(), options_, watch_, out_);
        out_.groups = PathStarts::groups;
        const double most =
            options_.sample_effort * paths_a_beam() * static_cast<double>(out_.beams);
        const double times = times_there(), elsewhere = waiting_ - waiting_there_;
        const double a_weight = std::max(std::min(survivors_wanted(), most), PathStarts::fewest) /
                                (elsewhere + times * waiting_there_);
        PathStarts others(elsewhere, a_weight * elsewhere, paths.random()),
            there(waiting_there_, a_weight * times * waiting_there_, paths.random());
        queue_.each([&](const Beam& b, PolygonView polygon) {
            PathStarts& starts = b.entry == facet_ ? there : others;
            for (int n = starts.of(b.weight()); n > 0; --n) {
                paths.follow(b, polygon, starts.spacing(), starts.group());
            }
        });
        paths.finish();
    }

    /// One sector of a symmetric view is enough.
    void fold() {
        const double whole = out_.area_total;
        symmetry_ = symmetry_of(stone_, medium_, light_.colours().axes(), frame_);
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

    void advance() {
        const Beam before = beam_;
        const Vec3 along = Light::flow(beam_);
        if constexpr (absorbing) light_.grow(beam_, along);
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
            if constexpr (absorbing) left += light_.absorb(beam_, piece_, piece.distance);
            light_.meet(beam_, cells_.facets().normal(piece.facet), *this);
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

    void give_up(int entry, double weight) {
        out_.entry_untraced[static_cast<std::size_t>(entry)] += weight;
        out_.untraced += weight;
    }

    const Stone& stone_;
    const Medium& medium_;
    FacetCells cells_;
    PictureFrame frame_;
    ViewOptions options_;
    Light light_;
    Watch watch_;
    ExitRecorder<Response, crystal, absorbing> recorder_;
    Exits& out_;
    ViewSymmetry symmetry_;
    BeamQueue<Beam> queue_;
    double diameter_ = 0;                 ///< at least the stone's
    double waiting_ = 0;                  ///< weight times area of what is in the queue
    int facet_ = -1;                      ///< whose own error is asked for
    double waiting_there_ = 0;            ///< of that, what entered there
    bool together_;                       ///< paths are followed side by side
    int group_ = 0;                       ///< that is being sampled
    BeamList<Beam>* children_ = nullptr;  ///< where its beams go on
    Beam beam_{};
    Polygon polygon_, piece_;
};

}  // namespace icespar
