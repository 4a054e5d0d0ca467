"""Errors of the cutter's numbers, in points, and processor seconds, by design, mineral and axis.

    python bench/cutters_numbers.py scenes/designs/srb_quartz.asc --minerals zircon,rutile --axes 100,101 --step 1
"""

import argparse
import itertools
import pathlib
import time

import numpy as np

from icespar.analysis import analyse
from icespar.gem import Gem

MINERALS = "diamond,zircon,calcite,rutile,moissanite,corundum,quartz,topaz"


def worst(found):
    """The largest standard error of the whole stone's numbers, and of its table's."""
    errors = {True: [0.0], False: [0.0]}
    for numbers in found:
        for name, number in numbers.items():
            errors[name.startswith("table_")].append(number.error)
    return f"{max(errors[False]):.3f},{max(errors[True]):.3f}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("designs", nargs="+", type=pathlib.Path)
    arguments.add_argument("--minerals", default=MINERALS)
    arguments.add_argument("--axes", default="001,100,101", help="digits along x, y and z of the design")
    arguments.add_argument("--step", type=float, default=0, help="degrees between tilts from -30 to 30; 0: face-up only")
    given = arguments.parse_args()
    tilts = np.arange(-30, 30.5, given.step) if given.step > 0 else []
    print("design,mineral,axis,fire,error,scintillation,error,face-up error,table,tilted error,table,seconds")
    for design, mineral, axis in itertools.product(given.designs, given.minerals.split(","), given.axes.split(",")):
        gem = Gem.of(design, mineral, axis=tuple(int(digit) for digit in axis))
        start = time.process_time()
        found = analyse(gem, tilts)
        seconds = time.process_time() - start
        changes = (f"{n.value:.2f},{n.error:.3f}" for n in (found.face_up[k] for k in ("fire", "scintillation")))
        curves = [numbers for curve in found.curves.values() for numbers in curve]
        print(
            f"{gem.name},{mineral},{axis},{','.join(changes)},{worst([found.face_up])},{worst(curves)},{seconds:.1f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
