"""Scenes from files and texts, and their messages."""

import warnings

import pytest

import icespar
from conftest import BOX

GOOD = BOX.replace("INDICES", "1.5")


def test_a_path_is_a_file_and_anything_with_a_brace_is_text(tmp_path):
    file = tmp_path / "box.spar"
    file.write_text("// A box.\n" + GOOD)
    for source in (file, str(file), file.read_text()):
        assert "1 gem" in repr(icespar.load(source))
    assert icespar.load(file).title == "A box."
    icespar.load(" ".join(GOOD.split()))  # one line


def test_a_fault_is_raised_with_its_place_and_repair():
    with pytest.raises(icespar.SceneError) as caught:
        icespar.load(GOOD.replace("interior", "interiro"))
    first = caught.value.diagnostics[0]
    assert first.severity == "error" and first.line == 6
    assert "interiro" in str(caught.value) and "interior" in str(caught.value)
    assert str(first) in str(caught.value)
    assert isinstance(caught.value, ValueError)


def test_a_missing_file_is_a_scene_error_with_its_name():
    with pytest.raises(icespar.SceneError, match="no_such.spar"):
        icespar.load("no_such.spar")


def test_a_word_without_effect_is_a_warning():
    with pytest.warns(icespar.SceneWarning, match="photons"):
        icespar.load(GOOD + "global_settings { photons { count 1000 } }")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        icespar.load(GOOD)


@pytest.mark.parametrize("indices", ["0.5", "1.5, 0.9 axis y", "1.6, 1.5 axis <0, 0, 0>", "1e400", "0/0", "-1.5"])
def test_light_never_meets_an_index_or_an_axis_that_is_none(indices):
    with pytest.raises(icespar.SceneError):
        icespar.load(BOX.replace("INDICES", indices))


def test_two_stones_in_one_place_are_a_fault():
    gem = GOOD[GOOD.index("gem") :]
    with pytest.raises(icespar.SceneError):
        icespar.load(GOOD + gem.replace("<1, 1, 1>", "<2, 2, 2>"))
