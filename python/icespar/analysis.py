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
from .moved import moved
from .optics import interface
from .views import View, view

HEAD = 10.0  #: half the angle of the observer's head in light return and extinction, degrees; GemRay's
SCOPE_HEAD = 15.0  #: and in ASET and Ideal-Scope
LAMP = 2.0  #: side of a patch of sky that counts as one lamp, for fire, degrees
PATCH = 10.0  #: and for scintillation
NUDGE = 2.0  #: tilt between the two views of scintillation, degrees
BEAMS = 500_000  #: after so many a view that is to be traced to a bound ends, and states what is left
CHANGING = 150_000  #: the same of each view for fire and scintillation, whose rest tells enough
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
        return _percent(seen.light_return(lambda _: lit))

    head, scope = math.cos(math.radians(HEAD)), math.cos(math.radians(SCOPE_HEAD))
    half, above = math.sin(math.pi / 4), height > 0
    out: Numbers = {}
    for dome in ("iso", "cosine", "sc2"):
        out[dome] = _percent(seen.light_return(dome, head_shadow=HEAD, zenith=towards))
    if np.any(seen.stone.normals[:, 2] > 1 - 1e-9):
        for dome in ("iso", "cosine", "sc2"):
            out[f"table_{dome}"] = _percent(seen.light_return(dome, head_shadow=HEAD, zenith=towards, table=True))
    out["leakage"] = part(~above)
    out["window"] = part(~above & (seen.hits == 2))
    out["extinction"] = part(height > head)
    out["aset_red"] = part((height > half) & (height <= scope))
    out["aset_green"] = part(above & (height <= half))
    out["aset_blue"] = out["idealscope_black"] = part(height > scope)
    out["aset_black"] = out["idealscope_white"] = out["leakage"]
    out["idealscope_red"] = part(above & (height <= scope))
    return out


def _frame(tilt: tuple[float, float]) -> NDArray[np.float64]:
    """The viewer's right, up and towards, in the frame of the stone."""
    return tilted(np.eye(3), tilt)


def fire(gem: Gem, tilt: tuple[float, float] = (0.0, 0.0), bound: float = 3e-3, error: float | None = 3e-5) -> Number:
    """MEANING["fire"]; the others are those of `trace`, for each of two views."""
    blue, red = (trace(gem, tilt, gem.medium(nm), bound, error, CHANGING) for nm in (F_LINE, C_LINE))
    return _percent(moved(blue, red, _frame(tilt), _frame(tilt), LAMP, HEAD))


def scintillation(
    gem: Gem, tilt: tuple[float, float] = (0.0, 0.0), bound: float = 4e-3, error: float | None = 1e-4
) -> Number:
    """MEANING["scintillation"]; the others are those of `trace`, for each of three views."""
    ways = tilt, (tilt[0] + NUDGE, tilt[1]), (tilt[0], tilt[1] + NUDGE)
    still, *nudged = ((trace(gem, way, None, bound, error, CHANGING), _frame(way)) for way in ways)
    found = [moved(still[0], seen, still[1], frame, PATCH, HEAD) for seen, frame in nudged]
    return _percent(np.mean(found, axis=0).tolist())


def _percent(number: Iterable[float]) -> Number:
    return Number(*(100 * x for x in number))


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
    rest to the standard error `error`; the views of fire and scintillation end with 3 and 4 `bound`, or earlier, and are sampled as well.
    At each tilt about both axes numbers have an error of 5 `error`, whatever their bound.

    Stones are clear: colours belong to pictures, numbers to the cut.
    """
    tilts = [float(t) for t in tilts]
    plain = gem.isotropic(D_LINE) if gem.birefringent else None
    found = Analysis(gem, {}, None, tilts)
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
        # The longest jobs first.
        changes = [
            pool.submit(scintillation, gem, bound=4 * bound, error=error),
            pool.submit(fire, gem, bound=3 * bound, error=0.3 * error),
        ]
        straight = [pool.submit(trace, gem, medium=m, bound=bound, error=error) for m in (None, plain)[: 1 if plain is None else 2]]
        for done, (job, result) in enumerate(zip(jobs, pool.map(one, jobs), strict=True), 1):
            getattr(found, job[0]).setdefault(job[2], []).append(result)
            if progress:
                progress(done / len(jobs))
        found.face_up.update(numbers(straight[0].result()))
        found.face_up["scintillation"], found.face_up["fire"] = (change.result() for change in changes)
        if plain is not None:
            found.without = numbers(straight[1].result())
    if plain is not None:
        found.doubled = {
            axis: [doubling(gem, (t, 0.0) if axis == "x" else (0.0, t)) for t in tilts] for axis in "xy"
        }
    return found
