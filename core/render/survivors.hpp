// What becomes of beams that survived by chance and went on as rays, told apart for the estimate of
// the error.
#pragma once

#include <span>
#include <vector>

#include "beams/faint_rays.hpp"
#include "beams/roulette.hpp"

namespace icespar {

/// `Response`: of a mode.
template <class Response>
class Survivors {
public:
    void add(int hits, Response response) {
        response.scale(1 / response.power());
        survivors_.push_back({hits, response});
    }
    /// Of the last survivor.
    void send(FaintRays::Ray ray, std::size_t pixel, std::uint64_t seed, FaintRays& rays) {
        ray.owner = static_cast<int>(owners_.size());
        ray.random = Random(seed);
        owners_.push_back({survivors_.size() - 1, pixel});
        rays.add(ray);
    }
    /// Follows the rays and ends. see(pixel, exit, response) returns the luminance; the response is
    /// that of a wave whose power is 1. Returns the weight given up.
    template <class See>
    double follow(FaintRays& rays, double threshold, int most_hits, std::size_t pixels,
                  Roulette& roulette, const See& see) {
        light_.assign(survivors_.size() * pixels, 0);
        const double lost = rays.follow(threshold, most_hits, [&](const FaintRays::Exit& exit) {
            const Owner& owner = owners_[static_cast<std::size_t>(exit.owner)];
            light_[owner.survivor * pixels + owner.pixel] +=
                see(owner.pixel, exit, survivors_[owner.survivor].response);
        });
        for (std::size_t i = 0; i < survivors_.size(); ++i) {
            roulette.saw(survivors_[i].hits, std::span(light_).subspan(i * pixels, pixels));
        }
        survivors_.clear();
        owners_.clear();
        return lost;
    }

private:
    struct Survivor {
        int hits;
        Response response;
    };
    struct Owner {
        std::size_t survivor, pixel;
    };
    std::vector<Survivor> survivors_;
    std::vector<Owner> owners_;
    std::vector<double> light_;  ///< luminance [survivor][pixel]
};

}  // namespace icespar
