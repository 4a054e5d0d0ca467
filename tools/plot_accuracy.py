"""The plots of docs/accuracy.md from the rows of build/tests/interface_sweeps: `make accuracy`.

tools/plot_accuracy.py rows.csv docs/accuracy
"""

import argparse
import collections
import csv
import io
import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402
from PIL import Image  # noqa: E402

AXES = {
    "normal": "angle from the normal (rad)",
    "grazing": "angle from grazing (degrees)",
    "critical": "distance from a critical angle, relative",
    "birefringence": "greatest less least index",
    "ratio": "index ratio",
    "kappa": "kappa",
    "optic_axis": "angle to an optic axis (rad)",
}
PANELS = {"totals": "powers and summed fields of a side", "waves": "each wave alone"}
COLOURS = {"uniaxial": "tab:blue", "biaxial": "tab:red"}
COLUMNS = ("x", "median_error", "largest_error", "single_median", "single_largest", "largest_change")
FLOOR = 1e-17  # an error of 0 has to stand somewhere


def rows_of(path: pathlib.Path) -> dict:
    """axis -> panel -> medium -> columns of numbers."""
    found = collections.defaultdict(lambda: collections.defaultdict(lambda: collections.defaultdict(list)))
    with path.open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            found[row["axis"]][row["what"]][row["medium"]].append(
                [float(row[name]) for name in COLUMNS]
            )
    return found


def figure_of(axis: str, panels: dict):
    figure, places = plt.subplots(1, 2, figsize=(10, 2.9), sharex=True, sharey=True, layout="constrained")
    for place, (what, title) in zip(places, PANELS.items(), strict=True):
        for medium, rows in panels[what].items():
            x, median, largest, single, single_largest, change = (
                [max(v, FLOOR) for v in column] for column in zip(*rows, strict=True)
            )
            colour = COLOURS[medium]
            place.fill_between(x, FLOOR, change, color=colour, alpha=0.12, linewidth=0)
            place.plot(x, median, color=colour, label=f"{medium}, median")
            place.plot(x, largest, ".", color=colour, label=f"{medium}, largest")
            if max(single) > FLOOR:
                place.plot(x, single, "--", color="tab:green", label=f"{medium}, single precision")
                place.plot(x, single_largest, ".", color="tab:green")
        place.set(yscale="log", ylim=(FLOOR, 10), title=title, xlabel=AXES[axis])
        if axis != "ratio":
            place.set_xscale("log")
        place.grid(alpha=0.3)
    if axis not in ("ratio", "kappa"):
        places[0].invert_xaxis()  # both: they share it
    places[0].set_ylabel("relative error")
    handles = {label: line for place in places for line, label in zip(*place.get_legend_handles_labels(), strict=True)}
    figure.legend(handles.values(), handles.keys(), fontsize=8, loc="outside right upper")
    return figure


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rows", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    rows = rows_of(arguments.rows)
    for axis in AXES:
        picture = io.BytesIO()
        figure = figure_of(axis, rows[axis])
        figure.savefig(picture, format="png", dpi=90)
        plt.close(figure)
        small = Image.open(picture).convert("RGB").quantize(64)
        small.save(arguments.folder / f"{axis}.png", optimize=True)


if __name__ == "__main__":
    main()
