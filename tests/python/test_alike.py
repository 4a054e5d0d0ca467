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
        found = [numbers(trace(gem, tilt, None, None, 7e-4), frame_of(tilt)[2]) for tilt in (a, b)]
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


def test_the_table_alone_has_the_error_asked_for_if_that_is_wanted(root):
    gem, tilt = gem_of(root, (1, 0, 0)), (20.0, 0.0)
    zenith, asked = frame_of(tilt)[2], 4e-3

    def found(table, seen):
        return seen.light_return("cosine", zenith=zenith, table=table)

    truth = trace(gem, tilt, bound=1e-3, error=1e-4)
    samples = [
        [trace(gem, tilt, None, None, asked, table_error=wanted, seed=seed) for seed in range(20)] for wanted in (True, False)
    ]
    for table in (True, False):
        here = [found(table, seen) for seen in samples[0]]
        off, errors = [abs(n.value - found(table, truth).value) for n in here], [n.error for n in here]
        assert sum(o <= 2 * e for o, e in zip(off, errors, strict=True)) >= 16
        assert 0.1 * asked < sum(errors) / 20 < 1.3 * asked
    of_table = [sum(found(True, seen).error for seen in some) for some in samples]
    assert of_table[1] > 1.5 * of_table[0]
