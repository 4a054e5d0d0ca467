// Gives each result of a batch a column of its own.
#include "support/batch_arrays.hpp"

namespace icespar::testing {

namespace {

VectorColumn columns_of(const std::vector<Vec3>& v) {
    return {{&v[0].x, 3}, {&v[0].y, 3}, {&v[0].z, 3}};
}

}  // namespace

BatchArrays::BatchArrays(const std::vector<InterfaceCase>& cases)
    : numbers_((5 * columns + 2 * total_columns) * cases.size(),
               std::numeric_limits<double>::quiet_NaN()),
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
    for (TotalColumns* t : {&wanted.reflected_total, &wanted.transmitted_total}) {
        t->power = column();
        t->E = {vector(), vector()};
        t->H = {vector(), vector()};
    }
}

void BatchArrays::solve(Lanes lanes) { solve_batch(faces, wanted, 0, faces.count, lanes); }

void BatchArrays::solve_without_fields(Lanes lanes) {
    BatchResult fewer = wanted;
    for (WaveColumns* w : {&fewer.incident, &fewer.reflected[0], &fewer.reflected[1],
                           &fewer.transmitted[0], &fewer.transmitted[1]}) {
        w->E = w->H = {};
    }
    for (TotalColumns* t : {&fewer.reflected_total, &fewer.transmitted_total}) t->E = t->H = {};
    solve_batch(faces, fewer, 0, faces.count, lanes);
}

BatchArrays::Found BatchArrays::found(std::size_t wave, std::size_t i) const {
    const std::size_t n = faces.count;
    const double* at = numbers_.data() + wave * columns * n + i;
    return {field(at, 8),  field(at, 14),      field(at, 20),
            vector(at, 5), {at[n], at[2 * n]}, *at,
            at[3 * n],     at[4 * n],          propagating_[wave * n + i]};
}

BatchArrays::Total BatchArrays::total(bool transmitted, std::size_t i) const {
    const double* at =
        numbers_.data() + (5 * columns + (transmitted ? total_columns : 0)) * faces.count + i;
    return {*at, field(at, 1), field(at, 7)};
}

Vec3 BatchArrays::vector(const double* at, std::size_t first) const {
    const std::size_t n = faces.count;
    return {at[first * n], at[(first + 1) * n], at[(first + 2) * n]};
}

CVec3 BatchArrays::field(const double* at, std::size_t first) const {
    return complexified(vector(at, first)) + Complex(0, 1) * complexified(vector(at, first + 3));
}

}  // namespace icespar::testing
