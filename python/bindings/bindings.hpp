// What the files of the Python module share: array types and their shapes.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "math/vec3.hpp"

namespace icespar::python {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Complexes = py::array_t<Complex>;

/// Any array of real numbers, or of complex ones; ValueError with the argument's name for anything
/// else.
[[nodiscard]] Doubles real_array(const py::object& values, const char* argument);
[[nodiscard]] py::array_t<Complex, py::array::c_style | py::array::forcecast> complex_array(
    const py::object& values, const char* argument);
/// "(2, 3)".
[[nodiscard]] std::string shape_of(const py::array& array);

/// The rows of an (N, 3) array; ValueError with the argument's name for any other shape.
[[nodiscard]] std::vector<Vec3> rows(const Doubles& array, const char* argument);
/// The three numbers of a (3,) array, likewise.
[[nodiscard]] Vec3 vector(const py::object& values, const char* argument);
/// A new (N, 3) array.
[[nodiscard]] Doubles array_of(const std::vector<Vec3>& rows);

void bind_medium(py::module_& module);
void bind_optics(py::module_& module);
void bind_faces(py::module_& module);
void bind_polarisation(py::module_& module);
void bind_design(py::module_& module);
void bind_stone(py::module_& module);
void bind_scene(py::module_& module);
void bind_light(py::module_& module);
void bind_image(py::module_& module);
void bind_view(py::module_& module);

}  // namespace icespar::python
