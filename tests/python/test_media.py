"""Media by themselves: what they say of themselves, the waves they carry, and what is refused."""

import copy
import pickle

import numpy as np
import pytest

import icespar
from icespar import IndexFunction, Medium

X, Y, Z = np.eye(3)
CALCITE = Medium.uniaxial(n_o=1.6584, n_e=1.4864, axis=(0, 0, 1))
TOPAZ = Medium.biaxial(n=(1.606, 1.609, 1.616), axes=((1, 0, 0), (0, 1, 0)))
ARAGONITE = Medium.biaxial(n=(1.530, 1.680, 1.685), axes=(Z, X))
QUARTZ = Medium.uniaxial(1.54421, 1.55331, Z, rotation_deg_per_mm=21.75, wavelength_nm=589.3, g_ratio=-0.5)
CINNABAR = Medium.uniaxial(2.905, 3.256, Z, rotation_deg_per_mm=-325, wavelength_nm=600)
TOURMALINE = Medium.uniaxial(1.644 + 2e-3j, 1.624 + 1e-4j, (1, 1, 0))
TANZANITE = Medium.biaxial(n=(1.700 + 0.01j, 1.692 + 0.02j, 1.693 + 0.05j), axes=((1, 1, 0), (-1, 1, 1)))
SKEW = Medium.from_tensor([[2.5 + 0.1j, 0.05j, 0], [0.05j, 2.7 + 0.1j, 0.1], [0, 0.1, 3]])
ALL = [
    Medium.isotropic(1.0),
    Medium.isotropic(0.2 + 3.4j),
    CALCITE,
    TOPAZ,
    ARAGONITE,
    QUARTZ,
    CINNABAR,
    TOURMALINE,
    TANZANITE,
    SKEW,
]


@pytest.mark.parametrize("medium", ALL, ids=repr)
def test_a_medium_survives_pickling_and_its_repr_makes_it_again(medium):
    for again in (pickle.loads(pickle.dumps(medium)), copy.deepcopy(medium)):
        assert again == medium and hash(again) == hash(medium) and repr(again) == repr(medium)
    made = eval(repr(medium))
    np.testing.assert_allclose(made.permittivity, medium.permittivity, atol=1e-14)
    assert made.symmetry == medium.symmetry and made.gyration == medium.gyration
    assert [other for other in ALL if other == medium] == [medium]


def test_a_medium_says_what_it_is():
    assert CALCITE.birefringent and not ALL[0].birefringent
    assert (CALCITE.n_o, CALCITE.n_e, CALCITE.axis) == (1.6584, 1.4864, (0, 0, 1))
    assert CALCITE == Medium.uniaxial(n_o=1.6584, n_e=1.4864, axis=(0, 0, -2))
    assert CALCITE != Medium.uniaxial(n_o=1.6584, n_e=1.4864, axis=(0, 1, 0))
    assert Medium.uniaxial(1.5, 1.5, Z) != Medium.isotropic(1.5)  # o and e are not s and p
    assert [m.symmetry for m in (ALL[0], CALCITE, TOPAZ)] == ["isotropic", "uniaxial", "biaxial"]
    assert TOPAZ.axis is None and CALCITE.axes is None and TOPAZ.axes.tolist() == np.eye(3).tolist()
    assert ARAGONITE.n == (1.530, 1.680, 1.685)
    np.testing.assert_allclose(ARAGONITE.axes, [Z, X, Y], atol=1e-15)
    assert TANZANITE.n == pytest.approx((1.692 + 0.02j, 1.693 + 0.05j, 1.700 + 0.01j))
    assert (TANZANITE.absorbing, TANZANITE.active) == (True, False)
    assert (QUARTZ.absorbing, QUARTZ.active) == (False, True)
    assert QUARTZ.gyration == pytest.approx(21.75 / 360 * 589.3e-6)


def test_a_tensor_is_classified_and_keeps_its_numbers():
    turn = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
    for diagonal, symmetry in (((2, 2, 2), "isotropic"), ((2, 3, 2), "uniaxial"), ((2, 2.5, 3), "biaxial")):
        for loss in (0, 0.1j):
            eps = turn @ np.diag(np.array(diagonal) * (1 + loss)) @ turn.T
            medium = Medium.from_tensor(eps)
            assert (medium.symmetry, medium.absorbing) == (symmetry, loss != 0)
            np.testing.assert_allclose(medium.permittivity, eps, atol=1e-14)
            np.testing.assert_allclose(sorted(np.square(medium.n).real), sorted({*map(float, diagonal)}), atol=1e-14)


def test_the_angle_between_the_optic_axes_is_the_handbooks():
    # cos^2 Vz = na^2 (nc^2 - nb^2) / (nb^2 (nc^2 - na^2)); topaz 2Vz 66.7, aragonite 2Vx 18 degrees.
    for medium in (TOPAZ, ARAGONITE):
        a, b, c = np.square(medium.n)
        two_v = 2 * np.arccos(np.sqrt(a * (c - b) / (b * (c - a))))
        assert medium.two_v_gamma == pytest.approx(two_v, rel=1e-12)
        assert medium.two_v == pytest.approx(min(two_v, np.pi - two_v), rel=1e-12)
        assert np.arccos(medium.optic_axes[0] @ medium.optic_axes[1]) == pytest.approx(two_v)
        waves = medium.modes(medium.optic_axes)
        np.testing.assert_allclose(waves.n_phase, medium.n[1], rtol=1e-7)
    assert np.degrees(ARAGONITE.two_v) == pytest.approx(18, abs=1.5) and ARAGONITE.two_v_gamma > np.pi / 2
    assert CALCITE.optic_axes.tolist() == [[0, 0, 1]] and ALL[0].optic_axes.shape == (0, 3)
    with pytest.raises(ValueError, match="biaxial"):
        CALCITE.two_v  # noqa: B018


@pytest.mark.parametrize("medium", ALL, ids=repr)
def test_modes_solve_maxwells_equations(medium):
    d = np.random.default_rng(4).normal(size=(200, 3))
    w = medium.modes(d)
    assert w.k.shape == w.E.shape == w.D.shape == w.H.shape == w.ray.shape == (200, 2, 3)
    assert w.n_phase.shape == w.n_ray.shape == w.walk_off.shape == w.mode.shape == (200, 2)
    np.testing.assert_allclose(np.linalg.norm(w.E, axis=-1), 1, atol=1e-14)
    np.testing.assert_allclose(np.cross(d[:, None], w.k), 0, atol=1e-13)
    np.testing.assert_allclose(np.sum(w.k * w.D, axis=-1), 0, atol=1e-13)
    if not medium.active:
        np.testing.assert_allclose(np.cross(w.k, w.E), w.H, atol=1e-13)
        np.testing.assert_allclose(w.E @ medium.permittivity, w.D, atol=1e-12)
    flow = np.cross(w.E, w.H.conj()).real
    np.testing.assert_allclose(flow / np.linalg.norm(flow, axis=-1, keepdims=True), w.ray, atol=1e-13)
    np.testing.assert_allclose(w.n_ray, w.n_phase * np.cos(w.walk_off), rtol=1e-13)
    if w.mode[0, 0] == "fast":
        assert (np.diff(np.sum(w.k * w.k, axis=-1).real) >= 0).all()


@pytest.mark.parametrize("medium", [ALL[0], CALCITE, TOPAZ, ARAGONITE, QUARTZ, TOURMALINE], ids=repr)
def test_every_wave_of_a_ray_sends_its_energy_along_it(medium):
    d = np.random.default_rng(6).normal(size=(200, 3))
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    w = medium.modes(d, by="ray")
    np.testing.assert_allclose(w.ray, np.stack([d, d], axis=1), atol=1e-12)
    for column in range(2):  # the wave of that name along the wave normal found flows back along the ray
        k = w.k[:, column].real
        forward = medium.modes(k)
        place = (forward.mode == w.mode[:, column, None]).argmax(axis=1)
        np.testing.assert_allclose(forward.ray[range(200), place], d, atol=1e-8)


def test_a_ray_inside_the_cone_of_conical_refraction_has_two_slow_waves():
    strong = Medium.biaxial(n=(1.4, 1.7, 2.2), axes=(X, Y))
    axis = strong.optic_axes[0]
    rim = strong.modes(axis + 1e-6 * np.array([Y, -Y, X, -X])).ray.reshape(-1, 3)
    inside = rim.mean(axis=0)
    w = strong.modes(inside, by="ray")
    assert w.mode.tolist() == [["slow", "slow"]]
    assert np.linalg.norm(np.cross(w.k[0, 0].real, w.k[0, 1].real)) > 0.01


def test_light_along_the_axis_of_quartz_is_circular_and_turns():
    w = QUARTZ.modes((0, 0, 1))
    x, y = w.E[0, :, 0], w.E[0, :, 1]
    np.testing.assert_allclose(2 * (x * y.conj()).imag, [1, -1], atol=1e-12)  # right circular is the fast one
    turn = np.pi * (w.n_phase[0, 1] - w.n_phase[0, 0]) / 589.3e-6
    assert np.degrees(turn) == pytest.approx(21.75, rel=1e-9)


def test_calcite_walks_off_by_6_26_degrees():
    angle = np.linspace(0, np.pi, 2001)
    w = CALCITE.modes(np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1))
    assert np.degrees(w.walk_off[:, 1].max()) == pytest.approx(6.26, abs=0.01)
    np.testing.assert_allclose(w.walk_off[:, 0], 0, atol=1e-15)


def test_indices_follow_the_wavelength():
    glass = IndexFunction.sellmeier2([0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653])
    assert glass(587.56) == pytest.approx(1.5168, abs=1e-5) and isinstance(glass(587.56), float)
    assert glass([[400, 500, 600]]).shape == (1, 3)
    assert IndexFunction.sellmeier1([0, 0.3306, 0.175, 4.3356, 0.106])(589.3) == pytest.approx(2.4173, abs=1e-4)
    assert IndexFunction.formula4([5.913, 0.2441, 0, 0.0803, 1, 0, 0, 0, 1])(589.3) == pytest.approx(2.613, abs=1e-3)
    assert IndexFunction.cauchy(1.5, 0.004)(500) == pytest.approx(1.516) and IndexFunction(1.5)(700) == 1.5
    assert Medium.isotropic(glass(500)).n == (glass(500),)


def test_minerals_of_every_symmetry_give_media():
    assert icespar.mineral("calcite").medium(486.1, axis=X).n == tuple(icespar.mineral("calcite").indices(486.1))
    topaz = icespar.mineral("topaz").medium(589.3, axes=(Y, Z))
    np.testing.assert_allclose(topaz.axes, [Y, Z, X], atol=1e-15)
    np.testing.assert_allclose(topaz.n, icespar.mineral("topaz").indices_589, atol=2e-4)
    for mineral in icespar.minerals():
        assert mineral.optic.startswith(mineral.medium().symmetry)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Medium.isotropic(1.5 - 0.1j), "n must have a finite kappa >= 0"),
        (lambda: Medium.uniaxial(1.5, 1.6, (0, 0, 0)), "axis must be a finite vector that is not zero"),
        (lambda: Medium.uniaxial(1.5, 1.6, (0, 1)), r"axis: shape \(2,\) is not \(3,\)"),
        (lambda: Medium.uniaxial(1.5, 1.6, (0, 1j, 0)), "axis: real numbers"),
        (lambda: Medium.uniaxial(1.5, 1.6, Z, rotation_deg_per_mm=20), "give wavelength_nm"),
        (lambda: Medium.uniaxial(1.5, 1.6, Z, rotation_deg_per_mm=20, gyration=1e-5), "gyration and rotation"),
        (lambda: Medium.uniaxial(1.5 + 1j, 1.6, Z, gyration=1e-5), "n_o and n_e of an active crystal must be real"),
        (lambda: Medium.uniaxial(1.5, 1.6, Z, gyration=np.nan), "rotary power"),
        (lambda: Medium.uniaxial(1.5, 1.6, Z, gyration=2.0), "rotary power is too large"),
        (lambda: Medium.biaxial((1.5, 1.6), (X, Y)), "n: three principal indices"),
        (lambda: Medium.biaxial((1.5, 1.6, 1.7), X), r"axes: shape \(3,\) is not \(2, 3\)"),
        (lambda: Medium.biaxial((1.5, 1.6, 1.7), (X, X + Y)), r"axes\[0\] and axes\[1\] must be perpendicular"),
        (lambda: Medium.biaxial((1.5, 1.6, 1.7), (X, 0 * Y)), r"axes\[1\] must be a finite vector"),
        (lambda: Medium.biaxial(("a", 1.6, 1.7), (X, Y)), "n: real or complex numbers"),
        (lambda: Medium.from_tensor(np.eye(2)), r"eps: shape \(2, 2\) is not \(3, 3\)"),
        (lambda: Medium.from_tensor(np.eye(3) + np.triu(np.ones((3, 3)), 1)), r"eps\[1\]\[0\] and eps\[0\]\[1\] differ"),
        (lambda: Medium.from_tensor(np.diag([1, -1, 1])), "eps is not positive definite"),
        (lambda: Medium.from_tensor(np.diag([1, np.nan, 1])), r"eps\[1\]\[1\] is not finite"),
        (lambda: Medium.from_tensor(np.diag([1, 1 - 0.1j, 1])), "eps gives energy to light"),
        (lambda: CALCITE.modes((0, 0, 0)), "direction is zero"),
        (lambda: CALCITE.modes([X, [np.inf, 0, 0]]), r"direction\[1\] is not finite"),
        (lambda: CALCITE.modes([[1, 2]]), r"direction: shape \(1, 2\)"),
        (lambda: CALCITE.modes(X, by="beam"), "by: 'beam'"),
        (lambda: IndexFunction.sellmeier1([1, 2]), "odd number of coefficients"),
        (lambda: IndexFunction.cauchy(1.5, 0.004)([500, 0]), r"wavelength_nm\[1\] must be"),
        (lambda: IndexFunction.cauchy(1.5, 0.004)(np.nan), "wavelength_nm must be"),
        (lambda: IndexFunction.sellmeier2([0, -2, 0.01])(500), "wavelength_nm: the formula has no real index"),
        (lambda: icespar.mineral("topaz").medium(axis=Z), "axis: 'topaz' is biaxial"),
        (lambda: icespar.mineral("quartz").medium(axes=(X, Y)), "axes: 'quartz' is uniaxial"),
        (lambda: icespar.mineral("quartz").medium(-5), "wavelength_nm must be"),
    ],
)
def test_what_is_no_medium_is_refused_by_name(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_lamps_have_luminance_1_and_the_published_ratios():
    nm = np.arange(380, 781, 5.0)
    assert icespar.illuminant("E", 500.0) == 1 and icespar.illuminant("e", nm).tolist() == [1.0] * 81
    d65 = icespar.illuminant("D65", [560.0, 460.0])
    assert d65[1] / d65[0] == pytest.approx(1.178120, rel=1e-6)  # CIE 015:2018, table 5
    assert icespar.illuminant("F11", 545.0) > 1.5 * icespar.illuminant("FL11", 535.0)  # terbium's line
    assert icespar.blackbody(2856, [[700.0], [400.0]]).shape == (2, 1)
    assert "LED-B3" in icespar.illuminants() and all(icespar.illuminant(n, 555.0) > 0 for n in icespar.illuminants())
    with pytest.raises(icespar.Error, match="F1 to F12"):
        icespar.illuminant("F13", nm)
