// The algebra of Stokes, Mueller and Jones over arrays whose shapes the package has made equal.
#include <array>

#include "bindings.hpp"
#include "polarisation/mueller.hpp"

namespace icespar::python {

namespace {

using Row = py::array_t<Complex, py::array::c_style | py::array::forcecast>;

template <class>
using ArrayFor = const Doubles&;

void put(const Mueller& m, py::ssize_t at, Doubles& to) {
    double* const place = to.mutable_data() + 16 * at;
    for (std::size_t i = 0; i < 16; ++i) place[i] = m.m[i / 4][i % 4];
}

void put(const Jones& j, py::ssize_t at, Complexes& to) {
    Complex* const place = to.mutable_data() + 4 * at;
    for (std::size_t i = 0; i < 4; ++i) place[i] = j.m[i / 2][i % 2];
}

Mueller mueller_at(const Doubles& from, py::ssize_t at) {
    Mueller m;
    for (std::size_t i = 0; i < 16; ++i) m.m[i / 4][i % 4] = from.data()[16 * at + py::ssize_t(i)];
    return m;
}

Stokes stokes_at(const Doubles& from, py::ssize_t at) {
    const double* const s = from.data() + 4 * at;
    return {s[0], s[1], s[2], s[3]};
}

/// f of N numbers for each argument, as N numbers or N matrices.
template <class R, class... A>
auto of_numbers(R (*f)(A...)) {
    return [f](ArrayFor<A>... arguments) {
        const py::ssize_t n = std::get<0>(std::tie(arguments...)).size();
        if constexpr (std::is_same_v<R, double>) {
            Doubles out(n);
            for (py::ssize_t i = 0; i < n; ++i) out.mutable_data()[i] = f(arguments.data()[i]...);
            return out;
        } else if constexpr (std::is_same_v<R, Mueller>) {
            Doubles out({n, py::ssize_t{4}, py::ssize_t{4}});
            for (py::ssize_t i = 0; i < n; ++i) put(f(arguments.data()[i]...), i, out);
            return out;
        } else {
            Complexes out({n, py::ssize_t{2}, py::ssize_t{2}});
            for (py::ssize_t i = 0; i < n; ++i) put(f(arguments.data()[i]...), i, out);
            return out;
        }
    };
}

/// f of N Mueller matrices, or of N Stokes vectors, as N numbers.
template <class T>
auto measure(double (*f)(const T&)) {
    return [f](const Doubles& values) {
        Doubles out(values.shape(0));
        for (py::ssize_t i = 0; i < out.size(); ++i) {
            if constexpr (std::is_same_v<T, Mueller>)
                out.mutable_data()[i] = f(mueller_at(values, i));
            else
                out.mutable_data()[i] = f(stokes_at(values, i));
        }
        return out;
    };
}

Doubles stokes_of_fields(const Row& fields) {
    Doubles out({fields.shape(0), py::ssize_t{4}});
    for (py::ssize_t i = 0; i < fields.shape(0); ++i) {
        const Stokes s = stokes_from_field(fields.at(i, 0), fields.at(i, 1));
        std::copy_n(std::array{s.s0, s.s1, s.s2, s.s3}.data(), 4, out.mutable_data() + 4 * i);
    }
    return out;
}

Doubles mueller_of_jones(const Row& jones) {
    Doubles out({jones.shape(0), py::ssize_t{4}, py::ssize_t{4}});
    for (py::ssize_t i = 0; i < jones.shape(0); ++i) {
        const Jones j{
            {{{jones.at(i, 0, 0), jones.at(i, 0, 1)}, {jones.at(i, 1, 0), jones.at(i, 1, 1)}}}};
        put(mueller_from_jones(j), i, out);
    }
    return out;
}

Complexes jones_of_mueller(const Doubles& mueller) {
    Complexes out({mueller.shape(0), py::ssize_t{2}, py::ssize_t{2}});
    for (py::ssize_t i = 0; i < mueller.shape(0); ++i)
        put(jones_from_mueller(mueller_at(mueller, i)), i, out);
    return out;
}

Doubles mueller_of_waves(const Row& analyser, const Doubles& sent) {
    Doubles out({analyser.shape(0), py::ssize_t{4}, py::ssize_t{4}});
    for (py::ssize_t i = 0; i < analyser.shape(0); ++i)
        put(mueller_of_wave(analyser.at(i, 0), analyser.at(i, 1), stokes_at(sent, i)), i, out);
    return out;
}

}  // namespace

void bind_polarisation(py::module_& module) {
    using namespace py::literals;
    module.def("rotator", of_numbers(&rotator), "angle"_a);
    module.def("linear_retarder", of_numbers(&linear_retarder), "retardance"_a, "fast_axis"_a);
    module.def("circular_retarder", of_numbers(&circular_retarder), "retardance"_a);
    module.def("linear_diattenuator", of_numbers(&linear_diattenuator), "along"_a, "across"_a,
               "axis"_a);
    module.def(
        "circular_polariser",
        [](bool right) {
            Doubles out({4, 4});
            put(circular_polariser(right), 0, out);
            return out;
        },
        "right"_a);
    module.def("depolariser", of_numbers(&depolariser), "a1"_a, "a2"_a, "a3"_a);
    module.def("jones_rotator", of_numbers(&jones_rotator), "angle"_a);
    module.def("jones_linear_retarder", of_numbers(&jones_linear_retarder), "retardance"_a,
               "fast_axis"_a);
    module.def("jones_circular_retarder", of_numbers(&jones_circular_retarder), "retardance"_a);
    module.def("jones_diattenuator", of_numbers(&jones_diattenuator), "along"_a, "across"_a,
               "axis"_a);
    module.def("retardance", of_numbers(&retardance), "n_fast"_a, "n_slow"_a, "length_mm"_a,
               "wavelength_nm"_a);
    module.def("depolarisation_index", measure(&depolarisation_index), "mueller"_a);
    module.def("diattenuation", measure(&diattenuation), "mueller"_a);
    module.def("polarisance", measure(&polarisance), "mueller"_a);
    module.def("degree_of_polarisation", measure(&degree_of_polarisation), "stokes"_a);
    module.def("degree_of_linear_polarisation", measure(&degree_of_linear_polarisation),
               "stokes"_a);
    module.def("angle_of_polarisation", measure(&angle_of_polarisation), "stokes"_a);
    module.def("ellipticity", measure(&ellipticity), "stokes"_a);
    module.def("stokes_from_field", &stokes_of_fields, "field"_a);
    module.def("mueller_from_jones", &mueller_of_jones, "jones"_a);
    module.def("jones_from_mueller", &jones_of_mueller, "mueller"_a);
    module.def("mueller_of_wave", &mueller_of_waves, "analyser"_a, "out"_a);
}

}  // namespace icespar::python
