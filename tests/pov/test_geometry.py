"""The same scene file gives the same picture in POV-Ray and here: cameras, transforms, directives, shapes.

Things in these scenes shine by themselves, so that a pixel off any edge has one value in both programs. At edges
POV-Ray's picture is the mean of 8 x 8 points a pixel, ours of 64 samples strewn over it: each has its own noise there.
"""

import numpy as np
import pytest

from .conftest import HERE, SIZE, mean_over

SCENES = sorted(path.stem for path in (HERE / "scenes").glob("*.pov"))
FINER = 8
# Five standard deviations of 64 samples of a coverage, and a row of POV-Ray's points.
AT_EDGES = 5 * 0.5 / 8 + 1 / FINER


def edges(picture):
    """Pixels whose 3 x 3 neighbours, in the finer picture's points, are not all alike."""
    height, width = SIZE[1], SIZE[0]
    blocks = picture.reshape(height, FINER, width, FINER, 3)
    low, high = blocks.min(axis=(1, 3)), blocks.max(axis=(1, 3))
    low, high = np.pad(low, ((1, 1), (1, 1), (0, 0)), "edge"), np.pad(high, ((1, 1), (1, 1), (0, 0)), "edge")
    shifts = [(slice(i, i + height), slice(j, j + width)) for i in range(3) for j in range(3)]
    low, high = np.min([low[s] for s in shifts], axis=0), np.max([high[s] for s in shifts], axis=0)
    return ((high - low) > 1e-3).any(axis=2)


def test_there_are_scenes_for_every_subject():
    assert len(SCENES) >= 25
    for subject in ("camera_", "turns", "order", "matrices", "transforms", "loops", "macros", "switches"):
        assert any(name.startswith(subject) for name in SCENES), subject


@pytest.mark.parametrize("name", SCENES)
def test_the_picture_is_povrays_to_the_pixel(name, povray, ours):
    scene = HERE / "scenes" / f"{name}.pov"
    fine, _ = povray(scene, size=(SIZE[0] * FINER, SIZE[1] * FINER))
    edge = edges(fine)
    theirs = mean_over(fine, FINER)
    picture = ours(scene)
    assert 0.01 < (theirs.max(axis=2) > 0.05).mean() and 0.03 < edge.mean() < 0.8, "the scene shows too little"
    difference = picture - theirs
    # 16 bits of POV-Ray's file, and our colours as spectra seen by the observer.
    assert np.abs(difference[~edge]).max() < 2e-3
    assert np.abs(difference[edge]).max() < AT_EDGES
    assert abs(difference[edge].mean()) < 0.01


def test_half_a_pixel_would_be_seen(povray):
    """The measure above is worth something: the picture half a pixel aside fails it."""
    fine, _ = povray(HERE / "scenes" / "camera_angle.pov", size=(SIZE[0] * FINER, SIZE[1] * FINER))
    theirs, aside = (mean_over(picture, FINER) for picture in (fine, np.roll(fine, FINER // 2, axis=1)))
    assert np.abs(aside - theirs).max() > AT_EDGES
