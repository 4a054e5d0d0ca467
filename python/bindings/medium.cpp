// Media, functions of wavelength that give their indices, and the table of minerals.
#include "crystal/medium.hpp"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <array>
#include <numbers>
#include <optional>

#include "bindings.hpp"
#include "crystal/mineral_colour.hpp"
#include "math/error.hpp"

namespace icespar::python {

namespace {

using namespace py::literals;

constexpr const char* symmetries[] = {"isotropic", "uniaxial", "biaxial"};

py::tuple tuple_of(const Vec3& v) { return py::make_tuple(v.x, v.y, v.z); }

/// A float where there is no loss, else a complex number.
py::object index_of(const Complex& n) {
    return n.imag() == 0 ? py::object(py::float_(n.real())) : py::cast(n);
}

py::tuple indices_of(const Medium& m) {
    const Complex n_o(m.n_o, m.kappa_o), n_e(m.n_e, m.kappa_e);
    if (m.symmetry == Symmetry::isotropic) return py::make_tuple(index_of(n_o));
    if (m.symmetry == Symmetry::uniaxial) return py::make_tuple(index_of(n_o), index_of(n_e));
    const auto n = principal_indices(m);
    return py::make_tuple(index_of(n[0]), index_of(n[1]), index_of(n[2]));
}

py::object permittivity_of(const Medium& m) {
    const ComplexTensor t = m.permittivity();
    const Complex e[9] = {t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz};
    if (m.absorbing) {
        Complexes out({3, 3});
        std::copy_n(e, 9, out.mutable_data());
        return out;
    }
    Doubles out({3, 3});
    std::transform(e, e + 9, out.mutable_data(), [](const Complex& z) { return z.real(); });
    return out;
}

/// (0, 3) when isotropic, (1, 3) when uniaxial, (2, 3) when biaxial.
Doubles optic_axes_of(const Medium& m) {
    if (m.symmetry == Symmetry::isotropic) return array_of({});
    const OpticAxes axes = optic_axes(m);
    if (m.symmetry == Symmetry::uniaxial) return array_of({axes.first});
    return array_of({axes.first, axes.second});
}

double two_v_gamma(const Medium& m) {
    if (m.symmetry == Symmetry::biaxial) return optic_axes(m).two_v_gamma;
    throw Error(std::string("an ") + symmetries[static_cast<int>(m.symmetry)] +
                " medium has no angle 2V; a biaxial one has");
}

std::string repr(const Medium& m) {
    const auto text = [](const py::object& value) { return std::string(py::repr(value)); };
    const py::tuple n = indices_of(m);
    switch (m.symmetry) {
        case Symmetry::isotropic:
            return "Medium.isotropic(" + text(n[0]) + ")";
        case Symmetry::uniaxial: {
            std::string out = "Medium.uniaxial(n_o=" + text(n[0]) + ", n_e=" + text(n[1]) +
                              ", axis=" + text(tuple_of(m.axis));
            if (m.active())
                out += ", gyration=" + text(py::float_(m.gyration)) +
                       ", g_ratio=" + text(py::float_((m.gyration_along / m.gyration + 1) / 2));
            return out + ")";
        }
        case Symmetry::biaxial:
            break;
    }
    const ComplexTensor of_indices =
        Medium::biaxial(principal_indices(m), m.principal[0], m.principal[1]).permittivity();
    const ComplexTensor apart = m.permittivity() + Complex(-1) * of_indices;
    double largest = 0;
    for (const Complex& z : {apart.xx, apart.yy, apart.zz, apart.yz, apart.xz, apart.xy})
        largest = std::max(largest, std::abs(z));
    if (largest > 1e-12 * std::abs(m.mean))
        return "Medium.from_tensor(" + text(permittivity_of(m).attr("tolist")()) + ")";
    return "Medium.biaxial(n=" + text(n) + ", axes=(" + text(tuple_of(m.principal[0])) + ", " +
           text(tuple_of(m.principal[1])) + "))";
}

Medium uniaxial(Complex n_o, Complex n_e, const py::object& axis, double gyration,
                double rotation_deg_per_mm, std::optional<double> wavelength_nm, double g_ratio) {
    const Vec3 c = vector(axis, "axis");
    if (rotation_deg_per_mm == 0 && gyration == 0) return Medium::uniaxial(n_o, n_e, c);
    if (n_o.imag() != 0 || n_e.imag() != 0)
        throw Error("n_o and n_e of an active crystal must be real; leave absorption out");
    if (gyration != 0) {
        if (rotation_deg_per_mm != 0)
            throw Error("gyration and rotation_deg_per_mm say the same thing; give one of them");
        return Medium::gyrotropic(n_o.real(), n_e.real(), c, gyration,
                                  (2 * g_ratio - 1) * gyration);
    }
    if (!wavelength_nm)
        throw Error("rotation_deg_per_mm depends on the wavelength; give wavelength_nm with it");
    return Medium::active(n_o.real(), n_e.real(), c, rotation_deg_per_mm, *wavelength_nm, g_ratio);
}

Medium biaxial(const py::object& n, const py::object& axes) {
    const auto indices = complex_array(n, "n");
    if (indices.ndim() != 1 || indices.shape(0) != 3)
        throw py::value_error("n: three principal indices are needed, not shape " +
                              shape_of(indices));
    const Doubles two = real_array(axes, "axes");
    if (two.ndim() != 2 || two.shape(0) != 2 || two.shape(1) != 3)
        throw py::value_error("axes: shape " + shape_of(two) +
                              " is not (2, 3): the axes of n[0] and n[1]");
    const std::vector<Vec3> principal = rows(two, "axes");
    return Medium::biaxial({indices.at(0), indices.at(1), indices.at(2)}, principal[0],
                           principal[1]);
}

Medium from_tensor(const py::object& eps) {
    const auto values = complex_array(eps, "eps");
    if (values.ndim() != 2 || values.shape(0) != 3 || values.shape(1) != 3)
        throw py::value_error("eps: shape " + shape_of(values) + " is not (3, 3)");
    std::array<std::array<Complex, 3>, 3> tensor;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) tensor[i][j] = values.at(i, j);
    return Medium::from_tensor(tensor);
}

/// Every number of a medium, for pickles.
py::tuple state_of(const Medium& m) {
    const ComplexTensor& d = m.deviation;
    return py::make_tuple(
        static_cast<int>(m.symmetry), m.absorbing,
        std::array<double, 6>{m.n_o, m.n_e, m.kappa_o, m.kappa_e, m.gyration, m.gyration_along},
        std::array<double, 3>{m.axis.x, m.axis.y, m.axis.z}, m.mean,
        std::array<Complex, 6>{d.xx, d.yy, d.zz, d.yz, d.xz, d.xy}, m.n_principal,
        tuple_of(m.principal[0]), tuple_of(m.principal[1]), tuple_of(m.principal[2]));
}

Medium medium_of_state(const py::tuple& state) {
    const auto vector_at = [&](std::size_t i) {
        const auto v = state[i].cast<std::array<double, 3>>();
        return Vec3{v[0], v[1], v[2]};
    };
    Medium m;
    m.symmetry = static_cast<Symmetry>(state[0].cast<int>());
    m.birefringent = m.symmetry != Symmetry::isotropic;
    m.absorbing = state[1].cast<bool>();
    const auto n = state[2].cast<std::array<double, 6>>();
    m.n_o = n[0];
    m.n_e = n[1];
    m.kappa_o = n[2];
    m.kappa_e = n[3];
    m.gyration = n[4];
    m.gyration_along = n[5];
    m.axis = vector_at(3);
    m.mean = state[4].cast<Complex>();
    const auto d = state[5].cast<std::array<Complex, 6>>();
    m.deviation = {d[0], d[1], d[2], d[3], d[4], d[5]};
    m.n_principal = state[6].cast<std::array<double, 3>>();
    for (std::size_t i = 0; i < 3; ++i) m.principal[i] = vector_at(7 + i);
    return m;
}

/// Indices at wavelengths of any shape; ValueError for a wavelength that is none, and for one at
/// which a formula gives no real positive index.
Doubles evaluated(const std::vector<IndexFunction>& functions, const py::object& wavelength_nm) {
    const Doubles wavelengths = real_array(wavelength_nm, "wavelength_nm");
    std::vector<py::ssize_t> shape(wavelengths.shape(), wavelengths.shape() + wavelengths.ndim());
    shape.push_back(static_cast<py::ssize_t>(functions.size()));
    Doubles result(shape);
    double* out = result.mutable_data();
    for (py::ssize_t i = 0; i < wavelengths.size(); ++i) {
        const double l = wavelengths.data()[i];
        const std::string element =
            wavelengths.ndim() == 0 ? "wavelength_nm" : "wavelength_nm[" + std::to_string(i) + "]";
        if (!(l > 0) || !std::isfinite(l))
            throw Error(element + " must be a finite positive number");
        for (const IndexFunction& n : functions) {
            *out = n(l);
            if (!(*out > 0) || !std::isfinite(*out))
                throw Error(element +
                            ": the formula has no real index there; stay within the "
                            "range it was fitted to");
            ++out;
        }
    }
    return result;
}

std::vector<std::string> colours_of(const Mineral& mineral) {
    std::vector<std::string> names;
    for (const MineralColour& c : mineral_colours())
        if (c.mineral == mineral.id) names.push_back(c.name);
    return names;
}

Doubles absorption_of(const Mineral& mineral, const std::string& colour,
                      const py::object& wavelength_nm) {
    const MineralColour* found = find_colour(mineral, colour);
    if (!found)
        throw Error("'" + mineral.id + "' has no colour '" + colour + "'; .colours lists them");
    const Doubles wavelengths = real_array(wavelength_nm, "wavelength_nm");
    std::vector<py::ssize_t> shape(wavelengths.shape(), wavelengths.shape() + wavelengths.ndim());
    shape.push_back(static_cast<py::ssize_t>(found->absorption.size()));
    Doubles result(shape);
    double* out = result.mutable_data();
    for (py::ssize_t i = 0; i < wavelengths.size(); ++i)
        for (const Spectrum& s : found->absorption) *out++ = s(wavelengths.data()[i]);
    return result;
}

Medium medium_of(const Mineral& mineral, double wavelength_nm, const py::object& axis,
                 const py::object& axes) {
    const Doubles n = evaluated(mineral.indices, py::float_(wavelength_nm));
    const std::size_t kinds = mineral.indices.size();
    if (kinds == 1) return Medium::isotropic(n.data()[0]);
    if (kinds == 2) {
        if (!axes.is_none())
            throw Error("axes: '" + mineral.id + "' is uniaxial; give its axis as axis=(x, y, z)");
        const Vec3 c = axis.is_none() ? Vec3{0, 0, 1} : vector(axis, "axis");
        return Medium::uniaxial(n.data()[0], n.data()[1], c);
    }
    if (!axis.is_none())
        throw Error("axis: '" + mineral.id +
                    "' is biaxial; give the axes of n_alpha and n_beta as axes=(x', y')");
    return biaxial(n, axes.is_none()
                          ? py::object(py::make_tuple(tuple_of({1, 0, 0}), tuple_of({0, 1, 0})))
                          : axes);
}

void bind_class(py::module_& module) {
    py::class_<Medium>(
        module, "Medium",
        "A homogeneous medium at one wavelength: isotropic, uniaxial or biaxial.\n\n"
        "Indices are relative to vacuum, n + i kappa with kappa > 0 where it absorbs; any index "
        "above 0 is a medium (scenes want 1 and more for stones). Make one with `isotropic`, "
        "`uniaxial`, `biaxial` or `from_tensor`. It never changes, pickles, and equals another "
        "that has the same symmetry and the same numbers.")
        .def_static("isotropic", static_cast<Medium (*)(Complex)>(&Medium::isotropic), "n"_a,
                    "A medium with one index n > 0, or n + i kappa with kappa >= 0.\n\n"
                    "ValueError for any other or non-finite n.")
        .def_static(
            "uniaxial", &uniaxial, "n_o"_a, "n_e"_a, "axis"_a, py::kw_only(), "gyration"_a = 0.0,
            "rotation_deg_per_mm"_a = 0.0, "wavelength_nm"_a = py::none(), "g_ratio"_a = 0.0,
            "A uniaxial crystal with optic axis `axis` (3,), of any length but 0.\n\n"
            "Indices are real, or complex where it absorbs. n_e = n_o stays uniaxial. An optically "
            "active crystal (quartz, cinnabar) turns linear polarisation along its axis by "
            "`rotation_deg_per_mm` at `wavelength_nm`, positive: clockwise for the receiver; or "
            "give `gyration` = (n_L - n_R) / 2 along the axis, which is rotation x wavelength / "
            "360 degrees. `g_ratio` = G11 / G33 of the gyration tensor (quartz: about -0.5). Its "
            "modes are 'fast' and 'slow', it must be transparent.\n\n"
            "ValueError when an index is not positive and finite, or the axis is 0 or not finite.")
        .def_static(
            "biaxial", &biaxial, "n"_a, "axes"_a,
            "A biaxial crystal with principal indices n (3,), real or complex, in any order; "
            "`axes` (2, 3) are the principal axes of n[0] and n[1], n[2] lies along their vector "
            "product.\n\nValueError for an index that is not positive and finite, or axes that are "
            "not perpendicular within 1e-6.")
        .def_static(
            "from_tensor", &from_tensor, "eps"_a,
            "The medium of a relative dielectric tensor (3, 3), real or complex symmetric: "
            "isotropic, uniaxial or biaxial as it is, within rounding.\n\nValueError when it is "
            "not finite or symmetric, gives energy to light, or is not positive definite.")
        .def_property_readonly(
            "symmetry", [](const Medium& m) { return symmetries[static_cast<int>(m.symmetry)]; },
            "'isotropic', 'uniaxial' or 'biaxial'.")
        .def_property_readonly(
            "n", &indices_of,
            "Principal indices: (n,), (n_o, n_e) or rising (n_alpha, n_beta, "
            "n_gamma); complex where it absorbs. Of Re eps only where Re eps and "
            "Im eps have no common axes.")
        .def_property_readonly(
            "n_o",
            [](const Medium& m) {
                return index_of({m.n_o, m.kappa_o});
            },
            "n[0]: the ordinary index; n_alpha of a biaxial medium.")
        .def_property_readonly(
            "n_e",
            [](const Medium& m) {
                return index_of({m.n_e, m.kappa_e});
            },
            "n[-1]: the principal extraordinary index; n_o when isotropic, n_gamma when biaxial.")
        .def_property_readonly(
            "axis",
            [](const Medium& m) -> py::object {
                return m.symmetry == Symmetry::uniaxial ? py::object(tuple_of(m.axis)) : py::none();
            },
            "Unit optic axis of a uniaxial medium, else None.")
        .def_property_readonly(
            "axes",
            [](const Medium& m) -> py::object {
                if (m.symmetry != Symmetry::biaxial) return py::none();
                return array_of({m.principal.begin(), m.principal.end()});
            },
            "Unit principal axes (3, 3) of a biaxial medium, a row for each of n; else None.")
        .def_property_readonly("optic_axes", &optic_axes_of,
                               "Directions in which both waves have one index (binormals), unit: "
                               "(0, 3) isotropic, (1, 3) uniaxial, (2, 3) biaxial (of Re eps).")
        .def_property_readonly("two_v_gamma", &two_v_gamma,
                               "The angle between the optic axes that the axis of n_gamma halves, "
                               "0 .. pi; ValueError unless biaxial.")
        .def_property_readonly(
            "two_v",
            [](const Medium& m) {
                const double angle = two_v_gamma(m);
                return std::min(angle, std::numbers::pi - angle);
            },
            "2V, the acute angle between the optic axes, 0 .. pi/2; ValueError unless biaxial.")
        .def_property_readonly("permittivity", &permittivity_of,
                               "The relative dielectric tensor, (3, 3), complex where it absorbs.")
        .def_readonly("gyration", &Medium::gyration,
                      "(n_L - n_R) / 2 along the axis; 0 without optical activity.")
        .def_readonly("birefringent", &Medium::birefringent, "True unless isotropic.")
        .def_readonly("absorbing", &Medium::absorbing, "True when an index is complex.")
        .def_property_readonly(
            "active", [](const Medium& m) { return m.active(); },
            "True when it turns polarisations (optical activity).")
        .def(
            "__eq__", [](const Medium& a, const Medium& b) { return a == b; }, py::is_operator())
        .def("__hash__",
             [](const Medium& m) {
                 const Complex e = m.symmetry == Symmetry::biaxial ? m.mean : m.eps_o();
                 return py::hash(py::make_tuple(static_cast<int>(m.symmetry), e, m.gyration));
             })
        .def("__repr__", &repr)
        .def(py::pickle(&state_of, &medium_of_state));
}

void bind_index_functions(py::module_& module) {
    py::class_<IndexFunction>(
        module, "IndexFunction",
        "A refractive index as a function of the wavelength: call it with wavelengths in nm.\n\n"
        "`Medium.isotropic(n(589.3))` is the medium there. Coefficients are as published, for "
        "wavelengths in micrometres; the formulas are numbered as in refractiveindex.info.")
        .def(py::init<double>(), "constant"_a, "The same index everywhere.")
        .def_static("cauchy", &IndexFunction::cauchy, "a"_a, "b_um2"_a, "n = a + b / l^2.")
        .def_static("sellmeier1", &IndexFunction::sellmeier1, "coefficients"_a,
                    "Formula 1: n^2 - 1 = C1 + sum C_2k l^2 / (l^2 - C_2k+1^2).")
        .def_static("sellmeier2", &IndexFunction::sellmeier2, "coefficients"_a,
                    "Formula 2: n^2 - 1 = C1 + sum C_2k l^2 / (l^2 - C_2k+1).")
        .def_static("formula4", &IndexFunction::formula4, "coefficients"_a,
                    "Formula 4: n^2 = C1 + C2 l^C3 / (l^2 - C4^C5) + C6 l^C7 / (l^2 - C8^C9) + C10 "
                    "l^C11 + ...")
        .def(
            "__call__",
            [](const IndexFunction& n, const py::object& wavelength_nm) {
                const py::object values = evaluated({n}, wavelength_nm);
                // A float for one wavelength.
                return py::object(values[py::make_tuple(py::ellipsis(), 0)][py::make_tuple()]);
            },
            "wavelength_nm"_a,
            "The index at wavelengths of any shape, in nm. ValueError, which names the element, "
            "where the formula has no real positive index.");
}

void bind_minerals(py::module_& module) {
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
        .def_readonly("dispersion_bg", &Mineral::dispersion_bg,
                      "Published n(430.8 nm) - n(686.7 nm), in the order of the indices.")
        .def_readonly("pleochroism", &Mineral::pleochroism, "In words.")
        .def_readonly("rotation", &Mineral::rotation, "Optical activity, in words.")
        .def_readonly("source", &Mineral::source, "Where the indices come from.")
        .def_property_readonly("colours", &colours_of,
                               "The colours that a scene may ask for, as in docs/minerals.md.")
        .def("absorption", &absorption_of, "colour"_a, "wavelength_nm"_a,
             "What a colour takes, in 1/mm of intensity, polarised along each principal axis, at "
             "wavelengths of any shape, in nm: shape + (1, 2 or 3).")
        .def(
            "indices",
            [](const Mineral& m, const py::object& wavelength_nm) {
                return evaluated(m.indices, wavelength_nm);
            },
            "wavelength_nm"_a = 589.3,
            "Indices at wavelengths of any shape, in nm: shape + (1, 2 or 3).")
        .def("medium", &medium_of, "wavelength_nm"_a = 589.3, "axis"_a = py::none(),
             "axes"_a = py::none(),
             "The medium at one wavelength.\n\n`axis` is the optic axis of a uniaxial mineral, z "
             "unless given; `axes` (2, 3) the axes of n_alpha and n_beta of a biaxial one, x and y "
             "unless given. ValueError for the wrong one of the two; both mean nothing to an "
             "isotropic mineral.")
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
}

}  // namespace

void bind_medium(py::module_& module) {
    bind_class(module);
    bind_index_functions(module);
    bind_minerals(module);
}

}  // namespace icespar::python
