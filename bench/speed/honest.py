"""Whether anything is biased, and whether the error that a render tells is the error it has.

    .venv/bin/python bench/speed/honest.py [--size N] [--runs N]

Means: each way to make a picture (engine, samples, part of the full kernel) makes `runs` independent ones of every scene;
their averages over the picture are held against those of rays. z is the difference over its standard error, which
should stay below 3 or so; the standard error says how small a bias would have been seen.
Errors: the estimate of a render over the true RMS error of its luminance, against the mean of all other runs.
"""

import argparse

import numpy as np

import scenes

WAYS = {
    "rays, 16": dict(engine="rays", spp=16),
    "beams, 2": dict(engine="beams", spp=2),
    "beams, 32": dict(engine="beams", spp=32),
    "beams, 16, wavelengths": dict(engine="beams", spp=16, full="wavelengths"),
    "beams, 16, surroundings": dict(engine="beams", spp=16, full="surroundings"),
    "beams, 16, pixels": dict(engine="beams", spp=16, full="pixels"),
    "beams, 16, survivors": dict(engine="beams", spp=16, full="survivors"),
    "beams, 16, Stokes": dict(engine="beams", spp=16, stokes=True),
    "beams, 48": dict(engine="beams", spp=48),
    "rays, 64": dict(engine="rays", spp=64),
}
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def pictures(scene, size, runs, seed, **how):
    images = [scene.render(size=(size, size), seed=seed + i, progress=False, **how) for i in range(runs)]
    return np.array([np.asarray(i.rgb, dtype=float) @ LUMINANCE for i in images]), [i.report.error for i in images]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=32)
    parser.add_argument("--runs", type=int, default=8)
    options = parser.parse_args()
    print(f"{'scene':<12}{'way':<26}{'mean':>9}{'std. error':>12}{'z':>7}{'told / true error':>20}")
    worst = 0.0
    for name, text in scenes.SCENES.items():
        scene = scenes.load(text, options.size)
        base = None
        for number, (way, how) in enumerate(WAYS.items()):
            made, told = pictures(scene, options.size, options.runs, 1000 * number, **how)
            means = made.mean(axis=(1, 2))
            mean, error = means.mean(), means.std(ddof=1) / np.sqrt(len(means))
            base = base or (mean, error)
            z = (mean - base[0]) / max(np.hypot(error, base[1]), 1e-12)
            worst = max(worst, abs(z))
            # Against the mean of the other runs, whose own variance is 1 / (runs - 1) of one run's.
            others = (made.sum(axis=0) - made) / (len(made) - 1)
            true = np.sqrt(np.mean((made - others) ** 2) * (len(made) - 1) / len(made)) / mean
            ratio = np.sqrt(np.mean(np.square(told))) / true if all(told) else np.nan
            print(f"{name:<12}{way:<26}{mean:>9.5f}{error / mean:>12.1e}{z:>7.1f}{ratio:>20.2f}", flush=True)
    print(f"largest |z| {worst:.1f}")


if __name__ == "__main__":
    main()
