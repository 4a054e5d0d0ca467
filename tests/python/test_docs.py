"""What the documentation shows works, and every file it names exists."""

import math
import re

import pytest

import icespar


def blocks(root, language, page="README.md"):
    return re.findall(rf"```{language}\n(.*?)```", (root / page).read_text(), re.S)


def test_the_readmes_python_runs(root, tmp_path, monkeypatch):
    (tmp_path / "scenes").symlink_to(root / "scenes")
    monkeypatch.chdir(tmp_path)
    (example,) = blocks(root, "python")
    names = {}
    exec(compile(example, "README.md", "exec"), names)
    assert (tmp_path / "grid.exr").exists()
    assert names["stokes"].shape == (1, 4)


def test_the_python_page_runs(root, monkeypatch):
    monkeypatch.chdir(root)
    names = {}
    for number, example in enumerate(blocks(root, "python", "docs/python.md")):
        exec(compile(example, f"docs/python.md, block {number}", "exec"), names)
    assert names["walk_off"] == pytest.approx(6.26, abs=0.01)


def test_the_report_pages_python_runs(root, monkeypatch):
    monkeypatch.chdir(root)
    (example,) = blocks(root, "python", "docs/report.md")
    exec(compile(example, "docs/report.md", "exec"), {})


def test_the_page_on_exact_beams_runs(root, monkeypatch):
    monkeypatch.chdir(root)
    (example,) = blocks(root, "python", "docs/exact_beams.md")
    names = {}
    exec(compile(example, "docs/exact_beams.md", "exec"), names)
    assert names["slope"](41.3, 1e-5) == pytest.approx(names["slope"](41.3, 1e-4), rel=1e-6)
    # The mains are best at the critical angle: any flatter and light from straight above goes through.
    assert names["high"] == pytest.approx(math.degrees(math.asin(1 / names["n"])), abs=0.01)


def test_the_readmes_scene_has_no_fault(root):
    (example,) = blocks(root, "pov")
    assert icespar.load(example).render(size=(8, 6), spp=1, progress=False).report.bad_samples == 0


def pages(root):
    return [root / "README.md", *sorted((root / "docs").glob("**/*.md"))]


def test_every_file_that_a_page_names_exists(root):
    for page in pages(root):
        text = page.read_text()
        for target in re.findall(r"\]\(([^)#\s]+)", text):
            if "://" not in target:
                assert (page.parent / target).exists(), f"{page.name}: {target}"
        for named in re.findall(r"`((?:core|parser|cli|python|scenes|tests|bench|docs|tools)/[\w./-]*\w)`", text):
            assert (root / named).exists(), f"{page.name}: {named}"


@pytest.mark.parametrize("word", ["render", "check", "stone", "minerals", "analyse", "compare"])
def test_the_readme_shows_every_command(root, word):
    assert f"build/icespar {word}" in (root / "README.md").read_text()
