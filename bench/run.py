"""Error against time: every scene at doubling samples, scored against two independent long references.

    make bench                      # or: .venv/bin/python bench/run.py [SCENE ...] [--size WxH] [--doublings N] [--engine NAME]

Prints a row per doubling and writes bench/results/error_against_time.csv: CPU seconds (all threads), samples
a pixel, RMSE of linear RGB, its ratio to the mean, and the renderer's own estimate. The squared error is
mean((x - a)(x - b)) for references a and b, in which the references' noise drops out.
"""

import argparse
import csv
import pathlib
import platform
import time

import numpy as np

import icespar

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE.parent / "scenes"


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def rendered(scene, size, spp, seed, engine):
    start = time.process_time()
    image = scene.render(size=size, spp=spp, seed=seed, engine=engine, progress=False)
    return np.asarray(image, dtype=float), time.process_time() - start, image.report.error


def rows(path, size, doublings, engine):
    scene = icespar.load(str(path))
    longest = 8 * 2**doublings
    a, b = (rendered(scene, size, 4 * longest, seed, engine)[0] for seed in (101, 102))
    mean = a.mean()
    for doubling in range(doublings + 1):
        spp = 8 * 2**doubling
        picture, seconds, estimate = rendered(scene, size, spp, doubling + 1, engine)
        rmse = max(np.mean((picture - a) * (picture - b)), 0) ** 0.5
        yield path.stem, spp, round(seconds, 3), round(rmse, 5), round(rmse / mean, 5), round(estimate, 5)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, default=sorted(SCENES.glob("*.spar")))
    parser.add_argument("--size", default="96x72")
    parser.add_argument("--doublings", type=int, default=3)
    parser.add_argument("--engine", default="auto", choices=["auto", "rays", "beams", "exact"])
    options = parser.parse_args()
    size = tuple(int(n) for n in options.size.split("x"))
    results = HERE / "results"
    results.mkdir(exist_ok=True)
    header = ["scene", "samples", "cpu_seconds", "rmse", "relative_rmse", "estimated_relative_rmse"]
    print(f"{processor()}, icespar {icespar.__version__}, {options.size}")
    print(("{:<20}" + "{:>24}" * 5).format(*header))
    with open(results / "error_against_time.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        for path in options.scenes:
            for row in rows(path, size, options.doublings, options.engine):
                writer.writerow(row)
                print(("{:<20}" + "{:>24}" * 5).format(*row), flush=True)


if __name__ == "__main__":
    main()
