"""Light at a plane face between two media: both reflected and both transmitted waves, exactly."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import directions, together
from ._core import Medium

_MODES = {
    "s": _core.Mode.s,
    "p": _core.Mode.p,
    "o": _core.Mode.o,
    "e": _core.Mode.e,
    "ordinary": _core.Mode.o,
    "extraordinary": _core.Mode.e,
}


@dataclass(frozen=True)
class Incident:
    """The wave that meets the face; N rays. It propagates, so its wave vector is real."""

    k: NDArray[np.float64]  #: wave vector in units of w/c, (N, 3)
    ray: NDArray[np.float64]  #: unit direction of the energy flow, (N, 3)
    E: NDArray[np.complex128]  #: electric field of unit Hermitian norm, (N, 3)
    H: NDArray[np.complex128]  #: k x E, (N, 3)
    n_phase: NDArray[np.float64]  #: |k|, (N,)
    n_ray: NDArray[np.float64]  #: k . ray, (N,)
    mode: NDArray[np.str_]  #: 's', 'p', 'o' or 'e', (N,)


@dataclass(frozen=True)
class Outgoing:
    """Both waves that leave the face on one side: s and p, or o and e, along the second axis.

    An evanescent wave has complex k, `power` 0 and `propagating` False. `amplitude` times `E` is the
    field that an incident E of norm 1 makes.
    """

    k: NDArray[np.complex128]  #: wave vectors in units of w/c, (N, 2, 3)
    ray: NDArray[np.float64]  #: unit directions of the energy flow, (N, 2, 3)
    E: NDArray[np.complex128]  #: electric fields of unit Hermitian norm, (N, 2, 3)
    H: NDArray[np.complex128]  #: k x E, (N, 2, 3)
    amplitude: NDArray[np.complex128]  #: amplitude of E, (N, 2)
    power: NDArray[np.float64]  #: part of the incident normal energy flow, (N, 2)
    n_phase: NDArray[np.float64]  #: |Re k|, (N, 2)
    n_ray: NDArray[np.float64]  #: Re k . ray, (N, 2)
    propagating: NDArray[np.bool_]  #: False: evanescent, (N, 2)
    mode: NDArray[np.str_]  #: 's' and 'p', or 'o' and 'e', (N, 2)


@dataclass(frozen=True)
class Interface:
    """What `interface` found: the incident wave and what it becomes."""

    incident: Incident
    reflected: Outgoing
    transmitted: Outgoing


def interface(
    medium1: Medium,
    medium2: Medium,
    normal: ArrayLike,
    direction: ArrayLike,
    by: Literal["wave_normal", "ray"] = "wave_normal",
    *,
    mode: Literal["s", "p", "o", "e", "ordinary", "extraordinary"],
) -> Interface:
    """The plane wave of `mode` in `medium1`, along `direction`, meets a plane face of `medium2`.

    `normal` points from medium1 to medium2. `normal` and `direction` have the shape (3,) or (N, 3), any
    length but 0, and broadcast over N rays; for one ray N is 1. Coordinates are right-handed.
    `by` says what `direction` is: the wave normal (along k), or the ray (along the energy flow).
    Modes of an isotropic medium1 are 's' (E along normal x k) and 'p', of a uniaxial one 'o' and 'e'.

    The problem is solved exactly: tangential k is conserved, tangential E and H match. For lossless media
    the four powers add up to 1.

    Raises ValueError, which names the argument and its element, for a zero or non-finite vector, shapes
    that do not broadcast, a mode that the medium has not, and a wave whose energy leaves the face.
    """
    for name, medium in (("medium1", medium1), ("medium2", medium2)):
        if not isinstance(medium, Medium):
            raise TypeError(f"{name}: an icespar.Medium is needed, not {type(medium).__name__}")
    if by not in ("wave_normal", "ray"):
        raise ValueError(f"by: {by!r} is neither 'wave_normal' nor 'ray'")
    fitting = ("o", "e") if medium1.birefringent else ("s", "p")
    core_mode = _MODES.get(mode) if isinstance(mode, str) else None
    if core_mode is None or core_mode.name not in fitting:
        kind = "uniaxial" if medium1.birefringent else "isotropic"
        raise ValueError(f"mode: {mode!r} is not a mode of {kind} medium1; it has {fitting[0]!r} and {fitting[1]!r}")

    n, d = together(normal=directions("normal", normal), direction=directions("direction", direction))
    incident, reflected, transmitted = _core.solve_interface(
        medium1, medium2, n, d, _core.By.__members__[by], core_mode
    )
    return Interface(
        Incident(mode=np.full(len(n), core_mode.name), **incident),
        Outgoing(mode=_pair(medium1, len(n)), **reflected),
        Outgoing(mode=_pair(medium2, len(n)), **transmitted),
    )


def _pair(medium: Medium, n: int) -> NDArray[np.str_]:
    return np.tile(np.array(["o", "e"] if medium.birefringent else ["s", "p"]), (n, 1))
