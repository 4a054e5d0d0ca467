"""Pictures of gemstones with the polarised light that birefringent crystals make.

>>> import icespar
>>> scene = icespar.load("scenes/calcite_on_grid.spar")
>>> picture = scene.render(size=(640, 480), error=0.02)
>>> picture.save("grid.exr")

The physics of a single face is `interface`, with `Medium` and its `modes`; the algebra of Stokes vectors,
Mueller and Jones matrices is the module `polarisation`; stones by themselves are `Stone`;
what a stone may be made of is `minerals`. Lengths are millimetres, wavelengths nanometres of vacuum; angles
are degrees in scenes and radians elsewhere.
Scenes have the left-handed world of the scene language; `interface` and `Stone` are right-handed.
"""

from . import polarisation
from ._core import Diagnostic, Error, IndexFunction, Medium, Mineral, Progress, RenderReport, Stone, __version__
from .image import Image
from .minerals import mineral, minerals
from .optics import Incident, Interface, Modes, Outgoing, interface
from .scene import Scene, SceneError, SceneWarning, load

__all__ = [
    "Diagnostic",
    "Error",
    "Image",
    "Incident",
    "IndexFunction",
    "Interface",
    "Medium",
    "Mineral",
    "Modes",
    "Outgoing",
    "Progress",
    "RenderReport",
    "Scene",
    "SceneError",
    "SceneWarning",
    "Stone",
    "__version__",
    "interface",
    "load",
    "mineral",
    "minerals",
    "polarisation",
]
