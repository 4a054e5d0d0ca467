"""How much of the light that a stone returns comes from elsewhere in another colour, or once the line of sight has turned."""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .views import LightReturn, View, spread

_Reals = NDArray[np.float64]


def moved(seen: View, by: ArrayLike, towards: ArrayLike, lamp: float, head: float) -> LightReturn:
    """The part of the light from above that a lamp of `lamp` degrees no longer sends after directions moved by `by`, (N, 3).

    A virtual facet, the polygon of one beam, shows the disc of a lamp wherever that disc holds its direction. Of all such
    places the part is left that holds the moved direction, too: what two discs have in common. The mean is over the light
    from above, `towards` its zenith, and from further than `head` degrees from there.
    """
    height = seen.direction @ np.asarray(towards, dtype=float)
    light = np.where((height > 0) & (height < math.cos(math.radians(head))), seen.weight * seen.area, 0) / seen.area_total
    gone = light * (1 - common(np.linalg.norm(by, axis=1) / math.radians(lamp)))
    exact, *groups = (np.bincount(seen.group, part, minlength=seen.groups + 1) for part in (light, gone))
    return _ratio(exact, groups[0], seen.untraced, seen.residue)


def common(apart: ArrayLike) -> _Reals:
    """The part that two equal discs have in common, `apart` of their diameter from each other."""
    a = np.minimum(apart, 1.0)
    return 2 / math.pi * (np.arccos(a) - a * np.sqrt(1 - a**2))


def _ratio(light: _Reals, part: _Reals, untraced: float, residue: float) -> LightReturn:
    """Of sums that begin with what was traced exactly, then those of each group of the sample of what is `untraced`."""
    if not light[0] + untraced > 0:
        return LightReturn(0.0, 0.0, 0.0)
    low, high = part[0] / (light[0] + untraced), min(1.0, (part[0] + untraced) / (light[0] + untraced))
    total, count = float(light.sum()), light.size - 1
    value = min(max(float(part.sum()) / total if total > 0 else 0.0, low), high)
    bound = float(max(high - value, value - low))
    if not count or not total > 0:
        return LightReturn(value, bound, bound)
    error = spread(part[1:] - value * light[1:])
    return LightReturn(value, bound, min(bound, (error + residue) / total))
