"""`python -m icespar analyse` and `compare`, which the program `icespar` calls for commands of these names."""

import argparse
import importlib.util
import math
import pathlib
import sys

import numpy as np

from ._core import Error
from ._progress import bar

DESIGNS = (".asc", ".gem", ".gcs")
OUTPUTS = (".html", ".json", ".csv")
MOST_STEPS = 1000  #: of tilt to either side


def main(arguments: list[str] | None = None) -> int:
    """The exit code: 0 done, 1 a file or a name is at fault, 2 wrong usage."""
    options = _parser().parse_args(arguments)
    try:
        return _run(options)
    except (Error, ValueError, OSError) as error:
        print(f"icespar: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("icespar: interrupted; nothing was written", file=sys.stderr)
        return 130


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="icespar")
    commands = parser.add_subparsers(dest="command", required=True)
    analyse = commands.add_parser(
        "analyse",
        help="pictures and numbers of a design in a mineral",
        description="Light return, leakage, extinction, fire, scintillation, tilt curves, weight and proportions of a faceting "
        "design cut from a mineral, with pictures, ASET, Ideal-Scope, facet diagram and cutting table.",
        epilog="Example: icespar analyse srb.asc --mineral zircon --axis 1,0,0 -o report.html --csv numbers.csv",
    )
    analyse.add_argument("design", metavar="DESIGN", help="a design: .asc or .gem (GemCad), .gcs (Gem Cut Studio)")
    analyse.add_argument("--mineral", metavar="NAME", help="what it is cut from (default: isotropic, of the design's index)")
    compare = commands.add_parser(
        "compare",
        help="designs, or minerals, side by side",
        description="The numbers of each design in each mineral, side by side. Words that end in .asc, .gem or .gcs are "
        "designs, the others minerals.",
        epilog="Example: icespar compare srb.asc oval.gem quartz corundum -o compared.html",
    )
    compare.add_argument("subjects", metavar="DESIGN|MINERAL", nargs="+", help="designs and minerals; one design at least")
    for command in (analyse, compare):
        command.add_argument("--colour", metavar="NAME", help="the mineral's colour in pictures, as `icespar minerals NAME` lists")
        command.add_argument(
            "--coloured",
            action="store_true",
            help="numbers of the stone with its colour besides, in white light (D65): parts of what the eye sees of it",
        )
        command.add_argument(
            "--axis",
            type=_direction,
            default=(0.0, 0.0, 1.0),
            metavar="X,Y,Z",
            help="optic axis (of biaxial minerals that of n_gamma) in the design's frame: z is the dop axis (default 0,0,1)",
        )
        command.add_argument(
            "--retarget",
            action="store_true",
            help="change the angles for the mineral's mean index first, by tangent ratios, as `icespar convert --index` does",
        )
        command.add_argument("--width", type=_positive, default=6.5, metavar="MM", help="width of the stone (default 6.5)")
        command.add_argument("--tilt", type=_tilt, default=30.0, metavar="DEG", help="largest tilt (default 30; 0: none)")
        command.add_argument("--step", type=_positive, default=2.0, metavar="DEG", help="between tilts (default 2)")
        command.add_argument("--bound", type=_positive, default=0.1, metavar="POINTS", help="light not followed exactly, face-up (default 0.1)")
        command.add_argument(
            "--error", type=_positive, default=0.01, metavar="POINTS", help="standard error face-up; tilted, 9 times that (default 0.01)"
        )
        command.add_argument("-o", "--output", type=pathlib.Path, metavar="FILE", help="the report: .html (or .json, .csv)")
        command.add_argument("--json", type=pathlib.Path, metavar="FILE", help="all numbers as JSON")
        command.add_argument("--csv", type=pathlib.Path, metavar="FILE", help="all numbers, one a line")
        command.add_argument("--size", type=_whole(16, 4096), default=280, metavar="N", help="pixels of a picture's side (280)")
        command.add_argument("--spp", type=_whole(1, 1 << 20), default=24, metavar="N", help="samples a pixel (24)")
    return parser


def _run(options: argparse.Namespace) -> int:
    outputs = {}
    for path in filter(None, (options.output, options.json, options.csv)):
        kind = ".json" if path is options.json else ".csv" if path is options.csv else path.suffix.lower()
        if kind not in OUTPUTS:
            raise Error(f"{path}: a report is written as {', '.join(OUTPUTS)}")
        if not path.absolute().parent.is_dir():
            raise Error(f"{path}: there is no folder {path.absolute().parent}")
        outputs[path] = kind
    if ".html" in outputs.values():
        missing = [name for name in ("jinja2", "matplotlib") if importlib.util.find_spec(name) is None]
        if missing:
            raise Error(f"an .html report needs {' and '.join(missing)}: {sys.executable} -m pip install {' '.join(missing)}")
    from . import report
    from .analysis import analyse

    gems = _gems(options)
    if options.tilt / options.step > MOST_STEPS:
        raise Error(f"--step: {options.step:g} degrees are too little for tilts up to {options.tilt:g}; at most {MOST_STEPS} steps fit")
    steps = math.floor(options.tilt / options.step + 1e-9)
    tilts = np.arange(-steps, steps + 1) * options.step if steps else np.array([0.0])
    found = []
    for gem in gems:
        with bar(report.label(gem)) as progress:
            found.append(analyse(gem, tilts, options.bound / 100, options.error / 100, progress, options.coloured))
    for path, kind in outputs.items():
        text = {
            ".html": lambda: report.html(found, options.size, options.spp),
            ".json": lambda: report.json_text(found),
            ".csv": lambda: report.csv_text(found),
        }[kind]()
        report.write(path, text)
        print(f"{path}: {len(text) / 1e3:.0f} kB", file=sys.stderr)
    if not outputs or options.command == "compare":
        print(report.table_text(found), end="")
    return 0


def _gems(options: argparse.Namespace) -> list:
    from .gem import Gem

    if options.command == "analyse":
        designs, minerals = [options.design], [options.mineral]
    else:
        designs = [word for word in options.subjects if word.lower().endswith(DESIGNS)]
        minerals = [word for word in options.subjects if word not in designs] or [None]
        if not designs:
            raise Error("compare: name one design at least (.asc, .gem or .gcs)")
    settings = {"colour": options.colour, "axis": options.axis, "width_mm": options.width}
    gems = [Gem.of(design, mineral, **settings) for design in designs for mineral in minerals]
    if not options.retarget:
        return gems
    return [Gem.of(gem.design.retarget(gem.mean_index()), gem.mineral, name=gem.name, **settings) for gem in gems]


def _positive(text: str) -> float:
    value = float(text)
    if not (math.isfinite(value) and value > 0):
        raise argparse.ArgumentTypeError(f"{text!r} is not a positive number")
    return value


def _tilt(text: str) -> float:
    value = float(text)
    if not 0 <= value <= 80:
        raise argparse.ArgumentTypeError(f"{text!r} is not between 0 and 80")
    return value


def _direction(text: str) -> tuple[float, ...]:
    values = tuple(float(word) for word in text.split(","))
    if len(values) != 3 or not all(map(math.isfinite, values)) or not any(values):
        raise argparse.ArgumentTypeError(f"{text!r} is not a direction X,Y,Z")
    return values


def _whole(least: int, most: int):
    def read(text: str) -> int:
        value = int(text)
        if not least <= value <= most:
            raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from {least} to {most}")
        return value

    read.__name__ = "whole number"
    return read


if __name__ == "__main__":
    sys.exit(main())
