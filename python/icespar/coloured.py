"""The cutter's numbers of a coloured stone in white light: those of each wavelength, weighted by how bright the light is there."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ._core import illuminant as spectrum_of
from ._core import observer
from .gem import Gem
from .performance import Number, Numbers, frame_of, numbers, percent, sure
from .views import view

FIRST, LAST = 400.0, 720.0  #: nm; what of the light lies beyond counts there

_Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Coloured:
    """The numbers of a stone with its colour, in one view."""

    wavelengths_nm: list[float]
    weights: list[float]  #: of each wavelength in the luminance; their sum is 1
    by_wavelength: list[Numbers]  #: parts of the light of each wavelength
    #: Parts of the luminance. Errors hold what the choice of wavelengths may do: half of by how much every other one would
    #: say it differently; bounds hold all of that.
    luminous: Numbers


def coloured(
    gem: Gem, tilt: tuple[float, float] = (0.0, 0.0), step_nm: float = 5.0, error: float = 1e-4, illuminant: str = "D65"
) -> Coloured:
    """Traces a gem with its absorption and its indices at wavelengths from 400 to 720 nm, `step_nm` apart or a little less.

    Light is white: the sky has the spectrum of the `illuminant`. Between wavelengths numbers are taken to be linear. `error` is
    the standard error that is asked of the samples of all wavelengths together.
    """
    if not 0.1 <= step_nm <= LAST - FIRST:
        raise ValueError(f"step_nm: {step_nm!r} is not between 0.1 and {LAST - FIRST:g}")
    at = np.linspace(FIRST, LAST, 1 + 2 * math.ceil((LAST - FIRST) / (2 * step_nm)))
    weights, coarse = _weights(at, illuminant), np.zeros(at.size)
    coarse[::2] = _weights(at[::2], illuminant)
    each = error / math.sqrt(float(np.sum(weights**2)))
    frame = frame_of(tilt)
    found = []
    for i, nm in enumerate(at.tolist()):
        seen = view(
            gem.stone,
            gem.medium(nm),
            direction=-frame[2],
            up=frame[1],
            absorption=gem.absorption(nm),
            bound=None,
            error=each,
            seed=i,
            table_error=True,
        )
        seen_numbers = numbers(seen, frame[2])
        passed = percent(seen.light_return(lambda d: np.ones(len(d))))
        found.append({**seen_numbers, "absorbed": passed._replace(value=100 - passed.value)})
    luminous = {}
    for name in found[0]:
        value, bound, deviation = np.array([one[name] for one in found]).T
        rule = abs(float((weights - coarse) @ value))
        chance = float(np.linalg.norm(weights * deviation))
        luminous[name] = Number(float(weights @ value), sure(float(weights @ bound), chance) + rule, math.hypot(chance, 0.5 * rule))
    return Coloured(at.tolist(), weights.tolist(), found, luminous)


def _weights(at: _Reals, illuminant: str) -> _Reals:
    """The part of the luminance that linear interpolation gives each wavelength."""
    fine = np.arange(380.0, 780.5)
    bright = observer(fine)[:, 1] * spectrum_of(illuminant, fine)
    parts = np.array([np.interp(fine, at, one) @ bright for one in np.eye(at.size)])
    return parts / parts.sum()
