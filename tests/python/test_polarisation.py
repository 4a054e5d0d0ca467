"""Stokes, Mueller and Jones: closed forms, each ray of a face, and what is refused."""

import numpy as np
import pytest

import icespar
from icespar import polarisation as pol

AIR = icespar.Medium.isotropic(1.0)
GLASS = icespar.Medium.isotropic(1.5)
CALCITE = icespar.Medium.uniaxial(n_o=1.6584, n_e=1.4864, axis=(0.6, 0.64, 0.48))
TOPAZ = icespar.Medium.biaxial(n=(1.606, 1.609, 1.616), axes=((1, 2, 0), (-2, 1, 1)))
ANGLES = np.linspace(-3, 3, 13)


def beams(degrees, azimuth=0.3):
    angle = np.radians(np.atleast_1d(degrees))
    return np.stack([np.sin(angle) * np.cos(azimuth), np.sin(angle) * np.sin(azimuth), np.cos(angle)], axis=1)


def test_a_quarter_wave_plate_makes_45_degree_light_left_circular():
    np.testing.assert_allclose(pol.linear_retarder(np.pi / 2) @ [1, 0, 1, 0], [1, 0, 0, -1], atol=1e-15)
    np.testing.assert_allclose(pol.stokes_from_field([1, -1j]) / 2, [1, 0, 0, 1], atol=1e-15)


def test_polarisers_follow_malus():
    through = pol.linear_polariser(ANGLES) @ [1, 1, 0, 0]
    np.testing.assert_allclose(through[:, 0], np.cos(ANGLES) ** 2, atol=1e-15)
    assert (pol.circular_polariser("left") @ [1, 0, 0, 1]).tolist() == [0, 0, 0, 0]


def test_a_plate_between_crossed_polarisers():
    phase = pol.retardance(1.5442, 1.5533, np.array([[0.01], [0.03]]), 589.3)
    seen = pol.linear_polariser(np.pi / 2) @ pol.linear_retarder(phase, ANGLES) @ [1, 1, 0, 0]
    np.testing.assert_allclose(seen[..., 0], (np.sin(2 * ANGLES) * np.sin(phase / 2)) ** 2, atol=1e-14)


def test_a_rotator_turns_and_a_circular_retarder_turns_back_by_half():
    out = pol.rotator(0.3) @ [1, 1, 0, 0]
    assert pol.angle_of_polarisation(out) == pytest.approx(0.3)
    np.testing.assert_allclose(pol.circular_retarder(0.6) @ out, [1, 1, 0, 0], atol=1e-15)
    quartz_1mm = pol.retardance(1.0, 1.0 + 2 * 21.75 / 360 * 589.3e-6, 1, 589.3)
    assert np.degrees(quartz_1mm / 2) == pytest.approx(21.75)


def test_mueller_matrices_follow_from_jones_matrices():
    pairs = [
        (pol.jones_rotator(ANGLES), pol.rotator(ANGLES)),
        (pol.jones_linear_retarder(1.1, ANGLES), pol.linear_retarder(1.1, ANGLES)),
        (pol.jones_circular_retarder(ANGLES), pol.circular_retarder(ANGLES)),
        (pol.jones_polariser(ANGLES), pol.linear_polariser(ANGLES)),
        (pol.jones_diattenuator(0.9, 0.4, ANGLES), pol.linear_diattenuator(0.81, 0.16, ANGLES)),
    ]
    for jones, mueller in pairs:
        np.testing.assert_allclose(pol.mueller_from_jones(jones), mueller, atol=1e-15)
        np.testing.assert_allclose(pol.mueller_from_jones(pol.jones_from_mueller(mueller)), mueller, atol=1e-12)
        np.testing.assert_allclose(pol.depolarisation_index(mueller), 1, atol=1e-12)
    field = np.array([0.3 - 0.8j, 0.9 + 0.2j])
    jones, mueller = pairs[1]
    np.testing.assert_allclose(pol.stokes_from_field(jones @ field), mueller @ pol.stokes_from_field(field), atol=1e-14)
    np.testing.assert_allclose(pol.turned(pol.linear_retarder(1.1), ANGLES), mueller, atol=1e-15)
    np.testing.assert_allclose(pol.turned(pol.jones_polariser(), 0.7), pol.jones_polariser(0.7), atol=1e-15)


def test_measures_of_light_and_of_elements():
    psi, chi, p = 0.4, -0.2, 0.7
    s = np.array([1, p * np.cos(2 * chi) * np.cos(2 * psi), p * np.cos(2 * chi) * np.sin(2 * psi), p * np.sin(2 * chi)])
    light = 3 * np.stack([s, s])
    np.testing.assert_allclose(pol.degree_of_polarisation(light), p)
    np.testing.assert_allclose(pol.degree_of_linear_polarisation(light), p * np.cos(2 * chi))
    np.testing.assert_allclose(pol.angle_of_polarisation(light), psi)
    np.testing.assert_allclose(pol.ellipticity(light), np.tan(chi))
    assert pol.degree_of_polarisation([0, 0, 0, 0]) == 0
    partial = pol.linear_diattenuator(0.8, 0.2, 0.5)
    assert pol.diattenuation(partial) == pytest.approx(0.6) and pol.polarisance(partial) == pytest.approx(0.6)
    after = pol.depolariser(0.5) @ partial
    assert pol.polarisance(after) == pytest.approx(0.3) and pol.diattenuation(after) == pytest.approx(0.6)
    assert pol.depolarisation_index(pol.depolariser(0.9, 0.5, 0.5)) == pytest.approx(np.sqrt((0.81 + 0.5) / 3))
    assert pol.depolarisation_index(pol.depolariser(0)) == 0


def test_the_phase_of_a_path_is_that_of_its_steps():
    w = CALCITE.modes((0, 0, 1))
    o, e = w.k[0].real
    whole = pol.path_retardance(e, o, (0, 0, 2), 589.3)
    assert whole == pytest.approx(pol.retardance(w.n_phase[0, 1], w.n_phase[0, 0], 2, 589.3), rel=1e-12)
    steps = [[0.5, 0.1, 0.5], [-0.5, -0.1, 1.5]]
    assert pol.path_retardance(e, o, steps, 589.3) == pytest.approx(whole, rel=1e-10)
    assert pol.path_retardance(e, o, steps, [589.3, 500]).shape == (2,)


def test_glass_has_fresnels_mueller_matrix():
    angle = np.linspace(0, 89, 30)
    i = np.radians(angle)
    t = np.arcsin(np.sin(i) / 1.5)
    rs = (np.cos(i) - 1.5 * np.cos(t)) / (np.cos(i) + 1.5 * np.cos(t))
    rp = (1.5 * np.cos(i) - np.cos(t)) / (1.5 * np.cos(i) + np.cos(t))
    m = pol.mueller_at_face(AIR, GLASS, (0, 0, 1), beams(angle))
    assert m.reflected.shape == m.transmitted.shape == (30, 2, 4, 4)
    jones = np.zeros((30, 2, 2))
    jones[:, 0, 0], jones[:, 1, 1] = rs, rp
    np.testing.assert_allclose(m.reflected_light, pol.mueller_from_jones(jones), atol=1e-14)
    np.testing.assert_allclose((m.reflected_light + m.transmitted_light)[:, 0, 0], 1, atol=1e-13)
    brewster = pol.mueller_at_face(AIR, GLASS, (0, 0, 1), beams(np.degrees(np.arctan(1.5))))
    np.testing.assert_allclose(pol.polarisance(brewster.reflected_light), 1, atol=1e-12)


def test_total_reflection_retards_p_against_s_as_fresnel_found():
    # tan(delta / 2) = cos i sqrt(sin^2 i - 1/n^2) / sin^2 i (Born & Wolf, 1.5.4).
    i = np.radians([45, 50, 54.6, 70])
    m = pol.mueller_at_face(GLASS, AIR, (0, 0, 1), beams(np.degrees(i)))
    delta = 2 * np.arctan(np.cos(i) * np.sqrt(np.sin(i) ** 2 - 1 / 1.5**2) / np.sin(i) ** 2)
    found = np.arctan2(np.abs(m.reflected_light[:, 2, 3]), m.reflected_light[:, 2, 2])
    np.testing.assert_allclose(found, delta, atol=1e-12)
    assert (m.transmitted == 0).all()


@pytest.mark.parametrize("crystal", [CALCITE, TOPAZ], ids=["calcite", "topaz"])
def test_each_ray_of_a_crystal_has_a_matrix_of_rank_1_with_its_power(crystal):
    d = beams([0, 20, 60, 80])
    m = pol.mueller_at_face(AIR, crystal, (0, 0, 1), d)
    assert m.transmitted_light is None
    np.testing.assert_array_less(np.linalg.svd(m.transmitted)[1][..., 1], 1e-15)
    for name, stokes in (("s", [1, 1, 0, 0]), ("p", [1, -1, 0, 0])):
        w = icespar.interface(AIR, crystal, (0, 0, 1), d, mode=name)
        out = m.transmitted @ stokes
        np.testing.assert_allclose(out[..., 0], w.transmitted.power, atol=1e-13)
        lit = out[w.transmitted.power > 1e-6]
        np.testing.assert_allclose(pol.degree_of_polarisation(lit), 1, atol=1e-12)
        np.testing.assert_allclose((m.reflected_light @ stokes)[:, 0], w.reflected_total, atol=1e-13)
    for stokes in ([1, 0, 1, 0], [1, 0, 0, 1], [1, 0, 0, 0]):  # energy, whatever the polarisation
        total = (m.transmitted.sum(axis=1) + m.reflected_light) @ stokes
        np.testing.assert_allclose(total[:, 0], 1, atol=1e-12)


def test_the_analysers_of_o_and_e_are_not_orthogonal():
    c = icespar.Medium.uniaxial(n_o=1.6584, n_e=1.4864, axis=(1, 1, 1))
    m = pol.mueller_at_face(AIR, c, (0, 0, 1), beams([0, 60, 80]))
    a = m.transmitted[:, :, 0, 1:] / m.transmitted[:, :, 0, :1]
    cosine = np.clip(np.sum(a[:, 0] * a[:, 1], axis=1), -1, 1)  # on the sphere of Poincare, at twice the angle
    between = np.degrees(np.arccos(cosine)) / 2
    assert between[0] == pytest.approx(90, abs=1.5) and between[2] < between[1] < 89


def test_light_that_leaves_a_crystal_has_the_polarisation_of_its_field():
    d = beams([5, 20])
    for mode, place in (("o", 0), ("e", 1)):
        m = pol.mueller_at_face(CALCITE, AIR, (0, 0, 1), d, mode=mode)
        w = icespar.interface(CALCITE, AIR, (0, 0, 1), d, mode=mode)
        np.testing.assert_allclose(m.transmitted_light[:, 0, 0] * 2, w.transmitted_total, atol=1e-13)
        np.testing.assert_allclose(pol.depolarisation_index(m.transmitted_light), 1, atol=1e-12)
        s, p = w.transmitted.amplitude[0]
        light = m.transmitted_light[0, :, 0] / m.transmitted_light[0, 0, 0]
        np.testing.assert_allclose(light, pol.stokes_from_field([s, p]) / (abs(s) ** 2 + abs(p) ** 2), atol=1e-12)
        assert m.reflected_light is None and m.reflected.shape == (2, 2, 4, 4)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: pol.rotator(np.nan), "angle is not finite"),
        (lambda: pol.rotator([0, np.inf]), r"angle\[1\] is not finite"),
        (lambda: pol.rotator("x"), "angle: real numbers"),
        (lambda: pol.linear_retarder(1j), "retardance: real numbers"),
        (lambda: pol.linear_retarder([1, 2], [1, 2, 3]), r"shapes do not broadcast: retardance \(2,\), fast_axis \(3,\)"),
        (lambda: pol.linear_diattenuator(1.2, 0), "along must be in 0 .. 1"),
        (lambda: pol.linear_diattenuator(1, [0, -0.1]), r"across\[1\] must be in 0 .. 1"),
        (lambda: pol.depolariser(1.5), "a1, a2, a3: no element does this"),
        (lambda: pol.depolariser(1, -1, 1), "no element does this"),
        (lambda: pol.circular_polariser("up"), "handedness: 'up'"),
        (lambda: pol.degree_of_polarisation([1, 0, 0]), r"stokes: shape \(3,\) does not end with \(4,\)"),
        (lambda: pol.degree_of_polarisation([[1, 0, 0, 0], [1, np.nan, 0, 0]]), r"stokes\[1, 1\] is not finite"),
        (lambda: pol.diattenuation(np.eye(3)), r"mueller: shape \(3, 3\)"),
        (lambda: pol.mueller_from_jones(np.eye(4)), r"jones: shape \(4, 4\)"),
        (lambda: pol.retardance(1.5, 1.6, 1, 0), "wavelength_nm must be positive"),
        (lambda: pol.path_retardance((0, 0, 1), (0, 0, 2), np.ones((2, 2)), 500), r"steps_mm: shape \(2, 2\)"),
        (lambda: pol.mueller_of_wave((1, 0), (0, 0, 0, 0)), "out: S0 must be positive"),
        (lambda: pol.turned(np.eye(3), 1), r"matrix: shape \(3, 3\)"),
        (lambda: pol.mueller_at_face(AIR, CALCITE, (0, 0, 1), (0, 0, 1), mode="s"), "mode: .*leave out 's'"),
        (lambda: pol.mueller_at_face(CALCITE, AIR, (0, 0, 1), (0, 0, 1)), "mode: None is not a mode of uniaxial"),
        (lambda: pol.mueller_at_face(AIR, CALCITE, (0, 0, 1), [(0, 0, 1), (0, 0, -1)]), r"direction\[1\].*leaves the face"),
        (
            lambda: pol.mueller_at_face(icespar.Medium.isotropic(1.5 + 0.1j), AIR, (0, 0, 1), (0, 0, 1)),
            r"direction\[0\].*does not absorb",
        ),
    ],
)
def test_a_wrong_call_is_told_which_argument_and_which_element(call, message):
    with pytest.raises(ValueError, match=message):
        call()
