"""The bench's scenes by icespar: both engines, the needs on and off, one thread and two."""

import statistics
import time

import numpy as np

import scenes
from curves import Curve, error_of

REFERENCE = {"isotropic": 512, "dispersive": 2048, "uniaxial": 256, "grid": 2048}
FIRST = {"beams": 1, "rays": 4}


def rendered(scene, size, spp, seed, **how):
    start = time.process_time()
    image = scene.render(size=(size, size), spp=spp, seed=seed, progress=False, **({"threads": 1} | how))
    return np.asarray(image.rgb, dtype=float), time.process_time() - start, image.report


class Ours:
    def __init__(self, size, longest):
        self.size, self.longest = size, longest
        self.scenes = {name: scenes.load(text, size) for name, text in scenes.SCENES.items()}
        self.references = {}

    def reference(self, name):
        if name not in self.references:
            spp = REFERENCE.get(name, 512)
            self.references[name] = [rendered(self.scenes[name], self.size, spp, seed)[0] for seed in (101, 102)]
        return self.references[name]

    def curve(self, name, engine):
        curve = Curve(name, f"icespar, {engine}")
        spp, seconds = FIRST[engine], 0.0
        longest = 2 * self.longest if name == "dispersive" else self.longest
        # A stone that keeps little light has no more beams to follow at last.
        while seconds < longest / 2 and spp <= 1 << 14:
            picture, seconds, _ = rendered(self.scenes[name], self.size, spp, spp, engine=engine)
            curve.rows.append((spp, seconds, error_of(picture, *self.reference(name))))
            spp *= 2
        return curve

    def split(self):
        """(mineral, curve of the crystal, curve of the same stone of one index), by beams."""
        for mineral, crystals in scenes.SPLIT.items():
            curves = []
            for kind, crystal in zip(("split", "whole"), crystals, strict=True):
                name = f"{mineral}, {kind}"
                self.scenes[name] = scenes.load(scenes.brilliant(crystal), self.size)
                curves.append(self.curve(name, "beams"))
            yield mineral, *curves

    def needs(self, runs):
        """(scene, part, engine, seconds without, with, error without, with): medians of pairs in turn."""
        cases = [
            ("isotropic", "beams", 32, ["stokes", "wavelengths", "surroundings", "tree", "pixels"]),
            ("uniaxial", "beams", 16, ["stokes", "wavelengths", "surroundings", "pixels", "survivors"]),
            ("isotropic", "rays", 16, ["wavelengths", "absorption", "tree"]),
            ("uniaxial", "rays", 4, ["general"]),
        ]
        for name, engine, spp, parts in cases:
            for part in parts:
                pairs = []
                for seed in range(runs):
                    for full in ((), (part,)):
                        picture, seconds, _ = rendered(
                            self.scenes[name], self.size, spp, seed, engine=engine, full=full
                        )
                        pairs.append((seconds, error_of(picture, *self.reference(name))))
                lesser, full = pairs[::2], pairs[1::2]
                middle = [statistics.median(p[i] for p in side) for i in (0, 1) for side in (lesser, full)]
                yield name, part, engine, spp, *middle

    def threads(self, runs):
        """(scene, engine, wall seconds by one thread, by two): the least of runs in turn."""
        for name, engine, spp in (("isotropic", "beams", 64), ("uniaxial", "beams", 32), ("isotropic", "rays", 16)):
            best = [9e9, 9e9]
            for seed in range(runs):
                for n in (1, 2):
                    report = rendered(self.scenes[name], self.size, spp, seed, engine=engine, threads=n)[2]
                    best[n - 1] = min(best[n - 1], report.seconds)
            yield name, engine, *best
