"""What a stone returns of the light around it to one who looks from afar: sums over exact beams, each with its bound and error."""

import math
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Error, Medium, Mineral, Stone
from .minerals import mineral

_Reals = NDArray[np.float64]
Light = Literal["iso", "cosine", "sc2"]

# GemRay 1.2 averages s and p at every face, follows a ray through ten faces, and drops it when a face
# that part of it leaves by has sent on less than a thousandth.
_GEMRAY = {"weights": _core.Weights.averaged, "max_hits": 10, "least_power": 1e-3}


class LightReturn(NamedTuple):
    """A mean radiance. The truth is never further than `bound` from `value`, and within about two `error` of it."""

    value: float
    bound: float  #: the part of the light that was not followed exactly
    error: float  #: one standard error of the sample of that part; the bound, if it was not sampled and is left out


class View:
    """Where the light came from that a stone sends along one direction; what `view` returns.

    Light is N beams. Each has left the stone in one direction with one weight, over a polygon of the picture. Those of the
    sample (`group` above 0) have the weight of all for which they stand: sums over all beams are right on average.
    """

    def __init__(self, stone: Stone, medium: Medium, towards: ArrayLike, exits: _core.Exits, polarised: bool) -> None:
        self.stone, self.medium = stone, medium
        self._exits, self._polarised = exits, polarised
        self._all: _core.Exits | None = None
        self._zenith = -np.asarray(towards, float)

    @property
    def _full(self) -> _core.Exits:
        """Every beam, where `_exits` holds one for all images of a symmetric view."""
        if self._all is None:
            self._all = self._exits.expanded()
        return self._all

    @property
    def direction(self) -> _Reals:
        """Where each beam comes from: unit vectors away from the stone, (N, 3)."""
        return self._full.direction

    @property
    def fan(self) -> _Reals:
        """By how much each direction moves, to first order, with the change `fan` of the permittivity, (N, 3)."""
        return self._full.fan

    @property
    def turned(self) -> _Reals:
        """By how much it moves per radian as the line of sight turns to picture-right, and to picture-up, (N, 2, 3)."""
        return self._full.turned

    @property
    def weight(self) -> _Reals:
        """What the viewer sees of unpolarised light of radiance 1 from there: (N,), or its Stokes vectors (N, 4)."""
        return self._full.weight if self._polarised else self._full.weight[:, 0]

    @property
    def area(self) -> _Reals:
        """Of each beam in the picture, in the stone's units squared, (N,)."""
        return self._full.area

    @property
    def entry(self) -> NDArray[np.int32]:
        """The facet that the viewer sees each beam in, (N,)."""
        return self._full.entry

    @property
    def facet(self) -> NDArray[np.int32]:
        """The facet on the other side of which each beam's light is, (N,)."""
        return self._full.facet

    @property
    def hits(self) -> NDArray[np.int32]:
        """Faces each beam has met, the first and the last included; 1: mirrored by the outside, (N,)."""
        return self._full.hits

    @property
    def group(self) -> NDArray[np.int32]:
        """0 for a beam that was followed exactly; else the number of its group in the sample of the rest, (N,).

        The groups 2 n - 1 and 2 n, up to `groups`, are alike but for chance: how the sums of a pair differ tells the error
        of a sum over all.
        """
        return self._full.group

    @property
    def groups(self) -> int:
        """Groups of the sample; 0 where nothing was left to sample, or no error was asked for."""
        return self._exits.groups

    @property
    def images(self) -> _Reals:
        """Turns and mirrors of the picture's right and up that leave stone, crystal and view as they are, (G, 2, 2)."""
        return self._exits.images

    @property
    def facet_area(self) -> _Reals:
        """Of each facet of the stone in the picture, 0 where it is not seen, (F,)."""
        return self._exits.entry_area

    @property
    def area_total(self) -> float:
        """Of the stone in the picture."""
        return self._exits.area_total

    @property
    def untraced(self) -> float:
        """The part of all light that was not followed exactly: it bounds the error of every number."""
        return self._exits.untraced / self._exits.area_total

    @property
    def residue(self) -> float:
        """The part of all light that is missing from the beams: all that is untraced, or next to nothing after a sample."""
        return self._exits.residue / self._exits.area_total

    @property
    def cut(self) -> float:
        """The part of all light that `max_hits` or `cutoff` left out on purpose."""
        return self._exits.cut / self._exits.area_total

    @property
    def absorbed(self) -> float:
        """The part of all light that the stone kept."""
        return self._exits.absorbed / self._exits.area_total

    @property
    def beams(self) -> int:
        """How many were followed from one facet to the next; images in a symmetric view are not counted."""
        return self._exits.beams

    def light_return(
        self,
        light: Light | Callable[[_Reals], ArrayLike] = "iso",
        *,
        head_shadow: float = 10.0,
        table: bool = False,
        zenith: ArrayLike | None = None,
        greatest: float = 1.0,
    ) -> LightReturn:
        """Mean radiance of the stone in this view, or of its table alone, under a light around it.

        Named lights are 1 ("iso"), d ("cosine") or 2 d sqrt(1 - d^2) ("sc2") at height d above the horizon, but for the
        head of the viewer: `head_shadow` degrees from the zenith to its edge, 0 for none. The zenith is at the viewer
        unless another is given. Any other light is a function of unit directions (N, 3) that returns radiances (N,) from
        0 to `greatest`; it makes its own shadow.
        """
        facet = None
        if table:
            facet = _core.table_facet(self.stone)
            if facet is None:
                raise Error("this stone has no table: no facet points along +z; leave table out")
        if isinstance(light, str):
            dome = _core.Dome.__members__.get(light)
            if dome is None:
                raise Error(f"no light is called {light!r}; there are {', '.join(_core.Dome.__members__)}, or give a function")
            if not 0 <= head_shadow <= 90:
                raise Error("head_shadow: 0 to 90 degrees")
            up = self._zenith if zenith is None else np.asarray(zenith, float)
            if not 0 < np.linalg.norm(up) < math.inf:
                raise Error("zenith: a direction is not 0")
            return LightReturn(*_core.light_return(self._exits, dome, up, math.radians(head_shadow), facet))
        radiance = np.asarray(light(self.direction), float)
        if radiance.shape != self.area.shape:
            raise Error(f"a light must return one number for each direction, {self.area.shape}, not {radiance.shape}")
        light = self._full.weight[:, 0] * self.area
        area, untraced = self.area_total, self._exits.untraced
        if facet is not None:
            light = np.where(self.entry == facet, light, 0)
            area, untraced = self.facet_area[facet], self._exits.entry_untraced[facet]
        if not area > 0:
            return LightReturn(0.0, 0.0, 0.0)
        exact, *groups = np.bincount(self.group, radiance * light, minlength=self.groups + 1)
        bound = float(greatest * untraced / area)
        if not groups:
            return LightReturn(float(exact / area), bound, bound)
        # What no path of the sample met may be there once.
        path = len(self.images) * light.max(initial=0.0, where=self.group > 0)
        error = math.hypot(spread(groups), greatest * path) + greatest * self._exits.residue
        value = exact + min(sum(groups), greatest * untraced)
        return LightReturn(float(value / area), bound, min(bound, float(error / area)))

    def __repr__(self) -> str:
        return f"<View of {self.stone!r}, untraced {self.untraced:.2g}>"


def spread(groups: Sequence[float] | _Reals) -> float:
    """One standard error of the sum over all groups of a sample, from how the two of each pair differ."""
    return float(np.linalg.norm(np.subtract(groups[::2], groups[1::2])))


def _medium(material: Medium | Mineral | str, wavelength_nm: float, axis: ArrayLike | None, axes: ArrayLike | None) -> Medium:
    if isinstance(material, Medium):
        if axis is not None or axes is not None:
            raise Error("a Medium has its axes already; give axis or axes with a mineral only")
        return material
    found = mineral(material) if isinstance(material, str) else material
    return found.medium(wavelength_nm, axis, axes)


def view(
    stone: Stone,
    material: Medium | Mineral | str,
    *,
    direction: ArrayLike = (0, 0, -1),
    up: ArrayLike = (0, 1, 0),
    wavelength_nm: float = 589.3,
    axis: ArrayLike | None = None,
    axes: ArrayLike | None = None,
    colour: str | None = None,
    absorption: ArrayLike | None = None,
    bound: float | None = 1e-3,
    error: float | None = 1e-4,
    max_beams: int = 2_000_000,
    time: float | None = None,
    seed: int = 0,
    max_hits: int | None = None,
    stokes: bool = False,
    cutoff: Literal["gemray"] | None = None,
    fan: ArrayLike | None = None,
    turns: bool = False,
    table_error: bool = False,
) -> View:
    """A stone seen along one direction from afar, by exact beams: every path through it is a polygon of the picture with
    one direction and one weight.

    The heaviest beams are followed first, until no more than `bound` of all light is left, or `max_beams` or `time`
    (seconds) are used up; what is left bounds the error of every number. It is then sampled (by paths of single rays), so
    that sums of radiances from 0 to 1 have about the standard error `error`, but for no longer than the exact part took. None as
    the bound ends that part when sampling the rest to `error` takes about as long; None as the error samples nothing, so that
    the truth lies between each value and value + bound. A mineral is taken at `wavelength_nm`, with its optic
    axis or axes as in `Mineral.medium`. The stone is clear, unless it has a `colour` of `Mineral.colours`, or an `absorption`
    per unit of length (a colour's is per mm) for light polarised along each principal axis: one number, two (across the
    optic axis, along it), or three by rising index; a beam's weight is then its mean. `max_hits` ends each path after so many faces.
    `stokes` keeps the polarisation. `fan`, a change of the permittivity (3, 3), and `turns` keep how directions move with that
    and with the line of sight. `table_error` asks for the error of the table alone, too. `cutoff="gemray"` traces as GemRay 1.2 does (no polarisation, ten faces, nothing below
    a thousandth), for comparison with its numbers; isotropic stones only.
    """
    if cutoff not in (None, "gemray"):
        raise Error(f"no cutoff is called {cutoff!r}; there is 'gemray'")
    if cutoff and (stokes or max_hits is not None):
        raise Error("cutoff settles stokes and max_hits; leave them out")
    weights = _core.Weights.stokes if stokes else _core.Weights.intensity
    rules = {"weights": weights, "max_hits": max_hits or 0, "least_power": 0.0}
    medium = _medium(material, wavelength_nm, axis, axes)
    if colour is not None:
        if absorption is not None or isinstance(material, Medium):
            raise Error("colour is one of a mineral's; give absorption alone for others")
        found = mineral(material) if isinstance(material, str) else material
        absorption = found.absorption(colour, wavelength_nm)
    exits = _core.trace_view(
        stone,
        medium,
        direction=direction,
        up=up,
        bound=bound,
        error=error or 0.0,
        max_beams=max_beams,
        seconds=time or 0.0,
        seed=seed,
        absorption=[] if absorption is None else np.atleast_1d(np.asarray(absorption, float)).tolist(),
        fan=None if fan is None else np.asarray(fan, float),
        turns=turns,
        error_of=_core.table_facet(stone) if table_error else None,
        **(_GEMRAY if cutoff else rules),
    )
    return View(stone, medium, direction, exits, stokes)


class TiltCurve(NamedTuple):
    """Light return of T tilts under L lights."""

    tilts: _Reals  #: degrees, (T,)
    value: _Reals  #: (T, L)
    bound: _Reals  #: (T, L): the truth is never further than this from value
    error: _Reals  #: (T, L): one standard error


def tilt_curve(
    stone: Stone,
    material: Medium | Mineral | str,
    tilts: ArrayLike = tuple(range(-30, 31)),
    *,
    about: Literal["x", "y"] = "x",
    lights: Sequence[Light] = ("iso", "cosine", "sc2"),
    head_shadow: float = 10.0,
    table: bool = False,
    bound: float | None = None,
    error: float | None = 5e-4,
    threads: int | None = None,
    **options: Any,
) -> TiltCurve:
    """Light return of a stone whose table (+z) leans from the viewer by `tilts` degrees, turned about x or y of the design
    as a right-hand screw (as GemRay does); lights and head stay with the viewer. `options` are those of `view`; tilts share
    the processor's threads."""
    if about not in ("x", "y"):
        raise Error(f"about: 'x' or 'y', not {about!r}")
    if wrong := {"direction", "up"} & options.keys():
        raise Error(f"{' and '.join(sorted(wrong))} follow from the tilt; leave them out")

    def at(tilt: float) -> list[LightReturn]:
        s, c = math.sin(math.radians(tilt)), math.cos(math.radians(tilt))
        direction, up = ((0, -s, -c), (0, c, -s)) if about == "x" else ((s, 0, -c), (0, 1, 0))
        seen = view(stone, material, direction=direction, up=up, bound=bound, error=error, **options)
        return [seen.light_return(light, head_shadow=head_shadow, table=table) for light in lights]

    angles = np.atleast_1d(np.asarray(tilts, float))
    with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        numbers = np.array(list(pool.map(at, angles.tolist()))).reshape(angles.size, len(lights), 3)
    return TiltCurve(angles, *np.moveaxis(numbers, 2, 0))
