// Stones: from planes, points or a design, and what can be read off them as arrays.
#include "stone/stone.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "bindings.hpp"
#include "designs/design.hpp"
#include "math/error.hpp"

namespace icespar::python {

namespace {

Stone stone_from_planes(const Doubles& normals, const Doubles& distances,
                        const std::vector<std::string>& names) {
    const std::vector<Vec3> n = rows(normals, "normals");
    const bool one = distances.ndim() == 0;
    if (!one && (distances.ndim() != 1 || static_cast<std::size_t>(distances.shape(0)) != n.size()))
        throw py::value_error(
            "distances must be one number, or have the shape (N,) where normals has (N, 3)");
    if (!names.empty() && names.size() != n.size())
        throw py::value_error("names must have one name for each plane, or be empty");
    std::vector<FacetPlane> planes(n.size());
    for (std::size_t i = 0; i < n.size(); ++i)
        planes[i] = {n[i], distances.data()[one ? 0 : i], names.empty() ? std::string() : names[i]};
    const py::gil_scoped_release unlocked;
    return Stone::from_planes(planes);
}

Stone stone_from_points(const Doubles& points) {
    const std::vector<Vec3> p = rows(points, "points");
    const py::gil_scoped_release unlocked;
    return Stone::from_points(p);
}

template <class F>
Doubles per_facet(const Stone& stone, F&& number) {
    Doubles result(static_cast<py::ssize_t>(stone.facets.size()));
    std::transform(stone.facets.begin(), stone.facets.end(), result.mutable_data(), number);
    return result;
}

}  // namespace

void bind_stone(py::module_& module) {
    using namespace py::literals;
    py::class_<Stone>(
        module, "Stone",
        "A cut stone: a closed convex polyhedron of V vertices and F facets.\n\n"
        "Coordinates are right-handed. A design keeps GemCad's: the table up along +z, distances "
        "as in "
        "the file. Facets come in the order of the planes; planes that coincide are one facet.")
        .def_static(
            "from_design",
            [](const std::filesystem::path& path) {
                const py::gil_scoped_release unlocked;
                return Stone::from_planes(read_design(path).planes());
            },
            "path"_a,
            "A faceting design: .asc or .gem (GemCad), .gcs (Gem Cut Studio). Error with file and "
            "place.")
        .def_static(
            "from_planes", &stone_from_planes, "normals"_a, "distances"_a,
            "names"_a = std::vector<std::string>{},
            "The points with normals . p <= distances: normals (N, 3) outwards, of any length, "
            "distances (N,) or one number for all.\n\nError when a number is not finite, a normal "
            "is 0, nothing is "
            "enclosed, or the stone is open.")
        .def_static("from_points", &stone_from_points, "points"_a,
                    "The convex hull of points (N, 3). Error when they lie in one plane.")
        .def_readonly("volume", &Stone::volume)
        .def_property_readonly(
            "vertices", [](const Stone& s) { return array_of(s.vertices); }, "Corners, (V, 3).")
        .def_property_readonly(
            "normals",
            [](const Stone& s) {
                std::vector<Vec3> n;
                for (const Facet& facet : s.facets) n.push_back(facet.normal);
                return array_of(n);
            },
            "Unit normals of the facets, outwards, (F, 3).")
        .def_property_readonly(
            "distances",
            [](const Stone& s) { return per_facet(s, [](const Facet& f) { return f.distance; }); },
            "Distances of the facets' planes from the origin, (F,).")
        .def_property_readonly(
            "areas",
            [](const Stone& s) { return per_facet(s, [](const Facet& f) { return f.area; }); },
            "Areas of the facets, (F,).")
        .def_property_readonly(
            "names",
            [](const Stone& s) {
                std::vector<std::string> names;
                for (const Facet& facet : s.facets) names.push_back(facet.name);
                return names;
            },
            "Names of the facets; empty where the plane had none.")
        .def_property_readonly(
            "facets",
            [](const Stone& s) {
                py::list facets;
                for (const Facet& facet : s.facets)
                    facets.append(py::array_t<std::uint32_t>(
                        static_cast<py::ssize_t>(facet.corners.size()), facet.corners.data()));
                return facets;
            },
            "For each facet the indices of its vertices, counter-clockwise as seen from outside.")
        .def_readonly("unreached", &Stone::unreached,
                      "Names of planes that do not touch the stone.")
        .def_property_readonly(
            "size",
            [](const Stone& s) {
                const GirdleSize size = girdle_size(s);
                return py::make_tuple(size.length, size.width, size.height);
            },
            "Length, width and height: width is the least extent across z, length the extent at "
            "right "
            "angles to it, height the extent along z.")
        .def("__repr__", [](const Stone& s) {
            return "<Stone of " + std::to_string(s.facets.size()) + " facets, volume " +
                   std::string(py::str(py::float_(s.volume))) + ">";
        });
}

}  // namespace icespar::python
