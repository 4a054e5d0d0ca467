"""Light at a face: closed forms, energy, shapes, and what is said about a wrong call."""

import numpy as np
import pytest

import icespar

AIR = icespar.Medium.isotropic(1.0)
GLASS = icespar.Medium.isotropic(1.5)
CALCITE = icespar.Medium.uniaxial(n_o=1.6584, n_e=1.4864, axis=(0, 0, 1))

TOPAZ = icespar.Medium.biaxial(n=(1.606, 1.609, 1.616), axes=((1, 0, 0), (0, 1, 0)))
QUARTZ = icespar.Medium.uniaxial(1.54421, 1.55331, axis=(0, 0, 1), rotation_deg_per_mm=21.75, wavelength_nm=589.3)
RUBY = icespar.Medium.uniaxial(1.768 + 3e-3j, 1.760 + 1e-3j, axis=(0, 0, 1))
TANZANITE = icespar.Medium.biaxial(n=(1.692 + 0.02j, 1.693 + 0.05j, 1.700 + 0.01j), axes=((1, 1, 0), (-1, 1, 1)))
MEDIA = [GLASS, CALCITE, TOPAZ, QUARTZ, RUBY, TANZANITE, icespar.Medium.isotropic(0.2 + 3.4j)]


def slanted(degrees):
    """Directions in the x z plane, (N, 3), at these angles from +z."""
    angle = np.radians(np.atleast_1d(degrees))
    return np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], axis=1)


def test_glass_reflects_as_fresnel_says():
    angle = np.linspace(0, 89, 90)
    cos_i = np.cos(np.radians(angle))
    cos_t = np.sqrt(1 - (np.sin(np.radians(angle)) / 1.5) ** 2)
    closed = {
        "s": ((cos_i - 1.5 * cos_t) / (cos_i + 1.5 * cos_t)) ** 2,
        "p": ((1.5 * cos_i - cos_t) / (1.5 * cos_i + cos_t)) ** 2,
    }
    for column, mode in enumerate("sp"):
        w = icespar.interface(AIR, GLASS, normal=(0, 0, 1), direction=slanted(angle), mode=mode)
        np.testing.assert_allclose(w.reflected.power[:, column], closed[mode], atol=1e-14)
        np.testing.assert_allclose(w.reflected.power[:, 1 - column], 0, atol=1e-28)
        np.testing.assert_allclose(w.transmitted.power[:, column], 1 - closed[mode], atol=1e-14)


@pytest.mark.parametrize("mode", ["o", "e"])
@pytest.mark.parametrize("by", ["wave_normal", "ray"])
def test_no_power_is_lost_between_two_crystals(mode, by):
    rng = np.random.default_rng(7)
    quartz = icespar.Medium.uniaxial(1.5442, 1.5533, axis=rng.normal(size=3))
    tilted = icespar.Medium.uniaxial(1.6584, 1.4864, axis=rng.normal(size=3))
    normal, direction = rng.normal(size=(2, 2000, 3))
    direction = np.where(np.sum(normal * direction, axis=1, keepdims=True) < 0, -direction, direction)
    cosine = np.sum(normal * direction, axis=1) / np.linalg.norm(normal, axis=1) / np.linalg.norm(direction, axis=1)
    keep = cosine > 0.2  # so that a wave's energy, up to 6 degrees off, also meets the face
    w = icespar.interface(tilted, quartz, normal=normal[keep], direction=direction[keep], by=by, mode=mode)
    total = w.reflected.power.sum(axis=1) + w.transmitted.power.sum(axis=1)
    np.testing.assert_allclose(total, 1, atol=1e-12)


def test_tangential_wave_vector_and_fields_are_continuous():
    normal = np.array([0.3, -0.2, 1.0]) / np.linalg.norm([0.3, -0.2, 1.0])
    w = icespar.interface(AIR, CALCITE, normal=normal, direction=slanted([0, 20, 70]), mode="p")

    def tangential(v):
        return v - (v @ normal)[..., None] * normal

    for side in (w.reflected, w.transmitted):
        np.testing.assert_allclose(tangential(side.k), np.broadcast_to(tangential(w.incident.k)[:, None], (3, 2, 3)), atol=1e-14)
    for field in "EH":
        before = getattr(w.incident, field) + np.sum(w.reflected.amplitude[..., None] * getattr(w.reflected, field), axis=1)
        after = np.sum(w.transmitted.amplitude[..., None] * getattr(w.transmitted, field), axis=1)
        np.testing.assert_allclose(tangential(before), tangential(after), atol=1e-13)


def test_the_extraordinary_ray_walks_off_by_at_most_6_26_degrees_in_calcite():
    w = icespar.interface(CALCITE, AIR, normal=(0, 0, 1), direction=slanted(np.linspace(0, 80, 801)), mode="e")
    cosine = np.sum(w.incident.ray * w.incident.k, axis=1) / w.incident.n_phase
    assert np.degrees(np.arccos(cosine)).max() == pytest.approx(6.26, abs=0.01)
    np.testing.assert_allclose(w.incident.n_ray, w.incident.n_phase * cosine, rtol=1e-14)


def test_a_ray_given_by_its_energy_direction_goes_there():
    direction = slanted([10, 40, 60])
    w = icespar.interface(CALCITE, AIR, normal=(0, 0, 1), direction=direction, by="ray", mode="e")
    np.testing.assert_allclose(w.incident.ray, direction, atol=1e-14)


def test_shapes_types_and_names_of_the_contract():
    w = icespar.interface(AIR, CALCITE, normal=(0, 0, 1), direction=slanted([10, 20, 30, 40, 50]), by="wave_normal", mode="s")
    for name, dtype in {"k": float, "ray": float, "E": complex, "H": complex}.items():
        assert getattr(w.incident, name).shape == (5, 3)
        assert getattr(w.incident, name).dtype == dtype
    assert w.incident.n_phase.shape == w.incident.n_ray.shape == (5,)
    for side, names in ((w.reflected, "sp"), (w.transmitted, "oe")):
        for name, dtype in {"k": complex, "ray": float, "E": complex, "H": complex}.items():
            assert getattr(side, name).shape == (5, 2, 3)
            assert getattr(side, name).dtype == dtype
        for name, dtype in {"amplitude": complex, "power": float, "n_phase": float, "n_ray": float, "propagating": bool}.items():
            assert getattr(side, name).shape == (5, 2)
            assert getattr(side, name).dtype == dtype
        assert side.mode.tolist() == [list(names)] * 5
    np.testing.assert_allclose(np.linalg.norm(w.transmitted.E, axis=-1), 1, rtol=1e-14)


def test_one_ray_is_an_array_of_one_and_either_argument_broadcasts():
    assert icespar.interface(AIR, GLASS, normal=(0, 0, 1), direction=(0, 0, 1), mode="s").reflected.power.shape == (1, 2)
    directions = slanted([0, 30, 60])
    one = icespar.interface(AIR, CALCITE, normal=[0, 0, 5], direction=directions, mode="p")
    many = icespar.interface(AIR, CALCITE, normal=[[0, 0, 1]] * 3, direction=1e-200 * directions, mode="p")
    np.testing.assert_allclose(one.transmitted.k, many.transmitted.k, rtol=1e-14)
    turned = icespar.interface(AIR, CALCITE, normal=directions, direction=(0, 0, 1), mode="p")
    assert turned.reflected.k.shape == (3, 2, 3)
    assert icespar.interface(AIR, GLASS, normal=(0, 0, 1), direction=np.zeros((0, 3)), mode="s").reflected.k.shape == (0, 2, 3)


def test_total_reflection_leaves_evanescent_waves_without_power():
    w = icespar.interface(GLASS, AIR, normal=(0, 0, 1), direction=slanted(60), mode="s")
    assert not w.transmitted.propagating.any()
    assert w.transmitted.power.tolist() == [[0, 0]]
    assert (w.transmitted.k[0, :, 2].imag > 0).all()
    assert w.reflected.power[0, 0] == pytest.approx(1, abs=1e-14)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"direction": (0, 0, 0)}, "direction is zero"),
        ({"direction": [[0, 0, 1], [0, np.nan, 1]]}, r"direction\[1\] is not finite"),
        ({"direction": [[0, 0, 1], [0, 0, -1]]}, r"direction\[1\].*leaves the face"),
        ({"direction": (1, 0, 0)}, r"direction.*leaves the face"),
        ({"direction": (1, 0)}, r"direction: shape \(2,\)"),
        ({"direction": [[0, 0, 1], [0, 1]]}, "direction"),
        ({"direction": (0, 0, 1j)}, "direction: real numbers"),
        ({"normal": np.zeros((4, 3))}, r"normal\[0\] is zero"),
        ({"normal": (0, 0, np.inf)}, "normal is not finite"),
        ({"normal": np.ones((2, 3)), "direction": np.ones((3, 3))}, "do not broadcast"),
        ({"mode": "o"}, "mode: 'o'.*isotropic"),
        ({"mode": "ordinary"}, "mode: 'ordinary'.*isotropic"),
        ({"mode": "q"}, "mode: 'q'"),
        ({"mode": None}, "mode"),
        ({"medium1": CALCITE, "mode": "s"}, "mode: 's'.*uniaxial"),
        ({"medium1": CALCITE, "mode": "fast"}, "mode: 'fast'.*uniaxial"),
        ({"medium1": TOPAZ, "mode": "e"}, "mode: 'e'.*biaxial.*'fast' and 'slow'"),
        ({"medium1": QUARTZ, "mode": "o"}, "mode: 'o'.*active"),
        ({"direction": np.broadcast_to([0.0, 0, 1], (10**12, 3))}, "direction: 10+ rays need .* GiB.*batches"),
        ({"by": "beam"}, "by: 'beam'"),
    ],
)
def test_a_wrong_call_is_told_which_argument_and_which_element(change, message):
    call = {"medium1": AIR, "medium2": GLASS, "normal": (0, 0, 1), "direction": (0, 0, 1), "mode": "s"}
    with pytest.raises(ValueError, match=message):
        icespar.interface(**(call | change))


def test_long_names_of_the_modes_are_understood():
    short = icespar.interface(CALCITE, AIR, normal=(0, 0, 1), direction=slanted(20), mode="e")
    long = icespar.interface(CALCITE, AIR, normal=(0, 0, 1), direction=slanted(20), mode="extraordinary")
    assert (short.reflected.power == long.reflected.power).all()
    assert short.incident.mode.tolist() == long.incident.mode.tolist() == ["e"]


@pytest.mark.parametrize("n", [0, -1.5, np.nan, np.inf])
def test_an_index_must_be_positive_and_finite(n):
    with pytest.raises(ValueError, match="^n must"):
        icespar.Medium.isotropic(n)
    with pytest.raises(ValueError, match="^n_o must"):
        icespar.Medium.uniaxial(n_o=n, n_e=1.5, axis=(0, 0, 1))
    with pytest.raises(ValueError, match="^n_e must"):
        icespar.Medium.uniaxial(n_o=1.5, n_e=n, axis=(0, 0, 1))
    with pytest.raises(ValueError, match=r"^n\[1\] must"):
        icespar.Medium.biaxial(n=(1.5, n, 1.6), axes=((1, 0, 0), (0, 1, 0)))


@pytest.mark.parametrize("axis", [(0, 0, 0), (np.nan, 0, 1), (0, 1)])
def test_an_axis_must_point_somewhere(axis):
    with pytest.raises(ValueError, match="axis"):
        icespar.Medium.uniaxial(n_o=1.6, n_e=1.5, axis=axis)


@pytest.mark.parametrize("medium2", MEDIA, ids=repr)
def test_every_medium_takes_what_is_not_reflected(medium2):
    rng = np.random.default_rng(5)
    normal, direction = rng.normal(size=(2, 300, 3))
    direction = np.where(np.sum(normal * direction, axis=1, keepdims=True) < 0, -direction, direction)
    for mode in "sp":
        w = icespar.interface(GLASS, medium2, normal, direction, mode=mode)
        np.testing.assert_allclose(w.reflected_total + w.transmitted_total, 1, atol=1e-11)
        if not medium2.absorbing:
            np.testing.assert_allclose(w.transmitted.power.sum(axis=1), w.transmitted_total, atol=1e-12)
        n = normal / np.linalg.norm(normal, axis=1, keepdims=True)
        for field in "EH":  # the summed fields continue the incident one
            step = getattr(w.incident, field) + getattr(w.reflected, field + "_total") - getattr(w.transmitted, field + "_total")
            np.testing.assert_allclose(np.cross(n, step), 0, atol=1e-10)


@pytest.mark.parametrize("medium1", [TOPAZ, QUARTZ], ids=["biaxial", "active"])
def test_fast_and_slow_waves_inside_keep_their_energy(medium1):
    direction = slanted(np.linspace(0, 85, 200))
    for mode in ("fast", "slow"):
        w = icespar.interface(medium1, AIR, normal=(0.1, 0.2, 1), direction=direction, mode=mode)
        np.testing.assert_allclose(w.reflected_total + w.transmitted_total, 1, atol=1e-11)
        assert set(w.incident.mode) == {mode} and w.reflected.mode[0].tolist() == ["fast", "slow"]
        assert (w.transmitted.power[~w.transmitted.propagating] == 0).all()


def test_a_homogeneous_wave_of_an_absorbing_medium_has_a_complex_wave_vector():
    w = icespar.interface(RUBY, AIR, normal=(0, 0, 1), direction=slanted([0, 10]), mode="o")
    np.testing.assert_allclose(w.incident.k, (1.768 + 3e-3j) * slanted([0, 10]), atol=1e-15)
    assert icespar.interface(CALCITE, AIR, (0, 0, 1), slanted(5), mode="o").incident.k.dtype == float


def many(count=20000):
    """Directions that meet a face along z."""
    rng = np.random.default_rng(3)
    d = rng.normal(size=(count, 3))
    d[:, 2] = np.abs(d[:, 2]) + 0.2
    return d


@pytest.mark.parametrize("medium", MEDIA[:4])
def test_arrays_asked_for_alone_are_what_they_are_among_all(medium):
    d = many(3000)
    every = icespar.interface(CALCITE, medium, (0, 0, 1), d, mode="e")
    some = icespar.interface(CALCITE, medium, (0, 0, 1), d, mode="e", only=("power", "ray", "total"))
    for a, b in ((every.reflected, some.reflected), (every.transmitted, some.transmitted)):
        np.testing.assert_allclose(b.power, a.power, atol=1e-13)
        np.testing.assert_allclose(b.total, a.total, atol=1e-13)
        np.testing.assert_allclose(b.ray, a.ray, atol=1e-11)
        assert b.k is None and b.E is None and b.E_total is None and b.n_ray is None
    assert some.incident.k is None and some.incident.ray.shape == (3000, 3)


def test_threads_change_no_bit():
    d = many()
    one = icespar.interface(AIR, CALCITE, (0, 0, 1), d, mode="p", threads=1)
    five = icespar.interface(AIR, CALCITE, (0, 0, 1), d, mode="p", threads=5)
    for name in ("k", "ray", "E", "H", "amplitude", "power", "E_total"):
        np.testing.assert_array_equal(getattr(one.transmitted, name), getattr(five.transmitted, name))


def test_single_precision_is_rounded_and_no_more():
    d = many()
    full = icespar.interface(AIR, CALCITE, (0, 0, 1), d, mode="p").transmitted
    single = icespar.interface(AIR, CALCITE, (0, 0, 1), d, mode="p", precision="single").transmitted
    rounding = np.finfo(np.float32).eps
    difference = np.abs(single.total - full.total)
    assert rounding / 100 < np.median(difference) < 8 * rounding
    np.testing.assert_allclose(single.ray, full.ray, atol=50 * rounding)


def test_an_error_names_the_first_ray_at_fault():
    d = many()
    d[[7000, 15000]] *= -1
    with pytest.raises(ValueError, match=r"direction\[7000\]"):
        icespar.interface(AIR, GLASS, (0, 0, 1), d, mode="s")


def test_unknown_arrays_and_threads_are_refused():
    with pytest.raises(ValueError, match="only: 'powers' is not an array of the answer"):
        icespar.interface(AIR, GLASS, (0, 0, 1), (0, 0, 1), mode="s", only={"powers"})
    with pytest.raises(ValueError, match="threads: 0"):
        icespar.interface(AIR, GLASS, (0, 0, 1), (0, 0, 1), mode="s", threads=0)
    with pytest.raises(ValueError, match="precision: .* not 'half'"):
        icespar.interface(AIR, GLASS, (0, 0, 1), (0, 0, 1), mode="s", precision="half")
