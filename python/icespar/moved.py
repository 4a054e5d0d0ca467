"""How much of the light that a stone returns comes from elsewhere in another view."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .views import LightReturn, View

_Reals = NDArray[np.float64]
_PLACES = 4  # of the grid of patches, along each of its sides


def moved(a: View, b: View, towards_a: ArrayLike, towards_b: ArrayLike, side: float, head: float) -> LightReturn:
    """The part of the light from above that comes by another facet, or from another patch of sky, in `b` than in `a`.

    Patches are squares of `side` degrees on the equal-area map of the sky as the viewer has it; the part is the mean over
    16 places of their grid. `towards_a` and `towards_b` have the viewer's right, up and towards as rows. Light from within
    `head` degrees of the zenith is left out.

    A sample makes the differences too large on average, since chance, too, moves light. With the sign of each difference
    from all groups of the sample but one, and its size from that one, they are too small on average. The value is the middle
    of both, less what half the sample says too much, as far as the rest of that error goes with one over the sample's size
    (jackknife). `error` is what was taken off, an eighth of what is between the two, and besides one standard error.
    """
    light = _Light.of(a, towards_a, side, head, 1).with_other(_Light.of(b, towards_b, side, head, -1))
    rest = a.untraced + b.untraced
    groups = max(a.groups, b.groups)
    totals = light.totals(groups)
    exact = float(totals[0])
    if not exact + rest > 0:
        return LightReturn(0.0, 0.0, 0.0)
    squares = light.by_square(groups)
    places = [squares.differences(shift) for shift in np.ndindex(_PLACES, _PLACES)]
    found = float(np.mean([place.exact for place in places]))
    low, high = max(0.0, (found - rest) / (exact + rest)), min(1.0, (found + rest) / (exact + rest))
    total = float(totals.sum())
    if not groups or not total > 0:
        value = min(max(found / exact if exact > 0 else 0.0, low), high)
        bound = max(high - value, value - low)
        return LightReturn(value, bound, bound)
    # Groups stand for one another: each is left out in turn (jackknife), its place taken by the mean of the others.
    without = exact + (total - exact - totals[1:]) * groups / (groups - 1)
    most, least, half = (np.mean([getattr(place, name) for place in places], axis=0) for name in ("most", "least", "half"))
    upper, lower = float(most[0] / total), float(np.sum(least) / total)
    upper_error = math.sqrt((groups - 1) ** 2 / groups * np.var(most[1:] / without, ddof=1))
    lower_error = math.sqrt(groups * np.var(least / total, ddof=1))
    middle = 0.5 * (upper + lower)
    excess = float(half / total) - middle
    value = min(max(middle - excess, low), high)
    bound = max(high - value, value - low)
    error = abs(excess) + abs(upper - lower) / 8 + max(upper_error, lower_error) + (a.residue + b.residue) / total
    return LightReturn(value, bound, min(bound, float(error)))


@dataclass(frozen=True)
class _Differences:
    """For one place of the grid, summed over its patches."""

    exact: float  #: of what was followed exactly
    most: _Reals  #: of all groups, then of all but each
    least: _Reals  #: a part from each group, with the signs that the others say
    half: float  #: the middle of both from half the sample, the mean of its two halves


@dataclass(frozen=True)
class _Light:
    """Light from squares of a quarter of a patch's side, by the facet and the group it comes by."""

    square: NDArray[np.int64]  #: two numbers on the map, and a facet, (3, N)
    group: NDArray[np.int32]
    amount: _Reals  #: of the stone's face; of the other view less than 0

    @classmethod
    def of(cls, seen: View, towards: ArrayLike, side: float, head: float, sign: int) -> "_Light":
        d = seen.direction @ np.asarray(towards, dtype=float).T
        keep = (d[:, 2] > 0) & (d[:, 2] < math.cos(math.radians(head)))
        d = d[keep]
        place = d[:, :2] * np.sqrt(2 / (1 + d[:, 2:])) * (_PLACES / math.radians(side))
        square = np.vstack([np.floor(place).astype(np.int64).T, seen.entry[keep]])
        return cls(square, seen.group[keep], sign * (seen.weight * seen.area)[keep] / seen.area_total)

    def with_other(self, other: "_Light") -> "_Light":
        return _Light(
            np.hstack([self.square, other.square]),
            np.concatenate([self.group, other.group]),
            np.concatenate([self.amount, other.amount]),
        )

    def totals(self, groups: int) -> _Reals:
        """From above: what was followed exactly, and of each group."""
        return np.bincount(self.group, np.abs(self.amount), minlength=groups + 1)

    def by_square(self, groups: int) -> "_Squares":
        x, y, entry = self.square
        _, first, where = np.unique((x * 16384 + y) * 4096 + entry, return_index=True, return_inverse=True)
        traced = self.group == 0
        exact = np.bincount(where[traced], self.amount[traced], minlength=first.size)
        return _Squares(
            self.square[:, first], exact, where[~traced], self.group[~traced] - 1, self.amount[~traced], groups
        )


@dataclass(frozen=True)
class _Squares:
    """The same, added up where it was followed exactly."""

    square: NDArray[np.int64]
    exact: _Reals
    where: NDArray[np.int64]  #: the square of each part of the sample
    group: NDArray[np.int32]
    amount: _Reals
    groups: int

    def differences(self, shift: tuple[int, ...]) -> _Differences:
        (x, y, entry), groups = self.square, self.groups
        _, patch = np.unique(
            ((x + shift[0]) // _PLACES * 4096 + (y + shift[1]) // _PLACES) * 4096 + entry, return_inverse=True
        )
        count = int(patch.max()) + 1 if patch.size else 0
        exact = np.bincount(patch, self.exact, minlength=count)
        if not groups:
            return _Differences(np.abs(exact).sum(), np.zeros(0), np.zeros(0), 0.0)
        parts = np.bincount(patch[self.where] * groups + self.group, self.amount, minlength=count * groups)
        found, halves = (parts.reshape(count, n, groups // n).sum(axis=2) for n in (1, 2))
        # Most groups have found nothing in most patches: only what they have is kept.
        met = np.flatnonzero(parts)
        in_patch, of_group = np.divmod(met, groups)
        part = parts[met]
        scale = groups / (groups - 1)
        others = exact + scale * found[:, 0]
        without = others[in_patch] - scale * part

        def by_group(values: _Reals) -> _Reals:
            return np.bincount(of_group, values, minlength=groups)

        most = np.abs(others).sum() + by_group(np.abs(without) - np.abs(others)[in_patch])
        share = exact / groups
        signs = np.sign(others)
        least = (signs * share).sum() + by_group(
            np.sign(without) * (share[in_patch] + part) - (signs * share)[in_patch]
        )
        of_all = np.abs(exact + found[:, 0]).sum()
        half = exact[:, None] + 2 * halves
        half_middle = 0.25 * float((np.sign(half) * (half + half[:, ::-1])).sum())
        return _Differences(np.abs(exact).sum(), np.concatenate([[of_all], most]), least, half_middle)
