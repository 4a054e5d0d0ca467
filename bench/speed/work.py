"""Processor time against the size of the work: facets, stones, pixels, samples of the spectrum, depth."""

import time

import numpy as np

import scenes

SKY = scenes.environment()


def ball(facets):
    """Planes that touch the unit ball, evenly spread but for chance."""
    random = np.random.default_rng(facets)
    z = 1 - (2 * np.arange(facets) + 1 + 0.8 * random.uniform(-1, 1, facets)) / facets
    turn = 2 * np.pi * (np.arange(facets) / ((1 + 5**0.5) / 2) + 0.1 * random.uniform(size=facets))
    r = np.sqrt(1 - z * z)
    planes = (f"plane {{ <{a:.12g}, {b:.12g}, {c:.12g}>, 1 }}" for a, b, c in zip(r * np.cos(turn), r * np.sin(turn), z))
    return f"""{scenes.CAMERA}
{SKY}
gem {{ intersection {{ {" ".join(planes)} }} interior {{ ior 1.8 }} }}
"""


def crowd(stones):
    """So many different boxes in a square that fills the picture."""
    side = int(np.ceil(np.sqrt(stones)))
    size = 1.6 / side
    gems = []
    for i in range(stones):
        x, z = (i % side - (side - 1) / 2) * 2 / side, (i // side - (side - 1) / 2) * 2 / side
        gems.append(
            f"gem {{ box {{ -{size / 2:.9g}, <{size / 2:.9g}, {size * (0.3 + 0.2 * i / stones):.9g}, {size / 2:.9g}> }}"
            f" interior {{ ior 1.8 }} rotate <{20 * np.sin(i):.6g}, {37 * i % 90}, 0> scale 0.7"
            f" translate <{x:.9g}, 0, {z:.9g}> }}"
        )
    return f"{scenes.CAMERA}\n{SKY}\n" + "\n".join(gems)


def deep(level):
    return f"global_settings {{ max_trace_level {level} }}\n" + scenes.SCENES["isotropic"]


def work(quick):
    """(what there is much of, how much, seconds to read the scene, seconds to render it)."""
    size = 32 if quick else 128
    cases = [
        *(("facets", n, ball(n), size, 8) for n in (10, 30, 100, 300, 1000, 3000, 10000)),
        *(("stones", n, crowd(n), size, 8) for n in (1, 4, 10, 30, 100, 300, 1000)),
        *(("pixels", n * n, scenes.SCENES["isotropic"], n, 4) for n in (32, 64, 128, 256, 512)),
        *(("samples of a dispersive stone", n, scenes.SCENES["dispersive"], size // 2, n) for n in (8, 16, 32, 64)),
        *(("faces of a path", n, deep(n), size, 64) for n in (2, 4, 8, 16, 32, 64)),
    ]
    for what, n, text, pixels, spp in cases:
        if quick and n > 300 and what != "pixels":
            continue
        start = time.process_time()
        scene = scenes.load(text, pixels)
        read = time.process_time()
        scene.render(size=(pixels, pixels), spp=spp, seed=1, threads=1, progress=False)
        yield what, n, read - start, time.process_time() - read

