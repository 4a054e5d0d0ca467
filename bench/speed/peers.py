"""The bench's stone by other renderers: POV-Ray where it is installed, Mitsuba 3 where a Python has it."""

import json
import os
import pathlib
import resource
import shutil
import subprocess

import numpy as np

import scenes

HERE = pathlib.Path(__file__).resolve().parent
WAVELENGTHS = 16
MAP = (1024, 512)  # pixels of the panorama that peers see
SCALE = 16.0  # POV-Ray's pictures go through 16 bits: the sky is dimmed by so much


def panorama(first_axis, second_axis):
    """Radiances by azimuth from one axis of the world to the other, from the top; mean over 4 x 4 points a pixel."""
    fine = 4
    azimuth = 2 * np.pi * (np.arange(MAP[0] * fine) + 0.5) / (MAP[0] * fine)
    polar = np.pi * (np.arange(MAP[1] * fine) + 0.5) / (MAP[1] * fine)
    around = np.cos(azimuth)[:, None] * np.array(first_axis) + np.sin(azimuth)[:, None] * np.array(second_axis)
    rows = []
    for part in np.array_split(polar, 16):
        d = np.sin(part)[:, None, None] * around + np.cos(part)[:, None, None] * np.array([0, 1, 0])
        rows.append(scenes.sky(d))
    light = np.concatenate(rows)
    return light.reshape(MAP[1], fine, MAP[0], fine).mean(axis=(1, 3)).astype(np.float32)


def write_exr(path, light):
    import OpenImageIO as oiio

    out = oiio.ImageOutput.create(str(path))
    spec = oiio.ImageSpec(light.shape[1], light.shape[0], 3, "float")
    out.open(str(path), spec)
    out.write_image(np.repeat(light[:, :, None], 3, axis=2))
    out.close()


def colour_weights():
    """Wavelengths, and what each adds to linear RGB; the sum is white (Wyman, Sloan and Shirley 2013)."""
    edges = np.linspace(400, 700, WAVELENGTHS + 1)
    nm = (edges[1:] + edges[:-1]) / 2

    def lobe(at, left, right):
        return np.exp(-0.5 * ((nm - at) * np.where(nm < at, left, right)) ** 2)

    x = 0.362 * lobe(442, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323) - 0.065 * lobe(501.1, 0.049, 0.0382)
    y = 0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322)
    z = 1.217 * lobe(437, 0.0845, 0.0278) + 0.681 * lobe(459, 0.0385, 0.0725)
    matrix = np.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.204, 1.057]])
    rgb = (matrix @ np.array([x, y, z])).T
    return nm, rgb / rgb.sum(axis=0)


class Mitsuba:
    """Path tracing, with the variant that works here: vectorised if its LLVM does."""

    name = "Mitsuba 3"
    levels = {"isotropic": (4, 16, 64, 256), "dispersive": (2, 8, 32)}
    references = {"isotropic": ((1024, 101), (1024, 102)), "dispersive": ((128, 101), (128, 102))}

    def __init__(self, python, folder):
        self.python, self.folder, self.variant = python, folder, None
        triangles = scenes.facets() * [1, 1, -1]  # right-handed, corners counter-clockwise from outside
        points = triangles.reshape(-1, 3)
        lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", "property float x", "property float y"]
        lines += ["property float z", f"element face {len(triangles)}", "property list uchar int vertex_indices"]
        lines += ["end_header", *(" ".join(f"{c:.9g}" for c in p) for p in points)]
        lines += [f"3 {i} {i + 1} {i + 2}" for i in range(0, len(points), 3)]
        (folder / "stone.ply").write_text("\n".join(lines) + "\n")
        write_exr(folder / "mitsuba.exr", panorama((0, 0, 1), (1, 0, 0)))
        for variant in ("llvm_ad_mono", "scalar_rgb"):
            if self.run("isotropic", 8, [], variant) is not None:
                self.variant = variant
                break

    def run(self, kind, size, renders, variant=None):
        """Renders are (level, seed). [(picture, CPU seconds)], or None when it does not work."""
        nm, rgb = colour_weights()
        flat = kind == "isotropic"
        job = {
            "variant": variant or self.variant,
            "size": size,
            "mesh": str(self.folder / "stone.ply"),
            "sky": str(self.folder / "mitsuba.exr"),
            "indices": [scenes.DIAMOND] if flat else [scenes.dispersive_index(w) for w in nm],
            "weights": [[1.0]] if flat else rgb.tolist(),
            "renders": renders,
            "output": str(self.folder / f"mitsuba-{kind}-"),
        }
        path = self.folder / "job.json"
        path.write_text(json.dumps(job))
        done = subprocess.run(
            [self.python, HERE / "mitsuba_worker.py", path], capture_output=True, text=True, timeout=1800
        )
        if done.returncode != 0:
            return None
        seconds = [float(line) for line in done.stdout.split("ready")[1].split()]
        return [(np.load(f"{job['output']}{i}.npy"), s) for i, s in enumerate(seconds)]

    def label(self):
        return f"{self.name} ({self.variant})"


class PovRay:
    """Recursive ray tracing with full splitting; a level is a grid of level x level jittered samples a pixel."""

    name = "POV-Ray 3.7"
    levels = {"isotropic": (1, 2, 3, 4), "dispersive": (1, 2)}
    references = {"isotropic": ((7, 1), (8, 1)), "dispersive": ((3, 1), (4, 1))}

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        write_exr(folder / "povray.exr", panorama((1, 0, 0), (0, 0, 1)) / SCALE)
        triangles = "\n".join(f"triangle {{ {', '.join(map(scenes.vector, t))} }}" for t in scenes.facets())
        (folder / "stone.inc").write_text(f"#declare Stone = mesh {{\n{triangles}\n}}\n")

    def text(self, kind):
        spread = scenes.dispersive_index(400) / scenes.dispersive_index(700)
        interior = f"ior {scenes.DIAMOND}"
        if kind == "dispersive":
            interior += f" dispersion {spread:.6f} dispersion_samples {WAVELENGTHS}"
        return f"""#version 3.7;
#include "stone.inc"
global_settings {{ assumed_gamma 1 max_trace_level 64 }}
{scenes.CAMERA}
sky_sphere {{ pigment {{ image_map {{ exr "povray.exr" map_type 1 interpolate 2 }} }} }}
object {{ Stone
  pigment {{ rgbt 1 }}
  finish {{ ambient 0 diffuse 0 reflection {{ 0, 1 fresnel }} conserve_energy }}
  interior {{ {interior} }}
}}
"""

    def run(self, kind, size, renders):
        scene, picture = self.folder / f"{kind}.pov", self.folder / f"{kind}.ppm"
        scene.write_text(self.text(kind))
        out = []
        for level, jitter in renders:
            options = [f"+I{scene}", f"+O{picture}", f"+W{size}", f"+H{size}", "+WT1", "-D", "+FP16", "File_Gamma=1.0"]
            options += [f"+AM1 +A0.0 +R{level} +J{jitter}"] if level > 1 else ["-A"]
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            done = subprocess.run(
                [self.program, *" ".join(options).split()],
                cwd=self.folder, capture_output=True, text=True, timeout=1800,
            )  # fmt: skip
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            if done.returncode != 0:
                print(done.stderr[-2000:])
                return None
            seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            out.append((SCALE * ppm(picture), seconds))
        return out

    def label(self):
        return self.name


def ppm(path):
    """A binary PPM of 16 bits as floats."""
    fields, data = [], path.read_bytes()
    at = 0
    while len(fields) < 4:
        end = data.index(b"\n", at)
        fields += data[at:end].split(b"#")[0].split()
        at = end + 1
    width, height = int(fields[1]), int(fields[2])
    return np.frombuffer(data, ">u2", width * height * 3, at).reshape(height, width, 3) / 65535.0


def found(folder):
    """Every peer that works here."""
    peers = []
    python = os.environ.get("MITSUBA_PYTHON")
    if python:
        peer = Mitsuba(python, folder)
        if peer.variant:
            peers.append(peer)
    program = shutil.which("povray")
    if program:
        peers.append(PovRay(program, folder))
    return peers
