"""What one view of a gem says to a cutter: light return, leakage, extinction, in percent, each with its bound and error."""

import math
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._core import Medium
from .gem import Gem, tilted
from .views import View, view

HEAD = 10.0  #: half the angle of the observer's head in light return and extinction, degrees; GemRay's
SCOPE_HEAD = 15.0  #: and in ASET and Ideal-Scope
LAMP = 2.0  #: across a lamp, for fire, degrees
WINDOW = 10.0  #: and across a window, for scintillation
SURE = 3.0  #: standard errors that bound a number
NUDGE = 2.0  #: tilt of scintillation, degrees
BEAMS = 400_000  #: after so many a view that is to be traced to a bound ends, and states what is left
F_LINE, C_LINE, D_LINE = 486.1, 656.3, 589.3  #: nm


class Number(NamedTuple):
    """A part of the stone's face, in percent, with a bound on how far the truth is away: it lies beyond once in some 300 numbers."""

    value: float
    bound: float  #: SURE standard errors, or where that is less the light that was not followed exactly
    error: float  #: one standard error; where nothing was sampled, the bound


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
    "absorbed": "of a coloured stone, the light that it keeps",
    "fire": (
        f"our own: of what the stone shows of a lamp {LAMP:g} degrees across, anywhere above, the part that is there in blue"
        " (F line) but not in red (C line)"
    ),
    "scintillation": (
        f"our own: of what the stone shows of a window {WINDOW:g} degrees across, anywhere above, the part that goes out once"
        f" the stone is tilted by {NUDGE:g} degrees; the mean of both tilts"
    ),
}


def trace(
    gem: Gem,
    tilt: tuple[float, float] = (0.0, 0.0),
    medium: Medium | None = None,
    bound: float | None = 1e-3,
    error: float | None = 1e-4,
    max_beams: int = BEAMS,
    **options: Any,
) -> View:
    """The gem in a parallel view, tilted as in `Gem.picture`; `medium` takes the place of its own at 589.3 nm.

    The rest is as in `icespar.view`, as are `options`.
    """
    toward, up = tilted([[0, 0, 1], [0, 1, 0]], tilt)
    medium = gem.medium(D_LINE) if medium is None else medium
    return view(gem.stone, medium, direction=-toward, up=up, bound=bound, error=error, max_beams=max_beams, **options)


def numbers(seen: View, towards: NDArray[np.float64] | tuple[float, ...] = (0, 0, 1)) -> Numbers:
    """What one view says."""
    height = seen.direction @ np.asarray(towards, dtype=float)

    def part(lit: NDArray[np.bool_]) -> Number:
        return percent(seen.light_return(lambda _: lit))

    head, scope = math.cos(math.radians(HEAD)), math.cos(math.radians(SCOPE_HEAD))
    half, above = math.sin(math.pi / 4), height > 0
    out: Numbers = {}
    for dome in ("iso", "cosine", "sc2"):
        out[dome] = percent(seen.light_return(dome, head_shadow=HEAD, zenith=towards))
    if np.any(seen.stone.normals[:, 2] > 1 - 1e-9):
        for dome in ("iso", "cosine", "sc2"):
            out[f"table_{dome}"] = percent(seen.light_return(dome, head_shadow=HEAD, zenith=towards, table=True))
    out["leakage"] = part(~above)
    out["window"] = part(~above & (seen.hits == 2))
    out["extinction"] = part(height > head)
    out["aset_red"] = part((height > half) & (height <= scope))
    out["aset_green"] = part(above & (height <= half))
    out["aset_blue"] = out["idealscope_black"] = part(height > scope)
    out["aset_black"] = out["idealscope_white"] = out["leakage"]
    out["idealscope_red"] = part(above & (height <= scope))
    return out


def frame_of(tilt: tuple[float, float]) -> NDArray[np.float64]:
    """The viewer's right, up and towards, in the frame of the stone."""
    return tilted(np.eye(3), tilt)


def percent(number: Iterable[float]) -> Number:
    """Of value, light that was not followed exactly and standard error, of 1."""
    value, missing, error = (100 * x for x in number)
    return Number(value, sure(missing, error), error)


def sure(most: float, error: float) -> float:
    """The bound of a number that is off by no more than `most` whatever chance does."""
    return min(most, SURE * error)
