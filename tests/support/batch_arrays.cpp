// Gives each result of a batch a column of its own.
#include "support/batch_arrays.hpp"

namespace icespar::testing {

namespace {

VectorColumn columns_of(const std::vector<Vec3>& v) {
    return {{&v[0].x, 3}, {&v[0].y, 3}, {&v[0].z, 3}};
}

}  // namespace

BatchArrays::BatchArrays(const std::vector<InterfaceCase>& cases)
    : numbers_(5 * columns * cases.size(), std::numeric_limits<double>::quiet_NaN()),
      propagating_(std::make_unique<bool[]>(5 * cases.size())) {
    for (const InterfaceCase& c : cases) {
        from_.push_back(c.from);
        to_.push_back(c.to);
        normal_.push_back(c.normal);
        direction_.push_back(c.direction);
    }
    const std::size_t n = cases.size();
    faces = {n, {from_.data(), 1}, {to_.data(), 1}, columns_of(normal_), columns_of(direction_)};
    faces.mode = cases[0].mode;
    double* next = numbers_.data();
    const auto column = [&] {
        next += n;
        return ResultColumn{next - n};
    };
    const auto vector = [&] { return VectorResult{column(), column(), column()}; };
    bool* flags = propagating_.get();
    for (WaveColumns* w : {&wanted.incident, &wanted.reflected[0], &wanted.reflected[1],
                           &wanted.transmitted[0], &wanted.transmitted[1]}) {
        w->power = column();
        w->amplitude_real = column();
        w->amplitude_imag = column();
        w->n_phase = column();
        w->n_ray = column();
        w->ray = vector();
        for (ComplexResult* field : {&w->k, &w->E, &w->H}) *field = {vector(), vector()};
        w->propagating = flags;
        flags += n;
    }
}

void BatchArrays::solve(Lanes lanes) { solve_batch(faces, wanted, 0, faces.count, lanes); }

BatchArrays::Found BatchArrays::found(std::size_t wave, std::size_t i) const {
    const std::size_t n = faces.count;
    const double* at = numbers_.data() + wave * columns * n + i;
    const auto number = [&](std::size_t column) { return at[column * n]; };
    const auto vector = [&](std::size_t first) {
        return Vec3{number(first), number(first + 1), number(first + 2)};
    };
    const auto field = [&](std::size_t first) {
        return complexified(vector(first)) + Complex(0, 1) * complexified(vector(first + 3));
    };
    return {field(8),
            field(14),
            field(20),
            vector(5),
            {number(1), number(2)},
            number(0),
            number(3),
            number(4),
            propagating_[wave * n + i]};
}

}  // namespace icespar::testing
