// Faceting designs: read, written, looked into, and cut for another index.
#include "designs/design.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "bindings.hpp"
#include "designs/solved.hpp"
#include "math/error.hpp"

namespace icespar::python {

namespace {

Tier make_tier(double angle, double distance, const Doubles& indices,
               const std::vector<std::string>& names, std::string instructions) {
    if (indices.ndim() != 1 || indices.size() == 0)
        throw py::value_error("indices: a tier has one index or more, of shape (N,)");
    const auto count = static_cast<std::size_t>(indices.size());
    if (names.size() > 1 && names.size() != count)
        throw py::value_error("names must be one, or one for each index, or none");
    Tier tier{angle, distance, {}, std::move(instructions)};
    for (std::size_t i = 0; i < count; ++i)
        tier.cuts.push_back({indices.data()[i], names.empty()       ? std::string()
                                                : names.size() == 1 ? names[0]
                                                                    : names[i]});
    return tier;
}

Design retarget(const Design& design, double index, double from_index, double pavilion,
                double crown) {
    const double from = from_index > 0 ? from_index : design.refractive_index;
    if (!(from > 0)) throw Error("the design does not say for which index it is: give from_index");
    const py::gil_scoped_release unlocked;
    return retargeted(design, {from, index, pavilion, crown});
}

void bind_tier(py::module_& module) {
    using namespace py::literals;
    py::class_<Tier>(module, "Tier", "Facets cut at one angle and distance.")
        .def(py::init(&make_tier), "angle"_a, "distance"_a, "indices"_a,
             "names"_a = std::vector<std::string>{}, "instructions"_a = "")
        .def_readonly("angle", &Tier::angle,
                      "Degrees from the dop axis: 0 the table, 90 the girdle, negative on the "
                      "pavilion; -0.0 faces down.")
        .def_readonly("distance", &Tier::distance, "From the stone's centre, in design units.")
        .def_readonly("instructions", &Tier::instructions)
        .def_property_readonly(
            "indices",
            [](const Tier& tier) {
                Doubles out(static_cast<py::ssize_t>(tier.cuts.size()));
                std::transform(tier.cuts.begin(), tier.cuts.end(), out.mutable_data(),
                               [](const Tier::Cut& cut) { return cut.index; });
                return out;
            },
            "Places on the gear, (N,).")
        .def_property_readonly(
            "names",
            [](const Tier& tier) {
                std::vector<std::string> names;
                for (const Tier::Cut& cut : tier.cuts) names.push_back(cut.name);
                return names;
            },
            "Names of the facets, one an index; empty where the file gives none.")
        .def("__repr__", [](const Tier& tier) {
            return "<Tier of " + std::to_string(tier.cuts.size()) + " facets at " +
                   std::string(py::str(py::float_(tier.angle))) + " degrees>";
        });
}

}  // namespace

void bind_design(py::module_& module) {
    using namespace py::literals;
    bind_tier(module);
    py::class_<Design>(
        module, "Design",
        "A faceting design: tiers of facets on an index gear, as a cutter's file has it.")
        .def(py::init([](std::vector<Tier> tiers, double gear, double gear_offset, int symmetry,
                         bool mirror, double refractive_index, std::vector<std::string> headers,
                         std::vector<std::string> footnotes) {
                 return Design{std::move(tiers),
                               gear,
                               gear_offset,
                               symmetry,
                               mirror,
                               refractive_index,
                               std::move(headers),
                               std::move(footnotes),
                               {}};
             }),
             "tiers"_a, "gear"_a = 96.0, "gear_offset"_a = 0.0, "symmetry"_a = 1,
             "mirror"_a = false, "refractive_index"_a = 0.0,
             "headers"_a = std::vector<std::string>{}, "footnotes"_a = std::vector<std::string>{})
        .def_static(
            "read",
            [](const std::filesystem::path& path) {
                const py::gil_scoped_release unlocked;
                return read_design(path);
            },
            "path"_a,
            "A design by its file's ending: .asc and .gem (GemCad), .gcs (Gem Cut Studio). Error "
            "with the file and the place in it.")
        .def(
            "write",
            [](const Design& design, const std::filesystem::path& path) {
                const py::gil_scoped_release unlocked;
                return write_design(design, path);
            },
            "path"_a,
            "Writes .asc, .gem or .gcs, or the stone as .stl or .obj; returns what the format "
            "cannot hold, as sentences.")
        .def(
            "stone",
            [](const Design& design) {
                const py::gil_scoped_release unlocked;
                return Stone::from_planes(design.planes());
            },
            "The finished stone. Error that names open directions when the facets do not close.")
        .def("retarget", &retarget, "index"_a, "from_index"_a = 0.0, "pavilion"_a = 0.0,
             "crown"_a = 0.0,
             "The design for another refractive index, by tangent ratios. "
             "`from_index` 0: the file's. `pavilion`, `crown`: new angles of the pavilion's lowest "
             "and the crown's largest tier in degrees; 0: found from the indices.")
        .def_readonly("tiers", &Design::tiers)
        .def_readonly("gear", &Design::gear, "Teeth; a negative gear turns the other way.")
        .def_readonly("gear_offset", &Design::gear_offset)
        .def_readonly("symmetry", &Design::symmetry)
        .def_readonly("mirror", &Design::mirror)
        .def_readonly("refractive_index", &Design::refractive_index, "0: the file does not say.")
        .def_readonly("headers", &Design::headers)
        .def_readonly("footnotes", &Design::footnotes)
        .def_readonly("remarks", &Design::remarks,
                      "What the file holds and the design cannot keep.")
        .def_property_readonly(
            "facet_of",
            [](const Design& design) {
                const SolvedDesign solved(design);
                return py::array_t<int>(static_cast<py::ssize_t>(solved.facet_of.size()),
                                        solved.facet_of.data());
            },
            "For each cut, tier by tier, its facet of `stone()`; -1 where it does not reach.")
        .def("__repr__", [](const Design& design) {
            return "<Design of " + std::to_string(design.facet_count()) + " facets in " +
                   std::to_string(design.tiers.size()) + " tiers>";
        });
}

}  // namespace icespar::python
