"""The cutter's numbers: light return, leakage, extinction, fire, scintillation and doubling, each with its bound and error."""

import math
import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._core import Medium
from .gem import Gem, tilted
from .optics import interface
from .views import View, view

HEAD = 10.0  #: half the angle of the observer's head in light return and extinction, degrees; GemRay's
SCOPE_HEAD = 15.0  #: and in ASET and Ideal-Scope
LAMP = 2.0  #: side of a patch of sky that counts as one lamp, for fire, degrees
PATCH = 10.0  #: and for scintillation
NUDGE = 2.0  #: tilt between the two views of scintillation, degrees
BEAMS = 500_000  #: after so many a view that is to be traced to a bound ends, and states what is left
TILTED = 5.0  #: so much larger is the error that is asked of tilted views
F_LINE, C_LINE, D_LINE = 486.1, 656.3, 589.3  #: nm


class Number(NamedTuple):
    """A part of the stone's face, in percent. The truth is never further than `bound` away, and within about two `error`."""

    value: float
    bound: float
    error: float  #: one standard error; where nothing was sampled, the bound: the truth then lies between value and value + bound


Numbers = dict[str, Number]

#: What each number is, for readers of a report. All are parts of the face-up picture's area, in percent.
MEANING = {
    "iso": "GemRay's ISO: the sky is white down to the horizon, but for the observer's head",
    "cosine": "GemRay's COS: the sky fades with the cosine of the angle from the zenith",
    "sc2": "GemRay's SC2: the sky is brightest at 45 degrees, 2 sine cosine",
    "table_iso": "ISO of the table alone",
    "table_cosine": "COS of the table alone",
    "table_sc2": "SC2 of the table alone",
    "leakage": "light that comes from below the horizon, where a setting is dark",
    "window": "the part of the leakage that passes straight through, in by one facet and out by the next",
    "extinction": "light that comes from the observer's head, which is dark",
    "aset_red": "what ASET shows red: from 45 degrees above the horizon to the head's edge",
    "aset_green": "green: from the horizon up to 45 degrees",
    "aset_blue": "blue: from the head",
    "aset_black": "black: from below",
    "idealscope_red": "what Ideal-Scope shows red: from above, beside the head",
    "idealscope_black": "black: from the head",
    "idealscope_white": "white: from below",
    "fire": (
        "our own: the part of the light from above that comes from another patch of sky, or by another facet, in blue (F line)"
        f" than in red (C line); patches of {LAMP:g} degrees, the size of a lamp"
    ),
    "scintillation": (
        f"our own: the part of the light from above that comes from another patch of sky, or by another facet, once the stone"
        f" is tilted by {NUDGE:g} degrees; patches of {PATCH:g} degrees; the mean of both tilts"
    ),
}


def trace(
    gem: Gem,
    tilt: tuple[float, float] = (0.0, 0.0),
    medium: Medium | None = None,
    bound: float | None = 1e-3,
    error: float | None = 1e-4,
    max_beams: int = BEAMS,
) -> View:
    """The gem in a parallel view, tilted as in `Gem.picture`; `medium` takes the place of its own at 589.3 nm.

    The rest is as in `icespar.view`.
    """
    toward, up = tilted([[0, 0, 1], [0, 1, 0]], tilt)
    medium = gem.medium(D_LINE) if medium is None else medium
    return view(gem.stone, medium, direction=-toward, up=up, bound=bound, error=error, max_beams=max_beams)


def numbers(seen: View, towards: NDArray[np.float64] | tuple[float, ...] = (0, 0, 1)) -> Numbers:
    """What one view says."""
    height = seen.direction @ np.asarray(towards, dtype=float)

    def part(lit: NDArray[np.bool_]) -> Number:
        return Number(*(100 * x for x in seen.light_return(lambda _: lit)))

    head, scope = math.cos(math.radians(HEAD)), math.cos(math.radians(SCOPE_HEAD))
    half, above = math.sin(math.pi / 4), height > 0
    out: Numbers = {}
    for dome in ("iso", "cosine", "sc2"):
        out[dome] = Number(*(100 * x for x in seen.light_return(dome, head_shadow=HEAD, zenith=towards)))
    if np.any(seen.stone.normals[:, 2] > 1 - 1e-9):
        for dome in ("iso", "cosine", "sc2"):
            returned = seen.light_return(dome, head_shadow=HEAD, zenith=towards, table=True)
            out[f"table_{dome}"] = Number(*(100 * x for x in returned))
    out["leakage"] = part(~above)
    out["window"] = part(~above & (seen.hits == 2))
    out["extinction"] = part(height > head)
    out["aset_red"] = part((height > half) & (height <= scope))
    out["aset_green"] = part(above & (height <= half))
    out["aset_blue"] = out["idealscope_black"] = part(height > scope)
    out["aset_black"] = out["idealscope_white"] = out["leakage"]
    out["idealscope_red"] = part(above & (height <= scope))
    return out


def moved(a: View, b: View, towards_a, towards_b, side: float) -> Number:
    """The part of the light from above that comes by another facet or from another patch of sky in `b` than in `a`.

    In percent. Patches are squares of `side` degrees on the equal-area map of the sky as the viewer has it; the number
    is the mean over 16 places of their grid. Light from the observer's head is left out, and so is what was sampled:
    chance, too, would move it.
    """
    sides = [_on_sky(v, toward) for v, toward in ((a, towards_a), (b, towards_b))]
    step = math.radians(side)
    found = []
    for shift in np.ndindex(4, 4):
        cells = [np.floor(place / step + np.array(shift) / 4).astype(np.int64) for place, _, _ in sides]
        keys = [(c[:, 0] * 4096 + c[:, 1]) * 4096 + entry for c, (_, entry, _) in zip(cells, sides, strict=True)]
        _, where = np.unique(np.concatenate(keys), return_inverse=True)
        light = np.concatenate([sides[0][2], -sides[1][2]])
        found.append(np.abs(np.bincount(where, light)).sum() / max(np.abs(light).sum(), 1e-300))
    total = sides[0][2].sum() + sides[1][2].sum()
    bound = 100 * min(1.0, (a.untraced + b.untraced) / max(float(total), 1e-300))
    return Number(100 * float(np.mean(found)), bound, bound)


def _on_sky(seen: View, frame: NDArray[np.float64]):
    """Places on the sky's equal-area map, facets of entry, and light, of what comes from above beside the head."""
    d = seen.direction @ np.asarray(frame, dtype=float).T
    keep = (d[:, 2] > 0) & (d[:, 2] < math.cos(math.radians(HEAD))) & (seen.group == 0)
    d = d[keep]
    return (
        d[:, :2] * np.sqrt(2 / (1 + d[:, 2:])),
        seen.entry[keep],
        (seen.weight * seen.area)[keep] / seen.area_total,
    )


def _frame(tilt: tuple[float, float]) -> NDArray[np.float64]:
    """The viewer's right, up and towards, in the frame of the stone."""
    return tilted(np.eye(3), tilt)


def fire(gem: Gem, bound: float = 1e-3) -> Number:
    """MEANING["fire"], face-up."""
    blue, red = (trace(gem, (0.0, 0.0), gem.medium(nm), bound, None) for nm in (F_LINE, C_LINE))
    return moved(blue, red, np.eye(3), np.eye(3), LAMP)


def scintillation(gem: Gem, still: View, bound: float = 1e-3) -> Number:
    """MEANING["scintillation"]; `still` is the view face-up."""
    found = [
        moved(still, trace(gem, tilt, still.medium, bound, None), np.eye(3), _frame(tilt), PATCH)
        for tilt in ((NUDGE, 0.0), (0.0, NUDGE))
    ]
    return Number(*np.mean(found, axis=0).tolist())


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
    line = -_frame(tilt)[2]
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

    @property
    def effect(self) -> Numbers:
        """By how much birefringence changes each number, with the sum of both bounds."""
        out: Numbers = {}
        for name, a in self.face_up.items():
            b = (self.without or {}).get(name)
            if b is not None:
                out[name] = Number(a.value - b.value, a.bound + b.bound, math.hypot(a.error, b.error))
        return out


def analyse(
    gem: Gem,
    tilts: Iterable[float] = np.arange(-30, 31, 2.0),
    bound: float = 1e-3,
    error: float = 1e-4,
    progress: Callable[[float], None] | None = None,
) -> Analysis:
    """Traces the gem face-up, until no more than `bound` of all light is left or many beams were followed, and samples the
    rest to the standard error `error`; fire and scintillation end with 5 `bound`. At each tilt about both axes numbers have an
    error of 5 `error`, whatever their bound.

    Stones are clear: colours belong to pictures, numbers to the cut.
    """
    tilts = [float(t) for t in tilts]
    plain = gem.isotropic(D_LINE) if gem.birefringent else None
    still = trace(gem, bound=bound, error=error)
    face_up = numbers(still)
    without = None if plain is None else numbers(trace(gem, medium=plain, bound=bound, error=error))
    face_up["fire"] = fire(gem, 5 * bound)
    face_up["scintillation"] = scintillation(gem, still, 5 * bound)
    found = Analysis(gem, face_up, without, tilts)
    jobs = [
        (curve, (t, 0.0) if axis == "x" else (0.0, t), axis, medium)
        for curve, medium in (("curves", None), ("plain_curves", plain))
        if curve == "curves" or plain is not None
        for axis in "xy"
        for t in tilts
    ]

    def one(job):
        _, tilt, _, medium = job
        medium = gem.medium(D_LINE) if medium is None else medium
        return numbers(trace(gem, tilt, medium, None, TILTED * error), _frame(tilt)[2])

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for done, (job, result) in enumerate(zip(jobs, pool.map(one, jobs), strict=True), 1):
            getattr(found, job[0]).setdefault(job[2], []).append(result)
            if progress:
                progress(done / len(jobs))
    if plain is not None:
        found.doubled = {
            axis: [doubling(gem, (t, 0.0) if axis == "x" else (0.0, t)) for t in tilts] for axis in "xy"
        }
    return found
