"""Light return against GemRay's: python bench/gemray.py FOLDER, where expected.csv lists designs and GemRay's percentages.

Columns: file, ri, and ISO, COS, SC2 at tilts (ISO_t+0, ISO_t+10 ...) and of the table (TISO_t0 ...), head shadow 10 degrees.
"""

import csv
import pathlib
import sys

import icespar

LIGHTS = {"ISO": "iso", "COS": "cosine", "SC2": "sc2"}


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    print("file,number,ours,gemray,difference,bound")
    for row in csv.DictReader((folder / "expected.csv").open()):
        stone = icespar.Stone.from_design(folder / row["file"])
        medium = icespar.Medium.isotropic(float(row["ri"]))
        for column, text in row.items():
            light, _, tilt = column.partition("_t")
            table = light.startswith("T")
            if light.removeprefix("T") not in LIGHTS or not tilt or (table and float(text) == 0):
                continue
            curve = icespar.tilt_curve(
                stone, medium, float(tilt), lights=[LIGHTS[light.removeprefix("T")]], table=table, bound=2e-4, cutoff="gemray"
            )
            ours = 100 * curve.value[0, 0]
            print(f"{row['file']},{column},{ours:.3f},{text},{ours - float(text):+.3f},{100 * curve.bound[0, 0]:.3f}")


if __name__ == "__main__":
    main()
