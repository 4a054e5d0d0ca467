"""Light that moves from one view to another, against exact sums: what a sample makes of it, and how well it knows its error."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import icespar
from icespar import analysis
from icespar.gem import Gem
from icespar.moved import moved

HERE = np.eye(3)


def beams(*places, light):
    """A view of beams from places on the sky's equal-area map, all of them followed exactly."""
    x, y = np.array(places, dtype=float).T
    squared = x**2 + y**2
    across = np.sqrt(1 - squared / 4)
    return SimpleNamespace(
        direction=np.column_stack([x * across, y * across, 1 - squared / 2]),
        entry=np.zeros(len(x), dtype=np.int32),
        group=np.zeros(len(x), dtype=np.int32),
        weight=np.array(light),
        area=np.ones(len(x)),
        area_total=1.0,
        untraced=0.0,
        residue=0.0,
        groups=0,
    )


@pytest.mark.parametrize(("step", "part"), [(0, 0), (0.25, 0.25), (0.5, 0.5), (1, 1)])
def test_light_that_moves_by_a_part_of_a_patch_leaves_it_at_so_many_places(step, part):
    side = 8.0
    start, to = 0.313, 0.313 + step * math.radians(side)
    a, b = beams((start, 0.2), (-0.6, 0.1), light=[0.3, 0.1]), beams((to, 0.2), (-0.6, 0.1), light=[0.3, 0.1])
    assert moved(a, b, HERE, HERE, side, 10) == pytest.approx((0.75 * part, 0, 0), abs=1e-12)


def test_a_sample_of_what_is_left_knows_how_much_light_moved_and_how_well(root):
    stone = Gem.of(root / "scenes/designs/srb_tolkowsky_diamond.asc", "diamond").stone
    media = [icespar.Medium.isotropic(n) for n in (2.40, 2.46)]

    def views(**options):
        return [icespar.view(stone, medium, direction=(0.2, 0.1, -1), max_hits=9, **options) for medium in media]

    # Of nine faces all beams can be followed.
    whole = views(bound=0, max_beams=0)
    samples = [views(bound=0, max_beams=1500, error=1e-9, seed=seed) for seed in range(24)]
    for side in (2, 10):
        truth = moved(*whole, HERE, HERE, side, 10)
        assert truth.bound < 1e-9
        found = np.array([moved(*sample, HERE, HERE, side, 10) for sample in samples])
        off, bounds, errors = abs(found[:, 0] - truth.value), found[:, 1], found[:, 2]
        assert np.all(off <= bounds)
        assert np.mean(off <= 2 * errors) >= 0.9
        assert np.all(errors < bounds / 8)
    truth = moved(*whole, HERE, HERE, 3, 10)
    unsampled = moved(*views(bound=0, max_beams=1500, error=None), HERE, HERE, 3, 10)
    assert abs(unsampled.value - truth.value) <= unsampled.bound == unsampled.error


@pytest.mark.parametrize(
    ("design", "mineral", "axis"), [("srb_tolkowsky_diamond", "diamond", (0, 0, 1)), ("srb_quartz", "zircon", (1, 0, 0))]
)
def test_fire_and_scintillation_are_known_to_a_tenth_of_a_point(root, design, mineral, axis):
    gem = Gem.of(root / f"scenes/designs/{design}.asc", mineral, axis=axis)
    for number in (analysis.fire(gem), analysis.scintillation(gem)):
        assert 0 < number.error < 0.1 < number.bound
        assert 20 < number.value < 60


@pytest.mark.parametrize(("power", "times"), [(0.6, 2), (0.3, 4), (0, 5)])
def test_beams_are_added_until_the_error_asked_for_or_the_most(power, times):
    efforts = []

    def traced(effort):
        efforts.append(effort)
        return analysis.Number(30.0, 5.0, 0.2 * effort**-power)

    number = analysis._until_known(traced, 1e-3)
    assert efforts[0] == 1 and efforts == sorted(set(efforts)) and len(efforts) <= times
    assert number.error <= 0.1 or efforts[-1] == analysis.MANY / analysis.FEW
    efforts.clear()
    assert analysis._until_known(traced, 2e-3).error == 0.2 and efforts == [1]
    analysis._until_known(traced, 5e-324)
    assert efforts[-1] == analysis.MANY / analysis.FEW


def test_a_sample_that_finds_no_light_from_above_knows_nothing_but_its_bound():
    below = beams((0.0, 1.9), light=[0.5])
    below.groups, below.untraced = 16, 0.1
    assert moved(below, below, HERE, HERE, 5, 10) == (0, 1, 1)


def test_a_view_without_light_from_above_shows_nothing_that_moves():
    below = beams((0.0, 1.9), light=[0.5])
    assert moved(below, below, HERE, HERE, 5, 10) == (0, 0, 0)
