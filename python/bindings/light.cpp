// Spectra of lamps: the CIE's illuminants, and black bodies; the observer of the CIE.
#include <pybind11/stl.h>

#include <algorithm>
#include <string>

#include "bindings.hpp"
#include "spectrum/spectrum.hpp"

namespace icespar::python {

namespace {

Doubles sampled(const Spectrum& spectrum, const py::object& wavelength_nm) {
    const Doubles at = real_array(wavelength_nm, "wavelength_nm");
    Doubles values(std::vector<py::ssize_t>(at.shape(), at.shape() + at.ndim()));
    std::transform(at.data(), at.data() + at.size(), values.mutable_data(),
                   [&](double nm) { return spectrum(nm); });
    return values;
}

}  // namespace

void bind_light(py::module_& module) {
    using namespace py::literals;
    module.def(
        "illuminant",
        [](const std::string& name, const py::object& wavelength_nm) {
            return sampled(illuminant(name), wavelength_nm);
        },
        "name"_a, "wavelength_nm"_a,
        "Relative radiance of an illuminant of the CIE (015:2018) at wavelengths of any shape, in "
        "nm, as scenes name it.\n\nScaled to luminance 1: for the 2-degree observer each looks as "
        "bright as the light E, which is 1 throughout. Linear between the published nodes, 5 nm "
        "apart from 380 to 780 nm, constant beyond. Error for other names; `illuminants()` lists "
        "them.");
    module.def(
        "blackbody",
        [](double kelvin, const py::object& wavelength_nm) {
            return sampled(blackbody(kelvin), wavelength_nm);
        },
        "kelvin"_a, "wavelength_nm"_a,
        "Planck's law at wavelengths of any shape, in nm, scaled as `illuminant`; 500 to 50000 K.");
    module.def(
        "observer",
        [](const py::object& wavelength_nm) {
            const Doubles at = real_array(wavelength_nm, "wavelength_nm");
            std::vector<py::ssize_t> shape(at.shape(), at.shape() + at.ndim());
            shape.push_back(3);
            Doubles values(shape);
            for (py::ssize_t i = 0; i < at.size(); ++i) {
                const Xyz xyz = observer(at.data()[i]);
                std::copy(xyz.begin(), xyz.end(), values.mutable_data() + 3 * i);
            }
            return values;
        },
        "wavelength_nm"_a,
        "The 2-degree observer of the CIE (1931) at wavelengths of any shape, in nm: x, y and z "
        "along one more axis.\n\nScaled so that the light E of radiance 1 has luminance 1; "
        "0 outside 380 to 780 nm.");
    module.def(
        "illuminants",
        [] {
            std::vector<std::string> names;
            for (const std::string_view name : illuminant_names()) names.emplace_back(name);
            return names;
        },
        "Names of the illuminants that `illuminant` and scenes know.");
}

}  // namespace icespar::python
