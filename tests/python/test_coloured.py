"""Numbers of coloured stones in white light: against Beer and Lambert's law over the spectrum, and by what adds up."""

import numpy as np
import pytest

import icespar
from icespar import Design, Error, Tier, analysis
from icespar.coloured import coloured
from icespar.gem import Gem

SQUARE = [0, 24, 48, 72]


def test_the_observer_sees_white_light_as_bright_as_the_light_e():
    nm = np.arange(380.0, 781.0)
    assert icespar.observer(nm).shape == (401, 3)
    assert icespar.observer(nm)[:, 1].sum() == pytest.approx(1, abs=1e-6)
    assert icespar.observer(nm)[:, 1] @ icespar.illuminant("D65", nm) == pytest.approx(1, abs=1e-6)
    assert nm[np.argmax(icespar.observer(nm)[:, 1])] == 555
    assert np.all(icespar.observer([379.0, 781.0]) == 0)


@pytest.mark.parametrize("colour", ["ruby", "blue sapphire"])
def test_a_coloured_plate_is_as_bright_as_beer_and_lamberts_law_over_the_spectrum(colour):
    flat = [Tier(0, 0.25, [0], ["T"]), Tier(-0.0, 0.25, [0], ["K"])]
    gem = Gem.of(Design([*flat, Tier(90, 1, SQUARE, ["G"])]), "corundum", name="plate", colour=colour, width_mm=6)
    found = coloured(gem)
    # Along the optic axis light is ordinary; the plate is a quarter as thick as wide.
    nm = np.arange(380.0, 781.0)
    n = np.array([gem.mineral.indices(x)[0] for x in nm])
    passed = (4 * n / (n + 1) ** 2) ** 2 * np.exp(-1.5 * gem.mineral.absorption(colour, nm)[:, 0])
    bright = icespar.observer(nm)[:, 1] * icespar.illuminant("D65", nm)
    value, bound, error = found.luminous["window"]
    assert 0 < error < 0.1 and error <= bound < 0.2
    assert value == pytest.approx(100 * passed @ bright / bright.sum(), abs=2 * error)
    at = found.wavelengths_nm.index(600)
    assert found.by_wavelength[at]["window"].value == pytest.approx(100 * passed[nm == 600][0], abs=1e-6)


def test_what_a_coloured_stone_returns_lets_through_and_keeps_is_all_the_light(root):
    settings = {"axis": (1, 0, 0), "width_mm": 4}
    gem = Gem.of(root / "scenes/designs/srb_quartz.asc", "tourmaline", colour="green", **settings)
    found = coloured(gem, (10.0, 0.0), step_nm=40, error=1e-3).luminous
    parts = sum(found[name].value for name in ("iso", "leakage", "extinction", "absorbed"))
    assert parts == pytest.approx(100, abs=1e-3)
    assert 20 < found["absorbed"].value < 90
    clear = Gem.of(gem.design, "tourmaline", **settings)
    assert coloured(clear, (10.0, 0.0), step_nm=80, error=1e-3).luminous["absorbed"].value == pytest.approx(0, abs=1e-3)


def test_colour_is_asked_for_by_name(root):
    clear = Gem.of(root / "scenes/designs/rose_cut_flat.asc", "corundum")
    with pytest.raises(Error, match="name one of its mineral's"):
        analysis.analyse(clear, [0], colour=True)
    with pytest.raises(ValueError, match="step_nm"):
        coloured(clear, step_nm=0)
