"""Light that moves with colour and with the line of sight, against closed forms, two traces and exact sums."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import icespar
from icespar import analysis
from icespar.gem import Gem
from icespar.moved import common, moved

UP = (0, 0, 1)


def beams(*directions, light, by=0.0):
    """A view of beams that all move by angles `by`, and by how much."""
    d = np.array(directions, dtype=float)
    d /= np.linalg.norm(d, axis=1)[:, None]
    across = np.cross(d, (0.3, 0.5, 0.1))
    seen = SimpleNamespace(
        direction=d,
        group=np.zeros(len(d), dtype=np.int32),
        weight=np.array(light),
        area=np.ones(len(d)),
        area_total=1.0,
        untraced=0.0,
        residue=0.0,
        groups=0,
    )
    return seen, across / np.linalg.norm(across, axis=1)[:, None] * np.reshape(by, (-1, 1))


def gem_of(root, design, mineral, axis=UP):
    return Gem.of(root / f"scenes/designs/{design}.asc", mineral, axis=axis)


def test_two_discs_have_in_common_what_areas_say():
    half = 2 / 3 - math.sqrt(3) / (2 * math.pi)  # each passes through the other's centre
    assert common([0, 0.5, 1, 7]) == pytest.approx([1, half, 0, 0], abs=1e-15)
    points = np.random.default_rng(1).uniform(-1, 1, (200_000, 2))
    here = points[np.hypot(*points.T) < 1]
    assert common(0.3) == pytest.approx(np.mean(np.hypot(here[:, 0] - 0.6, here[:, 1]) < 1), abs=5e-3)


def test_only_light_from_above_beside_the_head_moves_and_by_its_own_angle():
    lamp = math.radians(4)
    ways = (1, 0, 1), (0, -1, 1), (0, 0.05, 1), (1, 1, -0.1)
    seen, by = beams(*ways, light=[0.3, 0.1, 0.2, 0.2], by=[0.5 * lamp, 2 * lamp, lamp, lamp])
    assert moved(seen, by, UP, 4, 10) == pytest.approx(((0.3 * (1 - common(0.5)) + 0.1) / 0.4, 0, 0))
    assert moved(seen, 0 * by, UP, 4, 10) == (0, 0, 0)
    # Another zenith sees other light.
    assert moved(seen, by, (1, 0, 0), 4, 10).value == pytest.approx((0.3 * (1 - common(0.5)) + 0.2) / 0.5)


def test_a_sample_of_what_is_left_knows_how_much_light_moved_and_how_well(root):
    gem = gem_of(root, "srb_tolkowsky_diamond", "diamond")
    change = 0.3 * np.eye(3)

    def view(**options):
        medium = icespar.Medium.isotropic(2.43)
        return icespar.view(gem.stone, medium, direction=(0.2, 0.1, -1), max_hits=9, fan=change, turns=True, **options)

    # Of nine faces all beams can be followed.
    whole = view(bound=0, max_beams=0, error=None)
    samples = [view(bound=0, max_beams=1500, error=1e-9, seed=seed) for seed in range(24)]
    for lamp, part in ((2, lambda v: v.fan), (20, lambda v: v.fan), (10, lambda v: 0.035 * v.turned[:, 0])):
        truth = moved(whole, part(whole), UP, lamp, 10)
        assert truth.bound < 1e-9
        found = np.array([moved(sample, part(sample), UP, lamp, 10) for sample in samples])
        off, bounds, errors = abs(found[:, 0] - truth.value), found[:, 1], found[:, 2]
        assert np.all(off <= bounds)
        assert np.mean(off <= 2 * errors) >= 0.85
        assert np.mean(errors) < 2 * np.sqrt(np.mean(off**2))
        assert np.all(errors < bounds / 8)
    unsampled = view(bound=0, max_beams=1500, error=None)
    known = moved(unsampled, unsampled.fan, UP, 20, 10)
    truth = moved(whole, whole.fan, UP, 20, 10)
    assert abs(known.value - truth.value) <= known.bound == known.error


@pytest.mark.parametrize(
    ("design", "mineral", "axis"),
    [("srb_tolkowsky_diamond", "diamond", UP), ("srb_quartz", "zircon", (1, 0, 0)), ("srb_quartz", "moissanite", (1, 0, 1))],
)
def test_one_trace_tells_how_far_blue_and_red_come_apart_as_two_do(root, design, mineral, axis):
    gem = gem_of(root, design, mineral, axis)
    media = [gem.medium(nm) for nm in (analysis.F_LINE, analysis.C_LINE)]
    change = media[0].permittivity - media[1].permittivity
    rules = {"bound": 0, "max_beams": 0, "max_hits": 4, "error": None}
    seen = icespar.view(gem.stone, gem.medium(analysis.D_LINE), fan=change, **rules)
    others = [icespar.view(gem.stone, m, **rules) for m in media]
    light, lamp = seen.weight * seen.area, math.radians(analysis.LAMP)
    one = two = total = 0.0
    for i in np.flatnonzero((light > 1e-4 * seen.area_total) & (seen.direction[:, 2] > 0)):
        ends = []
        for sign, other in zip((0.5, -0.5), others, strict=True):
            same = (other.entry == seen.entry[i]) & (other.facet == seen.facet[i]) & (other.hits == seen.hits[i])
            if same.any():
                d = other.direction[same]
                ends.append(d[np.argmin(np.linalg.norm(d - seen.direction[i] - sign * seen.fan[i], axis=1))])
        apart = np.linalg.norm(ends[0] - ends[1]) if len(ends) == 2 else math.inf
        one += light[i] * common(np.linalg.norm(seen.fan[i]) / lamp)
        two += light[i] * common(apart / lamp)
        total += light[i]
    assert total > 0.1 * seen.area_total
    assert one / total == pytest.approx(two / total, abs=1e-3)


def test_fire_and_scintillation_are_known_to_a_twentieth_of_a_point(root):
    for design, mineral, axis in (
        ("srb_tolkowsky_diamond", "diamond", UP),
        ("srb_quartz", "zircon", (1, 0, 0)),
        ("srb_quartz", "moissanite", (1, 0, 0)),
    ):
        gem = gem_of(root, design, mineral, axis)
        for number in (analysis.fire(gem, error=5e-4), analysis.scintillation(gem, error=5e-4)):
            assert 0 < number.error < 0.05 and number.error < number.bound <= 3 * number.error
            assert 20 < number.value < 80


def test_fire_grows_with_dispersion_and_vanishes_without(root):
    def value(mineral):
        return analysis.fire(gem_of(root, "srb_tolkowsky_diamond", mineral), bound=0.01, error=1e-3).value

    values = [value(mineral) for mineral in (None, "fluorite", "spinel", "diamond", "strontium titanate")]
    assert values[0] == 0
    assert values == sorted(values) and values[-1] > 4 * values[1]


def test_a_mirror_that_is_tilted_sends_its_light_twice_as_far(root):
    gem = gem_of(root, "srb_tolkowsky_diamond", None)
    seen = icespar.view(gem.stone, icespar.Medium.isotropic(2.4), max_hits=1, turns=True, fan=np.eye(3))
    by = analysis.nudged(seen, np.eye(3))
    normals = np.array(gem.stone.normals)[seen.entry]
    for way, axis in zip(by, ((0, 1, 0), (-1, 0, 0)), strict=True):
        # The normal turns as the stone does, in the viewer's frame; what it mirrors turns with it, on both sides.
        turn = math.radians(analysis.NUDGE) * np.cross(axis, normals)
        sight = np.array((0.0, 0, -1))
        wanted = -2 * (np.outer(turn @ sight, [1, 1, 1]) * normals + (normals @ sight)[:, None] * turn)
        assert np.allclose(way, wanted, atol=1e-12)
    assert not seen.fan.any()


def test_a_sample_that_finds_no_light_from_above_knows_nothing_but_its_bound():
    below, by = beams((0, 1, -2), light=[0.5])
    below.groups, below.untraced = 16, 0.1
    assert moved(below, by, UP, 5, 10) == (0, 1, 1)


def test_a_view_without_light_from_above_shows_nothing_that_moves():
    below, by = beams((0, 1, -2), light=[0.5])
    assert moved(below, by, UP, 5, 10) == (0, 0, 0)
