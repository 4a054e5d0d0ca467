// Beams in the order of their weights, to within a fifth: one stack for each class of weights.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "beams/beam_list.hpp"

namespace icespar {

/// Weights lie in (0, 1] and those that are pushed never exceed the last one popped, but for
/// rounding.
template <class Beam>
class BeamQueue {
public:
    void push(const Beam& beam, double weight, PolygonView polygon) {
        classes_[std::max(number(weight), first_)].push(beam, polygon);
    }

    /// False when there is none left.
    bool pop(Beam& beam, Polygon& polygon) {
        while (classes_[first_].beams.empty()) {
            if (++first_ == classes_.size()) {
                --first_;
                return false;
            }
            classes_[first_ - 1] = {};
        }
        classes_[first_].pop(beam, polygon);
        return true;
    }

    /// Calls visit(beam, polygon), the heaviest class first.
    template <class Visit>
    void each(Visit&& visit) const {
        for (const BeamList<Beam>& c : classes_) c.each(visit);
    }

private:
    /// By exponent and the first two bits behind it: four classes an octave.
    static std::size_t number(double weight) {
        constexpr std::uint64_t one = std::bit_cast<std::uint64_t>(1.0) >> 50;
        const std::uint64_t w = std::bit_cast<std::uint64_t>(weight) >> 50;
        return static_cast<std::size_t>(w >= one ? 0 : std::min<std::uint64_t>(one - w, 255));
    }

    std::array<BeamList<Beam>, 256> classes_;
    std::size_t first_ = 0;
};

}  // namespace icespar
