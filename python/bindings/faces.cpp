// The boundary problem over arrays of rays, shared out over threads.
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <set>
#include <thread>

#include "bindings.hpp"
#include "interface/batch.hpp"

namespace icespar::python {

namespace {

using Shape = std::vector<py::ssize_t>;

/// The arrays of a batch that were asked for, under their names. An array has a row for each ray.
class Results {
public:
    Results(std::size_t count, std::set<std::string> names)
        : count_(static_cast<py::ssize_t>(count)), names_(std::move(names)) {}

    /// The waves of a ray, `waves` of them (0: one, without an axis of its own).
    py::dict waves(const std::vector<WaveColumns*>& columns, py::ssize_t waves) {
        py::dict all;
        const auto each = [&](const char* name, auto type, py::ssize_t width, const auto& use) {
            using T = decltype(type);
            T* const data = array<T>(all, name, waves, width);
            if (!data) return;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                use(*columns[i], data + static_cast<py::ssize_t>(i) * width);
            }
        };
        const auto n = static_cast<py::ssize_t>(columns.size());
        each("k", Complex{}, 3, [&](WaveColumns& w, Complex* at) { w.k = vectors(at, n); });
        each("E", Complex{}, 3, [&](WaveColumns& w, Complex* at) { w.E = vectors(at, n); });
        each("H", Complex{}, 3, [&](WaveColumns& w, Complex* at) { w.H = vectors(at, n); });
        each("ray", double{}, 3, [&](WaveColumns& w, double* at) {
            w.ray = {{at, 3 * n}, {at + 1, 3 * n}, {at + 2, 3 * n}};
        });
        each("n_phase", double{}, 1, [&](WaveColumns& w, double* at) { w.n_phase = {at, n}; });
        each("n_ray", double{}, 1, [&](WaveColumns& w, double* at) { w.n_ray = {at, n}; });
        if (waves == 0) return all;
        each("power", double{}, 1, [&](WaveColumns& w, double* at) { w.power = {at, n}; });
        each("amplitude", Complex{}, 1, [&](WaveColumns& w, Complex* at) {
            double* const parts = reinterpret_cast<double*>(at);
            w.amplitude_real = {parts, 2 * n};
            w.amplitude_imag = {parts + 1, 2 * n};
        });
        each("propagating", bool{}, 1, [&](WaveColumns& w, bool* at) {
            w.propagating = at;
            w.propagating_stride = n;
        });
        return all;
    }

    /// Adds what both waves of a side add up to.
    void totals(TotalColumns& columns, py::dict& all) {
        if (double* const at = array<double>(all, "total", 0, 1)) columns.power = {at, 1};
        if (Complex* const at = array<Complex>(all, "E_total", 0, 3)) columns.E = vectors(at, 1);
        if (Complex* const at = array<Complex>(all, "H_total", 0, 3)) columns.H = vectors(at, 1);
    }

private:
    template <class T>
    T* array(py::dict& all, const char* name, py::ssize_t waves, py::ssize_t width) const {
        if (!names_.contains(name)) return nullptr;
        Shape shape{count_};
        if (waves > 0) shape.push_back(waves);
        if (width > 1) shape.push_back(width);
        py::array_t<T> result(shape);
        all[name] = result;
        return result.mutable_data();
    }

    /// Columns of complex vectors, every n-th one from `at`. A complex number is its two parts.
    static ComplexResult vectors(Complex* at, py::ssize_t n) {
        double* const parts = reinterpret_cast<double*>(at);
        const auto part = [&](py::ssize_t i) { return ResultColumn{parts + i, 6 * n}; };
        return {{part(0), part(2), part(4)}, {part(1), part(3), part(5)}};
    }

    py::ssize_t count_;
    std::set<std::string> names_;
};

/// Columns from row i on.
ResultColumn after(ResultColumn c, std::size_t i) {
    if (c.data) c.data += static_cast<std::ptrdiff_t>(i) * c.stride;
    return c;
}
VectorResult after(const VectorResult& v, std::size_t i) {
    return {after(v.x, i), after(v.y, i), after(v.z, i)};
}
ComplexResult after(const ComplexResult& v, std::size_t i) {
    return {after(v.real, i), after(v.imag, i)};
}
WaveColumns after(const WaveColumns& w, std::size_t i) {
    const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(i) * w.propagating_stride;
    return {after(w.power, i),
            after(w.amplitude_real, i),
            after(w.amplitude_imag, i),
            after(w.ray, i),
            after(w.k, i),
            after(w.E, i),
            after(w.H, i),
            after(w.n_phase, i),
            after(w.n_ray, i),
            w.propagating ? w.propagating + step : nullptr,
            w.propagating_stride};
}
TotalColumns after(const TotalColumns& t, std::size_t i) {
    return {after(t.power, i), after(t.E, i), after(t.H, i)};
}
BatchResult after(const BatchResult& r, std::size_t i) {
    return {after(r.incident, i),
            {after(r.reflected[0], i), after(r.reflected[1], i)},
            {after(r.transmitted[0], i), after(r.transmitted[1], i)},
            after(r.reflected_total, i),
            after(r.transmitted_total, i)};
}

/// Rows of (N, 3), or one for all, as unit vectors in columns, a share at a time.
class UnitColumns {
public:
    UnitColumns(const Doubles& rows, const char* name) : at_(rows.data()) {
        if (rows.ndim() != 2 || rows.shape(1) != 3) {
            throw py::value_error(std::string(name) + ": shape (N, 3) is needed");
        }
        count_ = static_cast<std::size_t>(rows.shape(0));
    }

    [[nodiscard]] std::size_t count() const { return count_; }

    [[nodiscard]] VectorColumn share(std::size_t first, std::size_t count,
                                     std::vector<double>& memory) const {
        const bool one = count_ == 1;
        const std::size_t n = one ? 1 : count;
        memory.resize(3 * n);
        double *const x = memory.data(), *const y = x + n, *const z = y + n;
        const double* v = at_ + (one ? 0 : 3 * first);
        for (std::size_t i = 0; i < n; ++i, v += 3) {
            const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            x[i] = v[0] / size;
            y[i] = v[1] / size;
            z[i] = v[2] / size;
        }
        const std::ptrdiff_t stride = one ? 0 : 1;
        return {{x, stride}, {y, stride}, {z, stride}};
    }

private:
    const double* at_;
    std::size_t count_;
};

/// Shares a batch out over threads; the error of the first ray at fault is thrown.
void solve_in_threads(const FaceBatch& faces, const UnitColumns& normals,
                      const UnitColumns& directions, const BatchResult& wanted,
                      std::size_t threads) {
    constexpr std::size_t share = 4096;
    const std::size_t shares = (faces.count + share - 1) / share;
    std::vector<std::exception_ptr> errors(shares);
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        std::vector<double> of_normal, of_direction;
        for (std::size_t i = next++; i < shares; i = next++) {
            try {
                FaceBatch part = faces;
                part.first = i * share;
                part.count = std::min(share, faces.count - part.first);
                part.normal = normals.share(part.first, part.count, of_normal);
                part.direction = directions.share(part.first, part.count, of_direction);
                solve_batch(part, after(wanted, part.first), 0, part.count);
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (std::size_t i = 1; i < std::min(threads, shares); ++i) helpers.emplace_back(work);
        work();
    }
    for (const std::exception_ptr& error : errors) {
        if (error) std::rethrow_exception(error);
    }
}

/// Whether all rows can be divided by their lengths: finite, with squares that neither overflow nor
/// vanish.
bool have_lengths(const Doubles& rows) {
    const double* v = rows.data();
    bool all = true;
    for (py::ssize_t i = 0; i < rows.size(); i += 3) {
        const double square = v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2];
        all = all && square > 1e-200 && square < 1e200;
    }
    return all;
}

py::tuple solve_interface(const Medium& medium1, const Medium& medium2, const Doubles& normals,
                          const Doubles& directions, By by, Mode mode, std::set<std::string> names,
                          std::size_t threads, bool single) {
    const UnitColumns n(normals, "normal"), d(directions, "direction");
    const std::size_t count = n.count() == 1 ? d.count() : n.count();
    if (d.count() != 1 && d.count() != count) {
        throw py::value_error("normal and direction differ in length");
    }
    FaceBatch faces;
    faces.count = count;
    faces.from = {&medium1};
    faces.to = {&medium2};
    faces.mode = mode;
    faces.by = by;
    if (single) faces.precision = Precision::single;
    Results results(faces.count, std::move(names));
    BatchResult wanted;
    py::dict incident = results.waves({&wanted.incident}, 0),
             reflected = results.waves({&wanted.reflected[0], &wanted.reflected[1]}, 2),
             transmitted = results.waves({&wanted.transmitted[0], &wanted.transmitted[1]}, 2);
    results.totals(wanted.reflected_total, reflected);
    results.totals(wanted.transmitted_total, transmitted);
    {
        const py::gil_scoped_release unlocked;
        solve_in_threads(faces, n, d, wanted, threads);
    }
    return py::make_tuple(incident, reflected, transmitted);
}

}  // namespace

void bind_faces(py::module_& module) {
    using namespace py::literals;
    module.def("solve_interface", &solve_interface, "medium1"_a, "medium2"_a, "normal"_a,
               "direction"_a, "by"_a, "mode"_a, "names"_a, "threads"_a, "single"_a,
               "The boundary problem for (N, 3) or (1, 3) normals and directions of any length: "
               "incident, reflected and transmitted waves as dictionaries of the arrays named.");
    module.def("have_lengths", &have_lengths, "rows"_a,
               "Whether all rows of (3,) or (N, 3) can be divided by their lengths.");
}

}  // namespace icespar::python
