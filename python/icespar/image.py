"""A finished picture: arrays that look into its memory, and files."""

import os
import pathlib
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _core


class Image:
    """What `Scene.render` made; H rows from the top, W columns, radiances as float32.

    `np.asarray(image)` is `image.rgb`: no pixel is copied, and the arrays keep the memory alive.
    """

    def __init__(self, core: _core.Image, report: _core.RenderReport) -> None:
        self._core = core
        self.report = report  #: what the render did: samples, seconds, error, dropped energy ...

    @property
    def rgb(self) -> NDArray[np.float32]:
        """Linear sRGB (Rec. 709, D65), (H, W, 3). A view."""
        return self._core.rgb

    @property
    def shape(self) -> tuple[int, int, int]:
        return (self._core.height, self._core.width, 3)

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        if dtype is not None and np.dtype(dtype) != np.float32:
            if copy is False:
                raise ValueError("an Image holds float32: another dtype needs a copy")
            return self.rgb.astype(dtype)
        return self.rgb.copy() if copy else self.rgb

    @property
    def wavelengths(self) -> NDArray[np.float64]:
        """Centres of the bands in nm, rising, (bands,); empty when `spectral` was not asked."""
        return self._core.wavelengths

    @property
    def spectral(self) -> NDArray[np.float32] | None:
        """Radiance of each band, (H, W, bands), or None when `spectral` was not asked. A view."""
        values = self._core.spectral
        return None if values is None else values[..., 0]

    @cached_property
    def stokes(self) -> NDArray[np.float32] | None:
        """S0, S1, S2, S3 along the third axis, or None when `stokes` was not asked.

        With bands (H, W, 4, bands), a view. Without, (H, W, 4, 3) for linear R, G, B: put together once
        from two planes, and read-only. Picture frame: x right, y up, see docs/conventions.md.
        """
        if self._core.spectral is not None:
            values = self._core.spectral
            return values.swapaxes(2, 3) if values.shape[3] == 4 else None
        if self._core.rgb_stokes is None:
            return None
        joined = np.concatenate([self.rgb[:, :, None, :], self._core.rgb_stokes.swapaxes(2, 3)], axis=2)
        joined.flags.writeable = False
        return joined

    @property
    def standard_error(self) -> NDArray[np.float32] | None:
        """Estimated standard error of each pixel's luminance, (H, W), in the units of `rgb`; a view.

        Pixels share their estimate with their neighbours. None when there was one pass of samples only, and
        for exact beams, which have no noise.
        """
        return self._core.standard_error

    @property
    def metadata(self) -> dict[str, str]:
        """What an .exr says beside its pixels: scene, seed, samples, error, dropped energy, version."""
        return self._core.metadata

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the whole picture or nothing, by the ending: .exr (everything) or .png (sRGB, 8 bits).

        ValueError for any other ending; Error when it cannot be written.
        """
        ending = pathlib.Path(path).suffix.lower()
        if ending == ".exr":
            self._core.write_exr(path)
        elif ending == ".png":
            self._core.write_png(path)
        else:
            raise ValueError(f"{os.fspath(path)!r}: a picture is saved as .exr or .png")

    def _repr_png_(self) -> bytes:
        return self._core.png_bytes()

    def __repr__(self) -> str:
        extra = "" if self._core.spectral is None else f", {len(self.wavelengths)} bands"
        extra += "" if self.stokes is None else ", Stokes"
        return f"<Image {self._core.width}x{self._core.height}{extra}, {self.report.samples} samples a pixel>"
