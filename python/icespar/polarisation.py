"""The algebra of polarised light: Stokes vectors, Mueller and Jones matrices.

Frames and signs are those of docs/conventions.md: a receiver looks back at the source, x is right, y up, z
along the light; S1 > 0 lies along x, S2 > 0 at +45 degrees from x towards y, S3 > 0 is right circular,
clockwise in time for the receiver, S3 = 2 Im(Ex Ey*) for fields Re[E exp(-i w t)]. Angles are in radians,
from x towards y. Arguments broadcast against each other; a Stokes vector has the shape (..., 4), a Mueller
matrix (..., 4, 4), a field (..., 2), a Jones matrix (..., 2, 2). Elements in a row multiply from the right:
`linear_polariser(b) @ linear_retarder(d, a) @ stokes`.

Numbers that are not finite or not real, and shapes that do not fit, raise ValueError with the argument's
name and the element.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import directions, together
from ._core import Medium
from .optics import core_mode

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]


def rotator(angle: ArrayLike) -> Reals:
    """Mueller matrix, (..., 4, 4), of what turns light by `angle` from x towards y (laevorotatory when > 0)."""
    return _matrices(_core.rotator, 4, angle=angle)


def linear_retarder(retardance: ArrayLike, fast_axis: ArrayLike = 0.0) -> Reals:
    """Mueller matrix of a wave plate: the slow field lies `retardance` (a phase) behind the fast one.

    Collett 1993, eq. 5-27, with our sign of S3. A quarter-wave plate with its fast axis on x turns +45
    light left circular.
    """
    return _matrices(_core.linear_retarder, 4, retardance=retardance, fast_axis=fast_axis)


def circular_retarder(retardance: ArrayLike) -> Reals:
    """Mueller matrix of what delays left circular light by `retardance`: linear light turns by half of it, clockwise."""
    return _matrices(_core.circular_retarder, 4, retardance=retardance)


def linear_polariser(axis: ArrayLike = 0.0) -> Reals:
    """Mueller matrix of an ideal polariser that passes light along `axis`."""
    return linear_diattenuator(1.0, 0.0, axis)


def circular_polariser(handedness: Literal["right", "left"]) -> Reals:
    """Mueller matrix (4, 4) of an ideal polariser that passes right, or left, circular light."""
    if handedness not in ("right", "left"):
        raise ValueError(f"handedness: {handedness!r} is neither 'right' nor 'left'")
    return _core.circular_polariser(handedness == "right")


def linear_diattenuator(along: ArrayLike, across: ArrayLike, axis: ArrayLike = 0.0) -> Reals:
    """Mueller matrix with power transmissions (0 .. 1) along `axis` and across it.

    Chipman, Lam & Young 2019, eq. 6.53. ValueError for a transmission outside 0 .. 1.
    """
    _within("along", along, 0, 1)
    _within("across", across, 0, 1)
    return _matrices(_core.linear_diattenuator, 4, along=along, across=across, axis=axis)


def depolariser(a1: ArrayLike, a2: ArrayLike | None = None, a3: ArrayLike | None = None) -> Reals:
    """Mueller matrix diag(1, a1, a2, a3), each -1 .. 1; a2 and a3 are a1 unless given.

    ValueError unless 1 +- a1 +- a2 +- a3 >= 0 as Cloude 1986 asks of anything that can be made.
    """
    a2, a3 = a1 if a2 is None else a2, a1 if a3 is None else a3
    matrices = _matrices(_core.depolariser, 4, a1=a1, a2=a2, a3=a3)
    _, x, y, z = np.moveaxis(np.diagonal(matrices, axis1=-2, axis2=-1), -1, 0)
    # The eigenvalues of the coherency matrix.
    least = np.min([1 + x + y + z, 1 + x - y - z, 1 - x + y - z, 1 - x - y + z], axis=0)
    if (bad := least < -1e-15).any():
        raise ValueError(f"{_element('a1, a2, a3', bad)}: no element does this; each must be in -1 .. 1, all alike in -1/3 .. 1")
    return matrices


def jones_rotator(angle: ArrayLike) -> Complexes:
    """Jones matrix, (..., 2, 2), of `rotator`."""
    return _matrices(_core.jones_rotator, 2, angle=angle)


def jones_linear_retarder(retardance: ArrayLike, fast_axis: ArrayLike = 0.0) -> Complexes:
    """Jones matrix of `linear_retarder`, with the phase exp(-+ i retardance / 2) along and across the fast axis."""
    return _matrices(_core.jones_linear_retarder, 2, retardance=retardance, fast_axis=fast_axis)


def jones_circular_retarder(retardance: ArrayLike) -> Complexes:
    """Jones matrix of `circular_retarder`."""
    return _matrices(_core.jones_circular_retarder, 2, retardance=retardance)


def jones_polariser(axis: ArrayLike = 0.0) -> Complexes:
    """Jones matrix of `linear_polariser`."""
    return jones_diattenuator(1.0, 0.0, axis)


def jones_diattenuator(along: ArrayLike, across: ArrayLike, axis: ArrayLike = 0.0) -> Complexes:
    """Jones matrix with field transmissions along `axis` and across it: the roots of `linear_diattenuator`'s."""
    return _matrices(_core.jones_diattenuator, 2, along=along, across=across, axis=axis)


def turned(matrix: ArrayLike, angle: ArrayLike) -> Reals | Complexes:
    """The Mueller (..., 4, 4) or Jones (..., 2, 2) matrix of the element turned by `angle`: R(a) M R(-a)."""
    array = np.asarray(matrix)
    turn = jones_rotator if array.shape[-1:] == (2,) else rotator
    array = _array("matrix", matrix, (2, 2), complex) if turn is jones_rotator else _array("matrix", matrix, (4, 4))
    return turn(angle) @ array @ turn(np.negative(angle))


def mueller_from_jones(jones: ArrayLike) -> Reals:
    """Mueller matrix (..., 4, 4) of a Jones matrix (..., 2, 2): M_ij = 1/2 tr(sigma_i J sigma_j J+).

    Chipman, Lam & Young 2019, eq. 6.107, with our sign of S3.
    """
    array = _array("jones", jones, (2, 2), complex)
    return _core.mueller_from_jones(array.reshape(-1, 2, 2)).reshape(*array.shape[:-2], 4, 4)


def jones_from_mueller(mueller: ArrayLike) -> Complexes:
    """Jones matrix of a Mueller matrix, up to a phase; of one that depolarises, its largest part that does not.

    Cloude 1986: the first eigenvector of the coherency matrix. Its largest element is made real and positive.
    """
    array = _array("mueller", mueller, (4, 4))
    return _core.jones_from_mueller(array.reshape(-1, 4, 4)).reshape(*array.shape[:-2], 2, 2)


def stokes_from_field(field: ArrayLike) -> Reals:
    """Stokes vector (..., 4) of the field (Ex, Ey), (..., 2): |Ex|^2 + |Ey|^2, |Ex|^2 - |Ey|^2, 2 Re, 2 Im (Ex Ey*)."""
    array = _array("field", field, (2,), complex)
    return _core.stokes_from_field(array.reshape(-1, 2)).reshape(*array.shape[:-1], 4)


def degree_of_polarisation(stokes: ArrayLike) -> Reals:
    """sqrt(S1^2 + S2^2 + S3^2) / S0, (...); 0 for no light."""
    return _of_stokes(_core.degree_of_polarisation, stokes)


def degree_of_linear_polarisation(stokes: ArrayLike) -> Reals:
    """sqrt(S1^2 + S2^2) / S0, (...); 0 for no light."""
    return _of_stokes(_core.degree_of_linear_polarisation, stokes)


def angle_of_polarisation(stokes: ArrayLike) -> Reals:
    """Angle of the ellipse's long axis, atan2(S2, S1) / 2, (...), in -pi/2 .. pi/2."""
    return _of_stokes(_core.angle_of_polarisation, stokes)


def ellipticity(stokes: ArrayLike) -> Reals:
    """Short over long axis of the ellipse, (...), -1 .. 1, positive when right-handed."""
    return _of_stokes(_core.ellipticity, stokes)


def depolarisation_index(mueller: ArrayLike) -> Reals:
    """sqrt(sum M_ij^2 - M00^2) / (sqrt(3) M00), (...): 1 does not depolarise, 0 does wholly (Gil & Bernabeu 1986)."""
    return _of_mueller(_core.depolarisation_index, mueller)


def diattenuation(mueller: ArrayLike) -> Reals:
    """(T_max - T_min) / (T_max + T_min), (...), from the first row (Lu & Chipman 1996, eq. 11)."""
    return _of_mueller(_core.diattenuation, mueller)


def polarisance(mueller: ArrayLike) -> Reals:
    """Degree of polarisation that unpolarised light leaves with, (...) (Lu & Chipman 1996, eq. 13)."""
    return _of_mueller(_core.polarisance, mueller)


def retardance(n_fast: ArrayLike, n_slow: ArrayLike, length_mm: ArrayLike, wavelength_nm: ArrayLike) -> Reals:
    """Phase between two waves along one path, 2 pi (n_slow - n_fast) length / wavelength, (...).

    ValueError for a wavelength that is not positive.
    """
    _within("wavelength_nm", wavelength_nm, np.nextafter(0, 1), np.inf)
    arrays = _together(n_fast=n_fast, n_slow=n_slow, length_mm=length_mm, wavelength_nm=wavelength_nm)
    return _core.retardance(*(a.ravel() for a in arrays)).reshape(arrays[0].shape)[()]


def path_retardance(k_fast: ArrayLike, k_slow: ArrayLike, steps_mm: ArrayLike, wavelength_nm: ArrayLike) -> Reals:
    """Phase between two plane waves along a path of M straight steps: sum of 2 pi (k_slow - k_fast) . step / wavelength.

    Wave vectors in units of w/c and steps have the shape (..., M, 3), or (..., 3) for the same in all. Waves
    that part are compared along any one path between the two places: a plane wave's phase is k . r
    everywhere, whatever way its ray takes. Returns (...).
    """
    _within("wavelength_nm", wavelength_nm, np.nextafter(0, 1), np.inf)
    fast, slow, steps = (
        _array(name, value, (3,)) for name, value in (("k_fast", k_fast), ("k_slow", k_slow), ("steps_mm", steps_mm))
    )
    try:
        optical = np.sum((slow - fast) * np.atleast_2d(steps), axis=(-2, -1))
        return 2 * np.pi * optical / (np.asarray(wavelength_nm, float) * 1e-6)
    except ValueError as error:
        shapes = f"k_fast {fast.shape}, k_slow {slow.shape}, steps_mm {steps.shape}"
        raise ValueError(f"shapes do not broadcast: {shapes}, wavelength_nm {np.shape(wavelength_nm)}") from error


def mueller_of_wave(analyser: ArrayLike, out: ArrayLike) -> Reals:
    """The rank-1 matrix 1/2 (1, p_out) a^T of one fully polarised wave, such as the o or the e ray, (..., 4, 4).

    `analyser` (..., 2): the amplitudes of this wave for incoming light along x and y; a is their Stokes
    vector, conjugated. `out` (..., 4): the wave's own polarisation, fully polarised, scaled to S0 = 1.
    ValueError when S0 of `out` is not positive.
    """
    a, sent = _array("analyser", analyser, (2,), complex), _array("out", out, (4,))
    if (bad := ~(sent[..., 0] > 0)).any():
        raise ValueError(f"{_element('out', bad)}: S0 must be positive")
    try:
        shape = np.broadcast_shapes(a.shape[:-1], sent.shape[:-1])
    except ValueError as error:
        raise ValueError(f"shapes do not broadcast: analyser {a.shape}, out {sent.shape}") from error
    a, sent = np.broadcast_to(a, (*shape, 2)), np.broadcast_to(sent, (*shape, 4))
    return _core.mueller_of_wave(a.reshape(-1, 2), sent.reshape(-1, 4)).reshape(*shape, 4, 4)


@dataclass(frozen=True)
class FaceMueller:
    """Mueller matrices of what leaves a face; S0 is the energy flow through it, the incident light's being 1.

    Light is described as it runs along its ray, by x = s (normal x k of the incident wave) made perpendicular
    to the ray, and y = ray x x: by s and p in an isotropic medium.
    """

    reflected: Reals  #: of each reflected wave alone, rank 1, (N, 2, 4, 4); 0 when evanescent
    transmitted: Reals  #: of each transmitted wave alone, such as o and e, rank 1, (N, 2, 4, 4)
    reflected_light: Reals | None  #: s and p together, as fields, (N, 4, 4); None when medium1 is a crystal
    transmitted_light: Reals | None  #: likewise on the other side; None when medium2 is a crystal


def mueller_at_face(
    medium1: Medium,
    medium2: Medium,
    normal: ArrayLike,
    direction: ArrayLike,
    by: Literal["wave_normal", "ray"] = "wave_normal",
    *,
    mode: str | None = None,
) -> FaceMueller:
    """Mueller matrices of the reflected and transmitted rays; arguments and errors as of `icespar.interface`.

    From an isotropic medium1 light of any polarisation may come, and `mode` is left out. In a crystal light is
    in one `mode`; the matrices then accept that mode's polarisation and nothing else. Each matrix is
    M = 1/2 F (1, p_out) (a0, a1, a2, a3)^T: what the wave's analyser accepts leaves in its own polarisation.
    medium1 must not absorb.
    """
    if not medium1.birefringent and mode is not None:
        raise ValueError(f"mode: light of any polarisation may come from isotropic medium1; leave out {mode!r}")
    core_by, core = core_mode(medium1, by, "s" if not medium1.birefringent else mode)
    n, d = together(normal=directions("normal", normal), direction=directions("direction", direction))
    return FaceMueller(**_core.mueller_at_face(medium1, medium2, n, d, core_by, core))


def _array(name: str, value: ArrayLike, last: tuple[int, ...], kind: type = float) -> np.ndarray:
    """Finite numbers whose shape ends with `last`."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name}: rows of different lengths") from error
    if array.dtype.kind not in ("iufc" if kind is complex else "iuf"):
        raise ValueError(f"{name}: {'complex' if kind is complex else 'real'} numbers are needed, not {array.dtype}")
    if last and array.shape[-len(last) :] != last:
        raise ValueError(f"{name}: shape {array.shape} does not end with {last}")
    bad = ~np.isfinite(array)
    if bad.any():
        raise ValueError(f"{_element(name, bad)} is not finite")
    return array.astype(kind)


def _element(name: str, bad: NDArray[np.bool_]) -> str:
    return name if bad.ndim == 0 else f"{name}[{', '.join(map(str, np.argwhere(bad)[0]))}]"


def _within(name: str, value: ArrayLike, least: float, most: float) -> None:
    array = _array(name, value, ())
    if (bad := (array < least) | (array > most)).any():
        limits = "positive" if most == np.inf else f"in {least} .. {most}"
        raise ValueError(f"{_element(name, bad)} must be {limits}")


def _together(**values: ArrayLike) -> list[Reals]:
    arrays = {name: _array(name, value, ()) for name, value in values.items()}
    try:
        return np.broadcast_arrays(*arrays.values())
    except ValueError as error:
        shapes = ", ".join(f"{name} {a.shape}" for name, a in arrays.items())
        raise ValueError(f"shapes do not broadcast: {shapes}") from error


def _matrices(function, size: int, **values: ArrayLike) -> np.ndarray:
    arrays = _together(**values)
    return function(*(a.ravel() for a in arrays)).reshape(*arrays[0].shape, size, size)


def _of_stokes(function, stokes: ArrayLike) -> Reals:
    array = _array("stokes", stokes, (4,))
    return function(array.reshape(-1, 4)).reshape(array.shape[:-1])[()]


def _of_mueller(function, mueller: ArrayLike) -> Reals:
    array = _array("mueller", mueller, (4, 4))
    return function(array.reshape(-1, 4, 4)).reshape(array.shape[:-2])[()]
