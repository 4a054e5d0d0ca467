"""Renders the bench's stone with Mitsuba 3, in the Python that has it: mitsuba_worker.py JOB.json.

Says "ready" once everything is compiled; then for each (spp, seed), the last two of which are references, the CPU
seconds, after the picture has been written as .npy.
"""

import json
import pathlib
import sys
import time


def scene_of(mi, job, index, sampler):
    turn = mi.ScalarTransform4f().look_at(origin=[0, 3.75, 0], target=[0, 0, 0], up=[0, 0, -1])
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 64},
            "sensor": {
                "type": "perspective",
                "fov": 35,
                "to_world": turn,
                "sampler": sampler,
                "film": {
                    "type": "hdrfilm",
                    "width": job["size"],
                    "height": job["size"],
                    "rfilter": {"type": "box"},
                    "pixel_format": "luminance",
                },
            },
            "sky": {"type": "envmap", "filename": job["sky"]},
            "stone": {
                "type": "ply",
                "filename": job["mesh"],
                "face_normals": True,
                "bsdf": {"type": "dielectric", "int_ior": index, "ext_ior": 1.0},
            },
        }
    )


def main():
    job = json.loads(pathlib.Path(sys.argv[1]).read_text())
    import mitsuba as mi

    mi.set_variant(job["variant"])
    mi.set_log_level(mi.LogLevel.Error)
    import numpy as np

    sampler = {"type": "multijitter", "sample_count": 4}
    scenes = [scene_of(mi, job, index, sampler) for index in job["indices"]]
    weights = np.array(job["weights"])  # (wavelengths, channels)
    for spp, _ in [(4, 0), *job["renders"][:-2]]:
        for scene in scenes:
            np.array(mi.render(scene, spp=spp, seed=1))  # compiles
    print("ready", flush=True)
    for number, (spp, seed) in enumerate(job["renders"]):
        start = time.process_time()
        total = 0
        for i, (scene, weight) in enumerate(zip(scenes, weights, strict=True)):
            part = np.array(mi.render(scene, spp=spp, seed=len(scenes) * seed + i), dtype=float)
            total = total + part.reshape(job["size"], job["size"], -1)[:, :, :1] * weight
        seconds = time.process_time() - start
        np.save(f"{job['output']}{number}.npy", total)
        print(seconds, flush=True)


if __name__ == "__main__":
    main()
