"""Renders the gallery anew: docs/gallery/*.png and docs/gallery.md, each scene with its sentence and its command.

    make gallery                                     # everything
    .venv/bin/python tools/make_gallery.py figure_6  # the pictures whose names contain this, and the page
"""

import pathlib
import subprocess
import sys
from collections.abc import Callable

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[1]

RENDER = "build/icespar render scenes/{name}.spar --size {size} --spp {spp} -o {picture}"
PLOT = ".venv/bin/python scenes/{name}.py -o {picture}"


def palette(picture: Image.Image) -> Image.Image:
    """256 colours: enough for a grid, and a third of the bytes."""
    return picture.quantize(256, dither=Image.Dither.NONE)


def levels(picture: Image.Image) -> Image.Image:
    """64 levels of red, green and blue: where every colour occurs, a palette would dull them."""
    return picture.point(lambda value: min(255, (value + 2) // 4 * 4))


PICTURES = [  # name in scenes/, command, its numbers, how the bytes are reduced, what to look at
    ("calcite_on_grid", RENDER, {"size": "640x480", "spp": 64}, palette, """\
The rhomb is 1 mm high and seen straight from above. The ordinary image stays where a glass plate would put it: the
line through the middle goes on unbroken. The extraordinary image lies a walk-off, 0.11 mm, beside it, along the
projection of the optic axis, which is the grid's diagonal here; so both sets of lines are doubled alike. Where only
one of the images is dark, half the light remains: each carries one of two crossed polarisations."""),
    ("paper_figure_3", PLOT, {}, palette, """\
Light falls from air on quartz, polarised across (s, above) and in (p, below) the plane of incidence. The first letter of
an index is the incident wave, the second the outgoing one. Along the normal the axis lies in the plane of incidence,
and s light becomes the ordinary wave alone, p light the extraordinary one. Elsewhere both are excited; reflection
hardly notices, and the reflected powers that change s into p stay below a hundred-thousandth."""),
    ("paper_figure_5", RENDER, {"size": "960x240", "spp": 64}, palette, """\
Cubes with n_e - n_o = 0, 0.1, 0.2, 0.3 and the same optic axis. The extraordinary image moves down and to the left,
towards the axis, as it does for n_e > n_o."""),
    ("paper_figure_6", RENDER, {"size": "960x240", "spp": 64}, palette, """\
The first cube is seen along its optic axis: nothing is doubled, though n_e - n_o = 0.2. In the last the axis leans to
the right, and only the upright lines are doubled."""),
    ("paper_figure_7", RENDER, {"size": "960x640", "spp": 32}, palette, """\
From left to right, then below. The ordinary image goes on with the grid outside; the extraordinary one goes round it
clockwise, as the crystal is turned, at a constant distance. At 45 degrees it lies straight to the right."""),
    ("zircon_brilliant", RENDER, {"size": "640x480", "spp": 64}, levels, """\
The borders between bright and dark inside the stone are followed by a step of half the brightness: the doubling by
which gemmologists tell zircon from diamond with a loupe. The axis lies about 50 degrees from the view, near the largest walk-off."""),
    ("diamond_brilliant", RENDER, {"size": "640x480", "spp": 64}, levels, """\
The same cut in diamond: single edges, and fire. The lamps are white; light that was refracted into the stone and out
again leaves it spread, violet at one side of a flash and red or yellow at the other. The two large pale facets, to the
lower left and above the middle, mirror a lamp at the surface and stay white."""),
    ("cuts", RENDER, {"size": "640x480", "spp": 32}, levels, """\
Round brilliant, emerald cut, princess, trilliant; baguette, square step cut, an old brilliant with a high crown and short
lower halves, octahedron; quartz crystal, hexagonal prism, calcite rhomb, and a block with the angles of a triclinic cell.
Each is one line of `docs/includes.md`. The crystals below lack what cutting is for: light goes straight through them."""),
    ("tourmaline_dichroism", RENDER, {"size": "640x480", "spp": 64}, levels, """\
Seen from above over a white ground. On the left the optic axis points at the eye, and all light that goes straight through is
ordinary, which this tourmaline absorbs most; on the right the axis lies across, and the half of the light that is
polarised along it passes. Cutters therefore lay the table along the axis."""),
    ("iolite_trichroism", RENDER, {"size": "640x480", "spp": 64}, levels, """\
The colours of `docs/minerals.md`, mixed two by two: along X (left) those of Y and Z, in the middle of X and Z, on the right of
X and Y. Iolite goes from violet-blue to a pale blue and a pale lilac; tanzanite before heating from rose to a greyish green and to
violet."""),
    ("quartz_rotation", RENDER, {"size": "480x360", "spp": 32}, levels, """\
Polarised light comes up through plates of quartz cut across the axis, then through a thick tourmaline that passes one
polarisation. A millimetre turns yellow light by 21.75 degrees and violet by twice as much, so each thickness has its colour, and
right and left quartz have different ones; the margin, where there is no quartz, is grey. The two waves in the plate
are added as fields (docs/method.md): as powers all plates would be alike."""),
    ("coloured_brilliants", RENDER, {"size": "480x360", "spp": 32}, levels, """\
Colour grows with the way that light has gone within the stone, and so differs from facet to facet. Emerald, sapphire and ruby are
uniaxial, peridot is biaxial: their back facets are doubled."""),
    ("crossed_polarisers", RENDER, {"size": "400x300", "spp": 32}, levels, """\
Above, sheets that delay one polarisation by 0, 50, 100 ... 1900 nm: grey, white, yellow and brown, the sensitive tint
at 550 nm, and so on through the second and third order, in the sequence of the chart of Michel-Levy. Below, slices of calcite
turned from 0 to 90 degrees: the first and the last are there, and dark. Their o and e are added as powers: a slice
so thick has no colours."""),
    ("polariscope", RENDER, {"size": "480x160", "spp": 32}, levels, """\
Doubly refractive stones turn light four times and are dark four times in a turn; spinel on the right stays dark. With
`--frames 1-36` the stones turn. `docs/notebooks/polariscope.ipynb` measures it, with the dichroscope and Brewster's angle."""),
    ("calcite_analyser", RENDER, {"size": "320x160", "spp": 48}, levels, """\
The ordinary image on the left is where the dot is; the extraordinary one, a walk-off of 0.22 mm beside it, has coloured rims because
the walk-off changes with the wavelength. At 90 degrees the right one vanishes, at 0 the left one."""),
]


def command(name: str, form: str, numbers: dict) -> str:
    return form.format(name=name, picture=f"docs/gallery/{name}.png", **numbers)


def sentence(name: str, form: str) -> str:
    """What the scene proves: its first line."""
    source = ROOT / "scenes" / f"{name}{'.spar' if form is RENDER else '.py'}"
    return source.read_text(encoding="utf-8").splitlines()[0].strip('/" ')


def make(name: str, form: str, numbers: dict, reduced: Callable[[Image.Image], Image.Image]) -> None:
    subprocess.run(command(name, form, numbers).split(), cwd=ROOT, check=True)
    path = ROOT / "docs" / "gallery" / f"{name}.png"
    with Image.open(path) as picture:
        reduced(picture.convert("RGB")).save(path, optimize=True)


def page() -> str:
    parts = [
        "# Gallery",
        """\
Every scene of `scenes/`, with the sentence that its first line says and the command that makes it. `make gallery`
makes them all anew (`tools/make_gallery.py`) and reduces their colours to save bytes. The figures are those of
Weidlich and Wilkie, *Realistic Rendering of Birefringency in Uniaxial Crystals* (ACM Transactions on Graphics 27(1),
2008). The distances between the images are measured in `tests/python/test_doubling.py`.""",
    ]
    for name, form, numbers, _, words in PICTURES:
        said = sentence(name, form)
        parts += [f"## {name}", said, f"![{said}](gallery/{name}.png)", words]
        parts += [f"```sh\n{command(name, form, numbers)}\n```"]
    return "\n\n".join(parts) + "\n"


def main() -> None:
    wanted = sys.argv[1:] or [""]
    (ROOT / "docs" / "gallery").mkdir(exist_ok=True)
    for name, form, numbers, reduced, _ in PICTURES:
        if any(part in name for part in wanted):
            make(name, form, numbers, reduced)
    (ROOT / "docs" / "gallery.md").write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
