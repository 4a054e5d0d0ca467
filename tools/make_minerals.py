"""Writes docs/minerals.md and docs/minerals.png, the table of minerals and what their colours look like.

    .venv/bin/python tools/make_minerals.py   # after make build
"""

import csv
import io
import pathlib
import subprocess

from PIL import Image, ImageDraw, ImageFont

ROOT = pathlib.Path(__file__).resolve().parents[1]
AXES = {1: ("",), 2: ("o", "e"), 3: ("alpha", "beta", "gamma")}

INTRODUCTION = """\
# Minerals

Made by `tools/make_minerals.py` from `core/crystal/minerals.csv` and `core/crystal/colours.csv`; where each number comes
from stands there, and `icespar minerals NAME` prints it. [core/crystal/README.md](../core/crystal/README.md) says how far to trust
them.

A scene names a mineral and, if it is to be coloured, one of its colours: `crystal { mineral "corundum" colour "ruby" axis y }`.
Without `colour` the stone is clear.

## Indices

n at 589.3 nm: n; n_o, n_e; or n_alpha, n_beta, n_gamma. B-G is n(430.8 nm) - n(686.7 nm) for each of them. Confidence A: a
published dispersion formula; B: handbook values, which vary from stone to stone; C: the literature disagrees.
"""

COLOURS = """\
## Colours

What daylight (D65) becomes behind 5 mm, polarised along each principal axis: o and e of uniaxial minerals, alpha, beta and gamma of
biaxial ones. Confidence B: the centres of the bands are published, their widths and strengths are ours; C: the named colours
turned into smooth spectra, or bands of our own. None are measured spectra of one stone.

![What daylight becomes behind 5 mm of each coloured mineral, by axis.](minerals.png)
"""


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


def index_table(minerals: list[dict[str, str]]) -> str:
    lines = ["| mineral | name | optic | n at 589.3 nm | B-G | g/cm3 | confidence |", "|---|---|---|---|---|---|---|"]
    for m in minerals:
        n = ", ".join(m[key] for key in ("n1", "n2", "n3") if m[key])
        bg = m["dispersion_BG"].replace("/", ", ")
        optic, density, trust = m["optic"], m["density"], m["confidence"]
        lines.append(f"| `{m['id']}` | {m['name']} | {optic} | {n} | {bg} | {density} | {trust} |")
    return "\n".join(lines) + "\n"


def axes_of(row: dict[str, str]) -> list[tuple[str, str]]:
    shown = [row[key] for key in ("first", "second", "third") if row[key]]
    return list(zip(AXES[len(shown)], shown, strict=True))


def colour_table(colours: list[dict[str, str]]) -> str:
    lines = ["| mineral | colour | in words | behind 5 mm | confidence |", "|---|---|---|---|---|"]
    for c in colours:
        seen = ", ".join(f"{axis} {code}".strip() for axis, code in axes_of(c))
        lines.append(f"| `{c['mineral']}` | `{c['colour']}` | {c['words']} | {seen} | {c['confidence']} |")
    return "\n".join(lines) + "\n"


def chart(colours: list[dict[str, str]]) -> Image.Image:
    """Two columns of rows: the name, then a swatch for each axis with its letter."""
    font = ImageFont.load_default(size=13)
    height, width, text, swatch, half = 26, 860, 190, 72, (len(colours) + 1) // 2
    picture = Image.new("RGB", (width, half * height + 8), "white")
    draw = ImageDraw.Draw(picture)
    for i, c in enumerate(colours):
        x, y = 8 + (i // half) * width // 2, 6 + (i % half) * height
        draw.text((x, y + 3), f"{c['mineral']} {c['colour']}", "black", font)
        for j, (axis, code) in enumerate(axes_of(c)):
            left = x + text + j * swatch
            draw.rectangle((left, y, left + swatch - 4, y + height - 5), code, "gray")
            dark = sum(int(code[k : k + 2], 16) for k in (1, 3, 5)) < 330
            draw.text((left + 5, y + 2), axis, "white" if dark else "black", font)
    return picture


def main() -> None:
    minerals = rows_of((ROOT / "core/crystal/minerals.csv").read_text(encoding="utf-8"))
    command = ["build/icespar", "minerals", "--colours"]
    colours = rows_of(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout)
    chart(colours).quantize(256, dither=Image.Dither.NONE).save(ROOT / "docs/minerals.png", optimize=True)
    parts = [INTRODUCTION, index_table(minerals), COLOURS, colour_table(colours)]
    (ROOT / "docs/minerals.md").write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
