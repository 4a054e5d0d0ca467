"""What the Python tests share: the folders, the program, and a small scene."""

import os
import pathlib

import pytest

import icespar

ROOT = pathlib.Path(__file__).resolve().parents[2]

BOX = """
camera { location <0, 1, -6> look_at <0, 0, 0> angle 30 }
environment { uniform illuminant "D65" 1 }
gem {
  box { <-1, -1, -1>, <1, 1, 1> }
  interior { crystal { indices INDICES } }
}
"""


def box_scene(indices: str) -> icespar.Scene:
    """A box of 2 mm a side under a uniform environment of 1."""
    return icespar.load(BOX.replace("INDICES", indices))


@pytest.fixture(scope="session")
def root() -> pathlib.Path:
    return ROOT


@pytest.fixture(scope="session")
def program() -> pathlib.Path:
    path = pathlib.Path(os.environ.get("ICESPAR_PROGRAM", ROOT / "build" / "icespar"))
    assert path.exists(), f"{path} is not there: make build"
    return path


@pytest.fixture
def calcite_box() -> icespar.Scene:
    return box_scene("1.6584, 1.4864 axis <1, 2, 3>")


@pytest.fixture
def glass_box() -> icespar.Scene:
    return box_scene("1.5")
