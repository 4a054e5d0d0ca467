"""Frames: the clock of each, the names of their files, and going on where a render stopped."""

import json

import pytest

import icespar
from conftest import BOX

SMALL = ("--size", "8x6", "--spp", "1", "--threads", "1")
MOVING = (
    BOX.replace("INDICES", "1.5")
    + "\n#warning concat(str(frame_number, 0, 0), \" of \", str(final_frame, 0, 0), \" at \", str(clock, 0, 3))\n"
)


@pytest.fixture
def run(program, tmp_path):
    import subprocess

    (tmp_path / "box.spar").write_text(MOVING)

    def call(*arguments):
        return subprocess.run([program, *map(str, arguments)], cwd=tmp_path, capture_output=True, text=True, timeout=60)

    return call


def clocks(done):
    return [line.split("the scene says: ")[1] for line in done.stderr.splitlines() if "the scene says" in line]


def test_frames_have_their_clock_and_their_file(run, tmp_path):
    done = run("render", "box.spar", "-o", "a.png", "--frames", "1-3", *SMALL)
    assert done.returncode == 0
    assert clocks(done) == ["1 of 3 at 0.000", "2 of 3 at 0.500", "3 of 3 at 1.000"]
    assert sorted(p.name for p in tmp_path.glob("*.png")) == ["a0001.png", "a0002.png", "a0003.png"]
    part = run("render", "box.spar", "-o", "b.png", "--frames", "2-3/5", "--clock", "10,-10", *SMALL)
    assert clocks(part) == ["2 of 5 at 5.000", "3 of 5 at 0.000"]


def test_what_is_there_is_left_alone_when_a_render_is_resumed(run, tmp_path):
    (tmp_path / "a0002.png").write_text("old")
    done = run("render", "box.spar", "-o", "a.png", "--frames", "1-3", "--resume", *SMALL)
    assert done.returncode == 0
    assert "a0002.png is there already" in done.stderr
    assert (tmp_path / "a0002.png").read_text() == "old"
    assert (tmp_path / "a0003.png").exists()
    # With two outputs a frame is done when both are there.
    run("render", "box.spar", "-o", "a.png", "-o", "a.exr", "--frames", "2-2", "--resume", *SMALL)
    assert (tmp_path / "a0002.png").read_bytes().startswith(b"\x89PNG")


def test_a_still_picture_has_the_clock_it_is_given(run):
    assert clocks(run("render", "box.spar", "-o", "a.png", "--clock", "0.25", *SMALL)) == ["1 of 1 at 0.250"]
    assert clocks(run("check", "box.spar", "--clock=-2")) == ["1 of 1 at -2.000"]


@pytest.mark.parametrize(
    "arguments",
    [
        ["--frames", "3"],
        ["--frames", "3-1"],
        ["--frames", "1-5/4"],
        ["--frames", "0-5/9"],
        ["--frames", "1-9999999"],
        ["--frames", "1-2x"],
        ["--clock", "a"],
        ["--clock", "0,1"],
        ["--clock", "nan"],
        ["--clock", "1", "--frames", "1-3"],
    ],
)
def test_wrong_frames_and_clocks_are_wrong_usage(run, tmp_path, arguments):
    done = run("render", "box.spar", "-o", "a.png", *arguments, *SMALL)
    assert done.returncode == 2
    assert arguments[0] in done.stderr
    assert not list(tmp_path.glob("*.png"))


def test_python_gives_a_scene_its_clock():
    text = BOX.replace("INDICES", "1.5") + "\n#if (clock != 0.5) #error \"wrong clock\" #end\n"
    assert "1 gem" in repr(icespar.load(text, clock=0.5))
    with pytest.raises(icespar.SceneError, match="wrong clock"):
        icespar.load(text)
    with pytest.raises(ValueError, match="clock"):
        icespar.load(text, clock=float("nan"))


def test_check_speaks_json_to_editors(run, tmp_path):
    (tmp_path / "bad.spar").write_text(
        "#macro Ball(R) sphere { 0, R/0 pigmnt { rgb 1 } } #end\nBall(1)\n#declare A = \"\u00e4\u0001\" + 1;\n"
    )
    done = run("check", "--json", "bad.spar")
    assert done.returncode == 1 and done.stderr == ""
    found = json.loads(done.stdout)
    assert [d["severity"] for d in found] == ["error"] * len(found)
    first = found[0]
    assert first["message"] == "division by zero"
    assert (first["file"], first["line"], first["column"]) == ("bad.spar", 1, 30)
    assert first["end"] == {"line": 1, "column": 31}
    assert first["stack"] == [{"macro": "Ball", "file": "bad.spar", "line": 2, "column": 1}]
    assert set(first) == {"file", "line", "column", "end", "severity", "message", "hint", "stack"}
    good = run("check", "--json", "box.spar")
    assert good.returncode == 0
    assert [d["severity"] for d in json.loads(good.stdout)] == ["warning"]


def test_format_prints_or_writes_the_scene(run, tmp_path):
    (tmp_path / "untidy.spar").write_text("sphere {\n0, 1\n      pigment {\nrgb 1 } }\n")
    tidy = "sphere {\n  0, 1\n  pigment {\n    rgb 1 } }\n"
    assert run("format", "untidy.spar").stdout == tidy
    done = run("format", "-i", "untidy.spar")
    assert done.returncode == 0 and done.stdout == ""
    assert (tmp_path / "untidy.spar").read_text() == tidy
    (tmp_path / "bad.spar").write_text("/* never closed\n")
    refused = run("format", "--write", "bad.spar")
    assert refused.returncode == 1 and "bad.spar:1: error: this comment is never closed" in refused.stderr
    assert (tmp_path / "bad.spar").read_text() == "/* never closed\n"
    assert run("format", "missing.spar").returncode == 1
