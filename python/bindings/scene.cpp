// Scenes: reading, rendering, and tracing given rays.
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "bindings.hpp"
#include "math/error.hpp"
#include "parser/load.hpp"
#include "render/render.hpp"

namespace icespar::python {

namespace {

LoadOptions load_options(int width, int height, double clock,
                         std::vector<std::filesystem::path> allow) {
    LoadOptions options;
    options.width = width;
    options.height = height;
    options.clock = clock;
    options.allow = std::move(allow);
    return options;
}

py::tuple loaded(LoadResult result) {
    return py::make_tuple(std::move(result.scene), std::move(result.diagnostics));
}

py::tuple render_scene(const Scene& scene, const RenderOptions& options,
                       const py::object& progress) {
    std::optional<py::error_already_set> raised;
    // Between passes Python gets its turn: signals (Ctrl-C) first, then the caller's function.
    const auto callback = [&](const Progress& now) {
        const py::gil_scoped_acquire locked;
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (progress.is_none()) return true;
            const py::object answer = progress(now);
            return answer.is_none() || answer.cast<bool>();
        } catch (py::error_already_set& error) {
            raised.emplace(std::move(error));
            return false;
        }
    };
    Rendering rendering;
    {
        const py::gil_scoped_release unlocked;
        rendering = render(scene, options, callback);
    }
    if (raised) throw py::error_already_set(std::move(*raised));
    return py::make_tuple(std::move(rendering.image), rendering.report);
}

Forced forced(const std::vector<std::string>& full) {
    Forced parts;
    for (const std::string& name : full) parts.part(name) = true;
    return parts;
}

/// The world of a scene is left-handed, the core's is not.
Vec3 mirrored(const Vec3& v) { return {v.x, v.y, -v.z}; }

py::tuple trace_scene(const Scene& scene, const Doubles& origins, const Doubles& directions,
                      const Doubles& x_axes, const TraceOptions& options) {
    const std::vector<Vec3> o = rows(origins, "origins"), d = rows(directions, "directions"),
                            x = rows(x_axes, "x_axis");
    if (o.size() != d.size() || d.size() != x.size())
        throw py::value_error("origins, directions and x_axis differ in length");
    std::vector<SensorRay> rays(o.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        rays[i] = {mirrored(o[i]), mirrored(d[i]), mirrored(x[i])};
    Traced traced;
    {
        const py::gil_scoped_release unlocked;
        traced = trace(scene, rays, options);
    }
    const auto array = [](const std::vector<Stokes>& vectors) {
        Doubles out({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{4}});
        double* at = out.mutable_data();
        for (const Stokes& s : vectors)
            for (const double value : {s.s0, s.s1, s.s2, s.s3}) *at++ = value;
        return out;
    };
    return py::make_tuple(array(traced.stokes), array(traced.dropped));
}

}  // namespace

void bind_scene(py::module_& module) {
    using namespace py::literals;
    py::class_<Diagnostic>(module, "Diagnostic",
                           "One message about a scene; str() is what a user reads.")
        .def_property_readonly("severity",
                               [](const Diagnostic& d) {
                                   return d.severity == Diagnostic::Severity::error ? "error"
                                                                                    : "warning";
                               })
        .def_readonly("file", &Diagnostic::file)
        .def_readonly("line", &Diagnostic::line, "From 1; 0: about the whole file.")
        .def_readonly("column", &Diagnostic::column, "From 1.")
        .def_readonly("message", &Diagnostic::message)
        .def_readonly("hint", &Diagnostic::hint, "The likeliest repair; may be empty.")
        .def_property_readonly(
            "end", [](const Diagnostic& d) { return py::make_tuple(d.end_line, d.end_column); },
            "Line and column just after the last character.")
        .def_property_readonly("notes", &notes, "Includes and macros, the innermost first.")
        .def("__str__", [](const Diagnostic& d) { return to_string(d); })
        .def("__repr__", [](const Diagnostic& d) { return "<Diagnostic " + to_string(d) + ">"; });

    py::class_<Scene>(module, "Scene", "A scene's memory; `icespar.Scene` wraps it.")
        .def_readonly("title", &Scene::title)
        .def_property_readonly("gems", [](const Scene& s) { return s.gems.size(); })
        .def_property_readonly("things", [](const Scene& s) { return s.things.size(); })
        .def_property_readonly("lights", [](const Scene& s) { return s.lights.size(); });

    module.def(
        "load_file",
        [](const std::filesystem::path& file, int width, int height, double clock,
           std::vector<std::filesystem::path> allow) {
            return loaded(
                load_scene_file(file, load_options(width, height, clock, std::move(allow))));
        },
        "file"_a, "width"_a, "height"_a, "clock"_a, "allow"_a,
        "The scene or None, and the messages.");
    module.def(
        "load_text",
        [](const std::string& text, const std::string& name, const std::filesystem::path& folder,
           int width, int height, double clock, std::vector<std::filesystem::path> allow) {
            return loaded(load_scene_text(text, name, folder,
                                          load_options(width, height, clock, std::move(allow))));
        },
        "text"_a, "name"_a, "folder"_a, "width"_a, "height"_a, "clock"_a, "allow"_a,
        "The scene or None, and the messages.");

    module.def(
        "render",
        [](const Scene& scene, int width, int height, int samples, double error, double seconds,
           int threads, std::uint64_t seed, int bands, bool stokes, Engine engine,
           const std::vector<std::string>& full, ErrorMetric metric, const py::object& progress) {
            return render_scene(scene,
                                {width, height, samples, error, seconds, threads, seed, bands,
                                 stokes, engine, forced(full), metric},
                                progress);
        },
        "scene"_a, py::kw_only(), "width"_a, "height"_a, "samples"_a, "error"_a, "seconds"_a,
        "threads"_a, "seed"_a, "bands"_a, "stokes"_a, "engine"_a, "full"_a, "metric"_a,
        "progress"_a, "The image and the report.");
    module.def(
        "plan",
        [](const Scene& scene, bool stokes, Engine engine, const std::vector<std::string>& full) {
            const Needs needs = needs_of(scene, stokes, engine, forced(full));
            py::list lines;
            for (const PlanLine& l : plan(scene, needs))
                lines.append(py::make_tuple(l.subject, l.choice, l.reason));
            return py::make_tuple(lines, plan_warnings(scene), plan_text(scene, needs));
        },
        "scene"_a, py::kw_only(), "stokes"_a, "engine"_a, "full"_a,
        "Subject, choice and reason of each line; warnings; all of it as text.");
    module.def(
        "trace",
        [](const Scene& scene, const Doubles& origins, const Doubles& directions,
           const Doubles& x_axis, double wavelength_nm, int max_hits, double threshold,
           int threads) {
            return trace_scene(scene, origins, directions, x_axis,
                               {wavelength_nm, max_hits, threshold, threads});
        },
        "scene"_a, "origins"_a, "directions"_a, "x_axis"_a, py::kw_only(), "wavelength_nm"_a,
        "max_hits"_a, "threshold"_a, "threads"_a,
        "Stokes vectors (N, 4) and what was dropped (N, 4).");
}

}  // namespace icespar::python
