"""Pictures of gemstones with the polarised light that birefringent crystals make.

>>> import icespar
>>> scene = icespar.load("scenes/calcite_on_grid.spar")
>>> picture = scene.render(size=(640, 480), error=0.02)
>>> picture.save("grid.exr")

The physics of a single face is `interface`, with `Medium` and its `modes`; the algebra of Stokes vectors,
Mueller and Jones matrices is the module `polarisation`; stones by themselves are `Stone`,
faceting designs `Design` with `cutting_table`, `proportions` and the drawings of `icespar.diagram`;
what stones return of the light to a viewer is `view`;
what a stone may be made of is `minerals`. Lengths are millimetres, wavelengths nanometres of vacuum; angles
are degrees in scenes and radians elsewhere.
Scenes have the left-handed world of the scene language; `interface` and `Stone` are right-handed.
"""

from . import polarisation
from ._core import (
    Design,
    Diagnostic,
    Error,
    IndexFunction,
    Medium,
    Mineral,
    Progress,
    RenderReport,
    Stone,
    Tier,
    __version__,
    blackbody,
    illuminant,
    illuminants,
    observer,
)
from .cutting import Proportions, cutting_table, proportions
from .image import Image
from .minerals import mineral, minerals
from .optics import Incident, Interface, Modes, Outgoing, interface
from .scene import Plan, Scene, SceneError, SceneWarning, load
from .views import LightReturn, TiltCurve, View, tilt_curve, view

__all__ = [
    "Design",
    "Diagnostic",
    "Error",
    "Image",
    "Incident",
    "IndexFunction",
    "Interface",
    "LightReturn",
    "Medium",
    "Mineral",
    "Modes",
    "Outgoing",
    "Plan",
    "Progress",
    "Proportions",
    "RenderReport",
    "Scene",
    "SceneError",
    "SceneWarning",
    "Stone",
    "Tier",
    "TiltCurve",
    "View",
    "__version__",
    "blackbody",
    "cutting_table",
    "illuminant",
    "illuminants",
    "interface",
    "load",
    "mineral",
    "minerals",
    "observer",
    "polarisation",
    "proportions",
    "tilt_curve",
    "view",
]
