"""docs/speed.md and its plots."""

import math
import pathlib

import exact
from plots import plt, save, table

ERRORS = (0.2, 0.1, 0.05, 0.02, 0.01)
COLOURS = {"icespar, beams": "tab:blue", "icespar, rays": "tab:cyan", "Mitsuba": "tab:red", "POV-Ray": "tab:orange"}
HEAD = """# Speed

Seconds of processor time to reach an error, measured by `make speed` (`bench/speed/`), which writes this page.
{where}.

The stone is a round brilliant whose table leans by 12 degrees to a camera of 35 degrees at 3.75 girdle radii, below a
gradient of 0.25 to 0.6 and six lamps of radiance 12 and 9 degrees radius: of n = 2.417 (isotropic), of
n = 2.3784 + 0.0134 um^2 / wavelength^2 (dispersive), or of zircon with its axis along the table's normal
(uniaxial). "grid" is a brilliant of calcite above a luminous grid, where light that leaves the stone goes on as rays.
The error is the root mean square over pixels and R, G, B, relative to the picture's mean, against two long pictures x - a, x - b of the same
program: mean((x - a)(x - b)), from which the noise of the references drops out. Peers see the same triangles, the same camera and the sky as a
panorama; they average s and p at every facet, so that their pictures converge to slightly other ones.
Seconds in brackets lie beyond the rows measured, and follow the slope of the last two. A program that errs less in its first row has that row's seconds.
"""

SPLIT = """
## What birefringence costs

The brilliant above, of one wavelength, by beams: as a crystal with its axis along the table's normal, and as a stone of one index, the mean.
Where every face sends on two waves there are more beams to follow, and each weighs less. These are fractions of a second: on a shared
machine a ratio differs by up to a third from run to run.

"""

WORK = """
## Cost against work

![seconds against work](speed/work.png)

Stones with facets in random places (8 samples a pixel); a square full of different boxes (8); the isotropic stone above at 4 samples a
pixel, at 64 with paths cut off after so many faces, and the dispersive one at a quarter of the pixels. What is not named has 128x128 pixels.

"""


def plot(curves, scene, path):
    figure, place = plt.subplots(figsize=(5.2, 3.4), layout="constrained")
    for curve in curves:
        if curve.scene != scene:
            continue
        seconds, errors = zip(*((s, e) for _, s, e in curve.rows if e > 0), strict=True)
        colour = next(c for name, c in COLOURS.items() if curve.program.startswith(name))
        place.plot(seconds, errors, "o-", label=curve.program, color=colour, markersize=4)
    place.set(xscale="log", yscale="log", xlabel="CPU seconds", ylabel="relative RMSE", title=scene)
    place.grid(alpha=0.3, which="both")
    place.legend(fontsize=8)
    save(figure, path)


def plot_work(rows, path):
    kinds = list(dict.fromkeys(row[0] for row in rows))
    figure, places = plt.subplots(1, len(kinds), figsize=(2.3 * len(kinds), 2.4), sharey=True, layout="constrained")
    for place, kind in zip(places, kinds, strict=True):
        n, reading, rendering = zip(*(row[1:] for row in rows if row[0] == kind), strict=True)
        place.plot(n, rendering, "o-", color="tab:blue", markersize=3, label="rendering")
        if max(reading) > 2 * min(reading):
            place.plot(n, reading, "o-", color="tab:orange", markersize=3, label="reading")
            place.legend(fontsize=7)
        place.set(xscale="log", yscale="log")
        if max(n) < 100 * min(n):
            place.set_xticks(n, [str(x) for x in n])
            place.xaxis.minorticks_off()
        place.set_xlabel(kind, fontsize=8)
        place.tick_params(labelsize=7, which="both")
        place.grid(alpha=0.3, which="both")
    places[0].set_ylabel("CPU seconds", fontsize=8)
    save(figure, path)


def seconds_text(seconds, measured):
    if math.isnan(seconds):
        return "-"
    digits = 3 if seconds < 1 else 2 if seconds < 10 else 0
    text = f"{seconds:.{digits}f}"
    return text if measured else f"({text})"


def split_table(pairs):
    rows = []
    for mineral, *curves in pairs:
        times = [[curve.seconds_to(e) for e in ERRORS] for curve in curves]
        rows += [
            [f"{mineral}, {kind}", *(seconds_text(*t) for t in row)]
            for kind, row in zip(("two waves", "one"), times, strict=True)
        ]
        rows.append(["ratio", *(f"{a / b:.1f}" for (a, _), (b, _) in zip(*times, strict=True))])
    return table(["stone", *(f"to {e:g}" for e in ERRORS)], rows)


def write_report(folder, where, curves, pairs, needs, work, beams, threads):
    text = HEAD.format(where=where)
    for scene in dict.fromkeys(c.scene for c in curves):
        plot(curves, scene, pathlib.Path(folder) / "speed" / f"{scene}.png")
        text += f"\n## {scene}\n\n![error against time, {scene}](speed/{scene}.png)\n\n"
        text += table(
            ["program", *(f"to {e:g}" for e in ERRORS), "slope"],
            (
                [c.program, *(seconds_text(*c.seconds_to(e)) for e in ERRORS), f"{c.slope():.2f}"]
                for c in curves
                if c.scene == scene
            ),
        )
    text += SPLIT + split_table(pairs)
    text += "\n## What a scene does not need\n\nThe same samples a pixel, with one part of the full kernel forced "
    text += "(`full=` of `Scene.render`): seconds and relative RMSE without and with it.\n\n"
    text += table(
        ["scene", "engine", "part", "seconds", "forced", "ratio", "error", "forced"],
        (
            [scene, engine, part, f"{s0:.3f}", f"{s1:.3f}", f"{s1 / s0:.2f}", f"{e0:.4f}", f"{e1:.4f}"]
            for scene, part, engine, _, s0, s1, e0, e1 in needs
        ),
    )
    plot_work(work, pathlib.Path(folder) / "speed" / "work.png")
    text += WORK
    text += table(
        ["of", "number", "seconds to read", "seconds to render"],
        ([what, f"{n:,}", f"{reading:.3f}", f"{rendering:.3f}"] for what, n, reading, rendering in work),
    )
    text += exact.section(beams, folder)
    text += "\n## Threads\n\n"
    if not threads:
        text += "Not measured: the machine was busy with other work.\n"
        (pathlib.Path(folder) / "speed.md").write_text(text, encoding="utf-8")
        return
    text += "Elapsed seconds, the least of the runs.\n\n"
    text += table(
        ["scene", "engine", "one", "two", "ratio"],
        ([scene, engine, f"{a:.3f}", f"{b:.3f}", f"{a / b:.2f}"] for scene, engine, a, b in threads),
    )
    (pathlib.Path(folder) / "speed.md").write_text(text, encoding="utf-8")
