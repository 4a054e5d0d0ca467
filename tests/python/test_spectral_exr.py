"""A spectral picture opens in colour-science, and says there what it says in memory."""

import warnings
from pathlib import Path

import numpy as np
import pytest

import icespar

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import colour

SCENE = """
camera { location <0, 2, -4> look_at <0, 0.4, 0> angle 24 }
environment { uniform illuminant "D65" 0.4 }
plane { y, 0
  pigment { checker rgb <1, 0.6, 0.2>, rgb <0.02, 0.05, 0.1> scale 0.3 }
  finish { emission 1 diffuse 0 }
}
gem {
  box { <-0.5, 0.1, -0.5>, <0.5, 0.8, 0.5> }
  interior { crystal { mineral "calcite" axis <0.577, 0.577, 0.577> } }
}
"""


@pytest.fixture(scope="module")
def image():
    return icespar.load(SCENE).render(size=(8, 6), spp=4, spectral=5, stokes=True)


@pytest.fixture(scope="module")
def opened(image, tmp_path_factory):
    path = tmp_path_factory.mktemp("exr") / "x.exr"
    image.save(str(path))
    assert [p.name for p in path.parent.iterdir()] == ["x.exr"], "a temporary file was left"
    return colour.read_spectral_image_Fichet2021(path, additional_data=True)


def test_the_file_is_an_emissive_polarised_picture_of_layout_1_0(opened):
    components, specification = opened
    assert sorted(components) == ["S0", "S1", "S2", "S3"]
    assert specification.is_emissive
    assert specification.is_polarised
    assert not specification.is_bispectral
    attributes = {a.name: a.value for a in specification.attributes}
    assert attributes["spectralLayoutVersion"] == "1.0"
    assert attributes["emissiveUnits"] == "W.m^-2.sr^-1"
    assert attributes["polarisationHandedness"] == "right"


def test_bands_are_the_ones_asked_for(image, opened):
    for wavelengths, values in opened[0].values():
        assert values.shape == (6, 8, 5)
        # Names hold six decimals of a nanometre.
        np.testing.assert_allclose(wavelengths, image.wavelengths, atol=5e-7)
        assert np.all(np.diff(wavelengths) > 0)


def test_every_number_is_the_one_in_memory(image, opened):
    assert image.stokes.shape == (6, 8, 4, 5)
    for s in range(4):
        np.testing.assert_array_equal(opened[0][f"S{s}"][1], image.stokes[:, :, s, :])


def test_the_light_is_partly_polarised_and_nowhere_more_than_wholly(opened):
    s0, s1, s2, s3 = (opened[0][f"S{s}"][1].astype(float) for s in range(4))
    assert np.all(np.isfinite(s0)) and np.all(s0 >= 0) and s0.mean() > 0
    polarised = np.sqrt(s1**2 + s2**2 + s3**2)
    assert np.all(polarised <= s0 * (1 + 1e-5))
    assert polarised.max() > 0.01 * s0.max()


def test_rgb_and_metadata_stand_beside_the_bands(image, opened, tmp_path):
    path = tmp_path / "y.exr"
    image.save(path)
    rgb = colour.read_image(str(path))[..., :3]
    np.testing.assert_array_equal(rgb, image.rgb)
    attributes = {a.name: a.value for a in opened[1].attributes}
    for key, value in image.metadata.items():
        assert attributes[f"icespar:{key}"] == value


def test_a_missing_folder_is_reported_and_nothing_written(image, tmp_path):
    with pytest.raises(icespar.Error, match="there is no folder"):
        image.save(tmp_path / "no" / "x.exr")
    assert list(Path(tmp_path).iterdir()) == []
