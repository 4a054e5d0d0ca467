// Media and their checks.
#include "crystal/medium.hpp"

#include "math/error.hpp"

namespace icespar {
namespace {

void require_index(double n, const char* which) {
    if (!std::isfinite(n) || n <= 0) {
        throw Error(std::string(which) + " must be a finite positive number, not " +
                    std::to_string(n));
    }
}

}  // namespace

Medium Medium::isotropic(double n) {
    require_index(n, "n");
    return {n, n, {0, 0, 1}, false};
}

Medium Medium::uniaxial(double n_o, double n_e, const Vec3& axis) {
    require_index(n_o, "n_o");
    require_index(n_e, "n_e");
    const double size = length(axis);
    if (!is_finite(axis) || !std::isfinite(size) || size == 0) {
        throw Error("axis must be a finite vector that is not zero");
    }
    return {n_o, n_e, axis / size, true};
}

}  // namespace icespar
