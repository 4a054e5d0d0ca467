// Media, minerals, and the plane-wave boundary problem over arrays of rays.
#include <pybind11/stl.h>

#include <array>
#include <sstream>

#include "bindings.hpp"
#include "crystal/mineral.hpp"
#include "interface/interface.hpp"
#include "math/error.hpp"

namespace icespar::python {

namespace {

std::string repr(const Medium& m) {
    std::ostringstream text;
    if (!m.birefringent)
        text << "Medium.isotropic(" << m.n_o << ")";
    else
        text << "Medium.uniaxial(n_o=" << m.n_o << ", n_e=" << m.n_e << ", axis=(" << m.axis.x
             << ", " << m.axis.y << ", " << m.axis.z << "))";
    return text.str();
}

void put(py::ssize_t row, const CVec3& v, py::detail::unchecked_mutable_reference<Complex, 2>& to) {
    to(row, 0) = v.x;
    to(row, 1) = v.y;
    to(row, 2) = v.z;
}

/// One incident wave a ray.
struct Incident {
    explicit Incident(py::ssize_t n)
        : k({n, py::ssize_t{3}}),
          ray({n, py::ssize_t{3}}),
          E({n, py::ssize_t{3}}),
          H({n, py::ssize_t{3}}),
          n_phase(n),
          n_ray(n) {}

    Doubles k, ray;
    Complexes E, H;
    Doubles n_phase, n_ray;

    py::dict dict() const {
        return py::dict(py::arg("k") = k, py::arg("ray") = ray, py::arg("E") = E, py::arg("H") = H,
                        py::arg("n_phase") = n_phase, py::arg("n_ray") = n_ray);
    }
};

/// Both outgoing waves a ray, on one side of the face.
struct Outgoing {
    explicit Outgoing(py::ssize_t n)
        : k({n, py::ssize_t{2}, py::ssize_t{3}}),
          E({n, py::ssize_t{2}, py::ssize_t{3}}),
          H({n, py::ssize_t{2}, py::ssize_t{3}}),
          amplitude({n, py::ssize_t{2}}),
          ray({n, py::ssize_t{2}, py::ssize_t{3}}),
          power({n, py::ssize_t{2}}),
          n_phase({n, py::ssize_t{2}}),
          n_ray({n, py::ssize_t{2}}),
          propagating({n, py::ssize_t{2}}) {}

    Complexes k, E, H, amplitude;
    Doubles ray, power, n_phase, n_ray;
    py::array_t<bool> propagating;

    py::dict dict() const {
        return py::dict(py::arg("k") = k, py::arg("ray") = ray, py::arg("E") = E, py::arg("H") = H,
                        py::arg("amplitude") = amplitude, py::arg("power") = power,
                        py::arg("n_phase") = n_phase, py::arg("n_ray") = n_ray,
                        py::arg("propagating") = propagating);
    }
};

void put(py::ssize_t ray, const std::array<Wave, 2>& waves, const std::array<Complex, 2>& amplitude,
         const std::array<double, 2>& power, Outgoing& to) {
    for (py::ssize_t mode = 0; mode < 2; ++mode) {
        const Wave& wave = waves[static_cast<std::size_t>(mode)];
        const Complex k[3] = {wave.k.x, wave.k.y, wave.k.z}, E[3] = {wave.E.x, wave.E.y, wave.E.z},
                      H[3] = {wave.H.x, wave.H.y, wave.H.z};
        const double s[3] = {wave.ray.x, wave.ray.y, wave.ray.z};
        const py::ssize_t at = 2 * ray + mode;
        std::copy_n(k, 3, to.k.mutable_data() + 3 * at);
        std::copy_n(E, 3, to.E.mutable_data() + 3 * at);
        std::copy_n(H, 3, to.H.mutable_data() + 3 * at);
        std::copy_n(s, 3, to.ray.mutable_data() + 3 * at);
        to.amplitude.mutable_data()[at] = amplitude[static_cast<std::size_t>(mode)];
        to.power.mutable_data()[at] = power[static_cast<std::size_t>(mode)];
        to.n_phase.mutable_data()[at] = wave.n_phase;
        to.n_ray.mutable_data()[at] = wave.n_ray;
        to.propagating.mutable_data()[at] = wave.propagating;
    }
}

py::tuple solve_interface(const Medium& medium1, const Medium& medium2, const Doubles& normals,
                          const Doubles& directions, By by, Mode mode) {
    const std::vector<Vec3> n = rows(normals, "normal"), d = rows(directions, "direction");
    if (n.size() != d.size()) throw py::value_error("normal and direction differ in length");
    const auto count = static_cast<py::ssize_t>(n.size());
    Incident incident(count);
    Outgoing reflected(count), transmitted(count);
    {
        auto E = incident.E.mutable_unchecked<2>(), H = incident.H.mutable_unchecked<2>();
        double* const k = incident.k.mutable_data();
        double* const s = incident.ray.mutable_data();
        double* const n_phase = incident.n_phase.mutable_data();
        double* const n_ray = incident.n_ray.mutable_data();
        const py::gil_scoped_release unlocked;
        for (py::ssize_t i = 0; i < count; ++i) {
            const auto row = static_cast<std::size_t>(i);
            const Wave wave = plane_wave(medium1, mode, d[row], by, n[row]);
            constexpr double least_flux = 1e-140;
            if (!(wave.flux(n[row]) > least_flux))
                throw Error("direction[" + std::to_string(i) +
                            "]: the energy of this wave leaves the face or runs along it; it must "
                            "flow along the normal");
            const Interface face(medium1, medium2, n[row], wave);
            const OutgoingWaves waves = face.waves();
            const Coefficients c = face.solve(wave);
            const Vec3 wave_vector = real(wave.k);
            const double both[2][3] = {{wave_vector.x, wave_vector.y, wave_vector.z},
                                       {wave.ray.x, wave.ray.y, wave.ray.z}};
            std::copy_n(both[0], 3, k + 3 * i);
            std::copy_n(both[1], 3, s + 3 * i);
            put(i, wave.E, E);
            put(i, wave.H, H);
            n_phase[i] = wave.n_phase;
            n_ray[i] = wave.n_ray;
            put(i, waves.reflected, c.reflected, c.reflected_power, reflected);
            put(i, waves.transmitted, c.transmitted, c.transmitted_power, transmitted);
        }
    }
    return py::make_tuple(incident.dict(), reflected.dict(), transmitted.dict());
}

Medium medium_of(const Mineral& mineral, double wavelength_nm, const Doubles& axis) {
    if (mineral.indices.size() == 1) return Medium::isotropic(mineral.indices[0](wavelength_nm));
    if (mineral.indices.size() == 2)
        return Medium::uniaxial(mineral.indices[0](wavelength_nm),
                                mineral.indices[1](wavelength_nm), vector(axis, "axis"));
    throw Error("'" + mineral.id + "' is biaxial; choose an isotropic or uniaxial mineral");
}

Doubles indices_of(const Mineral& mineral, const Doubles& wavelength_nm) {
    std::vector<py::ssize_t> shape(wavelength_nm.shape(),
                                   wavelength_nm.shape() + wavelength_nm.ndim());
    shape.push_back(static_cast<py::ssize_t>(mineral.indices.size()));
    Doubles result(shape);
    double* out = result.mutable_data();
    for (py::ssize_t i = 0; i < wavelength_nm.size(); ++i)
        for (const IndexFunction& n : mineral.indices) *out++ = n(wavelength_nm.data()[i]);
    return result;
}

}  // namespace

void bind_optics(py::module_& module) {
    using namespace py::literals;
    py::enum_<By>(module, "By").value("wave_normal", By::wave_normal).value("ray", By::ray);
    py::enum_<Mode>(module, "Mode")
        .value("s", Mode::s)
        .value("p", Mode::p)
        .value("o", Mode::ordinary)
        .value("e", Mode::extraordinary);

    py::class_<Medium>(module, "Medium",
                       "A transparent medium at one wavelength: isotropic or uniaxial.\n\n"
                       "Indices are relative to vacuum. Make one with `isotropic` or `uniaxial`.")
        .def_static("isotropic", static_cast<Medium (*)(double)>(&Medium::isotropic), "n"_a,
                    "A medium with one index n > 0. ValueError when it is not positive and finite.")
        .def_static(
            "uniaxial",
            [](double n_o, double n_e, const Doubles& axis) {
                return Medium::uniaxial(n_o, n_e, vector(axis, "axis"));
            },
            "n_o"_a, "n_e"_a, "axis"_a,
            "A uniaxial crystal with optic axis `axis` (3,), of any length but 0.\n\n"
            "ValueError when an index is not positive and finite, or the axis is 0 or not finite.")
        .def_readonly("n_o", &Medium::n_o, "Ordinary index; the only one when isotropic.")
        .def_readonly("n_e", &Medium::n_e, "Principal extraordinary index; n_o when isotropic.")
        .def_property_readonly(
            "axis", [](const Medium& m) { return py::make_tuple(m.axis.x, m.axis.y, m.axis.z); },
            "Unit optic axis.")
        .def_readonly("birefringent", &Medium::birefringent, "True when the modes are o and e.")
        .def(
            "__eq__",
            [](const Medium& a, const Medium& b) {
                return a.n_o == b.n_o && a.n_e == b.n_e && a.birefringent == b.birefringent &&
                       (!a.birefringent || a.axis == b.axis);
            },
            py::is_operator())
        .def("__repr__", &repr);

    py::class_<Mineral>(module, "Mineral", "One row of the table of minerals.")
        .def_readonly("id", &Mineral::id, "As a scene names it.")
        .def_readonly("name", &Mineral::name)
        .def_readonly("formula", &Mineral::formula)
        .def_readonly("crystal_system", &Mineral::crystal_system)
        .def_readonly("optic", &Mineral::optic, "Such as 'isotropic', 'uniaxial +', 'biaxial -'.")
        .def_readonly("indices_589", &Mineral::indices_589,
                      "Published at 589.3 nm: [n], [n_o, n_e] or [n_alpha, n_beta, n_gamma].")
        .def_readonly("density", &Mineral::density, "g/cm3.")
        .def_readonly("confidence", &Mineral::confidence,
                      "A, B or C, as docs of the table explain.")
        .def("indices", &indices_of, "wavelength_nm"_a = 589.3,
             "Indices at wavelengths of any shape, in nm: shape + (1, 2 or 3).")
        .def("medium", &medium_of, "wavelength_nm"_a = 589.3,
             "axis"_a = std::vector<double>{0, 0, 1},
             "The medium at one wavelength. ValueError when the mineral is biaxial.")
        .def("__repr__",
             [](const Mineral& m) { return "<Mineral '" + m.id + "', " + m.optic + ">"; });

    module.def(
        "minerals",
        [] {
            py::list list;
            for (const Mineral& mineral : minerals())
                list.append(py::cast(&mineral, py::return_value_policy::reference));
            return list;
        },
        "All minerals, in the order of the table.");
    module.def("find_mineral", &find_mineral, "name"_a, py::return_value_policy::reference,
               "By id or name, whatever the case; None when there is none.");
    module.def(
        "solve_interface", &solve_interface, "medium1"_a, "medium2"_a, "normal"_a, "direction"_a,
        "by"_a, "mode"_a,
        "The boundary problem for unit (N, 3) normals and directions: incident, reflected and "
        "transmitted waves as dictionaries of arrays.");
}

}  // namespace icespar::python
