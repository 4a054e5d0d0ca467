"""Tilts that turns and mirrors of a stone make of one another: one trace tells the numbers of all."""

import math

import pytest

from icespar.analysis import alike, analyse, tilt_about
from icespar.gem import Gem
from icespar.performance import frame_of, numbers, trace


def gem_of(root, axis, mineral="zircon"):
    return Gem.of(root / "scenes/designs/srb_quartz.asc", mineral, axis=axis)


@pytest.mark.parametrize(("mineral", "axis", "count"), [("diamond", (0, 0, 1), 4), ("zircon", (1, 0, 0), 7), ("zircon", (1, 0, 1), 10)])
def test_tilts_have_as_many_names_as_the_stone_and_its_axis_leave(root, mineral, axis, count):
    gem = gem_of(root, axis, mineral)
    name = alike(gem, gem.medium())
    assert len({name(tilt_about(about, t)) for about in "xy" for t in (-30.0, -20.0, -10.0, 0.0, 10.0, 20.0, 30.0)}) == count


def test_tilts_of_one_name_have_the_same_numbers_and_others_do_not(root):
    gem = gem_of(root, (1, 0, 1))
    name = alike(gem, gem.medium())

    def apart(a, b):
        found = [numbers(trace(gem, tilt, None, None, 1e-3), frame_of(tilt)[2]) for tilt in (a, b)]
        pairs = [(found[0][key], found[1][key]) for key in found[0]]
        return max(abs(one.value - other.value) / math.hypot(one.error, other.error, 0.01) for one, other in pairs)

    assert name((12.0, 0.0)) == name((-12.0, 0.0)) and apart((12.0, 0.0), (-12.0, 0.0)) < 5
    assert name((0.0, 12.0)) != name((0.0, -12.0)) and apart((0.0, 12.0), (0.0, -12.0)) > 8


def test_curves_keep_the_order_of_their_tilts(root):
    gem = gem_of(root, (1, 0, 0))
    found = analyse(gem, (10.0, -20.0, -10.0), bound=0.1, error=5e-3)
    for curves in (found.curves, found.plain_curves):
        for curve in curves.values():
            assert curve[0] == curve[2] != curve[1]
    assert found.curves["x"] != found.curves["y"]
    assert found.plain_curves["x"] == found.plain_curves["y"]
