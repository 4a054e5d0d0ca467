"""Scenes: reading, rendering, and tracing given rays."""

import math
import operator
import os
import pathlib
import warnings
from collections.abc import Callable, Iterable
from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import directions as unit_directions
from ._arrays import together, vectors
from ._progress import shown
from .image import Image


class SceneError(_core.Error):
    """The scene is at fault. `diagnostics` has every message with its place; str() shows them all."""

    def __init__(self, message: str, diagnostics: Iterable[_core.Diagnostic] = ()) -> None:
        super().__init__(message)
        self.diagnostics = list(diagnostics)


class SceneWarning(UserWarning):
    """Something in a scene that is read but does nothing."""


def load(
    source: str | os.PathLike[str],
    *,
    size: tuple[int, int] = (640, 480),
    clock: float = 0.0,
    allow: Iterable[str | os.PathLike[str]] = (),
    folder: str | os.PathLike[str] = ".",
) -> "Scene":
    """A scene from a file, or from its text: a str that has a line break or a `{` is text.

    `size` and `clock` are what image_width, image_height and clock say in the scene. Files are read only
    below the scene's folder (for a text: `folder`) and the folders of `allow`.

    An animation is a loop over clocks.

    Raises SceneError with all messages when the scene is at fault; each warning becomes a SceneWarning.
    """
    if isinstance(source, str) and not source.strip():
        raise ValueError("load: the source is empty; give a scene's text, or the path of its file")
    if not math.isfinite(clock):
        raise ValueError(f"clock: {clock!r} is not a finite number")
    width, height = _size(size)
    folders = [pathlib.Path(path) for path in allow]
    if isinstance(source, str) and ("\n" in source or "{" in source):
        name = "text"
        core, diagnostics = _core.load_text(source, name, pathlib.Path(folder), width, height, clock, folders)
    else:
        name = pathlib.Path(source).name
        core, diagnostics = _core.load_file(pathlib.Path(source), width, height, clock, folders)
    if core is None:
        message = "\n".join(str(d) for d in diagnostics)
        if isinstance(source, str) and name != "text" and not os.path.exists(source):
            message += "; a scene's text has a line break or a '{', and this has neither"
        raise SceneError(message, diagnostics)
    for diagnostic in diagnostics:
        warnings.warn(str(diagnostic), SceneWarning, stacklevel=2)
    return Scene(core, name)


class Plan:
    """What a scene needs of the renderer; str() shows all of it with the reasons."""

    def __init__(self, lines: list[tuple[str, str, str]], warnings: list[str], text: str) -> None:
        #: what was chosen, by subject: "wavelengths", "crystals", "engine" and so on
        self.choices = {subject: choice for subject, choice, _ in lines}
        #: why, by subject
        self.reasons = {subject: reason for subject, _, reason in lines}
        self.warnings = warnings  #: what converges slowly or is left out
        self._text = text

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<Plan {self.choices}>"


class Scene:
    """A scene that is ready to be rendered. It does not change; load another one to change it."""

    def __init__(self, core: _core.Scene, name: str) -> None:
        self._core = core
        self.name = name  #: the file's name, or "text"

    @property
    def title(self) -> str:
        """The first comment line of the file."""
        return self._core.title

    def render(
        self,
        size: tuple[int, int] = (640, 480),
        error: float | None = None,
        spp: int | None = None,
        time: float | None = None,
        threads: int = 0,
        seed: int = 0,
        stokes: bool = False,
        spectral: int = 0,
        engine: Literal["auto", "rays", "beams", "exact"] = "auto",
        full: bool | Iterable[str] = False,
        error_metric: Literal["rms", "max"] = "rms",
        progress: bool | Callable[[_core.Progress], bool | None] = True,
    ) -> Image:
        """Renders to an Image of `size` (width, height).

        The render ends with the first bound it reaches: the estimated relative `error` of the picture (the root mean
        square of its pixels' over its mean, or their largest with `error_metric` "max"; `Image.standard_error` has them all),
        `spp` samples a pixel, or `time` in seconds; with none given, 64 samples. The same seed and samples
        make the same bits for any number of `threads` (0: all).
        `stokes` keeps the polarisation, `spectral` that many bands of the spectrum.
        `engine` "rays" samples, "beams" follows whole pixels through stones, "exact" whole facets of one stone that
        an orthographic camera sees below a sky alone (next to no noise; `spp` counts wavelengths of a dispersive or coloured stone);
        "auto" takes the last of them that applies. All make the same picture within their noise.
        `full` computes what the scene does not need, too (see `plan`): True all of it, or some of "wavelengths", "stokes",
        "general" (any crystal's solver), "absorption", "tree" (Embree), "surroundings" (a plain sky asked ray by ray), "pixels" (beams follow each by itself) and "survivors" (what survives by chance in a crystal stays a beam).
        `progress` True draws a bar on a terminal or in a notebook; a function is called with a Progress
        now and then, and ends the render by returning False. Ctrl-C raises KeyboardInterrupt.

        Raises ValueError when an argument makes no sense.
        """
        width, height = _size(size)
        bounds = {"error": _positive("error", error), "seconds": _positive("time", time)}
        samples = _count("spp", spp) if spp is not None else 0
        options = dict(
            width=width,
            height=height,
            samples=samples,
            threads=_count("threads", threads, least=0),
            seed=_count("seed", seed, least=0, most=2**64 - 1),
            bands=_count("spectral", spectral, least=0, most=400),
            stokes=bool(stokes),
            engine=_engine(engine),
            full=_parts(full),
            metric=_metric(error_metric),
            **bounds,
        )
        if callable(progress):
            core, report = _core.render(self._core, progress=progress, **options)
        else:
            with shown(progress) as callback:
                core, report = _core.render(self._core, progress=callback, **options)
        core.metadata = core.metadata | {"scene": self.name}
        return Image(core, report)

    def plan(
        self,
        stokes: bool = False,
        engine: Literal["auto", "rays", "beams", "exact"] = "auto",
        full: bool | Iterable[str] = False,
    ) -> Plan:
        """How `render` would make a picture with these arguments, and why."""
        return Plan(*_core.plan(self._core, stokes=bool(stokes), engine=_engine(engine), full=_parts(full)))

    @overload
    def trace(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        x_axis: ArrayLike,
        wavelength_nm: float = ...,
        max_hits: int | None = ...,
        threshold: float = ...,
        return_dropped: Literal[False] = ...,
        threads: int = ...,
    ) -> NDArray[np.float64]: ...

    @overload
    def trace(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        x_axis: ArrayLike,
        wavelength_nm: float = ...,
        max_hits: int | None = ...,
        threshold: float = ...,
        *,
        return_dropped: Literal[True],
        threads: int = ...,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def trace(
        self,
        origins,
        directions,
        x_axis,
        wavelength_nm=589.3,
        max_hits=None,
        threshold=0.0,
        return_dropped=False,
        threads=0,
    ):
        """Stokes vectors (N, 4) that given rays see, by the full tree without roulette.

        `origins`, `directions` (into the scene, any length but 0) and `x_axis` (picture-right, made
        perpendicular to the ray) have the shape (3,) or (N, 3), in the scene's left-handed world; y is up
        as in a POV-Ray picture (right, up, direction = x, y, z). Values are in units of the environment's
        illuminant at `wavelength_nm`.
        `max_hits` bounds the interface events of a path, the entry (or outer reflection) being the first;
        a branch whose weight is below `threshold` is dropped before it is continued. With neither bound,
        branches below 1e-16 are dropped, and a ray ends after 2^16 events, heaviest branches first. With
        `return_dropped` also what the dropped branches would have added under unit unpolarised light from
        everywhere, (N, 4): in such a furnace both arrays add up to 1, 0, 0, 0.

        Raises ValueError, which names the argument and its element, for vectors that are zero or not
        finite, an x_axis along its ray, and shapes that do not broadcast.
        """
        o, d, x = together(
            origins=vectors("origins", origins),
            directions=unit_directions("directions", directions),
            x_axis=unit_directions("x_axis", x_axis),
        )
        along = np.linalg.norm(np.cross(d, x), axis=1) < 1e-12
        if along.any():
            raise ValueError(f"x_axis[{int(np.argmax(along))}] is along its ray; picture-right is across it")
        stokes, dropped = _core.trace(
            self._core,
            o,
            d,
            x,
            wavelength_nm=_positive("wavelength_nm", wavelength_nm),
            max_hits=0 if max_hits is None else _count("max_hits", max_hits),
            threshold=_positive("threshold", threshold) if threshold != 0 else 0.0,
            threads=_count("threads", threads, least=0),
        )
        return (stokes, dropped) if return_dropped else stokes

    def __repr__(self) -> str:
        return f"<Scene {self.title!r}: {self._core.gems} gems, {self._core.things} things, {self._core.lights} lights>"


def _size(size: tuple[int, int]) -> tuple[int, int]:
    try:
        width, height = size
    except (TypeError, ValueError):
        raise ValueError(f"size: {size!r} is not (width, height)") from None
    return _count("size", width, most=65536), _count("size", height, most=65536)


def _count(name: str, value: int, least: int = 1, most: int = 2**31 - 1) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name}: {value!r} is not a whole number") from None
    if not least <= number <= most:
        raise ValueError(f"{name}: {value!r} is not in {least} .. {most}")
    return number


def _engine(name: str) -> _core.Engine:
    engines = {
        "auto": _core.Engine.automatic,
        "rays": _core.Engine.rays,
        "beams": _core.Engine.beams,
        "exact": _core.Engine.exact,
    }
    if name not in engines:
        raise ValueError(f"engine: {name!r} is not 'auto', 'rays', 'beams' or 'exact'")
    return engines[name]


def _metric(name: str) -> _core.ErrorMetric:
    metrics = {"rms": _core.ErrorMetric.rms, "max": _core.ErrorMetric.max}
    if name not in metrics:
        raise ValueError(f"error_metric: {name!r} is not 'rms' or 'max'")
    return metrics[name]


def _parts(full: bool | Iterable[str]) -> list[str]:
    if isinstance(full, str):
        return [full]
    if isinstance(full, Iterable):
        return list(full)
    return ["wavelengths", "stokes", "general", "absorption", "tree", "surroundings", "pixels", "survivors"] if full else []


def _positive(name: str, value: float | None) -> float:
    """The number, or 0 for None."""
    if value is None:
        return 0.0
    if not (math.isfinite(value) and value > 0):
        raise ValueError(f"{name}: {value!r} is not a positive number")
    return float(value)
