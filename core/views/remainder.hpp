// What exact tracing leaves in the queue: a few of its beams go on for all of them, by systematic
// roulette.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/random.hpp"
#include "views/beam_queue.hpp"

namespace icespar {

/// Beams of less than the threshold survive with a probability proportional to their weight, as a
/// systematic sample: probabilities are added up from a random start, and who passes a whole number
/// survives. So many survive that the weight of all together stays what it was, to rounding, and
/// that of each is expected to.
class Thinning {
public:
    /// `light` is the sum of the weights below the threshold.
    Thinning(double light, double threshold, Random& random)
        : threshold_(threshold),
          spacing_(light / std::max(1.0, std::ceil(light / threshold))),
          reached_(random.uniform()) {}

    /// By how much a beam's weight grows; 0 for one that ends.
    [[nodiscard]] double gain(double weight) {
        if (!(weight < threshold_)) return 1;
        reached_ += weight / spacing_;
        if (reached_ < 1) return 0;
        const double times = std::floor(reached_);
        reached_ -= times;
        return times * spacing_ / weight;
    }

private:
    double threshold_, spacing_;
    double reached_;
};

/// A sample of beams that have weight() and a `gain` in it, in groups that know nothing of each
/// other, so that their differences tell its error.
template <class Beam>
class Remainder {
public:
    static constexpr int groups = 16;
    /// Followed for each survivor, with what comes of it.
    static constexpr double beams_a_survivor = 5;

    /// Of a queue with so much weight, about so many survivors; of light that enters by `facet`
    /// `times` as many as of others.
    Remainder(const BeamQueue<Beam>& queue, double weight, double survivors, std::uint64_t seed,
              int facet = -1, double times = 1)
        : random_(seed),
          facet_(facet),
          times_(times),
          least_(end * weight / groups),
          starts_(groups) {
        double ranks = 0;
        queue.each([&](const Beam& b, PolygonView) { ranks += rank(b); });
        const double threshold = ranks * groups / std::max(survivors, 1.0 * groups * fewest);
        threshold_ = threshold / groups;
        double light = 0;
        queue.each([&](const Beam& b, PolygonView) {
            if (rank(b) < threshold) light += rank(b);
        });
        std::vector<Thinning> thinnings;
        for (int g = 0; g < groups; ++g) thinnings.emplace_back(light, threshold, random_);
        queue.each([&](const Beam& b, PolygonView polygon) {
            for (std::size_t g = 0; g < groups; ++g) {
                const double gain = thinnings[g].gain(rank(b));
                if (gain > 0) keep(b, gain / groups, polygon, starts_[g]);
            }
        });
    }

    /// Calls advance(beams, children) for one generation of a group after the other, until next to
    /// nothing is left or it returns false, or what is caught for so many. Returns the weight that
    /// is left.
    template <class Advance>
    double follow(int group, Advance&& advance) {
        BeamList<Beam>& beams = starts_[static_cast<std::size_t>(group)];
        BeamList<Beam> children;
        bool more = true;
        for (int i = 0; i < generations && more && total(beams) > least_; ++i) {
            children.clear();
            more = advance(beams, children);
            beams.clear();
            double light = 0;
            for (const Beam& b : children.beams) {
                if (rank(b) < threshold_) light += rank(b);
            }
            Thinning thinning(light, threshold_, random_);
            children.each([&](const Beam& b, PolygonView polygon) {
                const double gain = thinning.gain(rank(b));
                if (gain > 0) keep(b, gain, polygon, beams);
            });
        }
        return total(beams);
    }

private:
    static constexpr int generations = 5000;
    static constexpr int fewest = 4;     ///< survivors of a group
    static constexpr double end = 1e-5;  ///< of what it was at first

    static void keep(Beam beam, double gain, PolygonView polygon, BeamList<Beam>& list) {
        beam.gain *= gain;
        list.push(beam, polygon);
    }
    static double total(const BeamList<Beam>& list) {
        double sum = 0;
        for (const Beam& b : list.beams) sum += b.weight();
        return sum;
    }
    /// What roulette takes for a beam's weight.
    [[nodiscard]] double rank(const Beam& b) const {
        return b.entry == facet_ ? times_ * b.weight() : b.weight();
    }

    Random random_;
    int facet_;
    double times_;
    double least_, threshold_ = 0;
    std::vector<BeamList<Beam>> starts_;
};

}  // namespace icespar
