"""The cutter's numbers of a gem at all tilts, with fire, scintillation and doubling, each with its bound and error."""

import itertools
import math
import os
from collections.abc import Callable, Hashable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ._core import Error, Medium
from .coloured import Coloured, coloured
from .gem import Gem
from .moved import moved
from .optics import interface
from .performance import (
    C_LINE,
    D_LINE,
    F_LINE,
    HEAD,
    LAMP,
    NUDGE,
    WINDOW,
    Number,
    Numbers,
    frame_of,
    numbers,
    percent,
    sure,
    trace,
)
from .views import View

TILTED = 9.0  #: so much larger is the error that is asked of tilted views
COARSE = 10.0  #: between wavelengths of tilted views of a coloured stone, nm; 5 face-up


def fire(gem: Gem, tilt: tuple[float, float] = (0.0, 0.0), bound: float = 1e-3, error: float = 1e-4) -> Number:
    """MEANING["fire"], of a view that is traced as `trace` does."""
    return changes(moving(gem, tilt, bound, error), tilt)["fire"]


def scintillation(gem: Gem, tilt: tuple[float, float] = (0.0, 0.0), bound: float = 1e-3, error: float = 1e-4) -> Number:
    """MEANING["scintillation"], of a view that is traced as `trace` does."""
    return changes(moving(gem, tilt, bound, error), tilt)["scintillation"]


def moving(gem: Gem, tilt: tuple[float, float], bound: float | None, error: float | None) -> View:
    """The gem's view, with how directions move from red (C line) to blue (F line) and as it is tilted."""
    blue, red = (np.real(gem.medium(nm).permittivity) for nm in (F_LINE, C_LINE))
    return trace(gem, tilt, None, bound, error, fan=blue - red, turns=True, table_error=True)


def changes(seen: View, tilt: tuple[float, float] = (0.0, 0.0)) -> Numbers:
    """Fire and scintillation of a view that `moving` gave."""
    frame = frame_of(tilt)
    towards = frame[2]
    gone = [moved(seen, by, towards, WINDOW, HEAD) for by in nudged(seen, frame)]
    return {
        "scintillation": percent(np.mean(gone, axis=0).tolist()),
        "fire": percent(moved(seen, seen.fan, towards, LAMP, HEAD)),
    }


def nudged(seen: View, frame: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """How each direction moves, for a viewer whose sky stays, when the line of sight turns to the right or up by NUDGE."""
    right, up, towards = frame
    return [
        math.radians(NUDGE) * (seen.turned[:, i] - np.cross(np.cross(-towards, way), seen.direction))
        for i, way in enumerate((right, up))
    ]


@dataclass(frozen=True)
class Doubling:
    """How far apart the two images of the culet are, seen through the table."""

    separation_mm: float  #: across the line of sight; nan where the culet is not seen through the table
    arc_minutes: float  #: that for an eye at 250 mm; it tells about 1 apart, through a loupe of tenfold power 0.1


def doubling(gem: Gem, tilt: tuple[float, float] = (0.0, 0.0)) -> Doubling:
    """The two images of the stone's lowest point through its table, for a parallel view tilted as in `Gem.picture`."""
    scale = gem.width_mm / gem._width()
    corners = gem.stone.vertices * scale
    table = int(np.argmax(gem.stone.normals[:, 2]))
    if gem.stone.normals[table, 2] < 1 - 1e-9:
        return Doubling(math.nan, math.nan)
    low = corners[np.isclose(corners[:, 2], corners[:, 2].min())].mean(axis=0)
    depth = corners[:, 2].max() - low[2]
    line = -frame_of(tilt)[2]
    # Both waves are there for any polarisation of the incident light.
    entering = interface(Medium.isotropic(1.0), gem.medium(D_LINE), (0, 0, -1), line, mode="s", only={"ray"})
    rays = entering.transmitted.ray[0]
    # Where each line of sight that ends at the culet meets the table.
    met = low + rays * (depth / rays[:, 2:])
    polygon = corners[gem.stone.facets[table]][:, :2]
    edges = np.roll(polygon, -1, axis=0) - polygon
    for point in met[:, :2]:
        to = point - polygon
        if np.any(edges[:, 0] * to[:, 1] - edges[:, 1] * to[:, 0] < -1e-9):
            return Doubling(math.nan, math.nan)
    apart = met[1] - met[0]
    apart = float(np.linalg.norm(apart - line * (apart @ line)))
    return Doubling(apart, math.degrees(math.atan2(apart, 250)) * 60)


def tilt_about(axis: str, angle: float) -> tuple[float, float]:
    return (angle, 0.0) if axis == "x" else (0.0, angle)


def alike(gem: Gem, medium: Medium) -> Callable[[tuple[float, float]], tuple[float, ...]]:
    """A name for each tilt, the same of those that turns and mirrors of the stone in this medium make of one another."""
    images = trace(gem, medium=medium, bound=1.0, error=None).images

    def name(tilt: tuple[float, float]) -> tuple[float, ...]:
        x, y, z = frame_of(tilt)[2]
        # 0 is never -0.
        return min(tuple(float(c) for c in np.round([*(image @ (x, y)), z], 9) + 0.0) for image in images)

    return name


@dataclass
class Analysis:
    """All that a report says of one gem."""

    gem: Gem
    face_up: Numbers
    without: Numbers | None  #: face-up without birefringence: one index, the mean; None where there is none anyway
    tilts: list[float] = field(default_factory=list)
    curves: dict[str, list[Numbers]] = field(default_factory=dict)  #: "x", "y": numbers at each tilt
    plain_curves: dict[str, list[Numbers]] = field(default_factory=dict)  #: the same without birefringence
    doubled: dict[str, list[Doubling]] = field(default_factory=dict)
    coloured: Coloured | None = None  #: face-up with its colour, if that was asked for
    coloured_curves: dict[str, list[Numbers]] = field(default_factory=dict)  #: the same at each tilt, of the luminance

    @property
    def effect(self) -> Numbers:
        """By how much birefringence changes each number."""
        out: Numbers = {}
        for name, a in self.face_up.items():
            b = (self.without or {}).get(name)
            if b is not None:
                error = math.hypot(a.error, b.error)
                out[name] = Number(a.value - b.value, sure(a.bound + b.bound, error), error)
        return out


def analyse(
    gem: Gem,
    tilts: Iterable[float] = np.arange(-30, 31, 2.0),
    bound: float = 1e-3,
    error: float = 1e-4,
    progress: Callable[[float], None] | None = None,
    colour: bool = False,
) -> Analysis:
    """Traces the gem face-up, until no more than `bound` of all light is left or many beams were followed, and samples the
    rest to the standard error `error`.
    At each tilt about both axes numbers, also of the table, have an error of about 9 `error`, whatever their bound; of tilts that turns and mirrors
    of the stone make one of another one is traced.

    Stones are clear. With `colour` there are the numbers of the coloured stone besides, as `icespar.coloured` defines them.
    """
    if colour and not gem.colour:
        raise Error(f"{gem.name} has no colour: name one of its mineral's, or leave the coloured stone out")
    tilts = [float(t) for t in tilts]
    plain = gem.isotropic(D_LINE) if gem.birefringent else None
    found = Analysis(gem, {}, None, tilts)
    kinds = {"curves": True, "plain_curves": plain is not None, "coloured_curves": colour and len(tilts) > 1}
    names = {"curves": alike(gem, gem.medium(D_LINE)), "plain_curves": alike(gem, plain) if plain else None}
    jobs: dict[Hashable, list[tuple[str, str, int]]] = {}
    for curve, axis in itertools.product((name for name, wanted in kinds.items() if wanted), "xy"):
        getattr(found, curve)[axis] = [None] * len(tilts)
        for i, t in enumerate(tilts):
            tilt = tilt_about(axis, t)
            name = names[curve](tilt) if names.get(curve) else (axis, i)
            jobs.setdefault((curve, name), []).append((curve, axis, i))

    def one(same):
        curve, axis, i = same[0]
        tilt = tilt_about(axis, tilts[i])
        if curve == "coloured_curves":
            return coloured(gem, tilt, COARSE, TILTED * error).luminous
        medium = plain if curve == "plain_curves" else gem.medium(D_LINE)
        return numbers(trace(gem, tilt, medium, None, TILTED * error, table_error=True), frame_of(tilt)[2])

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        # The longest jobs first.
        straight = pool.submit(moving, gem, (0.0, 0.0), bound, error)
        tinted = pool.submit(coloured, gem, error=error) if colour else None
        without = None
        if plain is not None:
            without = pool.submit(trace, gem, medium=plain, bound=bound, error=error, table_error=True)
        for done, (same, result) in enumerate(zip(jobs.values(), pool.map(one, jobs.values()), strict=True), 1):
            for curve, axis, i in same:
                getattr(found, curve)[axis][i] = result
            if progress:
                progress(done / len(jobs))
        found.face_up.update(numbers(straight.result()) | changes(straight.result()))
        if tinted:
            found.coloured = tinted.result()
        if without is not None:
            found.without = numbers(without.result())
    if plain is not None:
        found.doubled = {
            axis: [doubling(gem, tilt_about(axis, t)) for t in tilts] for axis in "xy"
        }
    return found
