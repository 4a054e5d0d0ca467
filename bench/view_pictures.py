"""Error against CPU seconds of pictures in a parallel view: exact beams and pixel beams, one thread.

python bench/view_pictures.py, with references by exact beams; with the word shared (and names of stones), exact beams alone, at the wavelengths
that a stone is traced at by itself and at 65, which share nothing. Errors told are those of the luminance.
"""

import pathlib
import sys
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
SHARED = {
    "diamond": 'mineral "diamond"',
    "zircon": 'mineral "zircon" axis <1, 1, 0.3>',
    "topaz": 'mineral "topaz" axes x, z',
    "red spinel": 'mineral "spinel" colour "red"',
    "ruby": 'mineral "corundum" colour "ruby" axis y',
    "blue sapphire": 'mineral "corundum" colour "blue sapphire" axis y',
    "tourmaline": 'mineral "tourmaline" colour "green" axis x',
}


FOLDER = pathlib.Path(__file__).resolve().parents[1] / "scenes"


def shared(names: list[str]) -> None:
    print("stone,view,wavelengths,seconds,told,rmse of luminance,rmse of rgb")
    for name in names or SHARED:
        for view, turn in {"face-up": "0", "tilted": "<9, 0, 14>"}.items():
            scene = SCENE.replace("ENVIRONMENT", LAMPS).replace("INTERIOR", f"crystal {{ {SHARED[name]} }}").replace("TURN", turn)
            scene = scene.replace("rotate", "scale_to width 5.5 rotate").replace("2.4*", "6.6*").replace("5, 0>", "15, 0>")
            scene = icespar.load(scene, folder=FOLDER)

            def picture(error, seed, **how):
                start = time.process_time()
                image = scene.render(size=(256, 256), threads=1, progress=False, engine="exact", error=error, seed=seed, **how)
                return np.asarray(image.rgb, float), time.process_time() - start, image.report

            reference = picture(0.005, 1, spp=129)[0]
            for how in ({}, {"spp": 65}):
                image, seconds, report = picture(0.01, 2, **how)
                luminance, rgb = (
                    np.sqrt((((image - reference) @ w) ** 2).mean()) / (reference @ w).mean()
                    for w in (np.array([0.2126, 0.7152, 0.0722]), np.eye(3))
                )
                print(f"{name},{view},{report.samples},{seconds:.2f},{report.error:.4f},{luminance:.4f},{rgb:.4f}", flush=True)


def main() -> None:
    if sys.argv[1:2] == ["shared"]:
        return shared(sys.argv[2:])
    print("scene,engine,how,seconds,rmse,mean")
    for name, (sky, interior, turn, size) in CASES.items():
        scene = SCENE.replace("ENVIRONMENT", sky).replace("INTERIOR", interior)
        scene = icespar.load(scene.replace("TURN", turn), folder=FOLDER)

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
