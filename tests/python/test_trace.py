"""Given rays: energy, the frame of the receiver, bounds, and what is said about a wrong call."""

import numpy as np
import pytest

import icespar


def towards_the_box(n, seed=5):
    """Random rays from in front of the box to points in it."""
    rng = np.random.default_rng(seed)
    origins = rng.uniform([-2, -2, -8], [2, 2, -6], size=(n, 3))
    return origins, rng.uniform(-0.8, 0.8, size=(n, 3)) - origins


@pytest.mark.parametrize("scene", ["calcite_box", "glass_box"])
def test_in_a_furnace_a_stone_is_invisible_but_for_what_was_dropped(scene, request):
    origins, directions = towards_the_box(20)
    stokes, dropped = request.getfixturevalue(scene).trace(origins, directions, (1, 0, 0), threshold=1e-7, return_dropped=True)
    assert stokes.shape == (20, 4) and stokes.dtype == float
    assert dropped.shape == (20, 4) and (dropped[:, 0] > 0).all() and (dropped[:, 0] < 0.1).all()
    np.testing.assert_allclose(stokes + dropped, np.broadcast_to([1, 0, 0, 0], (20, 4)), atol=1e-12)


def test_light_off_a_level_face_is_polarised_along_the_horizon(glass_box):
    """Fresnel at 60 degrees; max_hits 1 leaves the outer reflection alone, so that only 1.5 counts."""
    cos_i, cos_t = 0.5, np.sqrt(1 - 0.75 / 2.25)
    r_s = ((cos_i - 1.5 * cos_t) / (cos_i + 1.5 * cos_t)) ** 2
    r_p = ((1.5 * cos_i - cos_t) / (1.5 * cos_i + cos_t)) ** 2
    direction = np.array([0, -0.5, np.sqrt(0.75)])
    up = np.array([0, np.sqrt(0.75), 0.5])
    right = np.array([1.0, 0, 0])
    for x_axis, s1, s2 in [(right, 1, 0), (up, -1, 0), (right + up, 0, -1), (right - up, 0, 1)]:
        stokes = glass_box.trace((0, 1, 0) - 5 * direction, direction, x_axis, max_hits=1)
        half = (r_s - r_p) / 2
        np.testing.assert_allclose(stokes, [[(r_s + r_p) / 2, s1 * half, s2 * half, 0]], atol=1e-14)


def test_the_world_is_the_scene_languages():
    scene = icespar.load("""
        environment { uniform illuminant "D65" 0 }
        camera { location <0, 0, -6> look_at <0, 0, 0> }
        box { <-1, -1, 4>, <1, 1, 5> pigment { rgb 1 } finish { emission 1 diffuse 0 } }
    """)
    seen = scene.trace((0, 0, 0), [(0, 0, 1), (0, 0, -1)], (1, 0, 0))
    assert seen[0, 0] == pytest.approx(1, rel=1e-3)
    assert seen[1, 0] == 0


def test_bounds_drop_what_they_say(calcite_box):
    origins, directions = towards_the_box(5)
    dropped = [calcite_box.trace(origins, directions, (1, 0, 0), max_hits=n, return_dropped=True)[1][:, 0] for n in (1, 2, 4, 8)]
    assert (np.diff(dropped, axis=0) <= 1e-15).all()
    assert (dropped[0] > 0.8).all()


def test_the_same_bits_for_any_number_of_threads(calcite_box):
    rays = towards_the_box(50)
    one = calcite_box.trace(*rays, (1, 0, 0), threshold=1e-5, threads=1)
    assert (one == calcite_box.trace(*rays, (1, 0, 0), threshold=1e-5, threads=2)).all()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"directions": [[0, 0, 1], [0, 0, 0]]}, r"directions\[1\] is zero"),
        ({"directions": (0, np.nan, 1)}, "directions is not finite"),
        ({"origins": [[0, 0, np.inf]]}, r"origins\[0\] is not finite"),
        ({"origins": np.zeros((2, 3)), "directions": np.ones((3, 3))}, "do not broadcast"),
        ({"origins": (0, 0)}, "origins"),
        ({"x_axis": (0, 0, -3)}, r"x_axis\[0\] is along its ray"),
        ({"wavelength_nm": 0}, "wavelength_nm"),
        ({"wavelength_nm": np.nan}, "wavelength_nm"),
        ({"max_hits": 0}, "max_hits"),
        ({"max_hits": 1.5}, "max_hits"),
        ({"threshold": -1}, "threshold"),
    ],
)
def test_a_wrong_call_is_told_which_argument_and_which_element(glass_box, change, message):
    call = {"origins": (0, 0, -5), "directions": (0, 0, 1), "x_axis": (1, 0, 0)}
    with pytest.raises(ValueError, match=message):
        glass_box.trace(**(call | change))
