"""Checks of the arrays that callers hand in: shapes that broadcast over rays, and vectors that point."""

import os

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Error


def vectors(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """`value` as finite float64 of shape (3,) or (N, 3); ValueError that names argument and element."""
    array = _rows(name, value).astype(np.float64)
    finite = np.isfinite(array)
    if not finite.all():
        raise ValueError(f"{_element(name, array, ~finite.all(axis=-1))} is not finite")
    return array


def directions(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """`vectors`, none of them zero, made unit vectors."""
    array = pointing(name, value)
    return array / np.sqrt(np.einsum("...i,...i", array, array))[..., None]


def pointing(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """`vectors`, none of them zero, of lengths whose squares neither overflow nor vanish."""
    array = np.ascontiguousarray(_rows(name, value), np.float64)
    if _core.have_lengths(array):
        return array
    array = vectors(name, value)
    largest = np.abs(array).max(axis=-1, keepdims=True, initial=0)
    zero = largest[..., 0] == 0
    if zero.any():
        raise ValueError(f"{_element(name, array, zero)} is zero; a direction is needed")
    return array / largest


def _rows(name: str, value: ArrayLike) -> NDArray[np.number]:
    """`value` as an array of real numbers of shape (3,) or (N, 3)."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name}: rows of different lengths; give (3,) or (N, 3)") from error
    if not (np.issubdtype(array.dtype, np.integer) or np.issubdtype(array.dtype, np.floating)):
        raise ValueError(f"{name}: real numbers are needed, not {array.dtype}")
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        raise ValueError(f"{name}: shape {array.shape} is neither (3,) nor (N, 3)")
    require_memory(name, array.size // 3, 48)
    return array


def rows_of(**arrays: NDArray[np.float64]) -> int:
    """N, to which all broadcast; ValueError that names the shapes."""
    lengths = {len(array) for array in arrays.values() if array.ndim == 2} - {1}
    if len(lengths) > 1:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"shapes do not broadcast: {shapes}")
    return lengths.pop() if lengths else 1


def together(**arrays: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """All broadcast to (N, 3), contiguous; ValueError that names the shapes."""
    n = rows_of(**arrays)
    return [np.ascontiguousarray(np.broadcast_to(array, (n, 3))) for array in arrays.values()]


def require_memory(name: str, count: int, bytes_each: int) -> None:
    """Error when `count` rays do not fit into this machine's memory at all."""
    try:
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):
        return  # not known here
    if count * bytes_each > memory:
        raise Error(
            f"{name}: {count} rays need {count * bytes_each / 2**30:.0f} GiB, this machine has "
            f"{memory / 2**30:.0f}; pass them in batches"
        )


def _element(name: str, array: NDArray[np.float64], bad: NDArray[np.bool_]) -> str:
    """Such as `direction[5]`, the first one that is bad."""
    return name if array.ndim == 1 else f"{name}[{int(np.argmax(bad))}]"
