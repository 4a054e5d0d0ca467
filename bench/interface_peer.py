"""The same faces by icespar and by pyElli, in one run: microseconds a face, and who is wrong where.

    .venv/bin/python -m pip install pyElli packaging
    .venv/bin/python bench/interface_peer.py [--count N] [--cases N] [--seed N]

Light meets a uniaxial crystal of any axis from an isotropic medium, denser or rarer. A face is both
incident polarisations, for either program. pyElli solves Berreman's 4 x 4 problem of a half space and
works on many wavelengths at a time, so its batch is one crystal at one angle; faces of different crystals
or angles need a call each. Times are CPU seconds of one core, best of several. Single random cases are
compared by the powers reflected into s and p; a power above 1 is wrong by itself.
"""

import argparse
import pathlib
import platform
import time
import warnings
from importlib.metadata import version

import elli
import numpy as np

import icespar


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def cpu_seconds(work, repeats=7):
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def material(n_o, n_e, axis):
    """pyElli's crystal with this axis in its frame: z along the normal, x and z in the plane of incidence."""
    crystal = elli.UniaxialMaterial(elli.ConstantRefractiveIndex(n_o), elli.ConstantRefractiveIndex(n_e))
    third = np.array(axis) / np.linalg.norm(axis)
    first = np.cross(third, [0.3, 0.5, -0.8])
    first /= np.linalg.norm(first)
    crystal.set_rotation(np.stack([first, np.cross(third, first), third], axis=1))
    return crystal


def by_elli(n, crystal, degrees, wavelengths):
    """Powers reflected, [incident s or p][reflected s or p]."""
    outside = elli.IsotropicMaterial(elli.ConstantRefractiveIndex(n))
    result = elli.Structure(outside, [], material(*crystal)).evaluate(wavelengths, degrees)
    r = np.abs(result.jones_matrix_r) ** 2  # [reflected p, s][incident p, s]
    return r[:, ::-1, ::-1].swapaxes(1, 2)


def by_icespar(n, crystal, directions, names=("power",)):
    first, second = icespar.Medium.isotropic(n), icespar.Medium.uniaxial(*crystal)
    return [
        icespar.interface(first, second, (0, 0, 1), directions, mode=mode, only=names, threads=1) for mode in "sp"
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000, help="faces of a batch")
    parser.add_argument("--cases", type=int, default=300, help="single cases compared")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    calcite, degrees = (1.6584, 1.4864, (0.36, 0.48, 0.8)), 50.0
    angle = np.radians(degrees)
    direction = np.array([np.sin(angle), 0, np.cos(angle)])

    print(f"{processor()}, one core; pyElli {version('pyElli')}, icespar {icespar.__version__}")
    wavelengths = np.linspace(400, 800, options.count)
    theirs = cpu_seconds(lambda: by_elli(1.0, calcite, degrees, wavelengths), 3) / len(wavelengths)
    print(f"pyElli, batch of {len(wavelengths)}: {theirs * 1e6:.2f} us a face")
    directions = np.tile(direction, (options.count, 1))
    fastest = np.inf
    for names in ({"power"}, {"power", "ray"}):
        ours = cpu_seconds(lambda: by_icespar(1.0, calcite, directions, names)) / options.count
        print(
            f"icespar, batch of {options.count}, {' and '.join(sorted(names))}: {ours * 1e6:.4f} us a face, "
            f"{theirs / ours:.0f} times as fast"
        )
        fastest = min(fastest, ours)
    single = cpu_seconds(lambda: by_elli(1.0, calcite, degrees, wavelengths[:1]))
    print(f"pyElli, a face of its own angle or crystal: {single * 1e6:.0f} us, icespar {single / fastest:.0f} times as fast")

    wrong, failed, energy = [], 0, 0.0
    for _ in range(options.cases):
        n, n_o, n_e = rng.uniform(1, 2.6), rng.uniform(1.3, 2.7), rng.uniform(1.3, 2.7)
        axis, degrees = rng.normal(size=3), rng.uniform(0, 89)
        angle = np.radians(degrees)
        waves = by_icespar(n, (n_o, n_e, axis), [np.sin(angle), 0, np.cos(angle)])
        ours = np.array([w.reflected.power[0] for w in waves])
        energy = max(energy, *(abs(w.reflected.power.sum() + w.transmitted.power.sum() - 1) for w in waves))
        try:
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore")
                theirs = by_elli(n, (n_o, n_e, axis), degrees, np.array([589.3]))[0]
        except (ArithmeticError, ValueError, np.linalg.LinAlgError):
            failed += 1
            continue
        if not np.abs(ours - theirs).max() < 1e-6:
            wrong.append((np.abs(ours - theirs).max(), n, n_o, n_e, axis, degrees, theirs.sum(axis=1)))
    print(f"{options.cases} random cases: icespar keeps energy to {energy:.1e}; pyElli differs by more than 1e-6 in "
          f"{len(wrong)} and raises in {failed}")
    for difference, n, n_o, n_e, axis, degrees, reflected in sorted(wrong, key=lambda w: -w[0])[:10]:
        print(
            f"  by {difference:.1e}: n {n:.6f}, n_o {n_o:.6f}, n_e {n_e:.6f}, axis {np.round(axis, 6).tolist()}, "
            f"{degrees:.4f} degrees; pyElli reflects {reflected[0]:.6f} of s and {reflected[1]:.6f} of p"
        )


if __name__ == "__main__":
    main()
