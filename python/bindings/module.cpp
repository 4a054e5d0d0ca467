// The Python module icespar._core: thin bindings, no logic of their own.
#include "bindings.hpp"
#include "math/error.hpp"

namespace icespar::python {

std::vector<Vec3> rows(const Doubles& array, const char* argument) {
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw py::value_error(std::string(argument) + " must have the shape (N, 3)");
    const auto values = array.unchecked<2>();
    std::vector<Vec3> result(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i)
        result[static_cast<std::size_t>(i)] = {values(i, 0), values(i, 1), values(i, 2)};
    return result;
}

Vec3 vector(const Doubles& array, const char* argument) {
    if (array.ndim() != 1 || array.shape(0) != 3)
        throw py::value_error(std::string(argument) + " must have three numbers");
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
    icespar::python::bind_optics(module);
    icespar::python::bind_stone(module);
    icespar::python::bind_image(module);
    icespar::python::bind_scene(module);
}
