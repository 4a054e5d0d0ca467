"""Error against CPU time, ours and other renderers' on the same stone, and docs/speed.md from it.

    make speed     # or: MITSUBA_PYTHON=... .venv/bin/python bench/speed/run.py [--quick] [--docs docs]

Peers: POV-Ray when it is installed; Mitsuba 3 when MITSUBA_PYTHON names a Python that has it (its vectorised variants want
LLVM 16 or newer: DRJIT_LIBLLVM_PATH). Each program is scored against two long pictures of its own, since
peers take the mean of s and p at every facet, which is not the same picture. Writes bench/results/speed*.csv.
"""

import argparse
import csv
import datetime
import os
import pathlib
import platform
import tempfile

import exact
import icespar
import peers
from curves import Curve, error_of
from ours import Ours
from report import write_report
from work import work

ROOT = pathlib.Path(__file__).resolve().parents[2]


def machine():
    name = platform.processor()
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            name = line.split(":", 1)[1].strip()
    return f"{name}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}"


def kept_curves():
    """What the last run wrote of peers."""
    curves = {}
    with open(ROOT / "bench" / "results" / "speed.csv", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["program"].startswith("icespar"):
                continue
            curve = curves.setdefault((row["scene"], row["program"]), Curve(row["scene"], row["program"]))
            curve.rows.append((int(row["level"]), float(row["cpu_seconds"]), float(row["relative_rmse"])))
    return list(curves.values())


def peer_curves(size, quick):
    with tempfile.TemporaryDirectory() as folder:
        for peer in peers.found(pathlib.Path(folder)):
            for scene in peer.levels:
                levels = peer.levels[scene][: 2 if quick else None]
                renders = [*((level, 7 + level) for level in levels), *peer.references[scene]]
                done = peer.run(scene, size, renders)
                if done is None:
                    print(f"{peer.label()} fails on {scene}; left out")
                    continue
                a, b = done[-2][0], done[-1][0]
                curve = Curve(scene, peer.label())
                for level, (picture, seconds) in zip(levels, done, strict=False):
                    curve.rows.append((level, seconds, error_of(picture, a, b)))
                yield curve


def written(name, header, rows):
    folder = ROOT / "bench" / "results"
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows(rows)
    for row in rows:
        print("  ".join(f"{v:.4g}" if isinstance(v, float) else str(v) for v in row), flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=256, help="pixels a side (default 256)")
    parser.add_argument("--quick", action="store_true", help="a small picture, short runs: to see that all works")
    parser.add_argument("--keep-peers", action="store_true", help="take other renderers' rows from the last run")
    parser.add_argument("--docs", type=pathlib.Path, help="write speed.md and its plots into this folder")
    options = parser.parse_args()
    size = 48 if options.quick else options.size
    runs = 1 if options.quick else 3
    ours = Ours(size, longest=0.2 if options.quick else 4.0)
    print(f"{machine()}; icespar {icespar.__version__}; {size}x{size} pixels")
    curves = []
    names = list(ours.scenes)
    for curve in (
        *(ours.curve(name, engine) for name in names for engine in ("beams", "rays")),
        *(kept_curves() if options.keep_peers else peer_curves(size, options.quick)),
    ):
        curves.append(curve)
    rows = [(c.scene, c.program, level, s, e) for c in curves for level, s, e in c.rows]
    written("speed.csv", ["scene", "program", "level", "cpu_seconds", "relative_rmse"], rows)
    pairs = list(ours.split())
    header = ["scene", "part", "engine", "samples", "lesser_s", "full_s", "lesser_rmse", "full_rmse"]
    needs = written("speed_needs.csv", header, list(ours.needs(runs)))
    sizes = written("speed_work.csv", ["what", "number", "reading_s", "rendering_s"], list(work(options.quick)))
    beams = written("speed_exact.csv", exact.HEADER, list(exact.costs(options.quick)))
    busy = os.getloadavg()[0] > 1.5  # elapsed time would say more of other programs
    times = [] if busy else list(ours.threads(runs))
    threads = written("speed_threads.csv", ["scene", "engine", "one_s", "two_s"], times)
    if options.docs:
        where = f"{machine()}, {datetime.date.today():%B %Y}, icespar {icespar.__version__}, {size}x{size} pixels"
        where += " (other renderers in an earlier run)" if options.keep_peers else ""
        write_report(options.docs, where, curves, pairs, needs, sizes, beams, threads)


if __name__ == "__main__":
    main()
