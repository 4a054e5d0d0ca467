"""Gem scenes as POV-Ray's artists write them run here unchanged: no error, one warning a word, a sensible picture.

The pictures cannot agree to the pixel: POV-Ray has highlights and mirrors on matt things, and no polarisation.
"""

import re
import warnings

import numpy as np
import pytest

import icespar
from .conftest import HERE

SCENES = sorted(path.stem for path in (HERE / "gems").glob("*.pov"))
SIZE = (64, 48)


def blurred(picture, by=4):
    """Means over squares of pixels, as light and dark alone, on a scale like the eye's."""
    height, width = picture.shape[0] // by, picture.shape[1] // by
    grey = np.clip(picture.mean(axis=2), 0, 1) ** 0.45
    return grey.reshape(height, by, width, by).mean(axis=(1, 3))


@pytest.mark.parametrize("name", SCENES)
def test_a_povray_artists_scene_runs_unchanged(name, povray):
    scene = HERE / "gems" / f"{name}.pov"
    theirs, _ = povray(scene, size=SIZE)
    if "assumed_gamma 2.2" in scene.read_text():
        theirs = theirs ** (1 / 2.2)  # POV-Ray reckons as we do, and then darkens; we say that we do not
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loaded = icespar.load(scene, size=SIZE)
    said = [str(warning.message) for warning in caught]
    words = [word for text in said for word in re.findall(r"warning: '(\w+)'", text)]
    assert len(words) == len(set(words)), "one warning a word"
    image = loaded.render(size=SIZE, spp=64, progress=False)
    assert image.report.bad_samples == 0
    picture = np.asarray(image.rgb, dtype=float)
    likeness, upside_down = (
        np.corrcoef(blurred(seen).ravel(), blurred(theirs).ravel())[0, 1] for seen in (picture, picture[::-1])
    )
    print(f"{name}: {len(said)} warnings, likeness {likeness:.3f}, upside down {upside_down:.3f}")
    assert likeness > 0.45 and likeness > upside_down + 0.1
