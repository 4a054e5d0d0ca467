// Plane waves of media, and Mueller matrices of a face, over arrays of rays.
#include <array>

#include "bindings.hpp"
#include "interface/interface.hpp"
#include "interface/mueller_at_face.hpp"
#include "math/error.hpp"

namespace icespar::python {

namespace {

using Shape = std::vector<py::ssize_t>;

Shape with(Shape shape, py::ssize_t last) {
    shape.push_back(last);
    return shape;
}

void put(const CVec3& v, py::ssize_t at, Complexes& to) {
    Complex* const place = to.mutable_data() + 3 * at;
    place[0] = v.x;
    place[1] = v.y;
    place[2] = v.z;
}

void put(const Vec3& v, py::ssize_t at, Doubles& to) {
    double* const place = to.mutable_data() + 3 * at;
    place[0] = v.x;
    place[1] = v.y;
    place[2] = v.z;
}

/// Arrays of waves, of shape (N,) or (N, 2).
struct Waves {
    explicit Waves(const Shape& shape)
        : k(with(shape, 3)),
          E(with(shape, 3)),
          H(with(shape, 3)),
          ray(with(shape, 3)),
          n_phase(shape),
          n_ray(shape) {}

    Complexes k, E, H;
    Doubles ray, n_phase, n_ray;

    void put(const Wave& wave, py::ssize_t at) {
        python::put(wave.k, at, k);
        python::put(wave.E, at, E);
        python::put(wave.H, at, H);
        python::put(wave.ray, at, ray);
        n_phase.mutable_data()[at] = wave.n_phase;
        n_ray.mutable_data()[at] = wave.n_ray;
    }

    [[nodiscard]] py::dict dict() const {
        return py::dict(py::arg("k") = k, py::arg("ray") = ray, py::arg("E") = E, py::arg("H") = H,
                        py::arg("n_phase") = n_phase, py::arg("n_ray") = n_ray);
    }
};

/// Calls f(i) for each ray without the GIL; an error says at which direction.
template <class F>
void each_ray(std::size_t count, F&& f) {
    const py::gil_scoped_release unlocked;
    for (std::size_t i = 0; i < count; ++i) {
        try {
            f(i, static_cast<py::ssize_t>(i));
        } catch (const Error& error) {
            throw Error("direction[" + std::to_string(i) + "]: " + error.what());
        }
    }
}

/// The wave of each ray, which must carry energy through the face.
Wave arriving(const Medium& medium, Mode mode, const Vec3& direction, By by, const Vec3& normal) {
    const Wave wave = plane_wave(medium, mode, direction, by, normal);
    constexpr double least_flux = 1e-140;
    if (wave.flux(normal) > least_flux) return wave;
    throw Error(
        "the energy of this wave leaves the face or runs along it; it must flow along the normal");
}

py::dict waves_of(const Medium& medium, const Doubles& directions, By by) {
    const std::vector<Vec3> d = rows(directions, "direction");
    const auto count = static_cast<py::ssize_t>(d.size());
    Waves waves({count, 2});
    Complexes D(Shape{count, 2, 3});
    py::array_t<int> mode(Shape{count, 2});
    each_ray(d.size(), [&](std::size_t i, py::ssize_t ray) {
        const std::array<Wave, 2> both = waves_along(medium, d[i], by, d[i]);
        for (std::size_t m = 0; m < 2; ++m) {
            const py::ssize_t at = 2 * ray + static_cast<py::ssize_t>(m);
            waves.put(both[m], at);
            put(-cross(both[m].k, both[m].H), at, D);
            mode.mutable_data()[at] = static_cast<int>(mode_index(both[m].mode));
        }
    });
    py::dict all = waves.dict();
    all["D"] = D;
    all["mode"] = mode;
    return all;
}

void put(const Mueller& m, py::ssize_t at, Doubles& to) {
    double* const place = to.mutable_data() + 16 * at;
    for (std::size_t i = 0; i < 16; ++i) place[i] = m.m[i / 4][i % 4];
}

py::dict muellers_at_face(const Medium& medium1, const Medium& medium2, const Doubles& normals,
                          const Doubles& directions, By by, Mode mode) {
    const std::vector<Vec3> n = rows(normals, "normal"), d = rows(directions, "direction");
    if (n.size() != d.size()) throw py::value_error("normal and direction differ in length");
    const auto count = static_cast<py::ssize_t>(n.size());
    Doubles reflected(Shape{count, 2, 4, 4}), transmitted(Shape{count, 2, 4, 4});
    Doubles reflected_light(Shape{count, 4, 4}), transmitted_light(Shape{count, 4, 4});
    each_ray(n.size(), [&](std::size_t i, py::ssize_t ray) {
        const FaceMueller m =
            mueller_at_face(medium1, medium2, n[i], arriving(medium1, mode, d[i], by, n[i]));
        for (std::size_t wave = 0; wave < 2; ++wave) {
            put(m.reflected[wave], 2 * ray + static_cast<py::ssize_t>(wave), reflected);
            put(m.transmitted[wave], 2 * ray + static_cast<py::ssize_t>(wave), transmitted);
        }
        if (m.reflected_light) put(*m.reflected_light, ray, reflected_light);
        if (m.transmitted_light) put(*m.transmitted_light, ray, transmitted_light);
    });
    py::dict all(py::arg("reflected") = reflected, py::arg("transmitted") = transmitted,
                 py::arg("reflected_light") = py::none(),
                 py::arg("transmitted_light") = py::none());
    if (!medium1.birefringent) all["reflected_light"] = reflected_light;
    if (!medium2.birefringent) all["transmitted_light"] = transmitted_light;
    return all;
}

}  // namespace

void bind_optics(py::module_& module) {
    using namespace py::literals;
    py::enum_<By>(module, "By").value("wave_normal", By::wave_normal).value("ray", By::ray);
    py::enum_<Mode>(module, "Mode")
        .value("s", Mode::s)
        .value("p", Mode::p)
        .value("o", Mode::ordinary)
        .value("e", Mode::extraordinary)
        .value("fast", Mode::fast)
        .value("slow", Mode::slow);
    module.def("mueller_at_face", &muellers_at_face, "medium1"_a, "medium2"_a, "normal"_a,
               "direction"_a, "by"_a, "mode"_a,
               "Mueller matrices of the waves that leave, as a dictionary of arrays.");
    module.def("waves", &waves_of, "medium"_a, "direction"_a, "by"_a,
               "Both waves for each of the unit (N, 3) directions, as a dictionary of arrays; mode "
               "is the place in the medium's pair of names.");
}

}  // namespace icespar::python
