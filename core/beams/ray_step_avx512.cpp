// The step of rays for AVX-512 processors, with the options that CMake gives this file alone.
#include "beams/ray_step.hpp"

namespace icespar {

void step_avx512(const RayStone& stone, double threshold, RayLanes& rays) {
    lanes::step_all<std::experimental::native_simd<double>>(stone, threshold, rays);
}

}  // namespace icespar
