"""What exact beams cost: against the bound and the error, the facets, the depth and the birefringence of a stone.

    python bench/speed/exact.py [--quick] [--docs docs]     # its section of docs/speed.md alone
"""

import argparse
import csv
import pathlib
import statistics
import time

import icespar
import numpy as np
from matplotlib.ticker import NullFormatter
from plots import plt, save, table

ROOT = pathlib.Path(__file__).resolve().parents[2]
TITLE = "## Exact beams"
TILTED = (0.1, 0.23, -1.0)
LEFT, ERROR = "1 % left", "error 0.05 points"
WAYS = {LEFT: {"bound": 0.01, "error": None}, ERROR: {"bound": None, "error": 5e-4}}
MOST = 2_000_000  #: beams; a row that needs more is left out
HEADER = ["against", "stone", "what", "number", "seconds", "beams", "left"]
SECTION = """
![seconds of exact beams](speed/exact.png)

One tilted view of a stone, without symmetry, by `icespar.view` (`python bench/speed/exact.py --docs docs` measures this section alone). Above: the
part of the light that is not followed exactly, which bounds every number's error (solid), and the standard error of light return (ISO) where that part is
sampled (dotted), of a round brilliant. Then seconds for stones with facets in random places; for all paths of so many faces through the brilliant; and for a brilliant whose
n_o is 1.7 and whose n_e is higher by so much, its axis in the girdle's plane. What needs more than two million beams is left out.

"""
_ACROSS = (1.0, 0.0, 0.0)
_MEDIA = {
    "isotropic, 2.42": icespar.Medium.isotropic(2.42),
    "quartz": icespar.Medium.uniaxial(1.5443, 1.5534, _ACROSS),
    "topaz": icespar.Medium.biaxial((1.619, 1.621, 1.627), ((1, 0, 0), (0, 1, 0))),
    "zircon": icespar.Medium.uniaxial(1.925, 1.984, _ACROSS),
}


def random_stone(facets):
    """Planes that touch the unit ball, evenly spread but for chance."""
    random, i = np.random.default_rng(facets), np.arange(facets)
    z = 1 - (2 * i + 2 * random.random(facets)) / facets
    turn = 2 * np.pi * (i / 1.618034 + 0.1 * random.random(facets))
    r = np.sqrt(1 - z**2)
    return icespar.Stone.from_planes(np.column_stack([r * np.cos(turn), r * np.sin(turn), z]), 1.0)


def seen(stone, medium, **how):
    """A view and its CPU seconds: the median of three if they are short."""
    times = []
    while len(times) < (1 if times and times[0] > 0.5 else 3):
        start = time.process_time()
        view = icespar.view(stone, medium, direction=TILTED, max_beams=MOST, **how)
        times.append(time.process_time() - start)
    return view, statistics.median(times)


def costs(quick=False):
    """Rows of HEADER."""
    brilliant = icespar.Design.read(ROOT / "scenes/designs/srb_tolkowsky_diamond.asc").stone()

    def row(against, name, what, number, stone, medium, **how):
        view, seconds = seen(stone, medium, **how)
        if view.beams < MOST:
            yield against, name, what, number, seconds, view.beams, view.untraced

    for name, medium in _MEDIA.items():
        for bound in (0.05, 0.02) if quick else (0.05, 0.02, 0.01, 0.005, 0.002, 0.001):
            yield from row("light", name, "left", bound, brilliant, medium, bound=bound, error=None)
        for error in (5e-3, 2e-3) if quick else (2e-3, 1e-3, 5e-4, 2e-4, 1e-4):
            yield from row("light", name, "error", error, brilliant, medium, bound=None, error=error)
    for facets in (10, 30) if quick else (10, 20, 50, 100, 200, 500, 1000):
        stone = random_stone(facets)
        for name, medium in (
            ("isotropic, 1.8", icespar.Medium.isotropic(1.8)),
            ("zircon", _MEDIA["zircon"]),
        ):
            for what, how in WAYS.items():
                yield from row("facets", name, what, facets, stone, medium, **how)
    for faces in (2, 4) if quick else (2, 3, 4, 6, 8, 10, 12, 16, 20, 24):
        for name in ("isotropic, 2.42", "zircon"):
            yield from row("faces of a path", name, "all", faces, brilliant, _MEDIA[name], bound=0, error=None, max_hits=faces)
    for apart in (0.01, 0.1) if quick else (1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3):
        medium = icespar.Medium.uniaxial(1.7, 1.7 + apart, _ACROSS)
        for what, how in WAYS.items():
            yield from row("birefringence", "n_o 1.7", what, apart, brilliant, medium, **how)


def plot_costs(rows, path):
    kinds = list(dict.fromkeys(row[0] for row in rows))
    figure, places = plt.subplots(2, 2, figsize=(9.2, 6.4), layout="constrained")
    for place, kind in zip(places.flat, kinds, strict=True):
        series = list(dict.fromkeys(row[1:3] for row in rows if row[0] == kind))
        names = list(dict.fromkeys(name for name, _ in series))
        whats = list(dict.fromkeys(what for _, what in series))
        for name, what in series:
            number, seconds = zip(*(row[3:5] for row in rows if row[:3] == (kind, name, what)), strict=True)
            style = {"color": f"C{names.index(name)}", "linestyle": ("-", ":")[whats.index(what)], "markersize": 3}
            x, y = (seconds, number) if kind == "light" else (number, seconds)
            place.plot(x, y, marker="o", label=f"{name}: {what}" if what != "all" else name, **style)
        place.set(xscale="log", yscale="log")
        if kind == "light":
            place.set(xlabel="CPU seconds", ylabel="part of the light", ylim=(5e-5, 2))
        else:
            place.set(xlabel=kind, ylabel="CPU seconds")
        if kind == "faces of a path":
            place.set_xticks(sorted({row[3] for row in rows if row[0] == kind}))
            place.xaxis.set_major_formatter("{x:g}")
        if kind == "birefringence":
            place.set_ylim(0.004, 2)
        for axis in (place.xaxis, place.yaxis):
            axis.set_minor_formatter(NullFormatter())
        place.grid(alpha=0.3, which="both")
        place.tick_params(labelsize=8, which="both")
        place.legend(fontsize=7, ncols=2 if kind == "light" else 1, loc="upper right" if kind == "light" else "best")
    save(figure, path)


def section(rows, folder):
    """The section's text; its plot goes into the folder."""
    plot_costs(rows, pathlib.Path(folder) / "speed" / "exact.png")
    text = f"\n{TITLE}\n{SECTION}Seconds:\n"
    for kind, what in dict.fromkeys((row[0], row[2]) for row in rows):
        found = {(row[1], row[3]): row[4] for row in rows if (row[0], row[2]) == (kind, what)}
        numbers, names = sorted({number for _, number in found}), list(dict.fromkeys(name for name, _ in found))
        header = [f"{kind}, {what}", *(f"{number:g}" for number in numbers)]
        lines = ([name, *(f"{found[name, n]:.4f}" if (name, n) in found else "-" for n in numbers)] for name in names)
        text += "\n" + table(header, lines)
    return text


def replaced(text, new):
    """A page with its section in the place of the old one, or before the last one."""
    before, found, after = text.partition(f"\n{TITLE}\n")
    if not found:
        at = text.rindex("\n## ")
        before, after = text[:at], text[at:]
    return before.rstrip("\n") + "\n" + new + after[after.index("\n## ") :]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few and short rows: to see that all works")
    parser.add_argument("--docs", type=pathlib.Path, help="write the section and its plot into this folder")
    options = parser.parse_args()
    rows = list(costs(options.quick))
    results = ROOT / "bench" / "results"
    results.mkdir(parents=True, exist_ok=True)
    with open(results / "speed_exact.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([HEADER, *rows])
    for row in rows:
        print("  ".join(f"{v:.4g}" if isinstance(v, float) else str(v) for v in row))
    if options.docs:
        page = options.docs / "speed.md"
        page.write_text(replaced(page.read_text(encoding="utf-8"), section(rows, options.docs)), encoding="utf-8")


if __name__ == "__main__":
    main()
