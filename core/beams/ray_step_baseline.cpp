// The step of rays for the baseline of the build.
#include "beams/ray_step.hpp"

namespace icespar {

void step_baseline(const RayStone& stone, double threshold, RayLanes& rays) {
    lanes::step_all<std::experimental::native_simd<double>>(stone, threshold, rays);
}

}  // namespace icespar
