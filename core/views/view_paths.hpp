// Paths of single rays, each from a point of a beam that is left, go on for all of them.
#pragma once

#include <optional>

#include "beams/faint_rays.hpp"
#include "views/exit_recorder.hpp"
#include "views/watch.hpp"

namespace icespar {

/// Whether a path ends at a face by what was asked for; `thinned`: where part of the light left.
template <class Beam>
[[nodiscard]] bool ends_by(const ViewOptions& options, const Beam& beam, bool thinned,
                           double power) {
    return (options.max_hits > 0 && beam.hits >= options.max_hits) ||
           (thinned && beam.passed * power < options.least_power);
}

/// Each path carries its weight whole to where it ends. Paths in clear uniaxial stones of which no
/// more than directions and powers is asked are followed side by side.
template <class Response, bool crystal, bool absorbing>
class ViewPaths {
public:
    using Light = ViewLight<Response, crystal, absorbing>;
    using Beam = typename Light::Beam;
    using Pair = typename Light::Pair;
    using Moves = typename Light::Moves;

    ViewPaths(Light& light, const Medium& medium, const FacetSearch& facets,
              const ViewOptions& options, Watch& watch, Exits& out)
        : light_(light),
          facets_(facets),
          options_(options),
          watch_(watch),
          recorder_(options, light.colours(), out),
          out_(out),
          random_(options.seed) {
        if (!side_by_side(medium, options)) return;
        rays_.emplace(facets);
        rays_->set_medium(medium);
    }

    /// Whether nothing but directions and powers is asked of paths, so that lanes can follow them.
    [[nodiscard]] static bool side_by_side(const Medium& medium, const ViewOptions& options) {
        return crystal && !absorbing && std::is_same_v<Response, IntensityResponse> &&
               medium.plain() && !options.fan && !options.turns && !options.polarised &&
               options.max_hits == 0 && options.least_power == 0;
    }

    /// From somewhere in a beam, in a group of the sample.
    void follow(const Beam& b, PolygonView polygon, double weight, int group) {
        if (rays_) {
            gather(b, polygon, weight, group);
        } else {
            walk(b, polygon, weight, group);
        }
    }
    /// After the last.
    void finish() {
        if (rays_) follow_gathered();
    }
    [[nodiscard]] Random& random() { return random_; }

    // For the light.
    void leave(const Beam&, const Vec3& k, const Moves& moves, const Vec3& s,
               const Pair& response) {
        if (!draws(response.power())) return;
        drawn_.leaves = true;
        drawn_.k = k;
        drawn_.s = s;
        drawn_.moves = moves;
        drawn_.light = response;
    }
    void send(const Beam& beam, bool thinned) {
        const double power = beam.response.power();
        if (!(beam.weight() > 0) || !draws(power)) return;
        drawn_.leaves = false;
        drawn_.thinned = thinned;
        drawn_.next = beam;
    }

private:
    static constexpr int longest_path = 5000;  ///< in faces

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

    void gather(const Beam& b, PolygonView polygon, double weight, int group) {
        const double u = random_.uniform(), v = random_.uniform();
        FaintRays::Ray ray;
        ray.position = b.place.at(point_in(polygon, u, v));
        ray.k = b.k;
        ray.field = b.s;
        ray.weight = 1;
        ray.random = Random(mixed(options_.seed ^ mixed(++paths_)));
        ray.left = b.left;
        ray.hits = b.hits;
        ray.owner = static_cast<int>(gathered_.size());
        ray.extraordinary = b.mode == 1;
        rays_->add(ray);
        gathered_.push_back({weight, b.area, b.entry, group});
        constexpr std::size_t enough = 4096;
        if (gathered_.size() == enough) follow_gathered();
    }

    void follow_gathered() {
        double left = 0;
        for (const Gathered& g : gathered_) left += g.weight;
        watch_.look();
        if (!watch_.stopped()) {
            const std::uint64_t before = rays_->events();
            beam_ = Beam{};
            const double lost = rays_->follow_whole(longest_path, [&](const FaintRays::Exit& e) {
                const Gathered& g = gathered_[static_cast<std::size_t>(e.owner)];
                left -= g.weight;
                beam_.area = g.area;
                beam_.entry = g.entry;
                beam_.left = e.facet;
                beam_.hits = e.hits;
                Pair light;
                light.scale(g.weight / g.area);
                recorder_.add(beam_, {}, g.group, e.k, {}, {}, light);
            });
            out_.beams += rays_->events() - before;
            if (!(lost > 0)) left = 0;
        }
        out_.residue += left;
        gathered_.clear();
    }

    /// At each face one of what becomes of the light goes on for all of it, by its power.
    void walk(const Beam& start, PolygonView polygon, double weight, int group) {
        beam_ = start;
        group_ = group;
        begin_at(polygon);
        power_ = beam_.response.power();
        beam_.response.scale(weight / beam_.weight());
        for (int i = 0; i < longest_path && !watch_.stopped(); ++i) {
            if (++out_.beams % Watch::beams_between_looks == 0) watch_.look();
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
                return light_.colours().transmit({&q, 1}, beam_.lengths);
            };
            // Convex: nowhere more than in a corner.
            double most = 0;
            for (const Point2& corner : polygon) most = std::max(most, passed(corner));
            while (random_.uniform() * most > (beam_.passed = passed(p))) p = anywhere();
            for (Affine& l : beam_.lengths) l = {l(p), 0, 0};
        }
        beam_.place = {beam_.place.at(p), {}, {}};
    }

    /// To the next face of a path that carries so much; false where it ends.
    bool step(double weight) {
        const Vec3 along = light_.flow(beam_);
        double t = 0;
        const int facet = facets_.exit(beam_.place.origin, along, beam_.left, t);
        if (facet < 0) return lose(weight);
        beam_.place.origin = beam_.place.origin + t * along;
        beam_.left = facet;
        ++beam_.hits;
        if constexpr (absorbing) {
            const double before = beam_.passed;
            constexpr Point2 here;
            const PolygonView point{&here, 1};
            light_.grow(beam_, along);
            light_.absorb(beam_, point, {t, 0, 0});
            if (random_.uniform() * before >= beam_.passed) {
                out_.absorbed += weight;
                return false;
            }
        }
        drawn_.power = 0;
        light_.meet(beam_, facets_.normal(facet), *this);
        if (!(drawn_.power > 0)) return lose(weight);
        if (drawn_.leaves) {
            drawn_.light.scale(weight / (beam_.area * beam_.passed * drawn_.light.power()));
            recorder_.add(beam_, {}, group_, drawn_.k, drawn_.moves, drawn_.s, drawn_.light);
            return false;
        }
        beam_ = drawn_.next;
        power_ *= beam_.response.power() / drawn_.power;
        beam_.response.scale(weight / beam_.weight());
        if (!ends_by(options_, beam_, drawn_.thinned, power_)) return true;
        out_.entry_cut[static_cast<std::size_t>(beam_.entry)] += weight;
        out_.cut += weight;
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

    Light& light_;
    const FacetSearch& facets_;
    const ViewOptions& options_;
    Watch& watch_;
    ExitRecorder<Response, crystal, absorbing> recorder_;
    Exits& out_;
    Random random_;
    Beam beam_{};
    int group_ = 0;  ///< of the path
    Drawn drawn_{};
    double power_ = 0;               ///< of its light without what it carries for others
    std::optional<FaintRays> rays_;  ///< of paths that are followed side by side
    std::vector<Gathered> gathered_;
    std::uint64_t paths_ = 0;
};

}  // namespace icespar
