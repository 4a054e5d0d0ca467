"""The scenes of the bench: a tilted brilliant below a graded sky with six lamps, for us and for peers."""

import pathlib

import numpy as np

import icespar

DESIGN = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "designs" / "srb_tolkowsky_diamond.asc"
TILT = np.radians(12)
BELOW, ABOVE, LAMP, LAMP_RADIUS = 0.25, 0.6, 12.0, 9.0

CAMERA = "camera { perspective location <0, 3.75, 0> right x up y sky z angle 35 look_at 0 }"


def lamps():
    """Six directions, towards the faces of a tilted cube; y is towards the camera."""
    x = np.array([0.9, 0.35, 0.3])
    x /= np.linalg.norm(x)
    y = np.cross([0.1, 1, 0.2], x)
    y /= np.linalg.norm(y)
    axes = (x, y, np.cross(x, y))
    return [sign * axis for axis in axes for sign in (1, -1)]


def vector(v):
    return "<" + ", ".join(f"{c:.9g}" for c in v) + ">"


def environment():
    discs = "\n".join(f"    disc {vector(d)}, {LAMP_RADIUS}, {LAMP}" for d in lamps())
    return f"environment {{\n  gradient {BELOW}, {ABOVE}\n  lamps {{\n{discs}\n  }}\n}}"


def brilliant(crystal):
    """Ours: the same stone as `facets`."""
    return f"""// A brilliant that leans by 12 degrees.
{CAMERA}
{environment()}
gem {{
  design "{DESIGN.name}"
  interior {{ crystal {{ {crystal} }} }}
  rotate x*{np.degrees(TILT):.9g}
}}
"""


GRID = f"""// A rhomb of calcite, without dispersion, on a luminous grid.
camera {{ perspective location <0, 5, -2.5> right x angle 28 look_at <0, 0.5, 0> }}
{environment()}
plane {{ y, 0
  pigment {{ grid rgb <0.05, 0.05, 0.2> rgb 1 line 0.06 scale 0.25 }}
  finish {{ emission 1 diffuse 0 }}
}}
gem {{
  design "{DESIGN.name}"
  interior {{ crystal {{ indices 1.6584, 1.4864 axis <1, 1, 1> }} }}
  translate y*1.2
}}
"""

SCENES = {
    "isotropic": brilliant("indices 2.417"),
    "dispersive": brilliant("indices 2.3784 dispersion { cauchy 2.3784, 0.0134 }"),
    "uniaxial": brilliant("indices 1.925, 1.984 axis y"),
    "grid": GRID,
}
#: Crystals with their axis along the table's normal, and the same stones of one index, the mean.
SPLIT = {
    "zircon": ("indices 1.925, 1.984 axis y", "indices 1.945"),
    "calcite": ("indices 1.6584, 1.4864 axis y", "indices 1.601"),
    "quartz": ("indices 1.5443, 1.5534 axis y", "indices 1.5473"),
}
DIAMOND = 2.417


def dispersive_index(nm):
    """Of the dispersive stone at a wavelength, for peers."""
    return 2.3784 + 0.0134 / (nm / 1000) ** 2


def load(text, size):
    return icespar.load(text, folder=DESIGN.parent, size=(size, size))


def facets():
    """The stone's triangles, (N, 3, 3), in the scene's left-handed world."""
    stone = icespar.Stone.from_design(DESIGN)
    points = np.asarray(stone.vertices)[:, [0, 2, 1]]
    c, s = np.cos(TILT), np.sin(TILT)
    points = points @ np.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    fans = [(f[0], f[i - 1], f[i]) for f in stone.facets for i in range(2, len(f))]
    return points[np.asarray(fans)]


def sky(directions):
    """Radiance from unit directions (..., 3)."""
    light = BELOW + (ABOVE - BELOW) * (1 + directions[..., 1]) / 2
    for lamp in lamps():
        light = light + LAMP * (directions @ lamp >= np.cos(np.radians(LAMP_RADIUS)))
    return light
