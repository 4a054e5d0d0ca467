"""Error against CPU seconds of pictures in a parallel view: exact beams and pixel beams, one thread.

python bench/view_pictures.py, with references by exact beams.
"""

import pathlib
import time

import icespar
import numpy as np

SCENE = """
camera { orthographic location <0, 5, 0> look_at <0, 0, 0> right 2.4*x up 2.4*z sky z }
environment { ENVIRONMENT }
gem { design "designs/srb_tolkowsky_diamond.asc" interior { INTERIOR } rotate TURN }
"""
LAMPS = """gradient rgb 0.02, rgb <0.7, 0.8, 1>
  lamps { disc <0.5, 1, 0.3>, 8, rgb 6 disc <-0.6, 1, -0.5>, 6, rgb <6, 3, 2> }"""
CASES = {
    "lamps": (LAMPS, "ior 2.417", "0", 512),
    "aset": ("aset head 10", "ior 2.417", "0", 512),
    "dispersive": (LAMPS, 'crystal { mineral "diamond" }', "0", 256),
    "tilted zircon": (LAMPS, "crystal { indices 1.925, 1.984 axis y }", "<9, 0, 14>", 256),
}
# Relative errors of references, where the default would take long.
REFERENCE = {"dispersive": 0.004, "tilted zircon": 0.002}


def main() -> None:
    folder = pathlib.Path(__file__).resolve().parents[1] / "scenes"
    print("scene,engine,how,seconds,rmse,mean")
    for name, (sky, interior, turn, size) in CASES.items():
        scene = SCENE.replace("ENVIRONMENT", sky).replace("INTERIOR", interior)
        scene = icespar.load(scene.replace("TURN", turn), folder=folder)

        def picture(**how):
            start = time.process_time()
            image = scene.render(size=(size, size), threads=1, progress=False, **how)
            return np.asarray(image.rgb, float), time.process_time() - start

        waves = {"spp": 512} if name == "dispersive" else {}
        reference, _ = picture(engine="exact", error=REFERENCE.get(name, 4e-5), **waves)
        ways = [{"engine": "exact", "error": e} for e in (0.1, 0.04, 0.02, 0.01, 0.004)]
        ways += [{"engine": "beams", "spp": n} for n in (16, 64, 256)]
        for way in ways:
            image, seconds = picture(**way)
            rmse = np.sqrt(((image - reference) ** 2).mean())
            bound = way.get("error", way.get("spp"))
            print(f"{name},{way['engine']},{bound},{seconds:.3f},{rmse:.5f},{reference.mean():.3f}", flush=True)


if __name__ == "__main__":
    main()
