"""Plane waves of a medium, and light at a plane face between two: all waves, exactly.

Vectors have the shape (3,) or (N, 3), right-handed; answers have N rows, also when N is 1. Directions and
normals broadcast against each other. Media, `by` and `mode` are one for a call and do not.
Angles are in radians.
"""

import os
from collections.abc import Collection
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import directions, pointing, require_memory, rows_of
from ._core import Medium

_MODES = {
    "s": _core.Mode.s,
    "p": _core.Mode.p,
    "o": _core.Mode.o,
    "e": _core.Mode.e,
    "fast": _core.Mode.fast,
    "slow": _core.Mode.slow,
    "ordinary": _core.Mode.o,
    "extraordinary": _core.Mode.e,
}

_BYTES_A_RAY = 1300  # of `interface`, its arguments among them


@dataclass(frozen=True)
class Modes:
    """Both waves of N directions: s and p, o and e, or fast and slow, along the second axis."""

    k: NDArray[np.complex128]  #: wave vectors in units of w/c, (N, 2, 3); complex where it absorbs
    ray: NDArray[np.float64]  #: unit directions of the energy flow, (N, 2, 3)
    E: NDArray[np.complex128]  #: electric fields of unit Hermitian norm, (N, 2, 3)
    D: NDArray[np.complex128]  #: -k x H, (N, 2, 3)
    H: NDArray[np.complex128]  #: k x E, and i alpha E more in an active medium, (N, 2, 3)
    n_phase: NDArray[np.float64]  #: |Re k|, (N, 2)
    n_ray: NDArray[np.float64]  #: Re k . ray, (N, 2)
    walk_off: NDArray[np.float64]  #: angle between wave normal and ray, (N, 2)
    mode: NDArray[np.str_]  #: names, (N, 2)


@dataclass(frozen=True)
class Incident:
    """The wave that meets the face; N rays. Arrays left out by `only` are None."""

    k: NDArray[np.float64] | NDArray[np.complex128]  #: wave vector in units of w/c, (N, 3); complex where medium1 absorbs
    ray: NDArray[np.float64]  #: unit direction of the energy flow, (N, 3)
    E: NDArray[np.complex128]  #: electric field of unit Hermitian norm, (N, 3)
    H: NDArray[np.complex128]  #: k x E, and i alpha E more in an active medium, (N, 3)
    n_phase: NDArray[np.float64]  #: |Re k|, (N,)
    n_ray: NDArray[np.float64]  #: Re k . ray, (N,)
    mode: NDArray[np.str_]  #: 's', 'p', 'o', 'e', 'fast' or 'slow', (N,)


@dataclass(frozen=True)
class Outgoing:
    """Both waves that leave the face on one side: s and p, o and e, or fast and slow, along the second axis.

    An evanescent wave has complex k, `power` 0 and `propagating` False. `amplitude` times `E` is the
    field that an incident E of norm 1 makes. Each wave's fields are ill-defined where the two waves
    become one (optic axes, merging evanescent waves); `total`, `E_total` and `H_total` never are.
    Arrays left out by `only` are None.
    """

    k: NDArray[np.complex128]  #: wave vectors in units of w/c, (N, 2, 3)
    ray: NDArray[np.float64]  #: unit directions of the energy flow, (N, 2, 3)
    E: NDArray[np.complex128]  #: electric fields of unit Hermitian norm, (N, 2, 3)
    H: NDArray[np.complex128]  #: k x E, and i alpha E more in an active medium, (N, 2, 3)
    amplitude: NDArray[np.complex128]  #: amplitude of E, (N, 2)
    power: NDArray[np.float64]  #: part of the incident normal energy flow, (N, 2)
    n_phase: NDArray[np.float64]  #: |Re k|, (N, 2)
    n_ray: NDArray[np.float64]  #: Re k . ray, (N, 2)
    propagating: NDArray[np.bool_]  #: False: evanescent, (N, 2); True for all waves of an absorbing medium
    mode: NDArray[np.str_]  #: names, (N, 2)
    total: NDArray[np.float64]  #: both waves' normal flow at the face over the incident one, (N,); where the medium absorbs the two interfere, and it is not the sum of their powers
    E_total: NDArray[np.complex128]  #: sum of both electric fields at the face, (N, 3)
    H_total: NDArray[np.complex128]  #: sum of both magnetic fields at the face, (N, 3)


_ARRAYS = {name for name in Outgoing.__dataclass_fields__ if name != "mode"}


@dataclass(frozen=True)
class Interface:
    """What `interface` found: the incident wave and what it becomes."""

    incident: Incident
    reflected: Outgoing
    transmitted: Outgoing

    @property
    def reflected_total(self) -> NDArray[np.float64]:
        """`reflected.total`, (N,)."""
        return self.reflected.total

    @property
    def transmitted_total(self) -> NDArray[np.float64]:
        """`transmitted.total`, (N,): with a transparent medium1, reflected and transmitted total add to 1."""
        return self.transmitted.total


def interface(
    medium1: Medium,
    medium2: Medium,
    normal: ArrayLike,
    direction: ArrayLike,
    by: Literal["wave_normal", "ray"] = "wave_normal",
    *,
    mode: Literal["s", "p", "o", "e", "ordinary", "extraordinary", "fast", "slow"],
    only: Collection[str] | None = None,
    threads: int | None = None,
    precision: Literal["double", "single"] = "double",
) -> Interface:
    """The plane wave of `mode` in `medium1`, along `direction`, meets a plane face of `medium2`.

    `normal` points from medium1 to medium2. `normal` and `direction` have the shape (3,) or (N, 3), any
    length but 0, and broadcast over N rays; for one ray N is 1. Coordinates are right-handed.
    `by` says what `direction` is: the wave normal (along k), or the ray (along the energy flow; not known
    in absorbing and active media). The two media, `by` and `mode` are the same for all rays.
    Modes of an isotropic medium1 are 's' (E along normal x k) and 'p', of a uniaxial one 'o' and 'e', of a
    biaxial or active one 'fast' (the smaller index for its wave normal; where it absorbs, the smaller
    Re n^2) and 'slow'.

    The problem is solved exactly: tangential k is conserved, tangential E and H match. For lossless media
    the four powers add up to 1.

    `only` names the arrays that are wanted, such as {"power", "ray"}: the others are None, and cost
    neither time nor memory. `threads` bounds the processors at work; all, if None. They change no bit.
    `precision` "single" computes isotropic and uniaxial media in single precision, faster and good to
    about 1e-6 where an input's last digit decides nothing; arrays stay double, docs/accuracy.md shows both.

    Raises ValueError, which names the argument and its element, for a zero or non-finite vector, shapes
    that do not broadcast, a mode that the medium has not, a name in `only` that is none, and a wave whose
    energy leaves the face.
    """
    for name, medium in (("medium1", medium1), ("medium2", medium2)):
        if not isinstance(medium, Medium):
            raise TypeError(f"{name}: an icespar.Medium is needed, not {type(medium).__name__}")
    core_by, core = core_mode(medium1, by, mode)
    names = _wanted(only)
    if precision not in ("double", "single"):
        raise ValueError(f"precision: 'double' or 'single' is needed, not {precision!r}")
    if threads is not None and threads < 1:
        raise ValueError(f"threads: {threads} is not a positive number; leave it out to use all processors")
    vectors = {"normal": pointing("normal", normal), "direction": pointing("direction", direction)}
    count = rows_of(**vectors)
    require_memory("direction", count, _BYTES_A_RAY if only is None else 100 * (1 + len(names)))
    n, d = (np.atleast_2d(array) for array in vectors.values())
    incident, reflected, transmitted = _core.solve_interface(
        medium1, medium2, n, d, core_by, core, names, threads or os.cpu_count() or 1, precision == "single"
    )
    if "k" in names and not medium1.absorbing:
        incident["k"] = incident["k"].real.copy()
    none = dict.fromkeys(_ARRAYS - names)
    lacking = {name: None for name in none if name in Incident.__dataclass_fields__}
    return Interface(
        Incident(mode=np.broadcast_to(core.name, count), **incident, **lacking),
        Outgoing(mode=np.broadcast_to(names_of_modes(medium1), (count, 2)), **reflected, **none),
        Outgoing(mode=np.broadcast_to(names_of_modes(medium2), (count, 2)), **transmitted, **none),
    )


def _wanted(only: Collection[str] | None) -> set[str]:
    """The names of arrays that `only` asks for; ValueError for one that is none."""
    if only is None:
        return set(_ARRAYS)
    names = {only} if isinstance(only, str) else set(only)
    if unknown := names - _ARRAYS:
        raise ValueError(f"only: {sorted(unknown, key=repr)[0]!r} is not an array of the answer; choose from {', '.join(sorted(_ARRAYS))}")
    return names


def modes(medium: Medium, direction: ArrayLike, by: Literal["wave_normal", "ray"] = "wave_normal") -> Modes:
    """Both waves of the medium for each direction, (3,) or (N, 3), of any length but 0.

    `by` "wave_normal": the waves whose k points there. In an isotropic medium every polarisation is a
    solution, and a fixed pair stands for all; so does one along an optic axis.
    `by` "ray": all the waves whose energy flows there, each with its own wave normal `k`. A biaxial
    crystal can answer with two slow waves (inside the cone of internal conical refraction); along a
    biradial a whole cone of wave normals answers, and two of them are given. In absorbing media the
    waves are homogeneous and their mean energy flow has the direction. Absorbing and active media have
    more than two such waves for some rays beside their optic axes: the two that continue those of the
    transparent crystal are given.

    Raises ValueError, which names the argument and its element, for a zero or non-finite direction.
    """
    d = np.atleast_2d(directions("direction", direction))
    core_by = _by(by)
    require_memory("direction", len(d), _BYTES_A_RAY)
    waves = _core.waves(medium, d, core_by)
    k, ray = waves["k"].real, waves["ray"]
    across = np.linalg.norm(np.cross(k, ray), axis=-1)
    name = np.array(names_of_modes(medium))[waves.pop("mode")]
    return Modes(mode=name, walk_off=np.arctan2(across, np.sum(k * ray, axis=-1)), **waves)


def names_of_modes(medium: Medium) -> tuple[str, str]:
    """The names of a medium's two waves."""
    if medium.symmetry == "biaxial" or medium.active:
        return "fast", "slow"
    return ("o", "e") if medium.birefringent else ("s", "p")


def core_mode(medium1: Medium, by: str, mode: str | None) -> tuple[_core.By, _core.Mode]:
    """What the C++ module calls them; ValueError for a mode that medium1 has not."""
    fitting = names_of_modes(medium1)
    found = _MODES.get(mode) if isinstance(mode, str) else None
    if found is None or found.name not in fitting:
        kind = "active" if medium1.active else medium1.symmetry
        raise ValueError(f"mode: {mode!r} is not a mode of {kind} medium1; it has {fitting[0]!r} and {fitting[1]!r}")
    return _by(by), found


def _by(by: str) -> _core.By:
    if by not in ("wave_normal", "ray"):
        raise ValueError(f"by: {by!r} is neither 'wave_normal' nor 'ray'")
    return _core.By.__members__[by]


Medium.modes = modes
