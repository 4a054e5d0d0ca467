"""The gallery shows every scene, says what the scene says, and its plot can be made."""

import runpy

import pytest


@pytest.fixture(scope="module")
def gallery(root):
    return runpy.run_path(str(root / "tools" / "make_gallery.py"))


def test_the_gallery_has_every_scene_and_its_first_line(root, gallery):
    scenes = {path.stem for path in (root / "scenes").iterdir() if path.suffix in (".spar", ".py")}
    assert {picture[0] for picture in gallery["PICTURES"]} == scenes
    page = (root / "docs" / "gallery.md").read_text(encoding="utf-8")
    assert page == gallery["page"](), "tools/make_gallery.py writes another docs/gallery.md: make gallery"


def test_all_powers_in_figure_3_add_up_to_one(root):
    figure_3 = runpy.run_path(str(root / "scenes" / "paper_figure_3.py"))
    for axis in figure_3["AXES"].values():
        for mode in "sp":
            powers = figure_3["coefficients"](axis, mode, figure_3["np"].linspace(0, 89, 90))
            assert len(powers) == 4 and abs(sum(powers.values()) - 1).max() < 1e-13


def test_figure_3_is_drawn(root, tmp_path, monkeypatch):
    monkeypatch.setattr("sys.argv", ["paper_figure_3.py", "-o", str(tmp_path / "new" / "figure.png")])
    runpy.run_path(str(root / "scenes" / "paper_figure_3.py"), run_name="__main__")
    assert (tmp_path / "new" / "figure.png").read_bytes().startswith(b"\x89PNG")
