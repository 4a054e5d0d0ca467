"""Both programs on one scene file: POV-Ray from its package, icespar from the build under test."""

import pathlib
import shutil
import subprocess
import warnings

import numpy as np
import pytest

import icespar

HERE = pathlib.Path(__file__).resolve().parent
SIZE = (64, 48)


@pytest.fixture(scope="session")
def root():
    return HERE.parents[1]


@pytest.fixture(scope="session")
def povray(tmp_path_factory):
    """A function from a scene file to POV-Ray's picture, linear, (height, width, 3), and to what it said."""
    program = shutil.which("povray")
    if program is None:
        pytest.fail(
            "POV-Ray is not installed, so nothing was compared with it. "
            "On Debian: apt-get install povray povray-includes; without it, leave tests/pov out.",
            pytrace=False,
        )
    folder = tmp_path_factory.mktemp("povray")

    def run(scene, size=SIZE):
        picture = folder / f"{scene.stem}.ppm"
        done = subprocess.run(
            [program, f"+I{scene}", f"+L{scene.parent}", f"+O{picture}", f"+W{size[0]}", f"+H{size[1]}"]
            + ["+FP16", "File_Gamma=1.0", "-D", "-A", "+WT2", "Declare=Povray=1"],
            cwd=folder, capture_output=True, text=True, timeout=60,
        )  # fmt: skip
        assert done.returncode == 0, f"POV-Ray on {scene.name}:\n{done.stderr[-3000:]}"
        return ppm(picture), done.stderr

    return run


def ppm(path):
    """A binary PPM of 16 bits, as POV-Ray writes it, as floats from 0 to 1."""
    data = path.read_bytes()
    fields, at = [], 0
    while len(fields) < 4:
        end = data.index(b"\n", at)
        line = data[at:end].split(b"#")[0].split()
        fields += line
        at = end + 1
    assert fields[0] == b"P6" and fields[3] == b"65535"
    width, height = int(fields[1]), int(fields[2])
    return np.frombuffer(data, ">u2", width * height * 3, at).reshape(height, width, 3) / 65535.0


def mean_over(picture, finer):
    """Means over squares of so many pixels a side."""
    height, width = picture.shape[0] // finer, picture.shape[1] // finer
    return picture.reshape(height, finer, width, finer, 3).mean(axis=(1, 3))


@pytest.fixture(scope="session")
def ours():
    """A function from a scene file to our picture of it; a warning is an error unless it is one of `known`."""

    def run(scene, size=SIZE, spp=64, known=(), seed=0):
        with warnings.catch_warnings():
            warnings.simplefilter("error", icespar.SceneWarning)
            for text in known:
                warnings.filterwarnings("ignore", text, icespar.SceneWarning)
            loaded = icespar.load(scene, size=size)
        return np.asarray(loaded.render(size=size, spp=spp, seed=seed, progress=False).rgb, dtype=float)

    return run
