// The Python module icespar._core: thin bindings, no logic of their own.
#include "bindings.hpp"
#include "math/error.hpp"

namespace icespar::python {

namespace {

/// `kinds`: NumPy's letters of the types that are welcome.
py::array numbers(const py::object& values, const char* argument, const char* kinds,
                  const char* wanted) {
    const py::array array = py::array::ensure(values);
    if (!array || std::string(kinds).find(array.dtype().kind()) == std::string::npos)
        throw py::value_error(std::string(argument) + ": " + wanted + " numbers are needed");
    return array;
}

}  // namespace

Doubles real_array(const py::object& values, const char* argument) {
    return numbers(values, argument, "iuf", "real");
}

py::array_t<Complex, py::array::c_style | py::array::forcecast> complex_array(
    const py::object& values, const char* argument) {
    return numbers(values, argument, "iufc", "real or complex");
}

std::string shape_of(const py::array& array) { return py::str(array.attr("shape")); }

std::vector<Vec3> rows(const Doubles& array, const char* argument) {
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw py::value_error(std::string(argument) + " must have the shape (N, 3)");
    const auto values = array.unchecked<2>();
    std::vector<Vec3> result(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
        result[static_cast<std::size_t>(i)] = {values(i, 0), values(i, 1), values(i, 2)};
    return result;
}

Vec3 vector(const py::object& values, const char* argument) {
    const Doubles array = real_array(values, argument);
    if (array.ndim() != 1 || array.shape(0) != 3)
        throw py::value_error(std::string(argument) + ": shape " + shape_of(array) +
                              " is not (3,)");
    return {array.at(0), array.at(1), array.at(2)};
}

Doubles array_of(const std::vector<Vec3>& rows) {
    Doubles result({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
    auto values = result.mutable_unchecked<2>();
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const auto i = static_cast<py::ssize_t>(row);
        values(i, 0) = rows[row].x;
        values(i, 1) = rows[row].y;
        values(i, 2) = rows[row].z;
    }
    return result;
}

}  // namespace icespar::python

PYBIND11_MODULE(_core, module) {
    namespace py = pybind11;
    module.doc() = "Bindings of the C++ library; the package icespar is the way in.";
    module.attr("__version__") = ICESPAR_VERSION;
    auto& error = py::register_exception<icespar::Error>(module, "Error", PyExc_ValueError);
    error.attr("__module__") = "icespar";
    error.attr("__doc__") = "A call that cannot be carried out; the message ends with the remedy.";
    icespar::python::bind_medium(module);
    icespar::python::bind_optics(module);
    icespar::python::bind_faces(module);
    icespar::python::bind_polarisation(module);
    icespar::python::bind_stone(module);
    icespar::python::bind_design(module);
    icespar::python::bind_light(module);
    icespar::python::bind_image(module);
    icespar::python::bind_scene(module);
    icespar::python::bind_view(module);
}
