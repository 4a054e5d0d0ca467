"""A design cut from a mineral: its media, and pictures of it in the lights by which cutters judge."""

import math
import os
import pathlib
import tempfile
import warnings
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import Design, Error, Medium, Mineral, Stone
from .cutting import Proportions, as_design, proportions
from .image import Image
from .minerals import mineral as mineral_of
from .scene import SceneWarning, load

#: Scene text of each light; `HEAD` is half the angle that the observer's head covers, in degrees.
LIGHTS = {
    "lamps": "environment { sc2 head HEAD rgb 0.9 lamps { "
    + " ".join(
        f"disc <{math.sin(turn) * math.cos(math.radians(height)):.6f}, {math.sin(math.radians(height)):.6f}, "
        f"{math.cos(turn) * math.cos(math.radians(height)):.6f}>, {radius}, rgb {value}"
        for height, count, radius, value in ((62, 7, 3, 5), (38, 11, 4, 3))
        for turn in (2 * math.pi * (i + 0.3) / count for i in range(count))
    )
    + " } }",
    "iso": "environment { iso head HEAD }",
    "cosine": "environment { cosine head HEAD }",
    "sc2": "environment { sc2 head HEAD }",
    "aset": "environment { aset head HEAD }",
    "idealscope": "environment { idealscope head HEAD }",
}
HEADS = {"aset": 15.0, "idealscope": 15.0}  #: degrees; 10 for the others, as GemRay has it


@dataclass(frozen=True)
class Gem:
    """A design in a mineral. The frame is the design's: right-handed, table up along z.

    `axis` is the optic axis of a uniaxial mineral and the axis of n_gamma of a biaxial one. Without a mineral
    the stone is isotropic and has the design's refractive index.
    """

    design: Design
    mineral: Mineral | None = None
    colour: str | None = None
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    width_mm: float = 6.5
    name: str = "stone"
    stone: Stone = field(init=False, repr=False, compare=False)
    proportions: Proportions = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        axis = np.array(self.axis, dtype=float)
        if axis.shape != (3,) or not np.isfinite(axis).all() or not axis.any():
            raise ValueError(f"axis: {self.axis!r} is not a direction of three numbers")
        if not 1e-6 <= self.width_mm <= 1e6:
            raise ValueError(f"width_mm: {self.width_mm!r} is not a width of a stone: give 1e-6 to 1e6")
        if self.mineral is None:
            if self.colour:
                raise Error("a colour belongs to a mineral: name one")
            if not self.design.refractive_index:
                raise Error(f"{self.name}: the design does not say for which index it is: name a mineral")
        elif self.colour and self.colour not in self.mineral.colours:
            known = ", ".join(map(repr, self.mineral.colours)) or "none"
            raise Error(f"{self.mineral.id} has no colour {self.colour!r}; its colours are: {known}")
        axis /= np.abs(axis).max()
        object.__setattr__(self, "axis", tuple(float(x) for x in axis / np.linalg.norm(axis)))
        try:
            object.__setattr__(self, "stone", self.design.stone())
        except Error as error:
            raise Error(f"{self.name}: {error}") from None
        object.__setattr__(self, "proportions", proportions(self.stone))

    @classmethod
    def of(
        cls, design: Design | str | os.PathLike[str], mineral: Mineral | str | None = None, **others: object
    ) -> "Gem":
        """A gem from the path of a design and the name of a mineral."""
        name = others.pop("name", None)
        if name is None:
            name = "stone" if isinstance(design, Design) else pathlib.Path(design).stem
        found = mineral_of(mineral) if isinstance(mineral, str) else mineral
        return cls(as_design(design), found, name=name, **others)

    @property
    def birefringent(self) -> bool:
        return self.mineral is not None and self.mineral.optic != "isotropic"

    @property
    def density(self) -> float | None:
        """g/cm^3; None without a mineral."""
        return self.mineral.density if self.mineral else None

    @property
    def carats(self) -> float | None:
        """Weight at `width_mm`; None without a mineral."""
        return self.proportions.carats(self.width_mm, self.mineral.density) if self.mineral else None

    def medium(self, wavelength_nm: float = 589.3) -> Medium:
        """The clear mineral, without its colour."""
        if self.mineral is None:
            return Medium.isotropic(self.design.refractive_index)
        if self.mineral.optic.startswith("uniaxial"):
            return self.mineral.medium(wavelength_nm, axis=self.axis)
        if self.mineral.optic.startswith("biaxial"):
            return self.mineral.medium(wavelength_nm, axes=self._principal()[:2])
        return self.mineral.medium(wavelength_nm)

    def absorption(self, wavelength_nm: float = 589.3) -> NDArray[np.float64] | None:
        """Of its colour at `width_mm`, per unit of length of `stone`, as `icespar.view` takes it; None without a colour."""
        if self.mineral is None or not self.colour:
            return None
        return self.mineral.absorption(self.colour, wavelength_nm) * (self.width_mm / self._width())

    def isotropic(self, wavelength_nm: float = 589.3) -> Medium:
        """The mineral without birefringence: of the mean of its three principal indices."""
        return Medium.isotropic(self.mean_index(wavelength_nm))

    def mean_index(self, wavelength_nm: float = 589.3) -> float:
        if self.mineral is None:
            return self.design.refractive_index
        n = self.mineral.indices(wavelength_nm)
        return float((n[0] + n[0] + n[1]) / 3 if len(n) == 2 else np.mean(n))

    def _principal(self) -> NDArray[np.float64]:
        """Unit vectors along n_alpha, n_beta and n_gamma = `axis`, right-handed; alpha as near to x as can be."""
        gamma = np.array(self.axis)
        start = np.eye(3)[0 if abs(gamma[0]) < 0.9 else 1]
        alpha = start - gamma * (gamma @ start)
        alpha /= np.linalg.norm(alpha)
        return np.array([alpha, np.cross(gamma, alpha), gamma])

    def crystal_text(self, clear: bool = False) -> str:
        """What a scene says of the material; `clear`: without colour, its indices everywhere those at 589.3 nm."""
        if self.mineral is None:
            return f"crystal {{ indices {self.design.refractive_index!r} }}"
        words = f'crystal {{ mineral "{self.mineral.id}"'
        if clear:
            words = "crystal { indices " + ", ".join(repr(float(n)) for n in self.mineral.indices(589.3))
        if self.mineral.optic.startswith("uniaxial"):
            words += f" axis {_in_scene(self.axis)}"
        elif self.mineral.optic.startswith("biaxial"):
            alpha, _, gamma = self._principal()
            words += f" axes {_in_scene(alpha)}, {_in_scene(gamma)}"
        return words + (f' colour "{self.colour}"' if self.colour and not clear else "") + " }"

    def picture(
        self,
        light: str = "lamps",
        tilt: tuple[float, float] = (0.0, 0.0),
        size: int = 320,
        error: float = 0.02,
        head: float | None = None,
        clear: bool = False,
        **options: object,
    ) -> Image:
        """The stone from straight above in a parallel view, as the crown view of its diagram.

        `light` is a key of LIGHTS. `tilt` turns the stone by degrees about picture-right, then about picture-up,
        both by the right hand: +, 0 raises its upper edge, 0, + lowers its right edge. `head` is half the angle of the
        observer's head. `clear` shows the clear stone without dispersion, as instruments' colour codes want it. `options` go to `Scene.render`.
        """
        if light not in LIGHTS:
            raise ValueError(f"light: {light!r} is none of {', '.join(LIGHTS)}")
        around = LIGHTS[light].replace("HEAD", repr(float(HEADS.get(light, 10.0) if head is None else head)))
        corners = self.stone.vertices
        reach = 1.05 * float(np.linalg.norm(corners, axis=1).max()) * self.width_mm / self._width()
        scene = f"""camera {{
  orthographic
  location y * {4 * reach!r}
  direction y * -1
  right x * {2 * reach!r}
  up z * {2 * reach!r}
}}
{around}
gem {{
  design "stone.asc"
  scale_to width {self.width_mm!r}
  interior {{ {self.crystal_text(clear)} }}
  rotate x * {-float(tilt[0])!r}
  rotate z * {-float(tilt[1])!r}
}}
"""
        with tempfile.TemporaryDirectory() as folder:
            self.design.write(pathlib.Path(folder, "stone.asc"))
            with warnings.catch_warnings():  # of facets that do not reach the stone: designs keep them
                warnings.simplefilter("ignore", SceneWarning)
                loaded = load(scene, folder=folder)
        return loaded.render(size=(size, size), error=error, progress=False, **options)

    def _width(self) -> float:
        return float(min(np.ptp(self.stone.vertices, axis=0)[:2]))


def tilted(vector: ArrayLike, tilt: tuple[float, float]) -> NDArray[np.float64]:
    """A vector of the viewer's frame (right, up, towards the viewer) in the frame of a stone that is tilted so."""
    a, b = np.radians(tilt)
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    return np.asarray(vector, dtype=float) @ (about_y @ about_x)


def _in_scene(vector: ArrayLike) -> str:
    """A vector of the design's frame, in the scene's: x = X, y = Z, z = Y."""
    x, y, z = (float(v) for v in vector)
    return f"<{x!r}, {z!r}, {y!r}>"
