// A finished picture as NumPy arrays that look into its own memory.
#include "image/image.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "bindings.hpp"
#include "render/render.hpp"

namespace icespar::python {

namespace {

using Shape = std::vector<py::ssize_t>;

/// An array over the image's memory, which keeps the image alive.
py::object view(const py::object& self, std::vector<float>& values, const Shape& shape) {
    if (values.empty()) return py::none();
    return py::array_t<float>(shape, values.data(), self);
}

template <class F>
auto viewed(F&& member_and_shape) {
    return [member_and_shape](const py::object& self) {
        return member_and_shape(self, self.cast<Image&>());
    };
}

}  // namespace

void bind_image(py::module_& module) {
    using namespace py::literals;
    py::class_<Image>(module, "Image", "A picture's memory; `icespar.Image` wraps it.")
        .def_readonly("width", &Image::width)
        .def_readonly("height", &Image::height)
        .def_property_readonly("rgb", viewed([](const py::object& self, Image& i) {
                                   return view(self, i.rgb, {i.height, i.width, 3});
                               }),
                               "Linear sRGB, (H, W, 3).")
        .def_property_readonly("rgb_stokes", viewed([](const py::object& self, Image& i) {
                                   return view(self, i.rgb_stokes, {i.height, i.width, 3, 3});
                               }),
                               "S1, S2, S3 of each colour, (H, W, colour, 3), or None.")
        .def_property_readonly("standard_error", viewed([](const py::object& self, Image& i) {
                                   return view(self, i.standard_error, {i.height, i.width});
                               }),
                               "Of the luminance, (H, W), or None.")
        .def_property_readonly(
            "spectral", viewed([](const py::object& self, Image& i) {
                return view(self, i.spectral,
                            {i.height, i.width, static_cast<py::ssize_t>(i.wavelengths_nm.size()),
                             i.spectral_components});
            }),
            "(H, W, bands, 1 or 4), or None.")
        .def_property_readonly(
            "wavelengths",
            [](const Image& i) {
                return Doubles(static_cast<py::ssize_t>(i.wavelengths_nm.size()),
                               i.wavelengths_nm.data());
            },
            "Centres of the bands in nm, (bands,).")
        .def_readwrite("metadata", &Image::metadata, "A copy of what is written beside the pixels.")
        .def(
            "write_exr",
            [](const Image& i, const std::filesystem::path& path) {
                const py::gil_scoped_release unlocked;
                write_exr(i, path.string());
            },
            "path"_a)
        .def(
            "write_png",
            [](const Image& i, const std::filesystem::path& path) {
                const py::gil_scoped_release unlocked;
                write_png(i, path.string());
            },
            "path"_a)
        .def("png_bytes", [](const Image& i) {
            const std::vector<unsigned char> bytes = png_bytes(i);
            return py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        });

    py::enum_<Engine>(module, "Engine", "What follows light through stones.")
        .value("automatic", Engine::automatic)
        .value("rays", Engine::rays)
        .value("beams", Engine::beams)
        .value("exact", Engine::exact);
    py::enum_<ErrorMetric>(module, "ErrorMetric", "What of the pixels' errors a picture's is.")
        .value("rms", ErrorMetric::rms)
        .value("max", ErrorMetric::largest);
    py::class_<RenderReport>(module, "RenderReport", "What a render did.")
        .def_readonly("samples", &RenderReport::samples, "A pixel.")
        .def_readonly("paths", &RenderReport::paths, "Camera paths.")
        .def_readonly("events", &RenderReport::events, "Interface events.")
        .def_readonly("seconds", &RenderReport::seconds)
        .def_readonly("error", &RenderReport::error,
                      "Estimated relative error of the picture, by the metric asked for.")
        .def_readonly("dropped", &RenderReport::dropped,
                      "Mean power of a camera path that a bound on depth gave up.")
        .def_readonly("bad_samples", &RenderReport::bad_samples, "NaN or infinite, left out.")
        .def_readonly("interrupted", &RenderReport::interrupted)
        .def_readonly("engine", &RenderReport::engine, "What made the picture.")
        .def("__repr__", [](const RenderReport& r) {
            return "<RenderReport: " + std::to_string(r.samples) + " samples a pixel in " +
                   std::to_string(r.seconds) + " s, error " + std::to_string(r.error) + ">";
        });
    py::class_<Progress>(module, "Progress", "How far a render is.")
        .def_readonly("done", &Progress::done, "0 to 1.")
        .def_readonly("seconds", &Progress::seconds, "Since the start.")
        .def_readonly("error", &Progress::error, "Estimate so far; 0 when not known yet.")
        .def_readonly("samples", &Progress::samples, "A pixel, finished.");
}

}  // namespace icespar::python
