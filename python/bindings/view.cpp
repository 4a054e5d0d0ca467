// Parallel views of stones: exits as arrays without a copy, and light return.
#include "views/view.hpp"

#include <pybind11/stl.h>

#include <optional>

#include "bindings.hpp"
#include "math/error.hpp"
#include "views/light_return.hpp"

namespace icespar::python {

namespace {

using namespace py::literals;

Exits traced(const Stone& stone, const Medium& medium, const py::object& direction,
             const py::object& up, const std::vector<double>& absorption, ViewOptions options) {
    const ParallelView view{vector(direction, "direction"), vector(up, "up")};
    bool raised = false;
    options.go_on = [&] {
        const py::gil_scoped_acquire locked;
        raised = PyErr_CheckSignals() != 0;
        return !raised;
    };
    std::vector<Absorption> colour;
    if (!absorption.empty()) colour.push_back(absorption_of(medium, absorption));
    Exits exits;
    {
        const py::gil_scoped_release unlocked;
        exits = trace_view(stone, medium, view, options, colour);
    }
    if (raised) throw py::error_already_set();
    return exits;
}

/// A read-only array over numbers that `owner` keeps.
template <class T>
py::array over(const T* first, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
               const py::object& owner) {
    py::array_t<T> array(std::move(shape), std::move(strides), first, owner);
    array.attr("setflags")("write"_a = false);
    return array;
}

template <class T>
auto column(std::vector<T> Exits::*member) {
    return [member](const py::object& self) {
        const auto& values = self.cast<const Exits&>().*member;
        return over(values.data(), {static_cast<py::ssize_t>(values.size())}, {sizeof(T)}, self);
    };
}

py::array direction_of(const py::object& self) {
    const auto& d = self.cast<const Exits&>().direction;
    return over(d.empty() ? nullptr : &d[0].x, {static_cast<py::ssize_t>(d.size()), 3},
                {sizeof(Vec3), sizeof(double)}, self);
}

py::array fan_of(const py::object& self) {
    const auto& f = self.cast<const Exits&>().fan;
    return over(f.empty() ? nullptr : &f[0].x, {static_cast<py::ssize_t>(f.size()), 3},
                {sizeof(Vec3), sizeof(double)}, self);
}

py::array turned_of(const py::object& self) {
    const auto& t = self.cast<const Exits&>().turned;
    return over(t.empty() ? nullptr : &t[0][0].x, {static_cast<py::ssize_t>(t.size()), 2, 3},
                {sizeof(t[0]), sizeof(Vec3), sizeof(double)}, self);
}

/// Symmetric, of real numbers.
RealTensor change_of(const py::array_t<double, py::array::c_style>& array) {
    if (array.ndim() != 2 || array.shape(0) != 3 || array.shape(1) != 3) {
        throw Error("fan: how the permittivity changes has shape (3, 3)");
    }
    const auto m = array.unchecked<2>();
    const RealTensor out{m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1)};
    if (!is_finite(Vec3{out.xx, out.yy, out.zz}) || !is_finite(Vec3{out.yz, out.xz, out.xy}) ||
        m(2, 1) != out.yz || m(2, 0) != out.xz || m(1, 0) != out.xy) {
        throw Error("fan: how the permittivity changes is finite and symmetric");
    }
    return out;
}

py::array_t<double> images_of(const Exits& exits) {
    py::array_t<double> out({exits.images.size(), std::size_t{2}, std::size_t{2}});
    auto m = out.mutable_unchecked<3>();
    for (py::ssize_t i = 0; i < m.shape(0); ++i) {
        const PictureImage& image = exits.images[static_cast<std::size_t>(i)];
        m(i, 0, 0) = image.right.x;
        m(i, 1, 0) = image.right.y;
        m(i, 0, 1) = image.up.x;
        m(i, 1, 1) = image.up.y;
    }
    return out;
}

py::array weight_of(const py::object& self) {
    const auto& w = self.cast<const Exits&>().weight;
    return over(w.empty() ? nullptr : &w[0].s0, {static_cast<py::ssize_t>(w.size()), 4},
                {sizeof(Stokes), sizeof(double)}, self);
}

py::tuple returned(const Exits& exits, Dome dome, const py::object& zenith, double head,
                   std::optional<int> facet) {
    const DomeLight light{dome, normalised(vector(zenith, "zenith")), head};
    const LightReturn out = light_return(exits, light, facet);
    return py::make_tuple(out.value, out.bound, out.error);
}

}  // namespace

void bind_view(py::module_& module) {
    py::enum_<Weights>(module, "Weights")
        .value("intensity", Weights::intensity)
        .value("stokes", Weights::stokes)
        .value("averaged", Weights::averaged);
    py::enum_<Dome>(module, "Dome")
        .value("iso", Dome::iso)
        .value("cosine", Dome::cosine)
        .value("sc2", Dome::sc2);
    py::class_<Exits>(module, "Exits")
        .def_property_readonly("direction", &direction_of)
        .def_property_readonly("fan", &fan_of)
        .def_property_readonly("turned", &turned_of)
        .def_property_readonly("images", &images_of)
        .def_property_readonly("weight", &weight_of)
        .def_property_readonly("area", column(&Exits::area))
        .def_property_readonly("entry", column(&Exits::entry))
        .def_property_readonly("facet", column(&Exits::facet))
        .def_property_readonly("hits", column(&Exits::hits))
        .def_property_readonly("group", column(&Exits::group))
        .def_property_readonly("entry_area", column(&Exits::entry_area))
        .def_property_readonly("entry_untraced", column(&Exits::entry_untraced))
        .def_readonly("area_total", &Exits::area_total)
        .def_readonly("untraced", &Exits::untraced)
        .def_readonly("residue", &Exits::residue)
        .def_readonly("groups", &Exits::groups)
        .def_readonly("cut", &Exits::cut)
        .def_readonly("absorbed", &Exits::absorbed)
        .def_readonly("beams", &Exits::beams)
        .def("expanded", [](const Exits& e) {
            const py::gil_scoped_release unlocked;
            return e.expanded();
        });
    module.def(
        "trace_view",
        [](const Stone& stone, const Medium& medium, const py::object& direction,
           const py::object& up, Weights weights, std::optional<double> bound, double error,
           std::uint64_t max_beams, double seconds, std::uint64_t seed, int max_hits,
           double least_power, const std::vector<double>& absorption,
           const std::optional<py::array_t<double, py::array::c_style>>& fan, bool turns,
           std::optional<int> error_of) {
            ViewOptions options;
            options.weights = weights;
            options.bound = bound;
            options.error = error;
            options.max_beams = max_beams;
            options.seconds = seconds;
            options.seed = seed;
            options.max_hits = max_hits;
            options.least_power = least_power;
            if (fan) options.fan = change_of(*fan);
            options.turns = turns;
            options.error_of = error_of;
            return traced(stone, medium, direction, up, absorption, std::move(options));
        },
        "stone"_a, "medium"_a, py::kw_only(), "direction"_a, "up"_a, "weights"_a, "bound"_a,
        "error"_a, "max_beams"_a, "seconds"_a, "seed"_a, "max_hits"_a, "least_power"_a,
        "absorption"_a, "fan"_a, "turns"_a, "error_of"_a);
    module.def("light_return", &returned, "exits"_a, "dome"_a, "zenith"_a, "head"_a, "facet"_a);
    module.def("table_facet", &table_facet, "stone"_a);
}

}  // namespace icespar::python
